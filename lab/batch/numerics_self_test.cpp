#include "lab/batch/numerics_self_test.h"

#include "lab/batch/ray_batch.h"
#include "tracer/clock.h"
#include "tracer/scene/read_scene.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace gnomon {
namespace {

using Vec = glm::dvec3;

constexpr double kFar = 1e4;   // units from the rays' origins to the bodies
constexpr int kRaysEach = 512; // uniform ones and grazing ones of each body
constexpr int kChoice = 8;     // grazing rays made for each one taken, the nearest to tangency
constexpr double kPi = 3.14159265358979323846;

// Numbers with all their bits, coordinates about 1, and room between the two.
constexpr const char* kScene = R"({"objects": [
    {"sphere": {"center": [-0.7132869, 0.6417531, -0.5928173], "radius": 1}},
    {"torus": {"center": [0.7294183, -0.6328497, 0.6117359], "axis": [0.5317294, 0.6982311, -0.4791357],
               "major_radius": 1, "minor_radius": 0.25}}]})";

/// A sphere or a torus as the shader has it: from its numbers in float.
struct Body {
    Vec center;
    double major = 0, minor = 0; // a sphere where major is 0
    Vec axis{0, 0, 1};

    explicit Body(const Shape& shape) {
        const Shape rounded = inFloat(shape);
        const bool torus = shape.kind == ShapeKind::Torus;
        center = pointOf(rounded, "center");
        major = torus ? lengthOf(rounded, "major_radius") : 0;
        minor = lengthOf(rounded, torus ? "minor_radius" : "radius");
        if (torus) axis = glm::normalize(pointOf(rounded, "axis"));
    }
    double size() const { return major + minor; }
    double distance(Vec p) const {
        p -= center;
        if (major == 0) return glm::length(p) - minor;
        const double height = glm::dot(p, axis);
        const double fromRing = glm::length(p - height * axis) - major;
        return std::sqrt(fromRing * fromRing + height * height) - minor;
    }
};

/// What a ray does in truth. `tangency`: how far, in units, it is from doing another thing.
struct Truth {
    bool hit = false;
    double t = 0, tangency = 1e30;
};

double along(const Body& body, const BatchRay& ray, double t) {
    return body.distance(Vec(ray.origin) + t * Vec(ray.direction));
}

/// Ray parameter of the closest approach to the body's centre.
double middleOf(const Body& body, const BatchRay& ray) {
    const Vec d(ray.direction);
    return glm::dot(body.center - Vec(ray.origin), d) / glm::dot(d, d);
}

Truth solveSphere(const Body& body, const BatchRay& ray) {
    const double middle = middleOf(body, ray), passes = along(body, ray, middle); // > 0: the ray passes by
    if (passes > 0) return {false, 0, passes};
    const double half = std::sqrt(-passes * (passes + 2 * body.minor)) / glm::length(Vec(ray.direction));
    return {true, middle - half, -passes};
}

/// The bottom of a dip of the distance between two ray parameters.
double bottomOf(const Body& body, const BatchRay& ray, double low, double high) {
    for (int i = 0; i < 45; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (along(body, ray, a) < along(body, ray, b))
            high = b;
        else
            low = a;
    }
    return (low + high) / 2;
}

double entryBetween(const Body& body, const BatchRay& ray, double outside, double inside) {
    for (int i = 0; i < 50; ++i) {
        const double middle = (outside + inside) / 2;
        (along(body, ray, middle) < 0 ? inside : outside) = middle;
    }
    return (outside + inside) / 2;
}

