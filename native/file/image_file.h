/// Picture files: PNG for eyes, PFM and OpenEXR for numbers.
///
///   .png  eight bits a channel; the picture as a screen shows it
///   .pfm  float32 little endian, `PF` for three channels, `Pf` for one, rows bottom to top as the format has it
///   .exr  float32, channels R, G, B, or Y
/// A file is written whole or not at all: a write that fails leaves what stood there before.
#pragma once

#include "tracer/image.h"
#include "tracer/settings/settings.h"

#include <string>

namespace gnomon {

/// May output `aov` go to a file of this name? False, with a problem, where its extension is unknown or cannot hold it.
bool checkImageFile(const std::string& file, Aov aov, Problems&);

/// The file holds eight-bit colours as a window shows them, not numbers.
bool isPicture(const std::string& file);

/// Writes what Renderer::readOutput gave: .pfm or .exr.
bool writeImage(const std::string& file, const FloatImage&, Problems&);
/// Writes what Renderer::readPicture gave: .png.
bool writeImage(const std::string& file, const Image&, Problems&);

/// The whole file in memory; empty where the picture cannot be encoded.
std::string toPng(const Image&);

} // namespace gnomon
