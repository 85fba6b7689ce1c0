/// The baseline for speed, the source document's way of tracing: it must do all the work that our picture takes, and do
/// it the plain way.
///
/// Its pictures are not ours to the last bit. Its level of detail comes from neighbouring pixels instead of the ray's
/// ray cone, so that stars and the lines of the ground are smoothed otherwise, and where two pixels of a quad see
/// different things it is wrong; inside of glass it follows no partial reflections; its rays start 1e-3 off every
/// surface.

#include "lab/reference/textbook/source_scene.h"
#include "lab/reference/textbook/textbook.h"
#include "tests/support/offscreen.h"
#include "tests/support/scenes.h"
#include "tracer/gl/objects.h"
#include "tracer/shader/shader_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ostream>

namespace gnomon {
namespace {

using namespace test;

/// Per cent of the pixels that differ by more than `step` of 255 in some channel.
double differing(const Image& a, const Image& b, int step) {
    int off = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        int worst = 0;
        for (std::size_t c = i; c < i + 3; ++c) worst = std::max(worst, std::abs(int(a.rgba[c]) - int(b.rgba[c])));
        off += worst > step;
    }
    return 100.0 * off / (double(a.width) * a.height);
}

struct Case {
    const char* scene;
    int depth;
    double time;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.scene << ", depth " << c.depth; }

class Source : public testing::TestWithParam<Case> {};

TEST_P(Source, DrawsNearlyOurPicture) {
    offscreen();
    const Case& c = GetParam();
    Settings settings;
    settings.size = {160, 120};
    settings.depth = c.depth;
    settings.time = c.time;
    const Scene scene = sceneNamed(c.scene);
    const Image ours = Drawing(scene, settings).picture();
    const Image theirs = Drawing(sourceScene(scene), settings, sourceShaders()).picture();
    const double little = differing(ours, theirs, 8), much = differing(ours, theirs, 24);
    std::printf("%s, depth %d, at %g s: %.2f %% of the pixels differ by more than 8/255, %.2f %% by more than 24/255\n",
                c.scene, c.depth, c.time, little, much);
    EXPECT_LE(little, 5);
    EXPECT_LE(much, 0.7);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Source, testing::Values(Case{"lite", 8, 0}, Case{"lite", 4, 4.25}, Case{"pro", 8, 0}, Case{"pro", 4, 4.25}),
    [](const auto& test) { return std::string(test.param.scene) + "_depth_" + std::to_string(test.param.depth); });

/// A face of a cube map whose colours tell the place: red across, green down, blue the face.
Image signpost(int face) {
    const int size = 256;
    Image image{size, size, std::vector<std::uint8_t>(std::size_t(size) * size * 4)};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const std::uint8_t texel[] = {std::uint8_t(x), std::uint8_t(y), std::uint8_t(40 * face), 255};
            std::copy(texel, texel + 4, &image.rgba[(std::size_t(y) * size + x) * 4]);
        }
    return image;
}

void nameSky(Renderer& renderer) {
    const char* faces[] = {"sky-px", "sky-nx", "sky-py", "sky-ny", "sky-pz", "sky-nz"};
    for (int i = 0; i < 6; ++i) renderer.setImage(faces[i], signpost(i));
}

// Into the corners of the cube, so that three faces are in each picture. Beside the edges between faces the planes show
// coarser levels.
TEST(SourceScene, ShowsTheCubeMapOnSixPlanes) {
    offscreen();
    Settings settings;
    settings.size = {96, 96};
    settings.fov = 100;
    settings.eye = glm::dvec3(0);
    const Scene scene = sceneFrom(R"({"background": {"cubemap": "sky"}, "encoding": "display",
        "objects": [{"sphere": {"center": [0, 0, 900], "radius": 0.001}}]})");
    for (int corner = 0; corner < 8; ++corner) {
        settings.target = glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        Drawing ours(scene, settings), theirs(sourceScene(scene), settings, sourceShaders());
        nameSky(ours.renderer());
        nameSky(theirs.renderer());
        EXPECT_LE(differing(ours.picture(), theirs.picture(), 4), 4) << "corner " << corner;
    }
}

