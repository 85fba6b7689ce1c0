/// A picture drawn by shader variants is the picture of the full variant alone, to every float: from anywhere, at any
/// time, whatever features in it are uncommon and wherever they are met.
#include "tests/support/clouds.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/gl/objects.h"
#include "tracer/gl/read_top_down.h"
#include "tracer/software/tuning.h"
#include "tracer/software/uncommon_features.h"

#include <gtest/gtest.h>

#include <set>

namespace gnomon {
namespace {

using namespace test;

struct Shot {
    glm::dvec3 eye, target;
    double time = 0, fov = 40;
};

Settings with(Variants variants, Settings settings) {
    settings.size = {163, 122};
    settings.variants = variants;
    return settings;
}

/// All shots of the scene are the same with variants and without, and show something.
void expectSame(const Scene& scene, const std::vector<Shot>& shots, const Settings& settings, const std::string& what) {
    offscreen();
    Drawing full(scene, with(Variants::Off, settings)), variants(scene, with(Variants::On, settings));
    std::set<float> values;
    for (const Shot& shot : shots) {
        FloatImage pictures[2];
        Drawing* drawings[] = {&full, &variants};
        for (int i = 0; i < 2; ++i) {
            View& view = drawings[i]->view;
            view.camera.eye = shot.eye;
            view.camera.target = shot.target;
            view.camera.fov = shot.fov;
            view.time = shot.time;
            pictures[i] = drawings[i]->output();
        }
        EXPECT_EQ(difference(pictures[0], pictures[1]), "") << what << ", shot " << &shot - shots.data();
        values.insert(pictures[0].pixels.begin(), pictures[0].pixels.end());
    }
    EXPECT_GT(values.size(), 1000u) << what;
    EXPECT_GT(variants.renderer().stats().sourceBytes, full.renderer().stats().sourceBytes + 1000)
        << what << ": there was no base variant";
}

struct Known {
    const char* name;
    std::vector<Shot> shots;
};

class VariantsOf : public testing::TestWithParam<Known> {};

TEST_P(VariantsOf, DrawTheFullVariantsPicture) {
    const Scene scene = sceneNamed(GetParam().name);
    for (const int depth : {1, 3, 8})
        for (const ShadowModel shadows : {ShadowModel::Off, ShadowModel::Hard}) {
            Settings settings;
            settings.depth = depth;
            settings.shadows = shadows;
            expectSame(scene, GetParam().shots, settings,
                       std::string(GetParam().name) + ", depth " + std::to_string(depth) + ", shadows " +
                           std::to_string(int(shadows)));
        }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, VariantsOf,
    testing::Values(
        Known{"lite", {{{0, 0, 35}, {0, 0, 0}}, {{12, 4, 20}, {0, -1, 0}, 3.7}, {{-9, 1, 3}, {-7, 0, 0}, 1, 90}}},
        Known{"pro",
              {{{0, 0, 35}, {0, 0, 0}},
               {{14, 2, 8}, {9, -1, 0}, 1.5},
               {{10, 0, 0.2}, {9, -1, 0}, 88, 90}, // within the cube and the torus
               {{0, 6, 24}, {0, -7, 12}, 5, 60}}},
        Known{"shapes",
              {{{0.5, 3.7, 6.9}, {0, 0.5, 0}}, {{-3, 0.2, -2}, {0, 0.6, 0}, 2, 80}, {{20, 9, 30}, {0, 0, 0}}}},
        Known{"torus", {{{0, 1.6, 5}, {0, -0.15, 0}}, {{0.3, 0.2, 40}, {0, 0, 0}, 0, 10}}}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST(ShaderVariants, HaveTheSkyOfAllShadowModels) {
    for (const ShadowModel model : {ShadowModel::Silhouette, ShadowModel::Montecarlo}) {
        Settings settings;
        settings.shadows = model;
        settings.samples = 4;
        settings.lightRadius = 1;
        expectSame(sceneNamed("lite"), {{{0, 0, 35}, {0, 0, 0}}}, settings, "model " + std::to_string(int(model)));
    }
}

/// A march hits what its pixel's cone grazes, if only within the ball about the object.
TEST(ShaderVariants, OfDistanceObjectsDrawTheFullVariantsPicture) {
    for (const char* name : {"solids", "mandelbulb", "complex"})
        for (const March march : {March::Cone, March::Sphere}) {
            const Scene scene = sceneNamed(name);
            Settings settings;
            settings.march = march;
            const glm::dvec3 eye = scene.camera.eye, target = scene.camera.target;
            expectSame(scene, {{eye, target}, {target + 3.0 * (eye - target), target, 0, 60}}, settings, name);
        }
}

TEST(ShaderVariants, FarFromTheOriginDrawTheFullVariantsPicture) {
    const glm::dvec3 by{30000, -7000, 500};
    expectSame(moved(sceneNamed("pro"), by), {{by + glm::dvec3(0, 0, 35), by}, {by + glm::dvec3(14, 2, 8), by}}, {},
               "far away");
}

/// All features that may be uncommon in a room of mirrors and much that is not, small and far and near, some in motion.
Scene crowd(std::uint64_t seed) {
    Dice dice(seed);
    const auto number = [](double x) { return std::to_string(x); };
    const auto point = [&](glm::dvec3 p) { return "[" + number(p.x) + "," + number(p.y) + "," + number(p.z) + "]"; };
    const auto position = [&] { return point(dice.point(6)); };
    const auto direction = [&] { return point(dice.point(1) + glm::dvec3(0, 0, 2)); };
    const char* materials[] = {"mirror", "glass", "bumpy", "wet", "plain", "plain"};
    std::string objects;
    const auto add = [&](const std::string& shape) {
        objects += (objects.empty() ? "" : ",") + std::string("{") + shape + R"(,"material":")" +
                   materials[int(dice.number(0, 6))] + R"(","casts_shadow":)" +
                   (dice.number(0, 1) < 0.8 ? "true" : "false");
        if (dice.number(0, 1) < 0.2)
            objects += R"(,"motion":{"orbit":{"cos":)" + position() + R"(,"sin":[0,1,0],"rate":1.5}})";
        objects += "}";
    };
    for (int i = 0; i < 5; ++i)
        add(R"("sphere":{"center":)" + position() + R"(,"radius":)" + number(dice.number(0.05, 0.5)) + "}");
    for (int i = 0; i < 2; ++i)
        add(R"("torus":{"center":)" + position() + R"(,"axis":)" + direction() +
            R"(,"major_radius":0.5,"minor_radius":0.2})");
    for (const char* kind : {"cylinder", "capsule", "cone"}) {
        const glm::dvec3 from = dice.point(6);
        add("\"" + std::string(kind) + R"(":{"from":)" + point(from) + R"(,"to":)" +
            point(from + dice.point(0.4) + glm::dvec3(0.5, 0, 0)) + R"(,"radius":0.3})");
    }
    add(R"("box":{"center":)" + position() + R"(,"half_size":[0.3,0.4,0.5]})");
    add(R"("triangle":{"vertices":[[-9,-5,-8],[9,-5,-8],[0,8,-9]]})");
    add(R"("disc":{"center":[0,-6,0],"normal":[0.1,1,0],"radius":14})");
    return sceneFrom(R"({"background":{"color":[0.2,0.3,0.5]},"camera":{"eye":[0,2,30],"target":[0,0,0]},
        "lights":[{"point":{"position":[5,15,12]}},{"point":{"position":[-12,3,2]}}],
        "materials":{"mirror":{"diffuse":0.1,"conductor":{"n":0.2,"k":3}},"glass":{"dielectric":{"ior":1.5}},
            "bumpy":{"diffuse":0.6,"normal_map":{"image":"moon-normal"}},
            "wet":{"diffuse":0.5,"texture":{"image":"earth-color"},"coat":{"ior":1.4,"mask":"earth-water"}},
            "plain":{"diffuse":[0.5,0.3,0.2],"ambient":0.1}},
        "objects":[)" +
                     objects + "]}");
}

TEST(ShaderVariants, OfCrowdsDrawTheFullVariantsPicture) {
    int uncommonKinds = 0, uncommonGlass = 0, uncommonMaps = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Scene scene = crowd(seed);
        const ScreenSplit split = splitPlanOf(*prepare(scene), {}, tunedFor(Rasteriser::Llvmpipe)).split;
        for (const ScreenSplit::Kind& kind : split.kinds) uncommonKinds += kind.shape;
        uncommonGlass += split.refraction;
        uncommonMaps += split.normalMaps;
        Dice dice(100 + seed);
        std::vector<Shot> shots{{{0, 2, 30}, {0, 0, 0}}};
        for (int i = 0; i < 4; ++i)
            shots.push_back({dice.point(9), dice.point(3), dice.number(0, 20), dice.number(20, 110)});
        Settings settings;
        settings.depth = 6;
        expectSame(scene, shots, settings, "crowd " + std::to_string(seed));
    }
    EXPECT_GT(uncommonKinds, 15);
    EXPECT_GT(uncommonGlass, 3);
    EXPECT_GT(uncommonMaps, 3);
}

TEST(ShaderVariants, ComeInBandsAsInOne) {
    offscreen();
    constexpr int kWidth = 160, kHeight = 120;
    Drawing drawing(sceneNamed("pro"), with(Variants::On, {}));
    drawing.view.width = kWidth;
    drawing.view.height = kHeight;
    const gl::Target screen = gl::makeTarget(kWidth, kHeight, GL_RGBA8);
    const auto shown = [&] {
        glBindFramebuffer(GL_FRAMEBUFFER, screen.framebuffer.get());
        return gl::readTopDown(kWidth, kHeight).rgba;
    };
    Renderer& renderer = drawing.renderer();
    renderer.draw(drawing.view, 1, screen.framebuffer.get());
    const auto once = shown();
    for (const int rows : {7, 43, 1, kHeight}) {
        EXPECT_LT(renderer.refined(), 1);
        renderer.refine(drawing.view, 1, rows);
    }
    EXPECT_EQ(renderer.refined(), 1);
    glBindFramebuffer(GL_FRAMEBUFFER, screen.framebuffer.get());
    glClearColor(1, 0, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    renderer.show(drawing.view, screen.framebuffer.get());
    EXPECT_EQ(shown(), once);
}

} // namespace
} // namespace gnomon
