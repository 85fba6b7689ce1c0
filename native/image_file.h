/// Picture files: PNG for eyes, PFM and OpenEXR for numbers.
///
///   .png  eight bits a channel; the picture as a screen shows it
///   .pfm  float32 little endian, `PF` for three channels, `Pf` for one, rows bottom to top as the format has it
///   .exr  float32, channels R, G, B, or Y
/// A file is written whole or not at all: a write that fails leaves what stood there before.
#pragma once

#include "tracer/image.h"
#include "tracer/render/settings.h"
#include "tracer/scene/scene.h"

#include <string>

namespace gnomon {

/// May output `aov` go to a file of this name? False, with a problem, where its extension is unknown or cannot hold it.
bool checkImageFile(const std::string& file, Aov aov, Problems&);

/// Writes what Renderer::readOutput gave. PNG shows colours clamped to [0, 1] (with `encoding` Linear sRGB-encoded),
/// normals as 0.5 + 0.5 n and visibility as grey; NaN is black.
bool writeImage(const std::string& file, const FloatImage&, Aov, Encoding, Problems&);
/// PNG only.
bool writeImage(const std::string& file, const Image&, Problems&);

} // namespace gnomon
