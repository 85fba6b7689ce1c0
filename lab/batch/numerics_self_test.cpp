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

constexpr double kFar = 1e4;   // units from the rays' origins to the shapes
constexpr int kRaysEach = 512; // uniform ones and grazing ones of each shape
constexpr int kChoice = 8;     // grazing rays made for each one taken, the nearest to tangency
constexpr double kPi = 3.14159265358979323846;

// Numbers with all their bits, coordinates about 1, and room between the two.
constexpr const char* kScene = R"({"objects": [
    {"sphere": {"center": [-0.7132869, 0.6417531, -0.5928173], "radius": 1}},
    {"torus": {"center": [0.7294183, -0.6328497, 0.6117359], "axis": [0.5317294, 0.6982311, -0.4791357],
               "major_radius": 1, "minor_radius": 0.25}}]})";

/// A sphere or a torus as the shader has it: from its numbers in float.
struct TestShape {
    Vec center;
    double major = 0, minor = 0; // a sphere where major is 0
    Vec axis{0, 0, 1};

    explicit TestShape(const Shape& shape) {
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

double along(const TestShape& shape, const BatchRay& ray, double t) {
    return shape.distance(Vec(ray.origin) + t * Vec(ray.direction));
}

/// Ray parameter of the closest approach to the shape's centre.
double middleOf(const TestShape& shape, const BatchRay& ray) {
    const Vec d(ray.direction);
    return glm::dot(shape.center - Vec(ray.origin), d) / glm::dot(d, d);
}

Truth solveSphere(const TestShape& shape, const BatchRay& ray) {
    const double middle = middleOf(shape, ray), passes = along(shape, ray, middle); // > 0: the ray passes by
    if (passes > 0) return {false, 0, passes};
    const double half = std::sqrt(-passes * (passes + 2 * shape.minor)) / glm::length(Vec(ray.direction));
    return {true, middle - half, -passes};
}

/// The bottom of a dip of the distance between two ray parameters.
double bottomOf(const TestShape& shape, const BatchRay& ray, double low, double high) {
    for (int i = 0; i < 45; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (along(shape, ray, a) < along(shape, ray, b))
            high = b;
        else
            low = a;
    }
    return (low + high) / 2;
}

double entryBetween(const TestShape& shape, const BatchRay& ray, double outside, double inside) {
    for (int i = 0; i < 50; ++i) {
        const double middle = (outside + inside) / 2;
        (along(shape, ray, middle) < 0 ? inside : outside) = middle;
    }
    return (outside + inside) / 2;
}

/// Knows nothing of the torus but its signed distance: samples it, and searches every dip for its bottom.
Truth solveTorus(const TestShape& shape, const BatchRay& ray) {
    constexpr int kSamples = 128;
    const double reach = 1.02 * shape.size(), step = 2 * reach / kSamples;
    const double from = middleOf(shape, ray) - reach;
    Truth truth;
    double outside = from, before = along(shape, ray, from), here = along(shape, ray, from + step);
    for (int i = 1; i < kSamples && !truth.hit; ++i) {
        const double t = from + i * step, next = along(shape, ray, t + step);
        if (here <= before && here <= next) {
            const double bottom = bottomOf(shape, ray, t - step, t + step), depth = along(shape, ray, bottom);
            truth.tangency = std::min(truth.tangency, std::abs(depth));
            truth.hit = depth < 0;
            if (truth.hit) truth.t = entryBetween(shape, ray, outside, bottom);
        }
        if (here > 0) outside = t;
        before = here;
        here = next;
    }
    return truth;
}

Truth solve(const TestShape& shape, const BatchRay& ray) {
    return shape.major == 0 ? solveSphere(shape, ray) : solveTorus(shape, ray);
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
BatchRay uniformRay(const TestShape& shape, Random& random) {
    const Vec origin = shape.center + kFar * random.direction();
    const Vec aim = shape.center + shape.size() * std::cbrt(random.number(0, 1)) * random.direction();
    return rayFrom(origin, aim - origin);
}

/// Tangent to the shape, but for the rounding of its far origin.
BatchRay grazingRay(const TestShape& shape, Random& random) {
    Vec normal = random.direction(), ring = glm::cross(shape.axis, normal);
    if (shape.major > 0) { // turned about a direction along the ring, any position on the tube
        const double around = random.number(0, 2 * kPi);
        const Vec across = glm::normalize(ring), out = glm::cross(across, shape.axis);
        normal = std::cos(around) * out + std::sin(around) * shape.axis;
        ring = shape.major * out;
    } else {
        ring = Vec(0);
    }
    const Vec point = shape.center + ring + shape.minor * normal;
    const Vec way = glm::normalize(glm::cross(normal, random.direction()));
    return rayFrom(point - kFar * way, way);
}

/// A ray with its truth.
struct Case {
    BatchRay ray;
    Truth truth;
};

/// Far enough from tangency for float32 to decide, and out of the other shape's way.
bool isClear(const Case& one, const TestShape& shape, const TestShape& other) {
    const double passes =
        glm::length(Vec(one.ray.origin) + middleOf(other, one.ray) * Vec(one.ray.direction) - other.center);
    return one.truth.tangency > std::ldexp(shape.size(), -22) && passes > 1.01 * other.size();
}

template<class Make>
Case clearCase(const TestShape& shape, const TestShape& other, Make make) {
    for (;;) {
        Case one;
        one.ray = make();
        one.truth = solve(shape, one.ray);
        if (isClear(one, shape, other)) return one;
    }
}

std::vector<Case> casesOf(const TestShape& shape, const TestShape& other, Random& random) {
    std::vector<Case> cases;
    for (int i = 0; i < kRaysEach; ++i) {
        cases.push_back(clearCase(shape, other, [&] { return uniformRay(shape, random); }));
        Case nearest;
        for (int j = 0; j < kChoice; ++j) {
            const Case one = clearCase(shape, other, [&] { return grazingRay(shape, random); });
            if (one.truth.tangency < nearest.truth.tangency) nearest = one;
        }
        cases.push_back(nearest);
    }
    return cases;
}

double ulp(double x) { return std::ldexp(1.0, std::ilogb(x) - 23); }

/// The ray stops on another sheet: between where it should stop and where it does it is off the surface.
bool isElsewhere(const TestShape& shape, const Case& one, double t) {
    const double slack = 4 * (ulp(one.truth.t) + ulp(shape.size()));
    for (int i = 0; i <= 32; ++i)
        if (!(std::abs(along(shape, one.ray, one.truth.t + (t - one.truth.t) * i / 32)) <= slack)) return true;
    return false;
}

void compareHit(const TestShape& shape, int object, const Case& one, const BatchHit& hit, NumericsSelfTest& selfTest) {
    ++selfTest.rays;
    if (!one.truth.hit && hit.object < 0) return;
    const double off = shape.distance(Vec(hit.point));
    if (!one.truth.hit || hit.object != object || !std::isfinite(off) || isElsewhere(shape, one, hit.t)) {
        ++selfTest.wrong;
        return;
    }
    selfTest.worstPoint = std::max(selfTest.worstPoint, std::abs(off) / std::ldexp(shape.size(), -23));
    selfTest.worstAlong = std::max(selfTest.worstAlong, std::abs(along(shape, one.ray, hit.t)) / ulp(one.truth.t));
}

void measure(RayBatch& batch, const Scene& scene, NumericsSelfTest& selfTest) {
    const TestShape shapes[] = {TestShape(scene.objects[0].shape), TestShape(scene.objects[1].shape)};
    Random random;
    std::vector<Case> cases;
    for (const int i : {0, 1}) {
        const std::vector<Case> more = casesOf(shapes[i], shapes[1 - i], random);
        cases.insert(cases.end(), more.begin(), more.end());
    }
    std::vector<BatchRay> rays;
    for (const Case& one : cases) rays.push_back(one.ray);
    const std::vector<BatchHit> hits = batch.trace(rays);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const int object = i < cases.size() / 2 ? 0 : 1; // as in the scene: spheres come before tori
        compareHit(shapes[object], object, cases[i], hits[i], selfTest);
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
