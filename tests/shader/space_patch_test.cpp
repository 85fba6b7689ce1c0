/// Rays on the GPU against patches in space, held against all crossings in double (space_patch_hit.h).
///
/// A decision is right if it is that of the ray, or of one shifted across itself by the band: 2^-19 of the reach, by
/// which the farthest control point is from the anchor, over the lightest weight, of a heaviest from 1 to 2.
/// GNOMON_RAYS says how many rays a test traces, about.
#include "lab/batch/ray_batch.h"
#include "lab/reference/exact/space_patch_hit.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/scene/read_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <random>

namespace gnomon {
namespace {

using namespace test;
using oracle::ExactPatch;
using oracle::PatchCrossing;
using oracle::PatchPoint;

constexpr double kBand = 0x1p-19;

int rayCount(int usual) {
    const char* asked = std::getenv("GNOMON_RAYS");
    return asked ? std::min(usual, std::atoi(asked)) : usual;
}

/// Patches of one anchor, as the shader reads them.
class Model {
  public:
    explicit Model(const Scene& scene) : anchor(pointOf(inFloat(scene.objects.at(0).shape), "anchor")) {
        for (const Object& object : scene.objects) {
            const Shape shape = inFloat(object.shape);
            EXPECT_EQ(pointOf(shape, "anchor"), anchor);
            patches.emplace_back(*shape.net);
            boxes.push_back({shape.net->low, shape.net->high});
            for (const glm::dvec4& p : shape.net->points) {
                reach = std::max(reach, glm::length(glm::dvec3(p)) / p.w);
                lightest = std::min(lightest, p.w);
            }
        }
    }
    struct Hit {
        int patch = -1;
        PatchCrossing at;
    };

    /// Nearest crossing beyond tMin; of the patch that the ray starts on, at `start`, those elsewhere.
    Hit nearest(glm::dvec3 origin, glm::dvec3 direction, double tMin, int self, glm::dvec2 start) const {
        Hit hit;
        hit.at.t = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < patches.size(); ++i) {
            if (!mayMeet(boxes[i], origin, direction)) continue;
            for (const PatchCrossing& c : patches[i].crossings(origin, direction)) {
                const bool own = int(i) == self;
                const bool isStart = own && glm::distance(origin, patches[i].at(c.uv).place) < 1e-4 * reach &&
                                     glm::distance(c.uv, start) < 1e-2;
                if (!isStart && c.t > (own ? 0 : tMin) && c.t < hit.at.t) hit = {int(i), c};
            }
        }
        return hit;
    }

    glm::dvec3 anchor;
    std::vector<ExactPatch> patches;
    std::vector<Extent> boxes;
    double reach = 0, lightest = 1;
    double band() const { return kBand * reach / lightest; }

  private:
    bool mayMeet(const Extent& box, glm::dvec3 o, glm::dvec3 d) const {
        const glm::dvec3 middle = 0.5 * (box.low + box.high);
        const double radius = 0.5 * glm::distance(box.low, box.high) + 1e-3 * reach;
        return glm::length(glm::cross(o - middle, d)) <= radius * glm::length(d);
    }
};

struct Start {
    int self = -1;
    glm::dvec2 uv{0};
};

/// Worst errors in roundings, 2^-23 of the reach and of the anchor, over the lightest weight: of the surface point, off
/// the ray and off the surface, and of the normal, over how far the slopes there span the tangent plane.
struct Faults {
    int rays = 0, hits = 0, wrong = 0, inBand = 0;
    double rayError = 0, pointError = 0, normalError = 0;

