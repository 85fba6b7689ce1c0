/// Programs whose text is another and whose meaning is the same draw the same: what the builder wrote is rewritten
/// (tests/support/glsl_mutator.h) on its way to the GL, all of it, generated solids, too.
///
/// A compiler may do more with one text than with another. GLSL ES 3.00 has no `precise`: Mesa makes a b + a c into
/// a (b + c) and more of this kind wherever it sees both at once, and a condition between them hides one from the
/// other. So there are two comparisons. With each operation behind an optimisation barrier nothing is left to put
/// together. As the shaders are shipped, what has to agree is what docs/numerics.md promises.
///
/// Scope   lite, torus, mandelbulb, a random scene, and an intersector a shape; GNOMON_MUTATIONS=N takes N of
///         each instead of one, more scenes, and outputs that tell what the others do
/// Bound   behind barriers none: objects, distances and colours are equal bit for bit. As shipped objects and distances
///         are, too, colours within kShipped of light's scale; intersectors keep their bounds
/// Fails   with the seed
#include "lab/batch/ray_batch.h"
#include "lab/intersect/compare_hit.h"
#include "lab/intersect/subjects.h"
#include "tests/support/glsl_mutator.h"
#include "tests/support/offscreen.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"
#include "tracer/gl/gl.h"
#include "tracer/scene/read_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <utility>

namespace gnomon::test {
namespace {

using Rewrite = std::function<std::string(std::string_view)>;

/// Shaders that are compiled meanwhile are given to the GL as `rewrite` makes them.
class Rewritten {
  public:
    explicit Rewritten(Rewrite rewrite) {
        rewrite_ = std::move(rewrite);
        real_ = glad_glShaderSource;
        glad_glShaderSource = give;
    }
    ~Rewritten() { glad_glShaderSource = real_; }
    Rewritten(const Rewritten&) = delete;
    Rewritten& operator=(const Rewritten&) = delete;

