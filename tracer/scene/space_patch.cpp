#include "tracer/scene/space_patch.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

using Curve = std::array<glm::dvec4, 4>;

/// Of a curve over [0, 1]: its net over [low, high], by means only.
Curve partOf(const Curve& c, double low, double high) {
    const auto mix = [](const glm::dvec4& x, const glm::dvec4& y, double t) { return x + t * (y - x); };
    const auto blossom = [&](double a, double b, double d) {
        const glm::dvec4 x = mix(c[0], c[1], a), y = mix(c[1], c[2], a), z = mix(c[2], c[3], a);
        return mix(mix(x, y, b), mix(y, z, b), d);
    };
    return {blossom(low, low, low), blossom(low, low, high), blossom(low, high, high), blossom(high, high, high)};
}

/// The hulls of 8 x 8 parts: nearer to the surface than 1/64 of what bends.
void setBox(SpaceNet& net) {
    constexpr int kParts = 8;
    net.low = net.high = glm::dvec3(net.points[0]) / net.points[0].w;
    for (int part = 0; part < kParts * kParts; ++part) {
        const double u = double(part % kParts) / kParts, v = double(part / kParts) / kParts, side = 1.0 / kParts;
        std::array<Curve, 4> rows;
        for (std::size_t j = 0; j < 4; ++j)
            rows[j] = partOf({net.points[4 * j], net.points[4 * j + 1], net.points[4 * j + 2], net.points[4 * j + 3]},
                             u, u + side);
        for (std::size_t i = 0; i < 4; ++i)
            for (const glm::dvec4& p : partOf({rows[0][i], rows[1][i], rows[2][i], rows[3][i]}, v, v + side)) {
                net.low = glm::min(net.low, glm::dvec3(p) / p.w);
                net.high = glm::max(net.high, glm::dvec3(p) / p.w);
            }
    }
}

} // namespace

SpaceNet spaceNet(const ControlPoints& points, glm::dvec3 anchor) {
    double heaviest = 0;
    for (const glm::dvec4& p : points) heaviest = std::max(heaviest, p.w);
    // The same surface, with weights that float32 has products of. A power of two, so that nothing is rounded.
    const double scale = std::ldexp(1.0, -std::ilogb(heaviest));
    SpaceNet net;
    for (std::size_t i = 0; i < 16; ++i) {
        const double weight = scale * points[i].w;
        net.points[i] = glm::dvec4(weight * (glm::dvec3(points[i]) - anchor), weight);
    }
    setBox(net);
    return net;
}

SpaceNet mappedNet(const SpaceNet& net, const glm::dmat3& linear) {
    SpaceNet result;
    for (std::size_t i = 0; i < 16; ++i)
        result.points[i] = glm::dvec4(linear * glm::dvec3(net.points[i]), net.points[i].w);
    setBox(result);
    return result;
}

} // namespace gnomon
