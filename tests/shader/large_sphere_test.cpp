/// Huge spheres on the GPU against a long-double oracle: from just above the ground, from inside, from elsewhere, from
/// far away.
///
/// Which sphere is meant: the one of the scene's double-precision numbers, not of centre and radius in float32.
/// Bounds (docs/numerics.md)  with D the distance from the anchor, which lies under the eye: no wrong decision further
/// than 2^-22 D of the tangent point from tangency; t within 1 ulp + 2^-22 D / cosine; the surface point within
/// 2^-22 D of the surface, and half an ulp of its own coordinates; normals within 3e-7 of the exact one.

#include "lab/reference/exact/scene_hit.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "lab/batch/ray_batch.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdarg>
#include <optional>
#include <random>

namespace gnomon {
namespace {

using namespace test;
using oracle::pixelRay;
using oracle::Vec;
using Real = long double;

constexpr Real kPi = 3.14159265358979323846L;

Real ulp(Real x) { return std::ldexp(1.0L, std::ilogb(x) - 23); }

std::string format(const char* pattern, ...) {
    char text[1000];
    va_list values;
    va_start(values, pattern);
    std::vsnprintf(text, sizeof text, pattern, values);
    va_end(values);
    return text;
}

std::string text(Vec v) { return format("[%.17Lg, %.17Lg, %.17Lg]", v.x, v.y, v.z); }

/// A sphere that passes the origin closely, with a tilted ground and numbers that float32 does not hold.
struct Ground {
    Real radius;
    Vec up, along, across; ///< at the origin
    Vec center;

    explicit Ground(Real r) : radius(r * 1.0000001234567L), up(glm::normalize(Vec(0.3123L, 0.8765L, -0.4321L))) {
        along = glm::normalize(glm::cross(up, Vec(0, 0, 1)));
        across = glm::cross(along, up);
        const glm::dvec3 held(Vec(0.1234567L, -0.2345678L, 0.3456789L) - radius * up);
        radius = double(radius); // what the scene's doubles hold
        center = Vec(held);
    }
    Real distance(Vec p) const { return glm::length(p - center) - radius; }
    /// The point `height` above the ground, x along it and z across it from the place under the eye.
    Vec over(Real x, Real z, Real height) const {
        return center + (radius + height) * glm::normalize(radius * up + x * along + z * across);
    }
    /// The camera stands so near to the ground that it is drawn as a globe, about the point over(0, 0, 0).
    std::string json(const std::string& more = "") const {
        return R"({"camera": {"eye": )" + text(over(0, 0, radius / 1000)) + R"(, "target": )" + text(over(1, 0, 0)) +
               R"(}, "objects": [)" + sphere() + more + "]}";
    }
    std::string sphere() const {
        return R"({"sphere": {"center": )" + text(center) + format(R"(, "radius": %.17Lg}})", radius);
    }
};

/// How far float32 may put the surface off at a point D from the anchor: the bent plane's terms are D and D² / 2r
/// large.
Real boundAt(const Ground& ground, Vec p) {
    const Real away = glm::length(p - ground.over(0, 0, 0));
    return std::ldexp(away * (1 + away / (2 * ground.radius)), -22);
}

/// Both roots along a ray, and how far it is from tangency, about the closest approach to the centre.
struct Chord {
    Real entry = 0, leave = 0;
    Real depth;  ///< of the closest approach below the surface; negative where the ray passes by
    Vec deepest; ///< the point of closest approach
    Real t;      ///< where that is

    Chord(Vec center, Real radius, Vec o, Vec d) {
        const Vec toOrigin = o - center;
        const Real a = glm::dot(d, d);
        t = -glm::dot(toOrigin, d) / a;
        const Real gap = glm::length(toOrigin + t * d);
        depth = radius - gap;
        deepest = o + t * d;
        const Real half = depth > 0 ? std::sqrt(depth * (radius + gap) / a) : 0;
        entry = t - half;
        leave = t + half;
    }
};

class Rays {
  public:
    Rays(const Ground& ground, unsigned seed) : ground_(ground), random_(seed) {}

