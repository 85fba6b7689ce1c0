#include "tracer/scene/height_patch.h"

#include <algorithm>
#include <cstdint>

namespace gnomon {
namespace {

using Cubic = std::array<double, 4>;

/// The value that is symmetric and linear in a, b and c, and the cubic's own where they are equal.
double blossom(const Cubic& c, double a, double b, double d) {
    const auto mix = [](double x, double y, double t) { return x + t * (y - x); };
    const double x = mix(c[0], c[1], a), y = mix(c[1], c[2], a), z = mix(c[2], c[3], a);
    return mix(mix(x, y, b), mix(y, z, b), d);
}

Cubic partOf(const Cubic& c, double low, double high) {
    return {blossom(c, low, low, low), blossom(c, low, low, high), blossom(c, low, high, high),
            blossom(c, high, high, high)};
}

/// In [0, 1), of 53 random bits: SplitMix64 (G. Steele, D. Lea, C. Flood, 2014).
double nextRandom(std::uint64_t& state) {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

} // namespace

Heights randomHeights(unsigned seed) {
    constexpr Cubic kMaxima{1, 4.0 / 9, 4.0 / 9, 1};
    std::uint64_t state = seed;
    Heights heights;
    for (std::size_t i = 0; i < 16; ++i)
        heights[i] = (2 * nextRandom(state) - 1) / (kMaxima[i % 4] * kMaxima[i / 4]);
    return heights;
}

double heightAt(const Heights& heights, double u, double v) {
    Cubic rows;
    for (std::size_t j = 0; j < 4; ++j)
        rows[j] = blossom({heights[4 * j], heights[4 * j + 1], heights[4 * j + 2], heights[4 * j + 3]}, u, u, u);
    return blossom(rows, v, v, v);
}

Heights partOf(const Heights& heights, glm::dvec2 low, glm::dvec2 high) {
    Heights part;
    for (std::size_t j = 0; j < 4; ++j) {
        const Cubic row = partOf(Cubic{heights[4 * j], heights[4 * j + 1], heights[4 * j + 2], heights[4 * j + 3]},
                                 low.x, high.x);
        std::copy(row.begin(), row.end(), part.begin() + std::ptrdiff_t(4 * j));
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const Cubic column = partOf(Cubic{part[i], part[4 + i], part[8 + i], part[12 + i]}, low.y, high.y);
        for (std::size_t j = 0; j < 4; ++j) part[4 * j + i] = column[j];
    }
    return part;
}

std::array<double, 2> heightRange(const Heights& heights) {
    // A part's net is nearer to its surface by the square of how small it is: 1/1024 of what bends, here.
    constexpr int kParts = 32;
    std::array<double, 2> range{heights[0], heights[0]};
    for (int j = 0; j < kParts; ++j)
        for (int i = 0; i < kParts; ++i) {
            const glm::dvec2 low = glm::dvec2(i, j) / double(kParts);
            const Heights part = partOf(heights, low, low + 1.0 / kParts);
            const auto [least, greatest] = std::minmax_element(part.begin(), part.end());
            range = {std::min(range[0], *least), std::max(range[1], *greatest)};
        }
    return range;
}

} // namespace gnomon