// Glass, whose normals must point outward, with something inside; and what moves around a box moves around its centre.
TEST(SourceScene, ShowsBoxesOfTriangles) {
    offscreen();
    Settings settings;
    settings.size = {160, 120};
    settings.time = 0.7;
    const Scene scene = sceneFrom(R"({"background": {"color": [0.2, 0.3, 0.5]},
        "camera": {"eye": [3, 4, 9], "target": [0, 0, 0]}, "lights": [{"point": {"position": [4, 9, 3]}}],
        "materials": {"clay": {"ambient": 0.1, "diffuse": 0.8}, "glass": {"specular": 0.5, "shininess": 50,
            "dielectric": {"ior": 1.5}}},
        "objects": [
            {"name": "moon", "sphere": {"center": [0, 0, 0], "radius": 0.4}, "material": "clay",
             "motion": {"orbit": {"cos": [2, 0, 0], "sin": [0, 0, 2], "rate": 1, "around": "clay"}}},
            {"name": "clay", "box": {"center": [-2, 0.3, 0.1], "half_size": [0.5, 0.8, 0.3]}, "material": "clay",
             "motion": {"orbit": {"cos": [0, 0.5, 0], "sin": [0.5, 0, 0], "rate": 2}}},
            {"name": "far", "sphere": {"center": [1.2, 0.2, -3], "radius": 1}, "material": "clay"},
            {"box": {"center": [1, 0.2, 0.5], "half_size": [1, 0.7, 0.6]}, "material": "glass"},
            {"plane": {"point": [0, -2, 0], "normal": [0, 1, 0]}, "material": "clay"}]})");
    const Scene source = sourceScene(scene);
    EXPECT_EQ(std::ranges::count(source.objects, ShapeKind::Triangle, [](const Object& o) { return o.shape.kind; }),
              24);
    const Image ours = Drawing(scene, settings).picture();
    EXPECT_LE(differing(ours, Drawing(source, settings).picture(), 3), 0.5);
}

// Every output, of scenes with and without images, glass and lights' shadows, in both preludes.
TEST(SourceShaders, Compile) {
    offscreen();
    Settings settings;
    Problems problems;
    for (const char* scene : {"lite", "pro", "torus", "shapes"})
        for (const bool es300 : {true, false})
            for (const ShadowModel shadows : {ShadowModel::Hard, ShadowModel::Off})
                for (const Aov aov : {Aov::Color, Aov::Object, Aov::Visibility}) {
                    settings.shadows = shadows;
                    settings.aov = aov;
                    const Plan plan = planOf(*prepare(sourceScene(sceneNamed(scene))), settings, {.es300 = es300});
                    const ShaderSource source = buildShader("pass/trace.frag", plan, problems, sourceShaders());
                    const gl::Program program(buildCanvas(plan, problems).text, source.text);
                    EXPECT_TRUE(program.linked()) << scene << '\n' << toString(mapLog(program.fragmentLog(), source));
                }
    EXPECT_EQ(toString(problems), "");
}

// A ray that adds little to the picture is traced like any other.
TEST(SourceShaders, LeaveNoRayOut) {
    offscreen();
    const Scene scene = sceneNamed("lite");
    Settings every, few;
    every.size = few.size = {80, 60};
    every.threshold = 0;
    few.threshold = 0.05;
    EXPECT_GT(differing(Drawing(scene, every).picture(), Drawing(scene, few).picture(), 0), 1);
    const Scene source = sourceScene(scene);
    EXPECT_EQ(Drawing(source, every, sourceShaders()).picture().rgba,
              Drawing(source, few, sourceShaders()).picture().rgba);
}

// No loop over objects is left early, neither by a shadow ray that has found one in its way, and none that the
// picture's own shader would leave out is left out: what that shader does so with is not in the baseline's.
TEST(SourceShaders, AskEveryObject) {
    const Settings settings;
    Problems problems;
    const auto textOf = [&](const Scene& scene, std::span<const ShaderFile> overrides) {
        return buildShader("pass/trace.frag", planOf(*prepare(scene), settings, {.blockTexels = 4096}), problems,
                           overrides)
            .text;
    };
    const Scene scene = sceneNamed("pro");
    const std::string ours = textOf(scene, {}), theirs = textOf(sourceScene(scene), sourceShaders());
    EXPECT_EQ(toString(problems), "");
    for (const char* word : {"break;", "occluded(", "frame.threshold"}) {
        EXPECT_NE(ours.find(word), std::string::npos) << word;
        EXPECT_EQ(theirs.find(word), std::string::npos) << word;
    }
}

} // namespace
} // namespace gnomon
