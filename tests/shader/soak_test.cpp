/// One renderer for as long as asked: scenes, sizes, settings and images change, contexts are lost, and in the end it
/// holds what it held after the warm-up.
///
/// A turn draws a shipped or a random scene with settings of its own, every fourth turn a random one that never comes
/// again, then a still sphere. In phases the context is lost at each sphere, and now and then at the scene; between
/// them programs gather, up to those that the cache keeps. Memory is read at the sphere after a loss, where a renderer
/// that forgets nothing would show all it had. The driver's compiler is in it: what it keeps counts as growth, too.
///
/// Length  GNOMON_SOAK seconds; 5 by default, `scripts/test shader --long` asks for an hour
/// Bounds  pictures have the same bytes whenever they come again, and after a loss as many GL objects; never more
///         objects than the cache's programs need. By the least-squares line through the later two thirds of the
///         readings the heap in use grows by less than 4 KiB a turn, a tenth of one program's source, and resident
///         memory, which includes what fragments, by less than 16; judged from 300 s on
#include "native/file/asset_folder.h"
#include "tests/support/clouds.h"
#include "tests/support/offscreen.h"
#include "tests/support/random_scene.h"
#include "tests/support/scenes.h"
#include "tracer/clock.h"
#include "tracer/gl/generation.h"
#include "tracer/scene/read_scene.h"
#include "tracer/shader/program_cache.h"
#include "tracer/shader/shader_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <malloc.h>
#include <map>
#include <string>
#include <unistd.h>
#include <vector>

namespace gnomon::test {
namespace {

constexpr double kMiB = 1024 * 1024;
constexpr int kRandomScenes = 13; ///< that come again
constexpr int kPhase = 50;        ///< turns with losses, then as many without

constexpr double kJudged = 300;                     ///< seconds, from which on a line says something
constexpr double kMostHeap = 4, kMostResident = 16; ///< KiB a turn

/// Of the process, in MiB, without what malloc keeps of the largest compilation there was: hundreds of MiB.
double residentMemory() {
    malloc_trim(0);
    long pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return double(resident) * double(sysconf(_SC_PAGESIZE)) / kMiB;
}
/// What malloc has given out and not got back, in MiB.
double heap() {
    const struct mallinfo2 info = mallinfo2();
    return double(info.uordblks + info.hblkhd) / kMiB;
}

struct Reading {
    double turn, resident, heap;
};

/// Growth a turn by the least-squares line through the later two thirds.
double slopeOf(const std::vector<Reading>& all, double Reading::*value) {
    const std::vector<Reading> late(all.begin() + std::ptrdiff_t(all.size() / 3), all.end());
    double turn = 0, mean = 0, cross = 0, square = 0;
    for (const Reading& one : late) {
        turn += one.turn / double(late.size());
        mean += one.*value / double(late.size());
    }
    for (const Reading& one : late) {
        cross += (one.turn - turn) * (one.*value - mean);
        square += (one.turn - turn) * (one.turn - turn);
    }
    return cross / std::max(square, 1.0);
}

/// A scene and how it is drawn.
struct Subject {
    std::string name;
    Scene scene;
    Settings settings;
    int side = 8;      ///< of its images
    bool once = false; ///< it does not come again
};

void resize(Subject& subject, Dice& dice) {
    subject.settings.size = {8 + int(dice.number(0, 60)), 8 + int(dice.number(0, 40))};
    subject.side = 1 << int(dice.number(0, 7));
}

/// The first scene of a family.
Subject randomSubject(std::uint64_t family, Dice& dice) {
    Problems problems;
    const auto scene = readScene(randomScene(kFamily * family), "random", problems);
    EXPECT_TRUE(scene) << toString(problems);
    Subject subject{"family " + std::to_string(family), scene.value_or(Scene{}), randomSettings(kFamily * family)};
    resize(subject, dice);
    return subject;
}

std::vector<Subject> shippedAndRandom() {
    std::vector<Subject> deck;
    Dice dice(1);
    for (const std::string& name : AssetFolder(std::string(GNOMON_SOURCE_DIR) + "/assets").sceneNames()) {
        Settings settings;
        settings.depth = 1 + int(dice.number(0, 4));
        settings.shadows = dice.number(0, 1) < 0.7 ? ShadowModel::Hard : ShadowModel::Off;
        settings.data = DataPath(int(dice.number(0, 3)));
        settings.accel = Accel(int(dice.number(0, 3)));
        settings.variants = Variants(int(dice.number(0, 3)));
        deck.push_back({name, sceneNamed(name), settings});
    }
    for (int family = 0; family < kRandomScenes; ++family) deck.push_back(randomSubject(std::uint64_t(family), dice));
    for (Subject& one : deck) resize(one, dice);
    return deck;
}

/// The renderer that lives through all of it.
class Soak {
  public:
    /// As it was drawn first, with as many objects after each loss.
    void draw(const Subject& subject, bool lose) {
        Problems problems;
        renderer_.configure(subject.settings);
        ASSERT_TRUE(renderer_.setScene(subject.scene, problems)) << subject.name << ": " << toString(problems);
        for (const std::string& name : imagesOf(subject.scene)) renderer_.setImage(name, noise(name, subject.side));
        if (lose) {
            renewContext();
            ASSERT_EQ(gl::liveObjects(), 0);
            renderer_.contextRestored();
            ++losses;
        }
        ASSERT_TRUE(renderer_.finish(problems)) << subject.name << ": " << toString(problems);
        const Settings& settings = subject.settings;
        const Image image =
            renderer_.readPicture({subject.scene.camera, settings.time, settings.size.x, settings.size.y}, problems);
        ++switches;
        ASSERT_LE(gl::liveObjects(), 64 + 3 * int(ProgramCache::kMostKept)) << "a program has two shaders";
        if (subject.once) return;
        const Image& first = pictures_.emplace(subject.name, image).first->second;
        ASSERT_EQ(first.rgba, image.rgba) << subject.name << " after " << losses << " losses";
        if (!lose) return;
        ASSERT_EQ(objects_.emplace(subject.name, gl::liveObjects()).first->second, gl::liveObjects());
    }

