/// Whole scenes at random against the exact answers: which object a ray meets, where, and with which normal.
///
/// Rays    those that nearestHit() of the shader library is given: of cameras anywhere, far and near, within and
///         grazing; about an object in every class of tests/shader/intersect_test.cpp; and, of what those have met,
///         mirrored, bent and shadow rays, which start on a surface
/// Scenes  of all that scene files may hold, by every search; a Mandelbulb, which has an estimate only, makes undecided
///         what may meet it. No march by equal steps, which may miss what is thin: tests/shader/solid_test.cpp
/// Bounds  those of the shapes' files (lab/intersect/compare_hit.cpp, scene_object.h). A ray is decided where one
/// answer
///         only is right: not where it is in the band of an object that may come first, or where two surfaces are
///         nearer to each other than their bounds, unless these are of equal objects: then the first is right
/// Scope   GNOMON_RAYS says how many rays, about; `scripts/test shader --long` asks for 10 million
#include "lab/intersect/compare_scene_hit.h"
#include "lab/reference/exact/scene_hit.h"
#include "tests/support/offscreen.h"
#include "tests/support/random_scene.h"
#include "tests/support/scene_rays.h"
#include "tracer/scene/read_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <thread>

namespace gnomon {
namespace {

using namespace test;
using namespace oracle;

constexpr int kPrimary = 4096; ///< through a scene; almost as many start on what they meet

std::int64_t raysAsked() {
    const char* asked = std::getenv("GNOMON_RAYS");
    return asked ? std::atoll(asked) : 200000;
}

/// To compile the programs of a family takes as long as some 100 000 rays.
int families() { return raysAsked() < 1000000 ? 6 : 40; }

struct Search {
    const char* name;
    Accel accel;
    DataPath data;
};
constexpr Search kSearches[]{{"none, from a block", Accel::None, DataPath::Block},
                             {"hierarchies", Accel::Hierarchy, DataPath::Texture},
                             {"the cheapest", Accel::Auto, DataPath::Texture}};

Scene sceneOf(std::uint64_t seed) {
    Problems problems;
    const auto scene = readScene(randomScene(seed, Variety::Full), "seed " + std::to_string(seed), problems,
                                 [&](const std::string&, Problems&) { return std::optional(randomMesh(seed)); });
    EXPECT_EQ(toString(problems), "");
    return scene.value_or(Scene{});
}

Settings settingsOf(std::uint64_t seed, const Search& search) {
    Settings settings = randomSettings(seed);
    if (settings.march == March::Steps) settings.march = March::Cone;
    settings.marchSteps = 16384; // what a march does not reach in so many it does not meet
    settings.accel = search.accel;
    settings.data = search.data;
    return settings;
}

/// Of a camera of 50 degrees and 480 rows, in every second family; else what is marched to is met to the last bit.
float pixelAngleOf(std::uint64_t seed) { return seed / kFamily % 2 ? 0.002f : 0; }

/// What has been found, by the kind that is rightly met; nothing is a kind, too.
struct Row {
    std::int64_t decided = 0, wrong = 0;
    double ray = 0, point = 0, normal = 0;
};
struct Count {
    std::int64_t primary = 0, secondary = 0, decided[2] = {0, 0};
    std::map<std::string, Row> rows;
    std::map<std::string, int> faults;

