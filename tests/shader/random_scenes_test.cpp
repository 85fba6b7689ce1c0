/// Whole scenes at random, each drawn in every way that must make no difference: every float is the same.
///
/// After GraphicsFuzz: no oracle says what is right, but programs that compute the same in another order, from other
/// memory or with other code around it agree. They do not where a search loses a hit, where rounding decides who is
/// first, or where a driver compiles wrongly.
///
/// Scope   416 scenes, 32 of each of 13 families: what takes long is to compile a family. GNOMON_SCENES=N takes N, all
/// of
///         a family; GNOMON_SEED=N the one with that number. Every other way in families of even number, the rest in
///         those of odd number.
/// Bound   none: objects, distances and colours equal bit for bit
/// Fails   with the seed; the scene then lies in build/random-scenes/SEED.json
#include "tests/support/offscreen.h"
#include "tests/support/random_scene.h"
#include "tracer/gl/gl.h"
#include "tracer/scene/read_scene.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <vector>

namespace gnomon {
namespace {

using namespace test;

constexpr int kFamilies = 13;
constexpr std::uint64_t kOfEach = 32;
static_assert(kFamilies * kOfEach >= 200 && kOfEach <= kFamily);

/// What the GL calls itself while a renderer is made: it then tunes its shaders for another.
class Renamed {
  public:
    explicit Renamed(const char* name) {
        name_ = name;
        if (name) glad_glGetString = answer;
    }
    ~Renamed() { glad_glGetString = real_; }
    Renamed(const Renamed&) = delete;
    Renamed& operator=(const Renamed&) = delete;

  private:
    static const GLubyte* GLAD_API_PTR answer(GLenum what) {
        return what == GL_RENDERER ? reinterpret_cast<const GLubyte*>(name_) : real_(what);
    }
    static inline const char* name_ = nullptr;
    static inline PFNGLGETSTRINGPROC real_ = nullptr;
    PFNGLGETSTRINGPROC saved_ = real_ = glad_glGetString;
};

struct Way {
    const char* name;
    Accel accel;
    DataPath data;
    Variants variants;
    const char* renderer = nullptr; ///< what the GL is taken for; null: what it is
};

/// The first is what the others are compared with: each ray asks each object.
constexpr Way kWays[]{
    {"no search, from a texture", Accel::None, DataPath::Texture, Variants::Off},
    {"no search, from a block", Accel::None, DataPath::Block, Variants::Off},
    {"hierarchies", Accel::Hierarchy, DataPath::Texture, Variants::Off},
    {"the cheapest search", Accel::Auto, DataPath::Block, Variants::Off},
    {"shader variants", Accel::Auto, DataPath::Auto, Variants::On},
    {"as on a GPU", Accel::Auto, DataPath::Auto, Variants::Auto, "some GPU"},
    {"as in SwiftShader", Accel::Hierarchy, DataPath::Auto, Variants::On, "SwiftShader"},
};
constexpr Aov kOutputs[]{Aov::Object, Aov::Distance, Aov::Color};

/// One way, with the programs of a family of scenes.
class Tracer {
  public:
    explicit Tracer(const Way& way, std::span<const ShaderFile> overrides = {}) : way_(way) {
        const Renamed renamed(way.renderer);
        renderer_ = std::make_unique<Renderer>(overrides);
    }

    FloatImage output(const Scene& scene, std::uint64_t seed, Aov aov) {
        Settings settings = randomSettings(seed);
        settings.size = {32, 24};
        settings.accel = way_.accel;
        settings.data = way_.data;
        settings.variants = way_.variants;
        settings.aov = aov;
        Problems problems;
        renderer_->configure(settings);
        renderer_->setScene(scene, problems);
        for (const std::string& image : imagesOf(scene)) renderer_->setImage(image, noise(image));
        renderer_->finish(problems);
        FloatImage image = renderer_->readOutput({scene.camera, settings.time, 32, 24}, problems);
        EXPECT_EQ(toString(problems), "") << "seed " << seed << ", " << way_.name;
        return image;
    }