    BatchRay downward(Vec from) {
        Vec way = direction();
        if (glm::dot(way, up(from)) > 0) way = -way;
        return ray(from, way);
    }
    BatchRay anywhere(Vec from) { return ray(from, direction()); }
    /// Towards the horizon but for up to 2 % of its dip, log-uniform.
    BatchRay horizon(Vec from) {
        const Vec out = up(from);
        const Real dip = std::acos(ground_.radius / glm::length(Vec(glm::vec3(from)) - ground_.center));
        const Real offset = std::pow(10.0L, number(-5, std::log10(0.02L))) * (number(0, 1) < 0.5L ? -1 : 1);
        const Vec side = direction();
        const Vec level = glm::normalize(side - glm::dot(side, out) * out);
        const Real angle = dip * (1 + offset);
        return ray(from, std::cos(angle) * level - std::sin(angle) * out);
    }
    /// From far away towards a point of the sphere or just beside it.
    BatchRay towards(Vec from) { return ray(from, ground_.center + 1.02L * ground_.radius * direction() - from); }

    Vec direction() {
        const Real z = number(-1, 1), around = number(0, 2 * kPi), r = std::sqrt(1 - z * z);
        return {r * std::cos(around), r * std::sin(around), z};
    }
    Real number(Real low, Real high) { return low + (high - low) * Real(random_() >> 11) * 0x1p-53L; }

  private:
    Vec up(Vec from) const { return glm::normalize(from - ground_.center); }
    static BatchRay ray(Vec from, Vec way) {
        BatchRay ray;
        ray.origin = glm::vec3(from);
        ray.direction = glm::vec3(glm::normalize(way));
        return ray;
    }

    const Ground& ground_;
    std::mt19937_64 random_;
};

/// What the GPU got wrong in a set of rays; the worst errors as shares of what the bounds allow.
struct Faults {
    int compared = 0, wrong = 0;
    Real inBand = 0; ///< worst wrong decision's distance from tangency: within the band by construction
    Real t = 0, point = 0, normal = 0;

    void compare(const Ground& ground, const BatchRay& ray, const BatchHit& hit);
    void comparePoint(const Ground& ground, const BatchHit& hit);
    void expectNone(const std::string& what, int rays) const {
        std::printf("%-44s %6d compared, %d wrong (in the band up to %.2Lf of it); of the bounds: t %.2Lf, point %.2Lf, "
                    "normal %.2Lf\n",
                    what.c_str(), compared, wrong, inBand, t, point, normal);
        EXPECT_GE(compared, rays) << what;
        EXPECT_EQ(wrong, 0) << what;
        EXPECT_LE(t, 1.0L) << what;
        EXPECT_LE(point, 1.0L) << what;
        EXPECT_LE(normal, 1.0L) << what;
    }
};

void Faults::compare(const Ground& ground, const BatchRay& ray, const BatchHit& hit) {
    const Vec o(ray.origin), d(ray.direction);
    const Chord chord(ground.center, ground.radius, o, d);
    const bool inside = ray.side < 0 || (ray.side == 0 && ground.distance(o) < 0);
    const Real wanted = inside ? chord.leave : chord.entry;
    const bool hits = ray.side <= 0 && chord.depth > 0 && (inside || wanted > 0);
    const bool got = hit.object >= 0;
    // A ray from inside always leaves; one from outside may only graze, where the tangent point lies ahead.
    const Real band = boundAt(ground, chord.deepest);
    if (!inside && chord.t > 0 && std::abs(chord.depth) < band) {
        if (hits != got) inBand = std::max(inBand, std::abs(chord.depth) / band);
        return;
    }
    ++compared;
    wrong += hits != got;
    if (!hits || !got) return;
    const Vec met = o + wanted * d;
    const Real cosine = std::abs(glm::dot(d, met - ground.center)) / ground.radius;
    const Real allowed = ulp(wanted) + boundAt(ground, met) / cosine;
    t = std::max(t, std::abs(Real(hit.t) - wanted) / allowed);
    comparePoint(ground, hit);
}

void Faults::comparePoint(const Ground& ground, const BatchHit& hit) {
    const Vec p(hit.point), n(hit.normal), size = glm::abs(p);
    // Each coordinate is rounded by half an ulp, which counts by the normal's share of it.
    const Real rounding = (ulp(size.x) * std::abs(n.x) + ulp(size.y) * std::abs(n.y) + ulp(size.z) * std::abs(n.z)) / 2;
    point = std::max(point, std::abs(ground.distance(p)) / (boundAt(ground, p) + rounding));
    normal = std::max(normal, glm::length(n - glm::normalize(p - ground.center)) / 3e-7L);
}

class LargeSphere : public testing::TestWithParam<double> {
  protected:
    const Ground ground{GetParam()};
    std::unique_ptr<RayBatch> batch;