    std::int64_t wrong() const {
        std::int64_t sum = 0;
        for (const auto& [name, count] : faults) sum += count;
        return sum;
    }
    void add(const SceneOracle& exact, const BatchRay& ray, const SceneVerdict& verdict);
    void add(const Count&);
    void print(const char* what) const;
};

std::string kindOf(const SceneOracle& exact, int object) {
    return object < 0 ? "nothing" : std::string(shapeRow(exact.kindOf(object)).key);
}

void Count::add(const SceneOracle& exact, const BatchRay& ray, const SceneVerdict& verdict) {
    ++(ray.side == 0 ? primary : secondary);
    if (verdict.fault != Fault::None) ++faults[std::string(nameOf(verdict.fault))];
    if (!verdict.decided) return;
    ++decided[ray.side != 0];
    Row& row = rows[kindOf(exact, verdict.object)];
    ++row.decided;
    row.wrong += verdict.fault != Fault::None;
    row.ray = std::max(row.ray, verdict.errors.ray);
    row.point = std::max(row.point, verdict.errors.point);
    row.normal = std::max(row.normal, verdict.errors.normal);
}

void Count::add(const Count& other) {
    primary += other.primary;
    secondary += other.secondary;
    for (int i = 0; i < 2; ++i) decided[i] += other.decided[i];
    for (const auto& [name, count] : other.faults) faults[name] += count;
    for (const auto& [name, row] : other.rows) {
        Row& own = rows[name];
        own = {own.decided + row.decided, own.wrong + row.wrong, std::max(own.ray, row.ray),
               std::max(own.point, row.point), std::max(own.normal, row.normal)};
    }
}

void Count::print(const char* what) const {
    std::printf("%s: %lld primary rays, %lld decided; %lld from surfaces, %lld decided; %lld wrong\n", what,
                (long long)primary, (long long)decided[0], (long long)secondary, (long long)decided[1],
                (long long)wrong());
    for (const auto& [name, count] : faults) std::printf("  %s %d\n", name.c_str(), count);
    for (const auto& [name, row] : rows)
        std::printf("  %-16s %9lld decided, %lld wrong; ray %.2f, point %.2f, normal %.2f\n", name.c_str(),
                    (long long)row.decided, (long long)row.wrong, row.ray, row.point, row.normal);
}

/// A wrong answer, to the last bit.
std::string described(const SceneOracle& exact, const BatchRay& ray, const BatchHit& hit, const SceneVerdict& verdict) {
    char text[1000];
    const auto meeting = [&](int object) {
        if (object < 0) return std::string("nothing");
        const Meeting m = exact.meetingWith(object, ray);
        char of[200];
        std::snprintf(of, sizeof of, "%s %d (t from %.9g to %.9g%s, tangency %.3g)", kindOf(exact, object).c_str(),
                      object, m.from, m.by, m.decided ? "" : ", undecided", m.exact.tangency);
        return std::string(of);
    };
    std::snprintf(text, sizeof text,
                  "%s: o = (%a, %a, %a), d = (%a, %a, %a), side %g: told %s at %.9g, right is %s%s; errors: ray "
                  "%.3g, point %.3g, normal %.3g",
                  std::string(nameOf(verdict.fault)).c_str(), ray.origin.x, ray.origin.y, ray.origin.z, ray.direction.x,
                  ray.direction.y, ray.direction.z, ray.side, meeting(hit.object).c_str(), hit.t,
                  verdict.decided ? "" : "undecided, ", meeting(verdict.object).c_str(), verdict.errors.ray,
                  verdict.errors.point, verdict.errors.normal);
    return text;
}

/// On all cores.
std::vector<SceneVerdict> compared(const SceneOracle& exact, const std::vector<BatchRay>& rays,
                                   const std::vector<BatchHit>& hits) {
    std::vector<SceneVerdict> verdicts(rays.size());
    const std::size_t workers = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::thread> threads;
    for (std::size_t worker = 0; worker < workers; ++worker)
        threads.emplace_back([&, worker] {
            for (std::size_t i = worker; i < rays.size(); i += workers) verdicts[i] = exact.compare(rays[i], hits[i]);
        });
    for (std::thread& thread : threads) thread.join();
    return verdicts;
}

/// The programs of one family of scenes, one a search.
class Family {
  public:
    explicit Family(std::span<const ShaderFile> overrides = {}) : overrides_(overrides) {}

    /// Rays through one scene. The first wrong ones of each sort are described.
    Count trace(std::uint64_t seed, std::size_t search, std::vector<std::string>& wrong) {
        const Scene scene = sceneOf(seed);
        const Settings settings = settingsOf(seed, kSearches[search]);
        Problems problems;
        auto& batch = batches_[search];
        if (!batch)
            batch = std::make_unique<RayBatch>(scene, settings, pixelAngleOf(seed), problems, overrides_);
        else
            batch->setScene(scene, problems);
        EXPECT_EQ(toString(problems), "") << "seed " << seed;
        Count count;
        if (!batch->valid()) return count;
        const SceneOracle exact(scene, settings.time);
        SceneRays made(scene, exact, seed);
        std::vector<BatchRay> rays = made.primary(kPrimary);
        std::vector<BatchHit> hits = batch->trace(rays);
        for (const bool again : {true, false}) {
            const std::vector<SceneVerdict> verdicts = compared(exact, rays, hits);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                count.add(exact, rays[i], verdicts[i]);
                const std::string sort = std::string(nameOf(verdicts[i].fault)) + kindOf(exact, hits[i].object);
                if (verdicts[i].fault != Fault::None && ++described_[sort] <= 2)
                    wrong.push_back("seed " + std::to_string(seed) + ", " + kSearches[search].name + ": " +
                                    described(exact, rays[i], hits[i], verdicts[i]));
            }
            if (again) rays = made.secondary(rays, hits), hits = batch->trace(rays);
        }
        return count;
    }

