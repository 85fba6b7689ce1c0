// Frame rates compared in the page, as `gnomon bench` compares them: a plain C interface over BenchRun for
// page/compare.js.
//
// The order of use, once in a module's life: benchPlan; for each of its scenes benchScene, benchImageNames and
// benchImage; benchBegin; benchPrepare until it is finished; benchContinue; benchStart; benchMeasure until that is.
// benchResults at any time after benchBegin. Text as in host.h. Steps answer 0: ask again after a moment, 1: one more
// is done, 2: all is done.
#include "lab/bench/bench_series.h"
#include "lab/bench/bench_tables.h"
#include "tracer/clock.h"
#include "tracer/gl/gl.h"
#include "tracer/image.h"
#include "tracer/plan/pose.h"
#include "tracer/scene/read_scene.h"
#include "tracer/version.h"
#include "web/host.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace {

using namespace gnomon;

struct Bench {
    BenchPlan plan;
    std::vector<std::pair<std::string, std::string>> values;
    std::vector<BenchScene> scenes;
    std::unique_ptr<BenchRun> run;
    std::string source;
    Problems problems; ///< until the page takes them
};
std::unique_ptr<Bench> bench;

} // namespace

void onContextLost() {
    if (bench && bench->run) bench->run->contextLost();
}

void onContextRestored() {
    if (bench && bench->run) bench->run->contextRestored(bench->problems);
}

extern "C" {

/// Scenes' names one a line, settings in lines `key=VALUE,…`.
EMSCRIPTEN_KEEPALIVE const char* benchPlan(const char* scenes, const char* settings, const char* baseline,
                                           const char* source) {
    bench = std::make_unique<Bench>();
    bench->values = pairsOf(settings);
    bench->source = source;
    Problems problems;
    bench->plan = planBench(linesOf(scenes), bench->values, baseline, problems, source);
    return give(toString(problems));
}

/// Scenes, settings with what stood in for those not given, and what each row draws, in words: lines `scenes=NAME`,
/// `values=KEY=VALUE,…` and `rows=TEXT`.
EMSCRIPTEN_KEEPALIVE const char* benchPlanned() {
    std::string lines;
    for (const std::string& scene : bench->plan.scenes) lines += "scenes=" + scene + '\n';
    for (const auto& pair : valuesOf(bench->plan, bench->values))
        lines += "values=" + pair.first + '=' + pair.second + '\n';
    for (const BenchEntry& entry : bench->plan.entries) lines += "rows=" + toString(bench->plan, entry) + '\n';
    return give(std::move(lines));
}

/// The plan's next scene as a scene file's text.
EMSCRIPTEN_KEEPALIVE const char* benchScene(const char* text, const char* name) {
    Problems problems;
    std::optional<Scene> scene = readScene(text, std::string(name) + ".json", problems, givenFiles());
    if (scene) {
        scene->name = name;
        bench->scenes.push_back({std::move(*scene), {}});
    }
    return give(toString(problems));
}

/// Names of the images of the scene given last, one a line.
EMSCRIPTEN_KEEPALIVE const char* benchImageNames() { return give(inLines(imagesOf(bench->scenes.back().scene))); }

EMSCRIPTEN_KEEPALIVE const char* benchImage(const char* name, const std::uint8_t* bytes, int size, int width) {
    Problems problems;
    if (std::optional<Image> image = imageFrom(name, {bytes, std::size_t(size)}, width, problems))
        bench->scenes.back().images.emplace_back(name, std::move(*image));
    return give(toString(problems));
}

/// `clockStep` in seconds.
EMSCRIPTEN_KEEPALIVE const char* benchBegin(double clockStep) {
    Problems problems;
    for (const BenchEntry& entry : bench->plan.entries)
        if (!poseOf(bench->scenes[entry.scene].scene, entry.settings, bench->source, problems)) break;
    const BenchMeans means{monotonicSeconds, nullptr, clockStep, !gl::drawnByProcessor(gl::info().renderer), nullptr};
    if (problems.empty()) bench->run = std::make_unique<BenchRun>(bench->plan, bench->scenes, means, problems);
    return give(toString(problems));
}

EMSCRIPTEN_KEEPALIVE void benchLeaveOut(int row) { bench->run->leaveOut(std::size_t(row)); }
EMSCRIPTEN_KEEPALIVE int benchPrepare() { return int(bench->run->prepare(bench->problems)); }
/// With what benchSeries told of an earlier browser session with the same plan.
EMSCRIPTEN_KEEPALIVE const char* benchContinue(const char* series) {
    const std::vector<BenchCost> earlier = readSeries(series);
    if (earlier.size() != bench->plan.entries.size()) return "earlier: these are not the rows that are measured here\n";
    bench->run->continueFrom(earlier);
    return "";
}
EMSCRIPTEN_KEEPALIVE const char* benchSeries() { return give(seriesText(bench->run->costs())); }

/// One browser session of several, so that each need not compile anew so often. No round begins later than so many
/// seconds from now.
EMSCRIPTEN_KEEPALIVE void benchStart(int rounds, int sessions, double seconds) {
    bench->run->begin(rounds, std::max(1, kBenchPasses / sessions), monotonicSeconds() + seconds);
}
EMSCRIPTEN_KEEPALIVE int benchMeasure() { return int(bench->run->measure()); }

/// The row of the last step, as counted in the plan.
EMSCRIPTEN_KEEPALIVE int benchRow() { return int(bench->run->current()); }
EMSCRIPTEN_KEEPALIVE int benchDrawn() { return int(bench->run->drawn()); }
EMSCRIPTEN_KEEPALIVE int benchRounds() { return bench->run->rounds(); }
/// What was wrong since the last call.
EMSCRIPTEN_KEEPALIVE const char* benchProblems() { return give(toString(std::exchange(bench->problems, {}))); }

/// JSON of docs/results.md. Charts are of all `contexts`, one a line, the environment holds lines `name=value`.
EMSCRIPTEN_KEEPALIVE const char* benchResults(const char* context, const char* contexts, const char* environment,
                                              const char* command) {
    Environment known{{"gnomon", version()}, {"commit", commit()}, {"context", context}, {"gl", gl::info().version}};
    for (auto& pair : pairsOf(environment)) known.push_back(std::move(pair));
    const ContextCosts costs{context, known, bench->run->costs(), bench->run->rounds()};
    return give(toJson(benchResults(bench->plan, {costs}, linesOf(contexts), command)));
}

} // extern "C"