/// Knows nothing of the torus but its signed distance: samples it, and searches every dip for its bottom.
Truth solveTorus(const Body& body, const BatchRay& ray) {
    constexpr int kSamples = 128;
    const double reach = 1.02 * body.size(), step = 2 * reach / kSamples;
    const double from = middleOf(body, ray) - reach;
    Truth truth;
    double outside = from, before = along(body, ray, from), here = along(body, ray, from + step);
    for (int i = 1; i < kSamples && !truth.hit; ++i) {
        const double t = from + i * step, next = along(body, ray, t + step);
        if (here <= before && here <= next) {
            const double bottom = bottomOf(body, ray, t - step, t + step), depth = along(body, ray, bottom);
            truth.tangency = std::min(truth.tangency, std::abs(depth));
            truth.hit = depth < 0;
            if (truth.hit) truth.t = entryBetween(body, ray, outside, bottom);
        }
        if (here > 0) outside = t;
        before = here;
        here = next;
    }
    return truth;
}

Truth solve(const Body& body, const BatchRay& ray) {
    return body.major == 0 ? solveSphere(body, ray) : solveTorus(body, ray);
}

/// Numbers that are the same everywhere.
class Random {
  public:
    double number(double low, double high) {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return low + (high - low) * double(state_ >> 11) * 0x1p-53;
    }
    Vec direction() {
        const double z = number(-1, 1), around = number(0, 2 * kPi), r = std::sqrt(1 - z * z);
        return {r * std::cos(around), r * std::sin(around), z};
    }

  private:
    std::uint64_t state_ = 20;
};

BatchRay rayFrom(Vec origin, Vec towards) {
    BatchRay ray;
    ray.origin = glm::vec3(origin);
    ray.direction = glm::vec3(glm::normalize(towards));
    return ray;
}

/// Towards a point somewhere in the bounding sphere.
BatchRay uniformRay(const Body& body, Random& random) {
    const Vec origin = body.center + kFar * random.direction();
    const Vec aim = body.center + body.size() * std::cbrt(random.number(0, 1)) * random.direction();
    return rayFrom(origin, aim - origin);
}

/// Tangent to the body, but for the rounding of its far origin.
BatchRay grazingRay(const Body& body, Random& random) {
    Vec normal = random.direction(), ring = glm::cross(body.axis, normal);
    if (body.major > 0) { // turned about a direction along the ring, any place of the tube
        const double around = random.number(0, 2 * kPi);
        const Vec across = glm::normalize(ring), out = glm::cross(across, body.axis);
        normal = std::cos(around) * out + std::sin(around) * body.axis;
        ring = body.major * out;
    } else {
        ring = Vec(0);
    }
    const Vec point = body.center + ring + body.minor * normal;
    const Vec way = glm::normalize(glm::cross(normal, random.direction()));
    return rayFrom(point - kFar * way, way);
}

/// A ray with its truth.
struct Case {
    BatchRay ray;
    Truth truth;
};

/// Far enough from tangency for float32 to decide, and out of the other body's way.
bool isClear(const Case& one, const Body& body, const Body& other) {
    const double passes =
        glm::length(Vec(one.ray.origin) + middleOf(other, one.ray) * Vec(one.ray.direction) - other.center);
    return one.truth.tangency > std::ldexp(body.size(), -22) && passes > 1.01 * other.size();
}

template<class Make>
Case clearCase(const Body& body, const Body& other, Make make) {
    for (;;) {
        Case one;
        one.ray = make();
        one.truth = solve(body, one.ray);
        if (isClear(one, body, other)) return one;
    }
}

std::vector<Case> casesOf(const Body& body, const Body& other, Random& random) {
    std::vector<Case> cases;
    for (int i = 0; i < kRaysEach; ++i) {
        cases.push_back(clearCase(body, other, [&] { return uniformRay(body, random); }));
        Case nearest;
        for (int j = 0; j < kChoice; ++j) {
            const Case one = clearCase(body, other, [&] { return grazingRay(body, random); });
            if (one.truth.tangency < nearest.truth.tangency) nearest = one;
        }
        cases.push_back(nearest);
    }
    return cases;
}

double ulp(double x) { return std::ldexp(1.0, std::ilogb(x) - 23); }