  private:
    std::span<const ShaderFile> overrides_;
    std::map<std::string, int> described_; ///< of each sort of fault
    std::array<std::unique_ptr<RayBatch>, std::size(kSearches)> batches_;
};

class RandomOracle : public testing::TestWithParam<int> {
  protected:
    void SetUp() override { offscreen(); }
    static void TearDownTestSuite() { total().print("all families"); }
    static Count& total() {
        static Count count;
        return count;
    }
};

TEST_P(RandomOracle, AgreesOnWhatRaysMeet) {
    const std::uint64_t first = kFamily * std::uint64_t(GetParam());
    Family family;
    Count count;
    std::vector<std::string> wrong;
    for (std::uint64_t scene = 0; scene < kFamily && families() * (count.primary + count.secondary) < raysAsked();
         ++scene)
        count.add(family.trace(first + scene, scene % std::size(kSearches), wrong));
    count.print(("family " + std::to_string(GetParam())).c_str());
    total().add(count);
    for (const std::string& text : wrong) std::printf("%s\n", text.c_str());
    EXPECT_EQ(count.wrong(), 0);
    EXPECT_GT(count.decided[0], count.primary / 2);
    EXPECT_GT(count.decided[1], count.secondary / 2);
}

/// The objects of a picture from the scene's own camera.
FloatImage objectsOf(const Scene& scene, Settings settings, int width, int height) {
    settings.size = {width, height};
    settings.aov = Aov::Object;
    Renderer renderer;
    Problems problems;
    renderer.configure(settings);
    renderer.setScene(scene, problems);
    for (const std::string& image : imagesOf(scene)) renderer.setImage(image, {1, 1, {255, 255, 255, 255}});
    renderer.finish(problems);
    FloatImage image = renderer.readOutput({scene.camera, settings.time, width, height}, problems);
    EXPECT_EQ(toString(problems), "");
    return image;
}

/// What float32 may make of a pixel's ray: the one through its middle, and four beside it, as far off as
/// tests/shader/outputs_test.cpp has it. Nothing where they do not agree.
std::optional<int> objectAt(const SceneOracle& exact, const CameraPose& pose, int x, int y, int width, int height) {
    Vec origin, direction;
    pixelRay(pose, x, y, width, height, origin, direction);
    const Vec right = glm::normalize(glm::cross(direction, Vec(0.3L, 0.5L, 0.8L))), up = glm::cross(right, direction);
    std::optional<int> object;
    for (const Vec off : {Vec(0), right, -right, up, -up}) {
        BatchRay ray;
        ray.origin = glm::vec3(origin);
        ray.direction = glm::vec3(glm::normalize(direction + 4e-7L * off));
        const SceneVerdict verdict = exact.compare(ray, {});
        if (!verdict.decided || (object && *object != verdict.object)) return std::nullopt;
        object = verdict.object;
    }
    return object;
}

// The way from a picture's pixels to nearestHit(), with the variants and the search that a program of users has.
TEST_P(RandomOracle, NamesTheObjectsOfAPicture) {
    constexpr int kWidth = 64, kHeight = 48;
    int decided = 0, wrong = 0;
    for (std::uint64_t seed = kFamily * std::uint64_t(GetParam()); seed % kFamily < 1; ++seed) {
        const Scene scene = sceneOf(seed);
        const Settings settings = settingsOf(seed, {"", Accel::Auto, DataPath::Auto});
        const SceneOracle exact(scene, settings.time);
        const FloatImage image = objectsOf(scene, settings, kWidth, kHeight);
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const auto object = objectAt(exact, scene.camera, x, y, kWidth, kHeight);
                if (!object) continue;
                ++decided;
                const int told = int(*image.at(x, y)), right = exact.fileIndexOf(*object);
                if (told != right && ++wrong <= 3)
                    ADD_FAILURE() << "seed " << seed << ", pixel " << x << ' ' << y << ": told " << told
                                  << ", right is " << right;
            }
    }
    std::printf("family %d: %d pixels decided, %d wrong\n", GetParam(), decided, wrong);
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(decided, kWidth * kHeight / 2);
}

