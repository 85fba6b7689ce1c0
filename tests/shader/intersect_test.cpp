/// Every shape's intersector on the GPU against the exact answer: hits and misses, t, surface point and normal, for all
/// classes of rays from 3 to 100 000 sizes away.
///
/// Bounds are those that the shapes' files state (lab/intersect/compare_hit.cpp holds them). GNOMON_RAYS says how many
/// rays a shape gets: 200 000 by default, `scripts/test shader --long` asks for 10 million.

#include "lab/intersect/compare_hit.h"
#include "lab/intersect/subjects.h"
#include "lab/reference/exact/fan.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/gl/gl.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace gnomon {
namespace {

using namespace test;
using namespace oracle;

constexpr double kDistances[] = {3, 10, 100, 1000, 10000, 100000};

/// Bounds are held on the GL that GNOMON_CONTEXT and GALLIUM_DRIVER name, OSMesa on llvmpipe by default.
void chooseGl() {
    const char* asked = std::getenv("GNOMON_CONTEXT");
    const auto kind = contextNamed(asked ? asked : "osmesa");
    ASSERT_TRUE(kind) << "GNOMON_CONTEXT=" << asked;
    offscreen(*kind);
    const char* driver = std::getenv("GALLIUM_DRIVER");
    const std::string renderer = gl::info().renderer;
    ASSERT_NE(renderer.find(driver ? driver : "llvmpipe"), std::string::npos) << renderer;
}

std::int64_t raysAShape() {
    const char* asked = std::getenv("GNOMON_RAYS");
    return asked ? std::atoll(asked) : 200000;
}

/// Classes and distances of all subjects of one shape.
int cellsOf(std::string_view shape) {
    int cells = 0;
    for (const auto* list : {&subjects(), &patches()})
        for (const Subject& subject : *list)
            for (const RayClass kind : kRayClasses)
                if (subject.shape == shape && fits(kind, subject)) cells += int(std::size(kDistances));
    return cells;
}

/// Patches are met as they are, not in a baked field of their distances.
RayBatch batchOf(const Shape& shape, Problems& problems, std::span<const ShaderFile> overrides = {}) {
    Settings settings;
    settings.surface = SurfaceMode::Patch;
    return {sceneOf({shape}), settings, 0, problems, overrides};
}

/// A wrong answer, to the last bit.
void describe(const Shape& shape, const BatchRay& ray, const BatchHit& answer) {
    const ExactShape<double> exactShape(shape);
    const ExactHit<double> exact = exactHit(exactShape, lineOf(exactShape, ray.origin, ray.direction));
    std::printf("  o = (%a, %a, %a), d = (%a, %a, %a): exactly %s at %.9Lg, %.3g sizes from deciding otherwise; told "
                "%s at %.9g\n",
                ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y, ray.direction.z,
                exact.hit ? "a hit" : "none", exact.t, exact.tangency / exactShape.size(),
                answer.object < 0 ? "none" : "a hit", answer.t);
}

class Intersect : public testing::TestWithParam<Subject> {};

TEST_P(Intersect, AnswersLikeTheOracleFromThreeToAHundredThousandSizes) {
    const Subject& subject = GetParam();
    ASSERT_NO_FATAL_FAILURE(chooseGl());
    const Bounds bounds = boundsOf(subject.geometry.kind);
    const std::int64_t each = raysAShape() / cellsOf(subject.shape) + 1;
    std::int64_t decided = 0, hits = 0;
    for (const RayClass kind : kRayClasses)
        for (const double distance : kDistances) {
            if (!fits(kind, subject)) continue;
            const Shape shape = placed(subject, kind, distance);
            Problems problems;
            RayBatch batch = batchOf(shape, problems);
            ASSERT_TRUE(batch.valid()) << toString(problems);
            RayStream stream(shape, kind, distance, std::uint64_t(distance) + std::uint64_t(kind));
            for (std::int64_t done = 0; done < each; done += 200000) {
                std::vector<BatchRay> rays(std::size_t(std::min<std::int64_t>(each - done, 200000)));
                for (BatchRay& ray : rays) ray = stream.next();
                const std::vector<BatchHit> answers = batch.trace(rays);
                const Tally tally = compareHits(shape, rays, answers);
                std::printf(
                    "%-9s %-8s %-8s %6.0f: %6ld rays, %6ld decided, %6ld hit, %ld missed, %ld invented, %ld elsewhere; "
                    "t %.2f ray %.2f ulp, point %.2f, normal %.2f, margin %.2f\n",
                    subject.shape.data(), subject.proportion.data(), nameOf(kind).data(), distance, tally.rays,
                    tally.decided, tally.hits, tally.missed, tally.invented, tally.elsewhere, tally.t.worst,
                    tally.ray.worst, tally.point.worst, tally.normal.worst, tally.worstMargin * 0x1p24);
                for (std::size_t i = 0; i < std::min<std::size_t>(tally.wrongRays.size(), 3); ++i)
                    describe(shape, rays[tally.wrongRays[i]], answers[tally.wrongRays[i]]);
                decided += tally.decided;
                hits += tally.hits;
                EXPECT_GE(tally.decidedFraction(), leastDecided(kind, subject.geometry.kind, distance));
                EXPECT_EQ(tally.missed, 0);
                EXPECT_EQ(tally.invented, 0);
                EXPECT_EQ(tally.elsewhere, 0);
                EXPECT_LE(tally.ray.worst, bounds.ray);
                EXPECT_LE(tally.point.worst, bounds.point);
                EXPECT_LE(tally.normal.worst, bounds.normal);
            }
        }
    EXPECT_GE(hits, decided / 20) << "t, points and normals are judged where a ray hits";
}

// Directions are unit to float32 in pictures; an intersector asks no more than that they are not 0.
TEST_P(Intersect, TakesDirectionsOfAnyLength) {
    const Subject& subject = GetParam();
    ASSERT_NO_FATAL_FAILURE(chooseGl());
    const Shape shape = placed(subject, RayClass::Uniform, 100);
    const Bounds bounds = boundsOf(subject.geometry.kind);
    Problems problems;
    RayBatch batch = batchOf(shape, problems);
    ASSERT_TRUE(batch.valid()) << toString(problems);
    for (const float length : {0.37f, 2.9f}) {
        RayStream stream(shape, RayClass::Uniform, 100, 9);
        std::vector<BatchRay> rays(std::size_t(std::min<std::int64_t>(raysAShape(), 20000)));
        for (BatchRay& ray : rays) {
            ray = stream.next();
            ray.direction *= length;
        }
        const Tally tally = compareHits(shape, rays, batch.trace(rays));
        EXPECT_EQ(tally.wrong(), 0) << length;
        EXPECT_LE(tally.point.worst, bounds.point) << length;
        EXPECT_LE(tally.normal.worst, bounds.normal) << length;
    }
}

// A ray that leaves a surface starts from the point that an earlier ray found, and names the side it travels on: it
// neither meets its own start again nor misses the rest of the shape.
TEST_P(Intersect, LetsARayLeaveTheSurfaceItStartsOn) {
    const Subject& subject = GetParam();
    ASSERT_NO_FATAL_FAILURE(chooseGl());
    const Shape shape = placed(subject, RayClass::Uniform, 10);
    const ExactShape<double> exactShape(shape);
    Problems problems;
    RayBatch batch = batchOf(shape, problems);
    ASSERT_TRUE(batch.valid()) << toString(problems);
    RayStream stream(shape, RayClass::Uniform, 10, 7);
    std::vector<BatchRay> first(std::size_t(raysAShape() / 6));
    for (BatchRay& ray : first) ray = stream.towardsSurface();
    std::vector<BatchRay> second;
    std::vector<double> clear; // by then the ray is farther from the surface than its start can be
    for (const BatchHit& hit : batch.trace(first))
        for (const float side : {1.0f, -1.0f}) {
            const Vec3<double> normal(hit.normal);
            Vec3<double> way = stream.direction();
            if (dot(way, normal) * side < 0) way = -way;
            if (hit.object < 0 || std::abs(dot(way, normal)) < 0.01) continue;
            second.push_back({hit.point, side, toFloat(way), 0});
            clear.push_back(0x1p-20 * exactShape.size() / std::abs(dot(way, normal)));
        }
    ASSERT_GT(second.size(), first.size());
    const std::vector<BatchHit> answers = batch.trace(second);
    int acne = 0, wrong = 0, decided = 0;
    for (std::size_t i = 0; i < second.size(); ++i) {
        const Line<double> line = lineOf(exactShape, second[i].origin, second[i].direction);
        const bool got = answers[i].object >= 0;
        if (exactShape.flat()) {
            acne += got;
            continue;
        }
        const Vec3<double> start(Vec3<long double>(second[i].origin) - exactShape.middle());
        const ExactHit<double> exact = exactHit(exactShape, line, clear[i], 4);
        // Two faces at once, or the tip of a cone: the shortest way through it that leaves at this angle.
        const double cosine = 0x1p-20 * exactShape.size() / clear[i],
                     thin = std::min(exactShape.toEdge(start), cosine * exactShape.bend(start));
        if (exact.tangency < 0x1p-21 * exactShape.size() || thin < 1e-5 * exactShape.size() + 2 * clear[i]) continue;
        ++decided;
        acne += got && answers[i].t < clear[i];
        wrong += exact.hit != got || (got && leavesSurface(exactShape, line, exact.s, line.local(answers[i].t),
                                                           0x1p-20 * exactShape.size()));
    }
    std::printf("%s: %zu rays leave the surface, %d decided\n", subject.name().c_str(), second.size(), decided);
    EXPECT_EQ(acne, 0);
    EXPECT_EQ(wrong, 0);
    if (!exactShape.flat()) {
        EXPECT_GT(decided, int(second.size()) * 8 / 10);
    }
}

INSTANTIATE_TEST_SUITE_P(Subjects, Intersect, testing::ValuesIn(subjects()),
                         [](const auto& test) { return test.param.name(); });
INSTANTIATE_TEST_SUITE_P(Patches, Intersect, testing::ValuesIn(patches()),
                         [](const auto& test) { return test.param.name(); });

/// An intersector with one thought left out, and rays that it is wrong for.
struct Mutant {
    const char* name;
    std::string subject;
    RayClass kind;
    double distance;
    const char *file, *line, *becomes;
};
std::ostream& operator<<(std::ostream& out, const Mutant& mutant) { return out << mutant.name; }

const Mutant kMutants[] = {
    {"sphereWithoutSecondFoot", "sphere", RayClass::Grazing, 10000, "primitive/sphere.glsl",
     "    foot = near.origin + fromNear * direction;", "    foot = near.origin;"},
    {"spherePointOnTheFarSide", "sphere", RayClass::Uniform, 10, "primitive/sphere.glsl", "normalize(t < middle ? ",
     "normalize(t > middle ? "},
    {"boxWithoutExactDifference", "boxfat", RayClass::Grazing, 10000, "ray/split.glsl",
     "    return (a - (difference - minusB)) - (b + minusB);", "    return vec3(0.0);"},
    {"boxLeavesAtTheNearSide", "boxfat", RayClass::Inside, 3, "primitive/box.glsl", "largestAxis(-leave)",
     "largestAxis(leave)"},
    {"torusWithoutTheLowHalf", "torusquarter", RayClass::Grazing, 10000, "ray/split.glsl",
     "    vec3 low = optimisationBarrier(direction - high);", "    vec3 low = vec3(0.0);"},
    // Nothing changes where the compiler takes the root's square for exact.
    {"torusWithTooMuchOfWhatItsRootLost", "torusquarter", RayClass::Uniform, 10, "primitive/torus.glsl",
     "* fromAxis + q * lost;", "* fromAxis + 100.0 * q * lost;"},
    {"ellipsoidWithTheNormalOfASphere", "ellipsoidfat", RayClass::Uniform, 10, "primitive/ellipsoid.glsl",
     "    vec3 normal = gradient / steep;", "    vec3 normal = u;"},
    {"ellipsoidPutBackAlongItself", "ellipsoidthin", RayClass::Axis, 3, "primitive/ellipsoid.glsl",
     "    u = normalize(u - 0.5", "    u = normalize(u - 0.0"},
    {"rotatedBoxRotatedTheOtherWay", "rotated_boxfat", RayClass::Uniform, 10, "primitive/rotated_box.glsl",
     "near.origin * rotated.axes, ray.direction * rotated.axes, enter",
     "rotated.axes * near.origin, rotated.axes * ray.direction, enter"},
    {"patchThatTakesAnyRootForTheFirst", "height_patchsteep", RayClass::Uniform, 10, "primitive/height_patch.glsl",
     "if (a.x >= 0.0 && min(fall.x, min(fall.y, fall.z)) >= 0.0)", "if (a.x >= 0.0 && b.w < 0.0)"},
    {"patchWithoutItsRim", "height_patchgentle", RayClass::Grazing, 10, "primitive/height_patch.glsl",
     "slabSpan(seen.origin.z, seen.direction.z, 0.5)", "slabSpan(seen.origin.z, seen.direction.z, 0.5001)"},
    {"cylinderByTheTextbooksDiscriminant", "cylinderthin", RayClass::Grazing, 3, "primitive/convex.glsl",
     "    float discriminant = a * (radius - l) * (radius + l);",
     "    float discriminant = b * b - a * (radial * radial - radius * radius);"},
};

class IntersectMutant : public testing::TestWithParam<Mutant> {};

// The comparison itself: the library's intersector passes on 20 000 rays, the same with one line changed does not.
TEST_P(IntersectMutant, TurnsTheJudgeRed) {
    const Mutant& mutant = GetParam();
    ASSERT_NO_FATAL_FAILURE(chooseGl());
    const auto& list = mutant.subject.starts_with("height_patch") ? patches() : subjects();
    const auto subject =
        std::find_if(list.begin(), list.end(), [&](const auto& s) { return s.name() == mutant.subject; });
    ASSERT_NE(subject, list.end()) << mutant.subject;
    std::string text(shaderText(mutant.file));
    const std::size_t at = text.find(mutant.line);
    ASSERT_NE(at, std::string::npos) << mutant.file << " has no `" << mutant.line << "`";
    text.replace(at, std::string_view(mutant.line).size(), mutant.becomes);
    const ShaderFile overrides[] = {{mutant.file, text}};

    const Shape shape = placed(*subject, mutant.kind, mutant.distance);
    RayStream stream(shape, mutant.kind, mutant.distance, 1);
    std::vector<BatchRay> rays(20000);
    for (BatchRay& ray : rays) ray = stream.next();
    Problems problems;
    RayBatch sound = batchOf(shape, problems), mutated = batchOf(shape, problems, overrides);
    ASSERT_TRUE(sound.valid() && mutated.valid()) << toString(problems);
    const Tally good = compareHits(shape, rays, sound.trace(rays)), bad = compareHits(shape, rays, mutated.trace(rays));
    for (const Tally* tally : {&good, &bad})
        std::printf("%s%s: %ld wrong of %ld, ray %.2f ulp, point %.2f, normal %.2f, margin %.2f\n", mutant.name,
                    tally == &good ? ", sound" : "", tally->wrong(), tally->decided, tally->ray.worst,
                    tally->point.worst, tally->normal.worst, tally->worstMargin * 0x1p24);
    EXPECT_TRUE(within(good, boundsOf(shape.kind)));
    EXPECT_FALSE(within(bad, boundsOf(shape.kind)));
}

INSTANTIATE_TEST_SUITE_P(Mutants, IntersectMutant, testing::ValuesIn(kMutants),
                         [](const auto& test) { return std::string(test.param.name); });

class Watertight : public testing::TestWithParam<glm::dvec3> {};

TEST_P(Watertight, LetsNoRayThroughAnEdgeOrAVertex) {
    ASSERT_NO_FATAL_FAILURE(chooseGl());
    Fan fan(GetParam());
    Problems problems;
    RayBatch batch(sceneOf(fan.triangles()), problems);
    ASSERT_TRUE(batch.valid()) << toString(problems);
    for (const double distance : {5.0, 500.0}) {
        std::vector<BatchRay> rays(std::size_t(raysAShape()), BatchRay{});
        for (BatchRay& ray : rays) ray = fan.next(distance);
        int leaks = 0;
        for (const BatchHit& hit : batch.trace(rays)) leaks += hit.object < 0;
        EXPECT_EQ(leaks, 0) << distance;
    }
}

INSTANTIATE_TEST_SUITE_P(Places, Watertight, testing::Values(glm::dvec3(0), glm::dvec3(148376, 1234, -223423)),
                         [](const auto& test) { return test.param.x == 0 ? "AtTheOrigin" : "FarAway"; });

} // namespace
} // namespace gnomon
