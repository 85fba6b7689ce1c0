/// Picture files: PNG for eyes, PFM and OpenEXR for numbers.
///
///   .png  eight bits a channel; the picture as a screen shows it
///   .pfm  float32 little endian, `PF` for three channels, `Pf` for one, rows bottom to top as the format has it
///   .exr  float32, channels R, G, B, or Y
/// Written as output_file.h says.
#pragma once

#include "tracer/image.h"
#include "tracer/settings/settings.h"

#include <optional>
#include <string>
#include <string_view>

namespace gnomon {

enum class ImageFormat {
    Png, ///< holds eight-bit colours as a window shows them; the others hold numbers
    Pfm,
    Exr,
};

/// The format called `named`, or where that is empty the one that the file's name ends with; standard output, pipes and
/// devices get PNG. Nothing, with a problem, where it is unknown or cannot hold output `aov`, or where the file cannot
/// be written.
std::optional<ImageFormat> checkImageFile(const std::string& file, std::string_view named, Aov aov, Problems&);

/// Writes what Renderer::readOutput gave, as .pfm or .exr.
bool writeImage(const std::string& file, ImageFormat, const FloatImage&, Problems&);
/// Writes what Renderer::readPicture gave, as .png.
bool writeImage(const std::string& file, const Image&, Problems&);

/// The whole file in memory; empty where the picture cannot be encoded.
std::string toPng(const Image&);

} // namespace gnomon