    void compare(const Model&, const BatchRay&, const BatchHit&, Start = {});
    void expectWithin(double mostRay, double mostNormal, const std::string& what) const {
        std::printf("%-28s %6d rays, %6d hits, %d wrong, %d in the band; ray %.2f, point %.2f, normal %.2f\n",
                    what.c_str(), rays, hits, wrong, inBand, rayError, pointError, normalError);
        EXPECT_EQ(wrong, 0) << what;
        EXPECT_LE(rayError, mostRay) << what;
        EXPECT_LE(pointError, 3) << what;
        EXPECT_LE(normalError, mostNormal) << what;
    }
};

/// The nearest of the feet that points of a grid lead to.
glm::dvec2 footOf(const ExactPatch& patch, glm::dvec3 p) {
    std::vector<std::pair<double, glm::dvec2>> starts;
    for (int i = 0; i < 33 * 33; ++i) {
        const glm::dvec2 uv(i % 33 / 32.0, i / 33 / 32.0);
        starts.emplace_back(glm::distance(patch.at(uv).place, p), uv);
    }
    std::partial_sort(starts.begin(), starts.begin() + 24, starts.end(),
                      [](const auto& a, const auto& b) { return a.first < b.first; });
    std::pair<double, glm::dvec2> best = starts[0];
    for (int i = 0; i < 24; ++i) {
        const glm::dvec2 uv = patch.footNear(p, starts[std::size_t(i)].second);
        const double far = glm::distance(patch.at(uv).place, p);
        if (far < best.first) best = {far, uv};
    }
    return best.second;
}

/// Whether the told answer may be given for the ray, or for one shifted across it by up to the band: a miss if one of
/// these misses; a hit if one of these has its first crossing there, or keeps within the band of the surface from its
/// first crossing to there, or the told point lies within the band of a surface that none of them crosses.
bool answersAsBeside(const Model& model, const BatchRay& ray, const BatchHit& hit, double tMin, Start start) {
    const glm::dvec3 o = glm::dvec3(ray.origin) - model.anchor, d(ray.direction);
    const glm::dvec3 e = glm::normalize(glm::cross(d, std::abs(d.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const double band = model.band(), room = 8 * 0x1p-23 * (model.reach + std::abs(double(hit.t)));
    std::vector<Model::Hit> answers{model.nearest(o, d, tMin, start.self, start.uv)};
    for (int i = 0; i < 24; ++i) {
        const double angle = i * 2 * 3.14159265358979 / 12, width = band * (i < 12 ? 1 : 0.5);
        const glm::dvec3 shift = width * (std::cos(angle) * e + std::sin(angle) * glm::cross(d, e));
        answers.push_back(model.nearest(o + shift, d, tMin, start.self, start.uv));
    }
    const auto misses = [](const Model::Hit& answer) { return answer.patch < 0; };
    if (hit.object < 0) return std::any_of(answers.begin(), answers.end(), misses);
    const auto keepsBeside = [&](double from) {
        const ExactPatch& patch = model.patches[std::size_t(hit.object)];
        glm::dvec2 uv = footOf(patch, o + double(hit.t) * d);
        for (int i = 0; i <= 16; ++i) {
            const glm::dvec3 p = o + glm::mix(double(hit.t), from, i / 16.0) * d;
            uv = patch.footNear(p, uv);
            if (glm::distance(p, patch.at(uv).place) > 2 * band + room) return false;
        }
        return true;
    };
    if (std::all_of(answers.begin(), answers.end(), misses)) return keepsBeside(hit.t);
    return std::any_of(answers.begin(), answers.end(), [&](const Model::Hit& answer) {
        return answer.patch >= 0 ? std::abs(answer.at.t - hit.t) < room || keepsBeside(answer.at.t)
                                 : misses(answers[0]) && keepsBeside(hit.t);
    });
}

void Faults::compare(const Model& model, const BatchRay& ray, const BatchHit& hit, Start start) {
    ++rays;
    const glm::dvec3 o = glm::dvec3(ray.origin) - model.anchor, d(ray.direction);
    const double tMin = ray.tMin;
    const Model::Hit exact = model.nearest(o, d, tMin, start.self, start.uv);
    const double rounding = 0x1p-23 * (model.reach + glm::length(model.anchor)) / model.lightest;
    const double ulp = double(std::nextafter(hit.t, 1e30f)) - double(hit.t);
    const bool told = hit.object >= 0, both = told && exact.patch >= 0;
    if (!told && exact.patch < 0) return;
    const double off = std::abs(double(hit.t) - exact.at.t);
    const double cosine =
        both ? std::abs(glm::dot(model.patches[std::size_t(exact.patch)].at(exact.at.uv).normal, d)) : 0;
    if (!both || off * cosine > 4 * rounding + ulp || cosine < 0.01) {
        const bool right = answersAsBeside(model, ray, hit, tMin, start);
        wrong += !right;
        if (!right && wrong < 6)
            std::printf(
                "  wrong: told object %d t %.9g, exact patch %d t %.9g uv %.9g %.9g cosine %.3g; from %.9g %.9g "
                "%.9g along %.9g %.9g %.9g\n",
                hit.object, double(hit.t), exact.patch, exact.at.t, exact.at.uv.x, exact.at.uv.y, cosine,
                double(ray.origin.x), double(ray.origin.y), double(ray.origin.z), double(ray.direction.x),
                double(ray.direction.y), double(ray.direction.z));
        inBand += right && told != (exact.patch >= 0);
        if (!both || !right) return;
    }
    ++hits;
    const ExactPatch& patch = model.patches[std::size_t(hit.object)];
    const glm::dvec3 point = glm::dvec3(hit.point) - model.anchor;
    // The told point, off the ray and off the surface. From the uv of the ray's own crossing there; a sheet that it
    // only comes near has none.
    const double along = glm::dot(point - o, d) / glm::dot(d, d);
    rayError = std::max(
        {rayError, glm::distance(point, o + along * d) / rounding, (std::abs(along - hit.t) - ulp) / rounding});
    glm::dvec2 from(0.5);
    double nearest = 1e300;
    for (const PatchCrossing& c : patch.crossings(o, d))
        if (std::abs(c.t - hit.t) < nearest) nearest = std::abs(c.t - hit.t), from = c.uv;
    PatchPoint under = patch.at(patch.footNear(point, from));
    if (nearest > 16 * rounding + ulp || glm::distance(point, under.place) > 4 * rounding)
        under = patch.at(footOf(patch, point));
    pointError = std::max(pointError, glm::distance(point, under.place) / rounding);
    // A rounding of slopes that are short, or all but one, turns the normal by more.
    const double u = glm::length(under.alongU), v = glm::length(under.alongV);
    const double spans = glm::length(glm::cross(under.alongU, under.alongV)) / std::max(u, v) / model.reach;
    normalError = std::max(normalError, glm::distance(glm::dvec3(hit.normal), under.normal) * std::min(1.0, spans) *
                                            model.lightest / 0x1p-23);
}

/// Rays at places of a model, from `sizes` reaches away.
class Aim {
  public:
    Aim(const Model& model, unsigned seed) : model_(model), random_(seed) {}

    double number(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
    double spread(double low, double high) { return std::exp(number(std::log(low), std::log(high))); }
    glm::dvec3 direction() {
        const double z = number(-1, 1), around = number(0, 2 * 3.14159265358979), r = std::sqrt(1 - z * z);
        return {r * std::cos(around), r * std::sin(around), z};
    }
    std::size_t patch() { return random_() % model_.patches.size(); }
    BatchRay at(glm::dvec3 place, glm::dvec3 along, double sizes) const {
        BatchRay ray;
        const glm::dvec3 target = model_.anchor + place;
        ray.origin = glm::vec3(target - sizes * model_.reach * along);
        ray.direction = glm::vec3(glm::normalize(target - glm::dvec3(ray.origin)));
        return ray;
    }
    BatchRay anywhere() {
        const glm::dvec3 place = 1.1 * model_.reach * std::cbrt(number(0, 1)) * direction();
        return at(place, direction(), spread(1, 1000));
    }
    BatchRay surface() {
        const ExactPatch& patch = model_.patches[this->patch()];
        return at(patch.at({number(0, 1), number(0, 1)}).place, direction(), spread(1, 1000));
    }
    BatchRay edge() {
        const ExactPatch& patch = model_.patches[this->patch()];
        glm::dvec2 uv(number(0, 1), number(0, 1));
        uv[int(random_() % 2)] = double(random_() % 2);
        return at(patch.at(uv).place, direction(), spread(1, 1000));
    }
    /// In the tangent plane, or beside it by 1e-9 to 1e-2 of the reach.
    BatchRay grazing() {
        const PatchPoint p = model_.patches[patch()].at({number(0, 1), number(0, 1)});
        const glm::dvec3 any = direction(), along = glm::normalize(any - glm::dot(any, p.normal) * p.normal);
        const double beside = (random_() % 2 ? 1 : -1) * spread(1e-9, 1e-2) * model_.reach;
        return at(p.place + beside * p.normal, along, spread(1, 1000));
    }

  private:
    const Model& model_;
    std::mt19937_64 random_;
};

Scene teapot() {
    Problems problems;
    const std::string text = textOf(std::string(GNOMON_SOURCE_DIR) + "/assets/scenes/teapot.bpt");
    const auto scene = readScene(R"({"objects": [{"surface": {"file": "teapot.bpt"}}]})", "f", problems,
                                 [&](const std::string&, Problems&) { return std::optional(text); });
    EXPECT_EQ(toString(problems), "");
    return scene.value_or(Scene{});
}

/// Points uniform in a cube, weights uniform in their logarithm.
Scene randomPatch(unsigned seed, bool rational) {
    std::mt19937_64 random(seed);
    const auto number = [&](double low, double high) { return low + (high - low) * double(random() >> 11) * 0x1p-53; };
    std::string points;
    for (int k = 0; k < 16; ++k) {
        points += k ? ", [" : "[";
        // The middle of the corners is 0, and so is the anchor, if two opposite ones reach farthest.
        for (int i = 0; i < 3; ++i)
            points += (i ? ", " : "") + std::to_string(k == 0 ? -1.0 : (k == 15 ? 1.0 : number(-1, 1)));
        if (rational) points += ", " + std::to_string(std::exp(number(std::log(0.2), std::log(5.0))));
        points += "]";
    }
    return sceneFrom(R"({"objects": [{"patch": {"points": [)" + points + "]}}]}");
}

class SpacePatches : public testing::Test {
  protected:
    void SetUp() override { offscreen(); }

    template<class Make>
    void trace(const Scene& scene, const Model& model, int count, Faults& faults, Make make) {
        Problems problems;
        if (!batch_) batch_ = std::make_unique<RayBatch>(scene, problems);
        if (batch_->valid()) batch_->setScene(scene, problems);
        ASSERT_EQ(toString(problems), "");
        std::vector<BatchRay> rays;
        for (int i = 0; i < count; ++i) rays.push_back(make());
        const std::vector<BatchHit> hits = batch_->trace(rays);
        for (std::size_t i = 0; i < rays.size(); ++i) faults.compare(model, rays[i], hits[i]);
    }

    std::unique_ptr<RayBatch> batch_;
};

TEST_F(SpacePatches, OfRandomNetsAreMetWhereTheyAre) {
    for (const bool rational : {false, true}) {
        Faults faults;
        const int nets = 100, rays = rayCount(10000) / nets;
        for (int seed = 0; seed < nets; ++seed) {
            const Scene scene = randomPatch(unsigned(seed), rational);
            const Model model(scene);
            Aim aim(model, unsigned(seed));
            int turn = 0;
            trace(scene, model, rays, faults, [&] {
                switch (++turn % 4) {
                case 0: return aim.anywhere();
                case 1: return aim.edge();
                case 2: return aim.grazing();
                default: return aim.surface();
                }
            });
        }
        faults.expectWithin(24, 64, rational ? "random, rational" : "random");
    }
}

TEST_F(SpacePatches, OfTheTeapotAreMetWhereTheyAre) {
    const Scene scene = teapot();
    const Model model(scene);
    Aim aim(model, 1);
    const int rays = rayCount(10000);
    Faults anywhere, surface, grazing;
    trace(scene, model, rays, anywhere, [&] { return aim.anywhere(); });
    anywhere.expectWithin(8, 16, "teapot, anywhere");
    trace(scene, model, rays, surface, [&] { return aim.surface(); });
    surface.expectWithin(8, 16, "teapot, at it");
    trace(scene, model, rays, grazing, [&] { return aim.grazing(); });
    grazing.expectWithin(8, 16, "teapot, grazing");
}

TEST_F(SpacePatches, OfTheTeapotHaveNoCracks) {
    const Scene scene = teapot();
    const Model model(scene);
    Aim aim(model, 2);
    Faults seams, tips;
    trace(scene, model, rayCount(6000), seams, [&] { return aim.edge(); });
    seams.expectWithin(8, 16, "teapot, at seams");
    trace(scene, model, rayCount(4000), tips, [&] {
        const glm::dvec3 tip(0, 0, aim.number(0, 1) < 0.5 ? 3.15 : 0);
        const glm::dvec3 off = aim.spread(1e-9, 1e-1) * aim.direction();
        return aim.at(tip - model.anchor + (aim.number(0, 1) < 0.2 ? glm::dvec3(0) : off), aim.direction(),
                      aim.spread(1, 1000));
    });
    tips.expectWithin(8, 16, "teapot, at points");
}

/// Rays that leave the surface at points told by the GPU, as shadows and reflections do.
TEST_F(SpacePatches, AreLeftWithoutMeetingTheStart) {
    const Scene scene = teapot();
    const Model model(scene);
    Aim aim(model, 3);
    Problems problems;
    RayBatch batch(scene, problems);
    ASSERT_EQ(toString(problems), "");
    std::vector<BatchRay> towards, leaving;
    for (int i = 0; i < rayCount(20000); ++i) towards.push_back(aim.surface());
    const std::vector<BatchHit> met = batch.trace(towards);
    std::vector<Start> starts;
    for (const BatchHit& hit : met) {
        if (hit.object < 0) continue;
        const ExactPatch& patch = model.patches[std::size_t(hit.object)];
        const glm::dvec2 uv = footOf(patch, glm::dvec3(hit.point) - model.anchor);
        BatchRay ray;
        ray.origin = hit.point;
        ray.direction = glm::vec3(aim.direction());
        const double cosine = glm::dot(patch.at(uv).normal, glm::dvec3(ray.direction));
        if (std::abs(cosine) < 1e-2) continue; // whose start is uncertain by 100 roundings along it
        ray.side = float((cosine > 0 ? 1 : -1) * (1 + hit.object));
        const glm::vec3 size = glm::abs(hit.point);
        ray.tMin = 4.8e-7f * (std::max(size.x, std::max(size.y, size.z)) + 1e-3f);
        leaving.push_back(ray);
        starts.push_back({hit.object, uv});
    }
    const std::vector<BatchHit> hits = batch.trace(leaving);
    Faults faults;
    for (std::size_t i = 0; i < leaving.size(); ++i) faults.compare(model, leaving[i], hits[i], starts[i]);
    faults.expectWithin(8, 16, "teapot, from it");
    EXPECT_GT(faults.hits, faults.rays / 4);
}

} // namespace
} // namespace gnomon
