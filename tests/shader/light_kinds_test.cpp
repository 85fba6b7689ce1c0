/// Directional lights, spots and lights that fall off with distance, against the oracle and against their definitions;
/// the checker against its squares.

#include "tests/support/oracle_pictures.h"
#include "tracer/gl/objects.h"
#include "tracer/shader/shader_builder.h"
#include "tracer/software/uncommon_features.h"

namespace gnomon {
namespace {

using namespace test;

/// A still life under one light, without reflections.
Scene under(const std::string& light) {
    return sceneFrom(R"({"camera": {"eye": [4, 5, 9], "target": [0, 0.6, 0], "fov": 34},
        "background": {"color": [0.2, 0.3, 0.5]}, "lights": [)" +
                     light + R"(],
        "materials": {"floor": {"ambient": 0.05, "diffuse": 0.6},
                      "clay": {"ambient": 0.05, "diffuse": [0.6, 0.3, 0.2], "specular": 0.3, "shininess": 20}},
        "objects": [{"plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}, "material": "floor"},
                    {"sphere": {"center": [-1, 1, 0.5], "radius": 1}, "material": "clay"},
                    {"box": {"center": [1.3, 0.7, -0.4], "half_size": [0.5, 0.7, 0.6]}, "material": "clay"},
                    {"torus": {"center": [0.8, 0.3, 1.8], "axis": [0.1, 1, 0.2], "major_radius": 0.7,
                               "minor_radius": 0.22}, "material": "clay"}]})");
}

const char* const kDirectional = R"({"directional": {"direction": [1.5, -2, -0.8]}, "color": 0.8})";

TEST(DirectionalLight, ShinesLikeTheOraclesParallelLight) {
    EXPECT_EQ(differenceOf("directional", under(kDirectional), sized(120, 90)).outliers, 0);
}

TEST(SpotLight, ShinesLikeTheOracles) {
    const Scene soft = under(R"({"spot": {"position": [2, 5, 3], "direction": [-0.5, -1, -0.6], "angle": 28,
                                          "softness": 0.5}, "falloff": 5})");
    EXPECT_EQ(differenceOf("spot", soft, sized(120, 90)).outliers, 0);
}

/// Of a white floor at y = 0, straight below the eye, at x.
double floorAt(double x, const std::string& light, const Settings& changed = {}) {
    const Scene scene = sceneFrom(R"({"camera": {"eye": [)" + std::to_string(x) + R"(, 10, 0], "target": [)" +
                                  std::to_string(x) + R"(, 0, 0], "up": [0, 0, -1], "fov": 1},
        "lights": [)" + light + R"(], "materials": {"m": {"diffuse": 1}},
        "objects": [{"plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}, "material": "m"},
                    {"box": {"center": [50, 500, 0], "half_size": [10, 1, 10]}, "material": "m"}]})");
    Settings settings = changed;
    settings.size = {1, 1};
    return *outputOf(scene, settings, Aov::Color).at(0, 0);
}

TEST(DirectionalLight, IsAsStrongEverywhereAndShadowedFromAnyDistance) {
    const char* light = R"({"directional": {"direction": [0, -1, 0]}, "color": 0.5})";
    EXPECT_FLOAT_EQ(float(floorAt(0, light)), 0.5f);
    EXPECT_FLOAT_EQ(float(floorAt(-900, light)), 0.5f);
    EXPECT_EQ(floorAt(50, light), 0) << "under a box 500 units above";
}

// Each model that takes a directional light draws it as it draws a small light far away.
TEST(DirectionalLight, IsServedByTheModelsThatSaySo) {
    const Scene parallel = under(kDirectional);
    const glm::dvec3 position = -3000.0 * parallel.lights[0].direction;
    Scene distant = under(R"({"point": {"position": [0, 0, 0]}, "color": 0.8})");
    distant.lights[0].position = position;
    for (const ShadowRow& row : kShadowModels) {
        if (!row.parallel) continue;
        Settings settings = sized(64, 48, 1);
        settings.shadows = row.model;
        settings.samples = 4;
        const FloatImage one = outputOf(parallel, settings, Aov::Visibility);
        const FloatImage other = outputOf(distant, settings, Aov::Visibility);
        double sum = 0;
        for (std::size_t i = 0; i < one.pixels.size(); ++i) sum += std::abs(double(one.pixels[i]) - other.pixels[i]);
        EXPECT_LE(sum / double(one.pixels.size()), 2e-3) << row.key;
    }
}

