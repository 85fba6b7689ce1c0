/// Scenes of many spheres, to see how the cost of finding objects grows with their number.
///
/// A cube of side kSphereCube about the world's origin holds equal spheres that do not overlap. Their radius is such
/// that their cross-sections add up to half a face of the cube, whatever their number, so that pictures of all numbers
/// are covered alike. One lamp, hard shadows, matte colours, every eighth sphere a mirror.
#pragma once

#include "tracer/scene/scene.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace gnomon {

inline constexpr double kSphereCube = 10;

enum class Arrangement {
    Random,    ///< evenly in the cube; each moves on a small orbit
    Clustered, ///< in eight heaps, so that most of the cube is empty; each moves likewise
    Regular    ///< at rest at the points of a lattice
};
inline constexpr std::array kArrangements{Arrangement::Random, Arrangement::Clustered, Arrangement::Regular};
std::string_view nameOf(Arrangement);

/// How many spheres the scene for `count` has, 8 or more: as many; of a lattice the nearest cube number.
int spheresIn(Arrangement, int count);

/// For `count` from 8 on: fewer would be too large to find room. The same seed gives the same scene everywhere.
Scene sphereScene(Arrangement, int count, std::uint64_t seed = 1);

/// The scenes in words, for those who read the numbers.
std::string sphereScenesText();

} // namespace gnomon
