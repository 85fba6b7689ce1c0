/// What image files say of themselves before their pixels are decoded: which of the formats that are read they have,
/// how large they are, and what decoding takes.
///
///   PNG           tracer/png.h
///   JPEG          tracer/jpeg.h
///   Radiance HDR  tracer/hdr.h
#pragma once

#include "tracer/problem.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace gnomon {

struct ImageHeader {
    int width = 0, height = 0;
    std::uint64_t decodeBytes = 0; ///< that decoding takes at most

    std::uint64_t pixels() const { return std::uint64_t(width) * std::uint64_t(height); }
};

/// Bytes of a file in which its header is looked for: metadata may stand before it.
inline constexpr std::size_t kHeaderBytes = std::size_t(1) << 20;

/// Of the first bytes of a file; none where they are no image's, or its header is broken.
std::optional<ImageHeader> imageHeader(std::span<const std::uint8_t> bytes);

/// The same with a problem where there is none, or where decoding would take more than 512 MB. `name` stands in it.
std::optional<ImageHeader> measureImage(const std::string& name, std::span<const std::uint8_t> bytes, Problems&);

} // namespace gnomon
