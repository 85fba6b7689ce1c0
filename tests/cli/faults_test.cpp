// One thing fails, wherever: the n-th allocation, the n-th call that writes a file. Each command says so in words, with
// an exit code of its own, and what stood in its output before is whole: the old file or the new one.
#include "tests/cli/cli.h"

#include <cmath>

namespace {

struct Command {
    const char *words, *output;
    int samples; ///< of the allocations: `render` and `bench` take longer
};
const Command kCommands[] = {
    {"check scene.json", "", 60},
    {"render scene.json --size=8x6 -o old.png", "old.png", 24},
    {"report r.json -o old.html", "old.html", 60},
    {"bench scene.json --depth=1 --shadows=off --size=8x6 --repeats=1 --json=old.json", "old.json", 24}};

class Faults : public Cli {
  protected:
    void SetUp() override {
        write("scene.json", kScene);
        ASSERT_EQ(gnomon("bench lite --depth=1 --shadows=off --size=8x6 --repeats=1 --json=r.json").code, 0);
    }

    Answer withFault(const Command& command, const std::string& fault) {
        return gnomon(command.words, "env -u DISPLAY -u WAYLAND_DISPLAY LD_PRELOAD='" GNOMON_FAULTS "' " + fault);
    }

    struct Seen {
        long allocations = 0, calls = 0;
    };
    /// How many of either the command makes where nothing fails.
    Seen countFaults(const Command& command) {
        const fs::path file = folder_.string() + ".seen";
        EXPECT_EQ(withFault(command, "GNOMON_FAULTS_SEEN='" + file.string() + "'").code, 0) << command.words;
        Seen seen;
        std::ifstream(file) >> seen.allocations >> seen.calls;
        fs::remove(file);
        EXPECT_GT(seen.allocations, 100) << command.words;
        return seen;
    }

    /// What stood there before, or the new file to its end; and no draft beside it.
    void expectTold(const Command& command, const std::string& fault) {
        if (*command.output) write(command.output, "old");
        const std::size_t before = files();
        const Answer run = withFault(command, fault);
        const std::string about =
            std::string(command.words) + " with " + fault + ": " + std::to_string(run.code) + "\n" + run.err;
        EXPECT_TRUE(run.code == 0 || run.code == 1 || run.code == 3) << about;
        EXPECT_EQ(run.code != 0, run.err.starts_with("gnomon: error: ")) << about;
        if (!*command.output) return;
        const std::string kept = readText(folder_ / command.output);
        const std::string_view end = fs::path(command.output).extension() == ".png" ? "IEND\xAE\x42\x60\x82" : "\n";
        EXPECT_TRUE(kept.ends_with(end) || (kept == "old" && run.code != 0)) << about;
        EXPECT_EQ(files(), before) << about;
    }
};

} // namespace

TEST_F(Faults, AllocationsThatFailAreTold) {
    for (const Command& command : kCommands) {
        const long all = countFaults(command).allocations;
        for (int i = 0; i < command.samples; ++i) {
            // The first ones, then ever farther apart: what allocates most is a loop.
            const long n = std::max<long>(i + 1, std::lround(std::pow(double(all), double(i + 1) / command.samples)));
            expectTold(command, "GNOMON_FAIL_ALLOCATION=" + std::to_string(n));
        }
    }
}

TEST_F(Faults, CallsThatFailAreTold) {
    for (const Command& command : kCommands) {
        const long all = countFaults(command).calls;
        EXPECT_GE(all, *command.output ? 4 : 0) << command.words << ": it opens, writes, syncs and renames";
        for (long n = 1; n <= all; ++n) expectTold(command, "GNOMON_FAIL_CALL=" + std::to_string(n));
    }
}