/// Drawn with one message, which holds `message`.
FloatImage toldOf(const Scene& scene, const Settings& settings, const std::string& message) {
    offscreen();
    Renderer renderer;
    Problems problems;
    renderer.configure(settings);
    renderer.setScene(scene, problems);
    renderer.finish(problems);
    const FloatImage image = renderer.readOutput({scene.camera, 0, settings.size.x, settings.size.y}, problems);
    EXPECT_EQ(problems.size(), 1u) << toString(problems);
    EXPECT_NE(toString(problems).find(message), std::string::npos) << toString(problems);
    return image;
}

TEST(DirectionalLight, HasNoPlaceThatConesCouldStartAt) {
    Settings settings = sized(16, 12, 1);
    settings.shadows = ShadowModel::ConeLinear;
    const FloatImage surface = outputOf(under(kDirectional), settings, Aov::Color);
    settings.coneOrigin = ConeOrigin::Light;
    EXPECT_EQ(toldOf(under(kDirectional), settings, "use --cone-origin=surface").pixels, surface.pixels);
}

TEST(DirectionalLight, HasHardShadowsWhereAModelDoesNotTakeIt) {
    Settings settings = sized(16, 12, 1);
    const FloatImage hard = outputOf(under(kDirectional), settings, Aov::Color);
    settings.shadows = ShadowModel::Silhouette;
    EXPECT_EQ(toldOf(under(kDirectional), settings, "use one of: off, hard, montecarlo, ").pixels, hard.pixels);
}

TEST(SpotLight, EndsAtItsAngleAndFadesWithinItsSoftness) {
    const auto at = [](double degrees, const char* more) {
        const double x = 4 * std::tan(glm::radians(degrees));
        const std::string spot = R"({"spot": {"position": [0, 4, 0], "direction": [0, -2, 0], "angle": 30)";
        return floorAt(x, spot + more + "}}") / std::cos(glm::radians(degrees));
    };
    EXPECT_NEAR(at(29.99, ""), 1, 1e-4);
    EXPECT_EQ(at(30.01, ""), 0);
    EXPECT_NEAR(at(14.9, R"(, "softness": 0.5)"), 1, 1e-4);
    EXPECT_EQ(at(30.01, R"(, "softness": 0.5)"), 0);
    const double end = std::cos(glm::radians(30.0)), full = std::cos(glm::radians(15.0));
    const double t = (std::cos(glm::radians(25.0)) - end) / (full - end);
    EXPECT_NEAR(at(25, R"(, "softness": 0.5)"), t * t * (3 - 2 * t), 1e-4);
}

TEST(Falloff, IsTheSquareOfTheDistance) {
    const auto lit = [](double height) {
        return floorAt(0, R"({"point": {"position": [0, )" + std::to_string(height) + R"(, 0]}, "falloff": 3})");
    };
    EXPECT_NEAR(lit(3), 1, 1e-5);
    EXPECT_NEAR(lit(6), 0.25, 1e-5);
    EXPECT_NEAR(lit(1.5), 4, 1e-4);
    EXPECT_NEAR(lit(1e-5), 1e6, 1) << "no stronger than at a thousandth of the distance";
}

// Whatever of it a scene has, in both preludes.
TEST(LightsAndMaterials, CompileInEveryCombination) {
    offscreen();
    const std::vector<std::string> lights{"", R"({"point": {"position": [0, 1, 0]}})", kDirectional,
                                          R"({"spot": {"position": [0, 3, 0], "direction": [0, -1, 0]}},
           {"point": {"position": [0, 1, 0]}, "falloff": 2})"};
    const std::vector<std::string> materials{
        R"("checker": {"colors": [1, 0]}, "mirror": 0.5)", R"("mirror": 0.5)", R"("coat": {"ior": 1.5})",
        R"("dielectric": {"ior": 1.5}, "checker": {"colors": [1, 0]}, "normal_map": "earth-normal")",
        R"("conductor": {"n": 1, "k": 2}, "texture": "grid")"};
    int count = 0;
    for (const char* fresnel : {"exact", "schlick"})
        for (const std::string& light : lights)
            for (std::size_t i = 0; i < materials.size(); ++i) {
                const std::string& other = materials[(i + 1) % materials.size()];
                const PreparedScenePtr scene = prepare(sceneFrom(
                    std::string(R"({"fresnel": ")") + fresnel + R"(", "lights": [)" + light +
                    R"(], "materials": {"a": {)" + materials[i] + R"(}, "b": {)" + (count % 2 ? other : materials[i]) +
                    R"(}}, "objects": [{"plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}, "material": "a"},
                                       {"sphere": {"center": [0, 2, 0], "radius": 1}, "material": "b"}]})"));
                Settings settings;
                if (count % 3 == 1) settings.shadows = ShadowModel::ConeLinear;
                if (count % 3 == 2) settings.shadows = ShadowModel::Off;
                Problems problems;
                const Plan plan = splitPlanOf(*scene, settings, {.es300 = count++ % 2 == 0});
                const ShaderSource source = buildShader("pass/trace.frag", plan, problems);
                const gl::Program program(buildCanvas(plan, problems).text, source.text);
                EXPECT_TRUE(program.linked()) << light << ' ' << materials[i] << '\n'
                                              << toString(mapLog(program.fragmentLog(), source));
                EXPECT_EQ(toString(problems), "");
            }
    EXPECT_EQ(count, 40);
}

