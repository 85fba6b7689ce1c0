#include "native/bench_lab.h"

#include "native/contender.h"
#include "tracer/clock.h"
#include "tracer/gl/gl.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gnomon {
namespace {

/// A turn takes at least that long, so that clocks and the start of drawing weigh little on fast GPUs.
constexpr double kTurnSeconds = 0.04;
constexpr int kMostFrames = 500;

/// Programs are compiled anew so often, for where a program's code comes to lie in memory changes its times: by up to a
/// fifth on llvmpipe (docs/bench.md).
constexpr int kPasses = 3;

} // namespace

BenchLab::BenchLab(const BenchPlan& plan, const std::vector<Loaded>& scenes, const Context& context, Problems& problems)
    : plan_(plan), scenes_(scenes), clock_(labClock()), timer_(context), yardstick_(clock_, problems),
      costs_(plan.entries.size()), frames_(plan.entries.size(), 1) {}

BenchLab::~BenchLab() = default;

Renderer& BenchLab::rendererOf(std::size_t entry) {
    const BenchEntry& wanted = plan_.entries[entry];
    auto& renderer = renderers_[{wanted.scene, wanted.settings.size.x, wanted.settings.size.y}];
    if (renderer) return *renderer;
    renderer = std::make_unique<Renderer>();
    for (const auto& [name, image] : scenes_[wanted.scene].images) renderer->setImage(name, image);
    return *renderer;
}

View BenchLab::viewOf(std::size_t entry) const {
    const BenchEntry& wanted = plan_.entries[entry];
    Problems none; // checked before the first entry was drawn
    const auto pose = poseOf(scenes_[wanted.scene].scene, wanted.settings, none);
    return {*pose, wanted.settings.time, wanted.settings.size.x, wanted.settings.size.y};
}

void BenchLab::draw(std::size_t entry) {
    const View view = viewOf(entry);
    rendererOf(entry).drawRows(view, plan_.entries[entry].settings.scale, 0, view.height);
}

void BenchLab::prepareOne(std::size_t entry, Problems& problems) {
    const BenchEntry& wanted = plan_.entries[entry];
    const int side = std::max(wanted.settings.size.x, wanted.settings.size.y), most = gl::info().maxTextureSize;
    if (side > most) {
        problems.push_back(
            {{},
             0,
             {},
             "a side of " + std::to_string(side) + " pixels is more than this GL's " + std::to_string(most),
             "use a smaller --size"});
        return;
    }
    BenchCost& cost = costs_[entry];
    const bool isNew = !renderers_.contains({wanted.scene, wanted.settings.size.x, wanted.settings.size.y});
    Renderer& renderer = rendererOf(entry);
    renderer.configure(wanted.settings); // before there is a scene, so that no other program is compiled
    if (isNew && !renderer.setScene(scenes_[wanted.scene].scene, problems)) return;
    if (!renderer.finish(problems)) return;
    if (!cost.drawn) cost.program = renderer.stats();
    const double start = monotonicSeconds();
    draw(entry);
    glFinish();
    if (!cost.drawn) cost.firstSeconds = monotonicSeconds() - start;
    cost.drawn = gl::check("drawing a frame", problems);
}

void BenchLab::prepare(LabProgress& progress, Problems& problems) {
    const double start = monotonicSeconds();
    for (std::size_t i = 0; i < plan_.entries.size() && !LabProgress::interrupted(); ++i) {
        prepareOne(i, problems);
        progress.step();
    }
    prepareSeconds_ = monotonicSeconds() - start;
}

Image BenchLab::picture(std::size_t entry, glm::ivec2 size, Problems& problems) {
    Renderer& renderer = rendererOf(entry);
    renderer.configure(plan_.entries[entry].settings);
    View view = viewOf(entry);
    view.width = size.x;
    view.height = size.y;
    return renderer.finish(problems) ? renderer.readPicture(view, problems) : Image{};
}

void BenchLab::turn(std::size_t entry, bool measured) {
    rendererOf(entry).configure(plan_.entries[entry].settings);
    const int frames = frames_[entry];
    const double before = measured ? yardstick_.draw() : 0;
    if (frames > 1) draw(entry); // a fast GPU's first frame after another program's takes longer
    glFinish();
    const double wall = monotonicSeconds(), cpu = processSeconds(), clock = clock_();
    timer_.begin();
    for (int i = 0; i < frames; ++i) draw(entry);
    timer_.end();
    glFinish();
    const double clockSeconds = clock_() - clock, cpuSeconds = processSeconds() - cpu,
                 seconds = monotonicSeconds() - wall;
    if (!measured) {
        frames_[entry] = int(std::clamp(std::ceil(kTurnSeconds / seconds), 1.0, double(kMostFrames)));
        return;
    }
    BenchCost& cost = costs_[entry];
    cost.passes = passes_;
    cost.wall.push_back(seconds / frames);
    cost.cpu.push_back(cpuSeconds / frames);
    cost.yards.push_back(clockSeconds / frames / (0.5 * (before + yardstick_.draw())));
    if (const auto gpu = timer_.seconds()) cost.gpu.push_back(*gpu / frames);
}

bool BenchLab::compileAgain(const std::vector<std::size_t>& entries) {
    const auto before = std::exchange(renderers_, {}); // kept meanwhile, so that the new programs lie elsewhere
    Problems none;                                     // what was drawn once is drawn again
    for (const std::size_t entry : entries) {
        if (LabProgress::interrupted()) return false;
        prepareOne(entry, none);
    }
    return true;
}

void BenchLab::race(int rounds, double deadline, LabProgress& progress) {
    std::vector<std::size_t> drawn;
    for (std::size_t i = 0; i < costs_.size(); ++i)
        if (costs_[i].drawn) drawn.push_back(i);
    const int roundsOfPass = (rounds + kPasses - 1) / kPasses;
    for (int round = -1; round < rounds; ++round) {
        if (round > 0 && monotonicSeconds() > deadline) break;
        const bool next = round > 0 && round % roundsOfPass == 0 && monotonicSeconds() + prepareSeconds_ < deadline;
        if (next && !compileAgain(drawn)) break;
        passes_ += next || round == 0;
        rounds_ = round + 1;
        if (!takeRound(
                drawn.size(), round, [&](std::size_t i) { turn(drawn[i], round >= 0); }, progress))
            break;
    }
}

} // namespace gnomon