  private:
    const Way& way_;
    std::unique_ptr<Renderer> renderer_;
};

std::string kept(std::uint64_t seed) {
    const auto folder = std::filesystem::path(GNOMON_SOURCE_DIR) / "build/random-scenes";
    std::filesystem::create_directories(folder);
    const auto file = folder / (std::to_string(seed) + ".json");
    std::ofstream(file) << randomScene(seed) << '\n';
    return file.string();
}

/// Half of the other ways, beside the first of all.
std::vector<Way> waysOf(std::uint64_t family) {
    std::vector<Way> ways{kWays[0]};
    for (std::size_t i = 1 + family % 2; i < std::size(kWays); i += 2) ways.push_back(kWays[i]);
    return ways;
}

/// All seeds from `first` to before `last`, which are of one family.
void expectSame(std::uint64_t first, std::uint64_t last) {
    offscreen();
    const std::vector<Way> ways = waysOf(first / kFamily);
    std::vector<Tracer> tracers(ways.begin(), ways.end());
    for (std::uint64_t seed = first; seed < last; ++seed) {
        Problems problems;
        const auto scene = readScene(randomScene(seed), "seed " + std::to_string(seed), problems);
        ASSERT_TRUE(scene) << toString(problems) << kept(seed);
        for (const Aov aov : kOutputs) {
            const FloatImage wanted = tracers[0].output(*scene, seed, aov);
            for (std::size_t way = 1; way < ways.size(); ++way) {
                const std::string unlike = difference(wanted, tracers[way].output(*scene, seed, aov));
                if (unlike.empty()) continue;
                ADD_FAILURE() << "seed " << seed << ", output " << int(aov) << ", " << ways[way].name << ": " << unlike
                              << "\nscene " << kept(seed);
            }
        }
    }
}

std::uint64_t numberIn(const char* variable) {
    const char* text = std::getenv(variable);
    return text ? std::strtoull(text, nullptr, 10) : 0;
}

class RandomScenes : public testing::TestWithParam<int> {};

TEST_P(RandomScenes, AreTheSameInEveryWay) {
    const std::uint64_t family = std::uint64_t(GetParam()), scenes = numberIn("GNOMON_SCENES");
    if (scenes == 0) expectSame(kFamily * family, kFamily * family + kOfEach);
    for (std::uint64_t first = kFamily * family; first < scenes; first += kFamily * kFamilies)
        expectSame(first, std::min(first + kFamily, scenes));
}

INSTANTIATE_TEST_SUITE_P(Families, RandomScenes, testing::Range(0, kFamilies));

// A hierarchy whose boxes are a little too small loses hits, and the comparison sees it.
TEST(RandomScene, TellsWhereASearchLosesHits) {
    offscreen();
    std::string text(shaderText("accel/hierarchy.glsl"));
    const std::string right = "9.5e-7 * (max(";
    ASSERT_NE(text.find(right), std::string::npos);
    text.replace(text.find(right), right.size(), "-1e-3 * (max(");
    const ShaderFile tight[]{{"accel/hierarchy.glsl", text}};
    Tracer each(kWays[0]), lost(kWays[2], tight);
    int unlike = 0;
    for (std::uint64_t seed = 0; seed < kOfEach; ++seed) {
        Problems problems;
        const auto scene = readScene(randomScene(seed), "seed " + std::to_string(seed), problems);
        ASSERT_TRUE(scene) << toString(problems);
        unlike += !difference(each.output(*scene, seed, Aov::Object), lost.output(*scene, seed, Aov::Object)).empty();
    }
    EXPECT_GT(unlike, 0);
}

// One seed again, the one that GNOMON_SEED names.
TEST(RandomScene, OfASeedIsTheSameInEveryWay) {
    const std::uint64_t seed = numberIn("GNOMON_SEED");
    expectSame(seed, seed + 1);
}

} // namespace
} // namespace gnomon
