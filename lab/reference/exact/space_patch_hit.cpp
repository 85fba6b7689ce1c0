#include "lab/reference/exact/space_patch_hit.h"

#include <algorithm>
#include <cmath>

namespace gnomon::oracle {
namespace {

using Vec = glm::dvec2;
using SeenNet = std::array<Vec, 16>; ///< across the ray

double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }

/// Cubic Bernstein polynomials and their derivatives.
std::array<double, 4> basis(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t};
}
std::array<double, 4> slopes(double t) {
    const double s = 1 - t;
    return {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t};
}

template<class T>
T weighed(const std::array<T, 16>& net, const std::array<double, 4>& u, const std::array<double, 4>& v) {
    T sum{0};
    for (std::size_t k = 0; k < 16; ++k) sum += u[k % 4] * v[k / 4] * net[k];
    return sum;
}

struct Part {
    SeenNet net;
    Vec low, high;
};

/// Halves a part across u (step 1) or v (step 4), by de Casteljau.
std::array<Part, 2> halves(const Part& part, std::size_t step) {
    std::array<Part, 2> result{part, part};
    for (std::size_t line = 0; line < 4; ++line) {
        const std::size_t first = line * (step == 1 ? 4 : 1);
        std::array<Vec, 4> c;
        for (std::size_t i = 0; i < 4; ++i) c[i] = part.net[first + i * step];
        for (std::size_t round = 0; round < 4; ++round) {
            result[0].net[first + round * step] = c[0];
            result[1].net[first + (3 - round) * step] = c[3 - round];
            for (std::size_t i = 0; i + 1 < 4 - round; ++i) c[i] = 0.5 * (c[i] + c[i + 1]);
        }
    }
    const int axis = step == 1 ? 0 : 1;
    result[0].high[axis] = result[1].low[axis] = 0.5 * (part.low[axis] + part.high[axis]);
    return result;
}

/// All of the net on one side of 0, seen along n.
bool misses(const SeenNet& net, Vec n, double room) {
    double least = 1e300, most = -1e300;
    for (const Vec p : net) least = std::min(least, glm::dot(n, p)), most = std::max(most, glm::dot(n, p));
    const double slack = room * (std::abs(n.x) + std::abs(n.y));
    return least > slack || most < -slack;
}

class Search {
  public:
    explicit Search(const SeenNet& net) : net_(net) {
        for (const Vec p : net) room_ = std::max(room_, 1e-15 * (std::abs(p.x) + std::abs(p.y)));
    }
    void look(const Part& part) {
        const auto& c = part.net;
        const Vec u = 0.5 * ((c[15] - c[12]) + (c[3] - c[0])), v = 0.5 * ((c[15] - c[3]) + (c[12] - c[0]));
        for (const Vec n : {Vec(1, 0), Vec(0, 1), Vec(v.y, -v.x), Vec(-u.y, u.x)})
            if (misses(c, n, room_)) return;
        if (single(c, u, v)) return settle(part, u, v);
        const Vec size = part.high - part.low;
        if (std::max(size.x, size.y) < 0x1p-40 || ++parts_ > 20000) {
            found.push_back({0, 0.5 * (part.low + part.high), true});
            return;
        }
        for (const Part& half : halves(part, size.x >= size.y ? 1 : 4)) look(half);
    }

    std::vector<PatchCrossing> found;

  private:
    static bool single(const SeenNet& c, Vec u, Vec v) {
        const double turn = cross(u, v);
        double inU[2] = {0, 0}, inV[2] = {0, 0};
        for (std::size_t k = 0; k < 16; ++k) {
            if (k % 4 < 3) {
                const Vec slope = 3.0 * (c[k + 1] - c[k]);
                inU[0] = std::max(inU[0], std::abs(cross(slope, v) - turn));
                inV[0] = std::max(inV[0], std::abs(cross(u, slope)));
            }
            if (k < 12) {
                const Vec slope = 3.0 * (c[k + 4] - c[k]);
                inU[1] = std::max(inU[1], std::abs(cross(slope, v)));
                inV[1] = std::max(inV[1], std::abs(cross(u, slope) - turn));
            }
        }
        return std::max(inU[0] + inU[1], inV[0] + inV[1]) < 0.5 * std::abs(turn);
    }

