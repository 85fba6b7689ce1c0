/// The oracle against itself in 50 digits and with three times the samples: what double, long double and the steps
/// along a ray leave open is far below what it decides. And compareHits() on answers that are right, and wrong in one
/// thing.

#include "lab/intersect/compare_hit.h"
#include "lab/intersect/subjects.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

namespace gnomon::oracle {
namespace {

using Digits50 = boost::multiprecision::cpp_bin_float_50;

class Oracle : public testing::TestWithParam<Subject> {};

// The narrowest band that anything is judged by is 2^-24 = 6e-8 of the size.
TEST_P(Oracle, AnswersInDoubleAsIn50Digits) {
    int hits = 0;
    for (const RayClass kind : kRayClasses)
        for (const double distance : {3.0, 100.0, 1e5}) {
            if (!fits(kind, GetParam())) continue;
            const Shape shape = placed(GetParam(), kind, distance);
            const ExactShape<double> exactShape(shape);
            const ExactShape<Digits50> wide(shape);
            RayStream stream(shape, kind, distance, 5);
            for (int i = 0; i < 6; ++i) {
                const BatchRay ray = stream.next();
                const ExactHit<double> got = exactHit(exactShape, lineOf(exactShape, ray.origin, ray.direction));
                const ExactHit<Digits50> exact =
                    exactHit(wide, lineOf(wide, ray.origin, ray.direction), Digits50(0), 3);
                const double tangency = std::min(double(exact.tangency), 1e-3); // no near decision beyond
                EXPECT_NEAR(std::min(got.tangency, 1e-3), tangency, 1e-10) << nameOf(kind) << ' ' << distance;
                if (tangency < 1e-10) continue;
                ASSERT_EQ(got.hit, exact.hit) << nameOf(kind) << ' ' << distance << ' ' << tangency;
                if (!got.hit) continue;
                ++hits;
                const double cosine = std::abs(double(dot(exact.normal, Vec3<Digits50>(ray.direction))));
                const double way = std::max(1.0, double(exact.t));
                EXPECT_NEAR(double(Digits50(got.t) - exact.t), 0, 1e-14 * way / (cosine * cosine));
                EXPECT_LT(double(length(Vec3<Digits50>(got.normal) - exact.normal)), 1e-6); // turns fast near an apex
            }
        }
    EXPECT_GT(hits, 10);
}

INSTANTIATE_TEST_SUITE_P(Subjects, Oracle, testing::ValuesIn(subjects()),
                         [](const auto& test) { return test.param.name(); });
INSTANTIATE_TEST_SUITE_P(Patches, Oracle, testing::ValuesIn(patches()),
                         [](const auto& test) { return test.param.name(); });

// Of a flat shape: no point of it is nearer than its distance, and one of many spread over it is about as near.
TEST(FlatDistance, IsThatOfTheNearestOfAllPoints) {
    constexpr int kSteps = 200;
    for (const Subject& subject : subjects()) {
        if (subject.shape != "disc" && subject.shape != "triangle") continue;
        const Shape shape = placed(subject, RayClass::Uniform, 3);
        const ExactShape<double> exactShape(shape);
        RayStream stream(shape, RayClass::Uniform, 3, 11);
        std::vector<Vec3<double>> spread;
        for (int i = 0; i < kSteps * kSteps; ++i) {
            const Vec3<double> rim = stream.surface().point; // both are convex: so are all points towards its middle
            spread.push_back(i % 2 ? rim : std::sqrt(stream.number(0, 1)) * rim);
        }
        for (int i = 0; i < 300; ++i) {
            const Vec3<double> p = stream.number(0, 2) * stream.direction();
            double least = 1e30;
            for (const Vec3<double>& q : spread) least = std::min(least, length(p - q));
            EXPECT_GE(least, exactShape.boundedDistance(p) - 1e-12) << subject.name();
            EXPECT_LE(least, exactShape.boundedDistance(p) + 0.05) << subject.name();
        }
    }
}

/// The exact answer, rounded to float32.
BatchHit roundedAnswer(const ExactShape<double>& shape, const BatchRay& ray) {
    const ExactHit<double> exact = exactHit(shape, lineOf(shape, ray.origin, ray.direction));
    BatchHit answer;
    if (!exact.hit) return answer;
    answer.object = 0;
    answer.t = float(exact.t);
    answer.point = toFloat(shape.middle() + Vec3<long double>(exact.point));
    answer.normal = toFloat(exact.normal);
    return answer;
}

class CompareHits : public testing::TestWithParam<Subject> {
  protected:
    Shape shape = placed(GetParam(), RayClass::Uniform, 10);
    ExactShape<double> exactShape{shape};
    std::vector<BatchRay> rays;
    std::vector<BatchHit> answers;