    void SetUp() override {
        offscreen();
        const Scene scene = sceneFrom(ground.json());
        ASSERT_EQ(drawnKinds(scene)[0], ShapeKind::LargeSphere);
        Problems problems;
        batch = std::make_unique<RayBatch>(scene, problems);
        ASSERT_TRUE(batch->valid()) << toString(problems);
    }
    template<class Make>
    Faults faultsOf(int count, const Make& make) {
        std::vector<BatchRay> rays(std::size_t(count), BatchRay{});
        for (BatchRay& ray : rays) ray = make();
        const std::vector<BatchHit> hits = batch->trace(rays);
        Faults faults;
        for (std::size_t i = 0; i < rays.size(); ++i) faults.compare(ground, rays[i], hits[i]);
        return faults;
    }
};

constexpr int kEach = 20000; // rays of each kind at each height
const Real kHeights[] = {0.01L, 1, 100};

TEST_P(LargeSphere, IsMetLikeTheOracleSaysFromAboveTheGround) {
    for (const Real height : kHeights) {
        const Vec eye = ground.over(0, 0, height);
        Rays rays(ground, 1);
        faultsOf(kEach, [&] {
            return rays.downward(eye);
        }).expectNone(format("r %g, %Lg above, downward", GetParam(), height), kEach * 95 / 100);
        faultsOf(kEach, [&] {
            return rays.horizon(eye);
        }).expectNone(format("r %g, %Lg above, horizon", GetParam(), height), kEach * 3 / 10);
    }
}

TEST_P(LargeSphere, IsMetLikeTheOracleSaysFromInside) {
    for (const Real depth : kHeights) {
        if (depth > ground.radius) continue;
        const Vec eye = ground.over(0, 0, -depth);
        Rays rays(ground, 2);
        faultsOf(kEach, [&] {
            return rays.anywhere(eye);
        }).expectNone(format("r %g, %Lg below, anywhere", GetParam(), depth), kEach);
    }
}

// The anchor lies under the eye, but rays start at mirrors and glass elsewhere, too.
TEST_P(LargeSphere, IsMetLikeTheOracleSaysFromFarFromItsAnchor) {
    for (const Real away : {0.01L, 0.1L, 0.5L, 1.0L, 1.5L}) {
        const Real height = ground.radius * 1e-3L;
        const Vec from = ground.center + (ground.radius + height) *
                                             glm::normalize(std::cos(away) * ground.up + std::sin(away) * ground.along);
        Rays rays(ground, 3);
        faultsOf(kEach, [&] {
            return rays.downward(from);
        }).expectNone(format("r %g, %.2Lf rad from the anchor, downward", GetParam(), away), kEach * 9 / 10);
        faultsOf(kEach, [&] {
            return rays.horizon(from);
        }).expectNone(format("r %g, %.2Lf rad from the anchor, horizon", GetParam(), away), kEach * 3 / 10);
    }
}

TEST_P(LargeSphere, IsMetLikeTheOracleSaysFromFarAway) {
    for (const Real far : {2.0L, 10.0L, 100.0L})
        for (const bool aboveAnchor : {true, false}) {
            Rays rays(ground, 4);
            const Vec way = aboveAnchor ? ground.up : glm::normalize(ground.along - 0.3L * ground.up);
            const Vec from = ground.center + far * ground.radius * way;
            faultsOf(kEach, [&] { return rays.towards(from); })
                .expectNone(format("r %g, %Lg r away, %s", GetParam(), far, aboveAnchor ? "above" : "aside"),
                            kEach * 9 / 10);
        }
}

// A ray that starts on the ground leaves it for good, or meets the far side: never its own start.
TEST_P(LargeSphere, IsNotMetAgainByRaysThatStartOnIt) {
    const Vec eye = ground.over(0, 0, std::min<Real>(1, ground.radius / 1000));
    Rays rays(ground, 5);
    std::vector<BatchRay> first(kEach);
    for (BatchRay& ray : first) ray = rays.downward(eye);
    std::vector<BatchRay> outward, inward;
    for (const BatchHit& hit : batch->trace(first)) {
        if (hit.object < 0) continue;
        BatchRay ray;
        ray.origin = hit.point;
        const Vec way = rays.direction();
        ray.direction = glm::vec3(glm::dot(way, Vec(hit.normal)) < 0 ? -way : way);
        ray.side = 1;
        outward.push_back(ray);
        ray.direction = -ray.direction;
        ray.side = -1;
        inward.push_back(ray);
    }
    ASSERT_GT(outward.size(), std::size_t(kEach) * 9 / 10);
    int acne = 0;
    for (const BatchHit& hit : batch->trace(outward)) acne += hit.object >= 0;
    EXPECT_EQ(acne, 0);
    const std::vector<BatchHit> leaving = batch->trace(inward);
    Faults faults;
    for (std::size_t i = 0; i < inward.size(); ++i) {
        const Vec o(inward[i].origin), d(inward[i].direction);
        if (std::abs(glm::dot(d, glm::normalize(o - ground.center))) < 1e-3L) continue; // along the ground
        faults.compare(ground, inward[i], leaving[i]);
    }
    faults.expectNone(format("r %g, from the ground inward", GetParam()), int(inward.size()) * 9 / 10);
}

INSTANTIATE_TEST_SUITE_P(Radii, LargeSphere, testing::Values(1e4, 1e3, 9e5, 1.0),
                         [](const auto& test) { return format("%.0f", test.param); });

/// Balls that lie on the ground, in the shader's float32 numbers.
struct Ball {
    Vec center;
    Real radius;
};

struct Landscape {
    Ground ground{1e4};
    Vec light;
    std::vector<Ball> balls;

