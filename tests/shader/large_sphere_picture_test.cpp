/// Pictures of a landscape on a huge sphere, against a long-double oracle, and of a sphere in both its forms.
#include "lab/reference/exact/scene_hit.h"
#include "tests/support/large_ground.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/plan/drawn.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace gnomon {
namespace {

using namespace test;
using oracle::pixelRay;

/// Balls that lie on the ground, in the shader's float32 numbers.
struct Ball {
    Vec center;
    Real radius;
};

struct Landscape {
    Ground ground{1e4};
    Vec light;
    std::vector<Ball> balls;

    /// Five balls about the point x along the ground.
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
    for (const Real along : {0.0L, 3000.0L})
        for (const Real height : {1.0L, 0.05L}) {
            SCOPED_TRACE(format("%Lg from the scene's camera, %Lg above the ground", along, height));
            const Landscape landscape(along);
            const Scene scene = landscape.scene();
            CameraPose pose = scene.camera;
            pose.eye = glm::dvec3(landscape.ground.over(along - 6, 0, height));
            pose.target = glm::dvec3(landscape.ground.over(along, 0, height * 0.6L));
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
            std::printf("%4Lg along, %4Lg above: %d wrong, %d unsure of %d pixels, %d of the ground in shadow\n", along,
                        height, faults.wrong, faults.unsure, 320 * 240, faults.dark);
            EXPECT_EQ(faults.wrong, 0);
            EXPECT_LE(faults.unsure, 320 * 240 / 500);
            EXPECT_GT(faults.dark, 10);
        }
}

// One sphere, drawn in its anchored form because the scene's camera stands close to it, and as a sphere because it does
// not. On textures they differ by 3e-4 rad of latitude, the error of the drivers' acos, which the anchored form does
// without.
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
        const FloatImage large = outputOf(near, settings, Aov::Color), sphere = outputOf(far, settings, Aov::Color);
        double worst = 0, sum = 0;
        for (std::size_t i = 0; i < large.pixels.size(); ++i) {
            const double difference = std::abs(double(large.pixels[i]) - sphere.pixels[i]);
            worst = std::max(worst, difference);
            sum += difference;
        }
        std::printf("%s: worst difference %.2g, mean %.2g\n", optics, worst, sum / double(large.pixels.size()));
        EXPECT_LE(worst, std::string(optics).find("texture") == std::string::npos ? 1e-4 : 0.01) << optics;
        EXPECT_LE(sum / double(large.pixels.size()), 1e-4) << optics;
    }
}

} // namespace
} // namespace gnomon