    void SetUp() override {
        RayStream stream(shape, RayClass::Uniform, 10, 3);
        for (int i = 0; i < 300; ++i) {
            rays.push_back(i % 2 ? stream.next() : stream.towardsSurface());
            answers.push_back(roundedAnswer(exactShape, rays.back()));
        }
    }
    /// Compares what `spoil` makes of every hit.
    template<class Spoil>
    Tally spoilt(const Spoil& spoil) const {
        std::vector<BatchHit> worse = answers;
        for (std::size_t i = 0; i < worse.size(); ++i)
            if (worse[i].object == 0) spoil(worse[i], rays[i]);
        return compareHits(shape, rays, worse);
    }
};

TEST_P(CompareHits, PassesExactAnswers) {
    const Tally tally = compareHits(shape, rays, answers);
    EXPECT_TRUE(within(tally, boundsOf(shape.kind)))
        << tally.wrong() << ' ' << tally.ray.worst << ' ' << tally.point.worst << ' ' << tally.normal.worst;
    EXPECT_GT(tally.hits, 100);
}

TEST_P(CompareHits, TellsMissedAndInventedHits) {
    const std::int64_t hits = compareHits(shape, rays, answers).hits;
    EXPECT_EQ(spoilt([](BatchHit& hit, const BatchRay&) { hit.object = -1; }).missed, hits);
    std::vector<BatchHit> all = answers;
    for (BatchHit& hit : all) hit.object = 0;
    const Tally tally = compareHits(shape, rays, all);
    EXPECT_EQ(tally.invented, tally.decided - hits);
}

TEST_P(CompareHits, TellsAPointOfAnotherPlaceOfTheSurface) {
    const std::int64_t hits = compareHits(shape, rays, answers).hits;
    const BatchHit other =
        *std::find_if(answers.begin(), answers.end(), [](const auto& hit) { return hit.object == 0; });
    const Tally tally = spoilt([&](BatchHit& hit, const BatchRay&) {
        hit.point = other.point;
        hit.normal = other.normal;
    });
    EXPECT_GE(tally.elsewhere, hits * 9 / 10); // but for those that are near it
    EXPECT_LE(tally.point.worst, boundsOf(shape.kind).point) << "it is a point of the surface";
}

TEST_P(CompareHits, TellsTheFarSideOfAClosedShape) {
    if (!exactShape.closed()) return; // it has none
    const std::int64_t hits = compareHits(shape, rays, answers).hits;
    const Tally tally = spoilt([&](BatchHit& hit, const BatchRay& ray) {
        const Line<double> line = lineOf(exactShape, ray.origin, ray.direction);
        const ExactHit<double> exact = exactHit(exactShape, line),
                               far = exactHit(exactShape, line, exact.s - line.start + 1e-5);
        hit.t = float(far.t);
    });
    EXPECT_GE(tally.elsewhere, hits * 8 / 10); // but for short chords and second entries
}

TEST_P(CompareHits, TellsWhatIsNoNumberAndWhatIsNoObject) {
    const std::int64_t hits = compareHits(shape, rays, answers).hits;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_GE(spoilt([&](BatchHit& hit, const BatchRay&) { hit.t = nan; }).elsewhere, hits);
    EXPECT_GE(spoilt([&](BatchHit& hit, const BatchRay&) { hit.point.y = nan; }).elsewhere, hits);
    EXPECT_GE(spoilt([&](BatchHit& hit, const BatchRay&) { hit.normal.z = nan; }).elsewhere, hits);
    EXPECT_GE(spoilt([&](BatchHit& hit, const BatchRay&) { hit.object = 1; }).elsewhere, hits);
}

INSTANTIATE_TEST_SUITE_P(Subjects, CompareHits, testing::ValuesIn(subjects()),
                         [](const auto& test) { return test.param.name(); });
INSTANTIATE_TEST_SUITE_P(Patches, CompareHits, testing::ValuesIn(patches()),
                         [](const auto& test) { return test.param.name(); });

} // namespace
} // namespace gnomon::oracle