  private:
    static void GLAD_API_PTR give(GLuint shader, GLsizei, const GLchar* const* texts, const GLint*) {
        const std::string text = rewrite_(texts[0]);
        const GLchar* one = text.c_str();
        real_(shader, 1, &one, nullptr);
    }
    static inline Rewrite rewrite_;
    static inline PFNGLSHADERSOURCEPROC real_ = nullptr;
};

Rewrite by(const Mutations& mutations) {
    return [mutations](std::string_view text) { return mutated(text, mutations); };
}

std::uint64_t mutationsAsked() {
    const char* text = std::getenv("GNOMON_MUTATIONS");
    return text ? std::strtoull(text, nullptr, 10) : 0;
}

constexpr double kShipped = 0x1p-14; ///< measured 2^-17.5

std::uint64_t seeds() { return std::max<std::uint64_t>(mutationsAsked(), 1); }

/// Distances and colours take most of what there is to compile.
std::vector<Aov> outputs() {
    return mutationsAsked() ? std::vector{Aov::Object, Aov::Distance, Aov::Color}
                            : std::vector{Aov::Distance, Aov::Color};
}

std::vector<std::string> scenes() {
    std::vector<std::string> names{"lite", "torus", "mandelbulb", "random3"};
    if (mutationsAsked())
        names.insert(names.end(),
                     {"solids", "pro", "complex", "shapes", "random0", "random5", "random6", "random8", "random9"});
    return names;
}

/// By a scene's name, or `random` and its family.
struct Picture {
    Scene scene;
    Settings settings;
};
Picture pictureOf(const std::string& name) {
    Picture picture;
    if (name.starts_with("random")) {
        const std::uint64_t seed = kFamily * std::strtoull(name.c_str() + 6, nullptr, 10);
        picture = {sceneFrom(randomScene(seed)), randomSettings(seed)};
    } else {
        picture.scene = sceneNamed(name);
    }
    picture.settings.size = {32, 24};
    picture.settings.variants = Variants::Off; // half as much to compile
    return picture;
}

FloatImage drawn(const Picture& picture, Aov aov, const Rewrite& rewrite) {
    offscreen();
    const Rewritten during(rewrite);
    Settings settings = picture.settings;
    settings.aov = aov;
    Problems problems;
    Renderer renderer;
    renderer.configure(settings);
    renderer.setScene(picture.scene, problems);
    for (const std::string& name : imagesOf(picture.scene)) renderer.setImage(name, noise(name));
    renderer.finish(problems);
    FloatImage image = renderer.readOutput({picture.scene.camera, settings.time, 32, 24}, problems);
    EXPECT_EQ(toString(problems), "");
    return image;
}

class EquivalentSources : public testing::TestWithParam<std::string> {};

TEST_P(EquivalentSources, GiveTheSameFloatsBehindBarriers) {
    const Picture picture = pictureOf(GetParam());
    for (const Aov aov : outputs()) {
        const FloatImage wanted = drawn(picture, aov, by({.kinds = 0, .barriers = true}));
        for (std::uint64_t seed = 1; seed <= seeds(); ++seed)
            EXPECT_EQ(difference(wanted, drawn(picture, aov, by({.seed = seed, .barriers = true}))), "")
                << "output " << int(aov) << ", seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, EquivalentSources, testing::ValuesIn(scenes()),
                         [](const auto& test) { return test.param; });

class ShippedSources : public testing::TestWithParam<std::string> {};

TEST_P(ShippedSources, GiveTheSameDistancesAndNearlyTheSameColours) {
    const Picture picture = pictureOf(GetParam());
    for (const Aov aov : outputs()) {
        const FloatImage wanted = drawn(picture, aov, [](std::string_view text) { return std::string(text); });
        for (std::uint64_t seed = 1; seed <= seeds(); ++seed) {
            const FloatImage is = drawn(picture, aov, by({.seed = seed}));
            if (aov != Aov::Color) {
                EXPECT_EQ(difference(wanted, is), "") << "output " << int(aov) << ", seed " << seed;
                continue;
            }
            double most = 0;
            for (std::size_t i = 0; i < is.pixels.size(); ++i)
                most = std::max(most, std::abs(double(wanted.pixels[i]) - double(is.pixels[i])));
            EXPECT_LE(most, kShipped) << "seed " << seed;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedSources,
                         testing::ValuesIn(mutationsAsked() ? scenes() : std::vector<std::string>{"lite", "torus"}),
                         [](const auto& test) { return test.param; });

class EquivalentIntersectors : public testing::TestWithParam<oracle::Subject> {};

TEST_P(EquivalentIntersectors, KeepTheirBounds) {
    offscreen();
    const Shape shape = oracle::placed(GetParam(), oracle::RayClass::Grazing, 1000);
    oracle::RayStream stream(shape, oracle::RayClass::Grazing, 1000, 1);
    std::vector<BatchRay> rays(20000);
    for (BatchRay& ray : rays) ray = stream.next();
    for (std::uint64_t seed = 1; seed <= seeds(); ++seed) {
        const Rewritten during(by({.seed = seed}));
        Problems problems;
        RayBatch batch(oracle::sceneOf({shape}), problems);
        ASSERT_TRUE(batch.valid()) << toString(problems);
        EXPECT_TRUE(within(oracle::compareHits(shape, rays, batch.trace(rays)), oracle::boundsOf(shape.kind)))
            << "seed " << seed;
    }
}

INSTANTIATE_TEST_SUITE_P(Subjects, EquivalentIntersectors, testing::ValuesIn(oracle::subjects()),
                         [](const auto& test) { return test.param.name(); });

// The comparison sees a constant of an intersector that is a thousandth off, and each kind of mutation writes other
// code.
TEST(EquivalentSource, TellsAnotherConstant) {
    const Picture picture = pictureOf("lite");
    const auto other = [](std::string_view text) {
        std::string changed = mutated(text, {.barriers = true});
        const std::string right = "float h2 =";
        const std::size_t at = changed.find(right);
        if (at != changed.npos) changed.replace(at, right.size(), "float h2 = 1.001 *");
        return changed;
    };
    const FloatImage wanted = drawn(picture, Aov::Distance, by({.kinds = 0, .barriers = true}));
    EXPECT_NE(difference(wanted, drawn(picture, Aov::Distance, other)), "");
}

TEST(EquivalentSource, IsOtherCodeByEachKindAndTheSameForASeed) {
    std::string text;
    drawn(pictureOf("lite"), Aov::Distance, [&](std::string_view given) {
        if (given.find("uniform Frame") != given.npos && given.size() > text.size()) text = given;
        return std::string(given);
    });
    const std::string unchanged = mutated(text, {.kinds = 0});
    for (unsigned kind = 1; kind <= kAllMutations; kind *= 2) {
        const std::string changed = mutated(text, {.kinds = kind});
        EXPECT_NE(changed, unchanged) << kind;
        EXPECT_EQ(changed, mutated(text, {.kinds = kind})) << kind;
        EXPECT_NE(changed, mutated(text, {.seed = 2, .kinds = kind})) << kind;
    }
}

} // namespace
} // namespace gnomon::test