INSTANTIATE_TEST_SUITE_P(Families, RandomOracle, testing::Range(0, families()));

// What ten million rays have found.

TEST(TorusRay, LeavesInwardFromAStartThatRoundingPutOutside) {
    offscreen();
    const Shape torus = inFloat(
        makeShape(ShapeKind::Torus, {{-1.31703272, 1.32462569, -2.57013388}, {0.699180567, 0.574985355, 0.424898077}},
                  {0.146389954, 0.0174853188}));
    Problems problems;
    RayBatch batch(oracle::sceneOf({torus}), problems);
    ASSERT_TRUE(batch.valid()) << toString(problems);
    BatchRay ray;
    ray.origin = {-0x1.48359p+0f, 0x1.5ae846p+0f, -0x1.5ae394p+1f};
    ray.direction = {0x1.31e8cp-1f, 0x1.972f12p-2f, -0x1.6487c6p-1f};
    ray.side = -1;
    ray.tMin = -1;
    EXPECT_NEAR(batch.trace(std::vector{ray})[0].t, 0.012344555, 2e-7);
}

// From 9016 units a pixel is 18 units wide.
TEST(SolidRay, MeetsASolidSmallerThanAPixel) {
    offscreen();
    std::vector<std::string> wrong;
    const Count count = Family().trace(7 * kFamily + 5, 2, wrong);
    EXPECT_EQ(count.wrong(), 0) << (wrong.empty() ? "" : wrong[0]);
    EXPECT_GT(count.rows.at("solid").decided, 100);
}

/// The shader library with one thought left out, and a family of scenes where that shows.
struct Mutant {
    const char* name;
    std::uint64_t family;
    std::size_t search; ///< of kSearches
    const char *file, *line, *becomes;
};
std::ostream& operator<<(std::ostream& out, const Mutant& mutant) { return out << mutant.name; }

const Mutant kMutants[] = {
    {"hierarchyWithBoxesTooSmall", 0, 1, "accel/hierarchy.glsl", "9.5e-7 * (max(", "-1e-3 * (max("},
    {"theLastOfEquals", 0, 1, "ray/nearest.glsl", "(limit < t || k$ShapeFirst + index < nearest)", "true"},
    {"rotatedBoxMetAsIfNotRotated", 1, 0, "primitive/rotated_box.glsl", "ray.direction * rotated.axes, enter",
     "ray.direction, enter"},
    {"rayThatNeverLeavesItsStart", 0, 0, "ray/ray.glsl", "object == ray.self ? ray.side : 0.0", "0.0"},
    {"solidMetTooDeep", 7, 0, "sdf/solid.glsl", "float finest = 1e-6", "float finest = 1e-4"},
};

class RandomOracleMutant : public testing::TestWithParam<Mutant> {};

// The comparison itself: a scene's rays pass, and do not with one line changed.
TEST_P(RandomOracleMutant, IsFoundWrong) {
    offscreen();
    const Mutant& mutant = GetParam();
    std::string text(shaderText(mutant.file));
    const std::size_t at = text.find(mutant.line);
    ASSERT_NE(at, std::string::npos) << mutant.file << " has no `" << mutant.line << "`";
    text.replace(at, std::string_view(mutant.line).size(), mutant.becomes);
    const ShaderFile overrides[] = {{mutant.file, text}};
    std::vector<std::string> wrong;
    const std::uint64_t seed = kFamily * mutant.family + 1;
    const Count sound = Family().trace(seed, mutant.search, wrong);
    const Count mutated = Family(overrides).trace(seed, mutant.search, wrong);
    std::printf("%s: %lld wrong of %lld\n", mutant.name, (long long)mutated.wrong(),
                (long long)(mutated.primary + mutated.secondary));
    EXPECT_EQ(sound.wrong(), 0);
    EXPECT_GT(mutated.wrong(), 0);
}

INSTANTIATE_TEST_SUITE_P(Mutants, RandomOracleMutant, testing::ValuesIn(kMutants),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace gnomon