    /// The contraction's fixed point, kept within the part; then Newton's steps from there.
    void settle(const Part& part, Vec u, Vec v) {
        const Vec size = part.high - part.low;
        const double turn = cross(u, v);
        Vec local(0.5);
        for (int i = 0; i < 100; ++i) {
            const Vec place = weighed(part.net, basis(local.x), basis(local.y));
            const Vec stride = Vec(cross(place, v), cross(u, place)) / turn;
            local = glm::clamp(local - stride, Vec(0), Vec(1));
            if (std::abs(stride.x) + std::abs(stride.y) < 1e-16) break;
        }
        Vec uv = part.low + local * size;
        for (int i = 0; i < 4; ++i) {
            const Vec place = weighed(net_, basis(uv.x), basis(uv.y));
            const Vec du = weighed(net_, slopes(uv.x), basis(uv.y)), dv = weighed(net_, basis(uv.x), slopes(uv.y));
            const double det = cross(du, dv);
            if (det == 0) break;
            uv = glm::clamp(uv - Vec(cross(place, dv), cross(du, place)) / det, Vec(0), Vec(1));
        }
        const Vec left = weighed(net_, basis(uv.x), basis(uv.y));
        if (std::max(std::abs(left.x), std::abs(left.y)) <= 20 * room_) found.push_back({0, uv, false});
    }

    const SeenNet& net_;
    double room_ = 0;
    int parts_ = 0;
};

} // namespace

ExactPatch::ExactPatch(const SpaceNet& net) : points_(net.points) {}

std::vector<PatchCrossing> ExactPatch::crossings(glm::dvec3 origin, glm::dvec3 direction) const {
    const double squared = glm::dot(direction, direction), middle = -glm::dot(origin, direction) / squared;
    const glm::dvec3 o = origin + middle * direction, d = direction / std::sqrt(squared);
    const glm::dvec3 e = glm::normalize(glm::cross(d, std::abs(d.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 f = glm::cross(d, e);
    SeenNet net;
    for (std::size_t k = 0; k < 16; ++k) {
        const glm::dvec3 p = glm::dvec3(points_[k]) - points_[k].w * o;
        net[k] = {glm::dot(p, e), glm::dot(p, f)};
    }
    Search search(net);
    search.look({net, Vec(0), Vec(1)});
    for (PatchCrossing& crossing : search.found)
        crossing.t = middle + glm::dot(at(crossing.uv).place - o, d) / std::sqrt(squared);
    std::sort(search.found.begin(), search.found.end(),
              [](const PatchCrossing& a, const PatchCrossing& b) { return a.t < b.t; });
    return search.found;
}

PatchPoint ExactPatch::at(glm::dvec2 uv) const {
    const auto at = [&](glm::dvec2 q) {
        const glm::dvec4 p = weighed(points_, basis(q.x), basis(q.y));
        const glm::dvec4 u = weighed(points_, slopes(q.x), basis(q.y)), v = weighed(points_, basis(q.x), slopes(q.y));
        PatchPoint point;
        point.place = glm::dvec3(p) / p.w;
        point.alongU = (glm::dvec3(u) - u.w * point.place) / p.w;
        point.alongV = (glm::dvec3(v) - v.w * point.place) / p.w;
        return point;
    };
    PatchPoint point = at(uv);
    // Beside an edge that is one point the derivative along it falls to 0: the normal is that of a point a little
    // inside, whose error is as small as that step.
    glm::dvec2 inside = uv;
    for (int i = 0; i < 2; ++i) {
        double &x = inside[i], step = 1e-7;
        x = x < step ? step : (x > 1 - step ? 1 - step : x);
    }
    const PatchPoint beside = at(inside);
    const glm::dvec3 normal = glm::cross(beside.alongU, beside.alongV);
    point.normal = normal / glm::length(normal);
    return point;
}

glm::dvec2 ExactPatch::footNear(glm::dvec3 p, glm::dvec2 start) const {
    // Gauss's steps, shortened until they lead nearer.
    glm::dvec2 uv = start;
    for (int i = 0; i < 50; ++i) {
        const PatchPoint q = at(uv);
        const double uu = glm::dot(q.alongU, q.alongU), across = glm::dot(q.alongU, q.alongV),
                     vv = glm::dot(q.alongV, q.alongV);
        const double tiny = 1e-12 * (uu + vv), det = (uu + tiny) * (vv + tiny) - across * across;
        if (!(det > 0)) break;
        const double a = glm::dot(p - q.place, q.alongU), b = glm::dot(p - q.place, q.alongV);
        glm::dvec2 stride = glm::dvec2((vv + tiny) * a - across * b, (uu + tiny) * b - across * a) / det;
        const double now = glm::distance(p, q.place);
        glm::dvec2 next = glm::clamp(uv + stride, Vec(0), Vec(1));
        for (int k = 0; k < 30 && glm::distance(p, at(next).place) > now; ++k)
            next = glm::clamp(uv + (stride *= 0.5), Vec(0), Vec(1));
        if (!(glm::distance(p, at(next).place) < now)) break;
        uv = next;
    }
    return uv;
}

} // namespace gnomon::oracle
