/// Whole scenes at random: every shape, solids of several levels, every sort of material, light and motion, objects
/// that touch or coincide, planets to stand on. No Mandelbulb of glass, and marches of 24 steps: llvmpipe's loops end
/// (docs/software-gl.md).
#pragma once

#include "tracer/image.h"
#include "tracer/settings/settings.h"

#include <cstdint>
#include <string>

namespace gnomon::test {

/// Scenes of one family have the same kinds of objects, materials and lights, and share their shader programs.
inline constexpr std::uint64_t kFamily = 512;

/// A scene file. The same seed gives the same text with every library; seeds of one family follow one another.
std::string randomScene(std::uint64_t seed);

/// How such a scene is drawn, by its family: depth, shadows and march.
Settings randomSettings(std::uint64_t seed);

/// Texels without any order, the same for one name.
Image noise(const std::string& name, int side = 8);

} // namespace gnomon::test
