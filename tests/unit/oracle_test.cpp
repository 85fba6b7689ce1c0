/// The oracle against itself in 50 digits: what double and long double leave open is far below what it judges.

#include "tests/oracle/subjects.h"

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
            const Body<double> body(shape);
            const Body<Digits50> wide(shape);
            RayStream stream(shape, kind, distance, 5);
            for (int i = 0; i < 6; ++i) {
                const BatchRay ray = stream.next();
                const ExactHit<double> got = exactHit(body, lineOf(body, ray.origin, ray.direction));
                const ExactHit<Digits50> exact = exactHit(wide, lineOf(wide, ray.origin, ray.direction));
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

} // namespace
} // namespace gnomon::oracle