// --- the checker -------------------------------------------------------------------------------------------------

Scene checkered(const std::string& camera, const std::string& checker) {
    return sceneFrom(R"({"camera": )" + camera + R"(, "background": {"color": 0.5},
        "materials": {"m": {"ambient": 1, "checker": )" +
                     checker + R"(}, "plain": {"ambient": [0.2, 0.4, 0.6]}},
        "objects": [{"plane": {"point": [0, 0, 0], "normal": [0, 1, 0]}, "material": "m"},
                    {"sphere": {"center": [0, 1, -3], "radius": 0.4}, "material": "plain"}]})");
}

TEST(Checker, HasItsColoursInSquaresOfTheSurfacesCoordinates) {
    const auto at = [](double x, double z) {
        const std::string position = std::to_string(x) + ", ", z_ = ", " + std::to_string(z) + "]";
        const Scene scene = checkered(R"({"up": [0, 0, -1], "fov": 1, "eye": [)" + position + "8" + z_ +
                                          R"(, "target": [)" + position + "0" + z_ + "}",
                                      R"({"colors": [[1, 0.5, 0], 0.25], "scale": [2, 1]})");
        Settings settings = sized(9, 9, 1);
        const float* p = outputOf(scene, settings, Aov::Color).at(4, 4);
        return glm::vec3(p[0], p[1], p[2]);
    };
    const glm::vec3 first(1, 0.5f, 0), second(0.25f);
    for (int i = -3; i < 4; ++i)
        for (int j = -2; j < 3; ++j)
            EXPECT_LE(glm::distance(at(0.5 * i + 0.25, j + 0.5), (i + j) % 2 == 0 ? first : second), 2e-4)
                << i << ' ' << j;
}

// Averaged over what a pixel covers: beside 400 points of each pixel, which the box about it encloses.
TEST(Checker, IsAveragedOverThePixel) {
    const Scene scene = checkered(R"({"eye": [1, 2, 6], "target": [0, 0, -6], "fov": 40})", R"({"colors": [1, 0]})");
    constexpr int kWidth = 80, kHeight = 60, kFine = 20;
    const FloatImage image = outputOf(scene, sized(kWidth, kHeight, 1), Aov::Color);
    const FloatImage object = outputOf(scene, sized(kWidth, kHeight, 1), Aov::Object);
    double squares = 0, worst = 0;
    int count = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            if (*object.at(x, y) != 0) continue;
            double sum = 0;
            for (int i = 0; i < kFine * kFine; ++i) {
                oracle::Vec o, d;
                oracle::pixelRay(scene.camera, x * kFine + i % kFine, y * kFine + i / kFine, kWidth * kFine,
                                 kHeight * kFine, o, d);
                const oracle::Vec p = o - o.y / d.y * d;
                sum += d.y < 0 && (int(std::floor(p.x)) + int(std::floor(p.z))) % 2 == 0;
            }
            const double by = std::abs(*image.at(x, y) - sum / (kFine * kFine));
            squares += by * by;
            worst = std::max(worst, by);
            ++count;
        }
    const double rmse = std::sqrt(squares / count);
    std::printf("checker: %d pixels, rmse %.3f, worst %.3f\n", count, rmse, worst);
    EXPECT_GT(count, 2000);
    EXPECT_LE(rmse, 0.08);
    EXPECT_LE(worst, 0.45);
    // The sphere's material has none.
    const float* plain = image.at(0, 0);
    for (int i = 0; i < kWidth * kHeight; ++i)
        if (object.pixels[std::size_t(i)] == 1) plain = image.at(i % kWidth, i / kWidth);
    EXPECT_EQ(glm::vec3(plain[0], plain[1], plain[2]), glm::vec3(0.2f, 0.4f, 0.6f));
}

} // namespace
} // namespace gnomon