    void report(double seconds) const {
        std::printf("%6.0f s: %d switches, %d losses, %d shaders, %d objects, resident %.1f MiB, heap %.1f MiB\n",
                    seconds, switches, losses, builtShaders(), gl::liveObjects(), residentMemory(), heap());
        std::fflush(stdout);
    }

    int switches = 0, losses = 0;

  private:
    Renderer renderer_;
    std::map<std::string, Image> pictures_;
    std::map<std::string, int> objects_;
};

TEST(Soak, HoldsInTheEndWhatItHeldAfterTheWarmUp) {
    const char* asked = std::getenv("GNOMON_SOAK");
    const double seconds = asked ? std::atof(asked) : 5;
    offscreen();
    const std::vector<Subject> deck = shippedAndRandom();
    const Subject still{"still", sceneFrom(R"({"objects": [{"sphere": {"center": [0, 0, 0], "radius": 1}}]})"), {}};
    Soak soak;
    Dice dice(2);
    std::vector<Reading> readings;
    const double begun = monotonicSeconds();
    for (int turn = 1; monotonicSeconds() - begun < seconds; ++turn) {
        const bool calm = turn / kPhase % 2 == 1; // programs gather, up to those that the cache keeps
        if (turn % 4 == 0) {
            Subject other = randomSubject(std::uint64_t(kRandomScenes + turn), dice);
            other.once = true;
            ASSERT_NO_FATAL_FAILURE(soak.draw(other, false));
        }
        const Subject& subject = deck[std::size_t(dice.number(0, double(deck.size())))];
        ASSERT_NO_FATAL_FAILURE(soak.draw(subject, !calm && turn % 8 == 0));
        for (int i = 0; i < 3; ++i) ASSERT_NO_FATAL_FAILURE(soak.draw(still, !calm));
        if (!calm) readings.push_back({double(turn), residentMemory(), heap()});
        if (turn % kPhase == 0) soak.report(monotonicSeconds() - begun);
    }
    ASSERT_GT(readings.size(), 2U);
    const double resident = 1024 * slopeOf(readings, &Reading::resident),
                 inUse = 1024 * slopeOf(readings, &Reading::heap);
    const Reading &first = readings.front(), &middle = readings[readings.size() / 2], &last = readings.back();
    std::printf("start, middle, end and a turn: resident %.1f, %.1f, %.1f MiB, %.2f KiB; heap %.1f, %.1f, %.1f MiB, "
                "%.2f KiB\n",
                first.resident, middle.resident, last.resident, resident, first.heap, middle.heap, last.heap, inUse);
    if (seconds < kJudged) return;
    EXPECT_LT(inUse, kMostHeap);
    EXPECT_LT(resident, kMostResident);
}

} // namespace
} // namespace gnomon::test