    /// Five balls about the place x along the ground.
    explicit Landscape(Real x) : light(glm::vec3(ground.over(x + 30, 15, 20))) {
        for (const auto& [along, across, radius] :
             {std::array{0.0L, 0.0L, 0.5L}, {1, 1.1L, 0.2L}, {2, -1, 0.1L}, {3.5L, -0.4L, 0.02L}, {5.5L, 0.2L, 0.005L}})
            balls.push_back({Vec(glm::vec3(ground.over(x - along, across, radius))), Real(float(radius))});
    }
    Scene scene() const {
        std::string more;
        for (const Ball& ball : balls)
            more += R"(, {"sphere": {"center": )" + text(ball.center) + format(R"(, "radius": %.17Lg}})", ball.radius);
        Scene scene = sceneFrom(ground.json(more));
        scene.lights = {{glm::dvec3(light)}};
        return scene;
    }
    /// What the ray meets first, the ground being 0, and t; -1 where it meets nothing.
    int first(Vec o, Vec d, Real& t, int besides = -1) const {
        t = 1e30L;
        int object = -1;
        for (int i = 0; i <= int(balls.size()); ++i) {
            const Vec center = i == 0 ? ground.center : balls[std::size_t(i - 1)].center;
            const Chord chord(center, i == 0 ? ground.radius : balls[std::size_t(i - 1)].radius, o, d);
            if (i == besides || chord.depth <= 0 || chord.entry <= 0 || chord.entry >= t) continue;
            t = chord.entry;
            object = i;
        }
        return object;
    }
    /// Object and light fraction as the outputs have them.
    std::pair<int, int> seen(Vec o, Vec d) const {
        Real t, shade;
        const int object = first(o, d, t);
        if (object < 0) return {object, 1};
        const Vec p = o + t * d, toLight = light - p;
        const Vec normal = p - (object == 0 ? ground.center : balls[std::size_t(object - 1)].center);
        if (glm::dot(toLight, normal) <= 0) return {object, 0};
        const bool dark = first(p, glm::normalize(toLight), shade, object) >= 0 && shade < glm::length(toLight);
        return {object, dark ? 0 : 1};
    }
};

/// Pixels whose object or shadow is not the oracle's though the rays 2^-21 rad about it all agree; `unsure` counts
/// those where they do not.
struct PictureFaults {
    int wrong = 0, unsure = 0, dark = 0;
    PictureFaults(const Landscape& landscape, const CameraPose& pose, const FloatImage& object,
                  const FloatImage& light) {
        const CameraFrame frame = frameOf(pose);
        for (int y = 0; y < object.height; ++y)
            for (int x = 0; x < object.width; ++x) {
                Vec o, d;
                pixelRay(pose, x, y, object.width, object.height, o, d);
                const auto wanted = landscape.seen(o, d);
                bool sure = true;
                for (const Vec aside : {Vec(frame.up), Vec(frame.right), -Vec(frame.up), -Vec(frame.right)})
                    sure &= landscape.seen(o, glm::normalize(d + std::ldexp(1.0L, -21) * aside)) == wanted;
                unsure += !sure;
                wrong += sure && wanted != std::pair(int(*object.at(x, y)), int(*light.at(x, y)));
                dark += wanted.first == 0 && wanted.second == 0;
            }
    }
};

// Small balls on a large ground, where the scene's camera stands and far from there.
TEST(LargeSpherePicture, ShowsEveryPixelOfObjectsAndShadowsLikeTheOracle) {
    for (const Real place : {0.0L, 3000.0L})
        for (const Real height : {1.0L, 0.05L}) {
            SCOPED_TRACE(format("%Lg from the scene's camera, %Lg above the ground", place, height));
            const Landscape landscape(place);
            const Scene scene = landscape.scene();
            CameraPose pose = scene.camera;
            pose.eye = glm::dvec3(landscape.ground.over(place - 6, 0, height));
            pose.target = glm::dvec3(landscape.ground.over(place, 0, height * 0.6L));
            pose.up = glm::dvec3(landscape.ground.up);
            pose.fov = 50;
            const auto output = [&](Aov aov) {
                Settings settings;
                settings.size = {320, 240};
                settings.aov = aov;
                Drawing drawing(scene, settings);
                drawing.view.camera = pose;
                return drawing.output();
            };
            offscreen();
            const PictureFaults faults(landscape, pose, output(Aov::Object), output(Aov::Visibility));
            std::printf("%4Lg along, %4Lg above: %d wrong, %d unsure of %d pixels, %d of the ground in shadow\n", place,
                        height, faults.wrong, faults.unsure, 320 * 240, faults.dark);
            EXPECT_EQ(faults.wrong, 0);
            EXPECT_LE(faults.unsure, 320 * 240 / 500);
            EXPECT_GT(faults.dark, 10);
        }
}

// One sphere, drawn as a globe because the scene's camera stands close to it, and as a sphere because it does not. On
// textures they differ by 3e-4 rad of latitude, the error of the drivers' acos, which the globe does without.
TEST(LargeSpherePicture, IsThatOfTheSphere) {
    const auto scene = [](const char* eye, const char* optics) {
        return sceneFrom(std::string(R"({"camera": {"eye": )") + eye + R"(, "target": [0, 0, 0]},
            "background": {"color": [0.2, 0.5, 0.8]}, "lights": [{"point": {"position": [4, 5, 6]}}],
            "materials": {"m": {"ambient": 0.3, "diffuse": 0.7)" +
                         optics + R"(}}, "objects": [
            {"sphere": {"center": [0.1, 0.2, 0.3], "radius": 1}, "material": "m"}]})");
    };
    Settings settings;
    settings.size = {200, 200};
    settings.eye = glm::dvec3(1, 2, 3);
    settings.target = glm::dvec3(0, 0, 0);
    for (const char* optics :
         {R"(, "texture": "earth-color", "normal_map": "earth-normal")", R"(, "dielectric": {"ior": 1.5})"}) {
        const Scene near = scene("[0.1, 0.2, 1.301]", optics), far = scene("[1, 2, 3]", optics);
        ASSERT_EQ(drawnKinds(near)[0], ShapeKind::LargeSphere);
        ASSERT_EQ(drawnKinds(far)[0], ShapeKind::Sphere);
        const FloatImage globe = outputOf(near, settings, Aov::Color), sphere = outputOf(far, settings, Aov::Color);
        double worst = 0, sum = 0;
        for (std::size_t i = 0; i < globe.pixels.size(); ++i) {
            const double difference = std::abs(double(globe.pixels[i]) - sphere.pixels[i]);
            worst = std::max(worst, difference);
            sum += difference;
        }
        std::printf("%s: worst difference %.2g, mean %.2g\n", optics, worst, sum / double(globe.pixels.size()));
        EXPECT_LE(worst, std::string(optics).find("texture") == std::string::npos ? 1e-4 : 0.01) << optics;
        EXPECT_LE(sum / double(globe.pixels.size()), 1e-4) << optics;
    }
}

} // namespace
} // namespace gnomon
