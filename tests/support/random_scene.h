/// Whole scenes at random: every shape, solids of several levels, every sort of material, light and motion, objects
/// that touch or coincide, planets to stand on. No Mandelbulb of glass.
#pragma once

#include "tracer/image.h"
#include "tracer/settings/settings.h"

#include <cstdint>
#include <string>

namespace gnomon::test {

/// Scenes of one family have the same kinds of objects, materials and lights, and share their shader programs.
inline constexpr std::uint64_t kFamily = 512;

/// Beside what every scene may have, some also have ellipsoids, rotated boxes, groups within groups, instances and
/// meshes, which need randomMesh().
enum class Variety { Base, Full };

/// A scene file. The same seed gives the same text with every library; seeds of one family follow one another.
std::string randomScene(std::uint64_t seed, Variety = Variety::Base);

/// The OBJ file that all meshes of such a scene are of: a dented ball of 48 triangles.
std::string randomMesh(std::uint64_t seed);

/// How such a scene is drawn, by its family: depth, shadows and march.
Settings randomSettings(std::uint64_t seed);

/// Texels without any order, the same for one name.
Image noise(const std::string& name, int side = 8);

} // namespace gnomon::test