/// The ray stops on another sheet: between where it should stop and where it does it is off the surface.
bool isElsewhere(const Body& body, const Case& one, double t) {
    const double slack = 4 * (ulp(one.truth.t) + ulp(body.size()));
    for (int i = 0; i <= 32; ++i)
        if (!(std::abs(along(body, one.ray, one.truth.t + (t - one.truth.t) * i / 32)) <= slack)) return true;
    return false;
}

void compareHit(const Body& body, int object, const Case& one, const BatchHit& hit, NumericsSelfTest& selfTest) {
    ++selfTest.rays;
    if (!one.truth.hit && hit.object < 0) return;
    const double off = body.distance(Vec(hit.point));
    if (!one.truth.hit || hit.object != object || !std::isfinite(off) || isElsewhere(body, one, hit.t)) {
        ++selfTest.wrong;
        return;
    }
    selfTest.worstPoint = std::max(selfTest.worstPoint, std::abs(off) / std::ldexp(body.size(), -23));
    selfTest.worstAlong = std::max(selfTest.worstAlong, std::abs(along(body, one.ray, hit.t)) / ulp(one.truth.t));
}

void measure(RayBatch& batch, const Scene& scene, NumericsSelfTest& selfTest) {
    const Body bodies[] = {Body(scene.objects[0].shape), Body(scene.objects[1].shape)};
    Random random;
    std::vector<Case> cases;
    for (const int i : {0, 1}) {
        const std::vector<Case> more = casesOf(bodies[i], bodies[1 - i], random);
        cases.insert(cases.end(), more.begin(), more.end());
    }
    std::vector<BatchRay> rays;
    for (const Case& one : cases) rays.push_back(one.ray);
    const std::vector<BatchHit> hits = batch.trace(rays);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const int object = i < cases.size() / 2 ? 0 : 1; // as in the scene: spheres come before tori
        compareHit(bodies[object], object, cases[i], hits[i], selfTest);
    }
    selfTest.measured = true;
}

} // namespace

bool NumericsSelfTest::holds() const {
    return measured && rays > 0 && wrong == 0 && worstPoint <= kMostPoint && worstAlong <= kMostAlong;
}

NumericsSelfTest runNumericsSelfTest(std::span<const ShaderFile> overrides) {
    const double start = monotonicSeconds();
    NumericsSelfTest selfTest;
    Problems problems;
    if (const auto scene = readScene(kScene, "numerics self-test", problems)) {
        RayBatch batch(*scene, problems, overrides);
        if (batch.valid()) measure(batch, *scene, selfTest);
    }
    if (!problems.empty()) selfTest.problem = toString(problems.front());
    selfTest.milliseconds = (monotonicSeconds() - start) * 1e3;
    return selfTest;
}

std::string toString(const NumericsSelfTest& selfTest) {
    if (!selfTest.measured) return "numerics not measured: " + selfTest.problem;
    char text[400];
    std::snprintf(
        text, sizeof text,
        "numerics %s: %d of %d decisions wrong, surface point within %.1f · 2^-23, distance within %.1f ulp%s",
        selfTest.holds() ? "exact" : "NOT EXACT", selfTest.wrong, selfTest.rays, selfTest.worstPoint,
        selfTest.worstAlong,
        selfTest.holds() ? ""
                         : "; this driver changes float arithmetic, so edges of far objects fray and specks "
                           "appear on them: update it, or use another");
    return text;
}

std::string toJson(const NumericsSelfTest& selfTest) {
    const nlohmann::ordered_json json{{"measured", selfTest.measured},
                                      {"holds", selfTest.holds()},
                                      {"rays", selfTest.rays},
                                      {"wrong", selfTest.wrong},
                                      {"worst_point", selfTest.worstPoint},
                                      {"worst_along", selfTest.worstAlong},
                                      {"milliseconds", selfTest.milliseconds},
                                      {"summary", toString(selfTest)}};
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace gnomon
