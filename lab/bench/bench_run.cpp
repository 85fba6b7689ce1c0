#include "lab/bench/bench_run.h"

#include "tracer/clock.h"
#include "tracer/gl/gl.h"
#include "tracer/plan/pose.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

/// A sample and a calibration take at least that long, so that clocks and the start of drawing weigh little on fast
/// GPUs: also in steps of the clock, where a browser makes them coarse.
constexpr double kSampleSeconds = 0.04, kCalibrationSeconds = 0.01;
constexpr double kSampleSteps = 40, kCalibrationSteps = 20;
constexpr int kMostFrames = 500;

/// A long sample's calibrations take that fraction of it, up to so many seconds: a glimpse of the machine says little
/// of a frame that takes a hundred times as long.
constexpr double kCalibrationFraction = 0.05, kMostCalibrationSeconds = 0.25;

double leastCalibrationSeconds(const BenchMeans& means) {
    return std::max(kCalibrationSeconds, kCalibrationSteps * means.clockStep);
}
double leastSampleSeconds(const BenchMeans& means) { return std::max(kSampleSeconds, kSampleSteps * means.clockStep); }

} // namespace

BenchRun::BenchRun(const BenchPlan& plan, const std::vector<BenchScene>& scenes, const BenchMeans& means,
                   Problems& problems)
    : plan_(plan), scenes_(scenes), means_(means), costs_(plan.entries.size()), leftOut_(plan.entries.size()),
      frames_(plan.entries.size(), 1), sampleSeconds_(plan.entries.size()) {
    contextRestored(problems);
}

BenchRun::~BenchRun() = default;

BenchRun::RendererKey BenchRun::keyOf(std::size_t entry) const {
    const BenchEntry& wanted = plan_.entries[entry];
    return {wanted.scene, wanted.settings.size.x, wanted.settings.size.y};
}

Renderer& BenchRun::rendererOf(std::size_t entry) {
    auto& renderer = renderers_[keyOf(entry)];
    if (renderer) return *renderer;
    renderer = std::make_unique<Renderer>();
    for (const auto& [name, image] : scenes_[plan_.entries[entry].scene].images) renderer->setImage(name, image);
    return *renderer;
}

View BenchRun::viewOf(std::size_t entry) const {
    const BenchEntry& wanted = plan_.entries[entry];
    Problems none; // checked before the first entry was drawn
    const auto pose = poseOf(scenes_[wanted.scene].scene, wanted.settings, {}, none);
    return {*pose, wanted.settings.time, wanted.settings.size.x, wanted.settings.size.y};
}

void BenchRun::draw(std::size_t entry) {
    rendererOf(entry).drawAside(viewOf(entry), plan_.entries[entry].settings.scale);
}

std::size_t BenchRun::drawn() const {
    return std::size_t(std::count_if(costs_.begin(), costs_.end(), [](const BenchCost& cost) { return cost.drawn; }));
}

// --- compiling ------------------------------------------------------------------------------------------------------

bool BenchRun::beginEntry(std::size_t entry, Problems& problems) {
    if (leftOut_[entry]) return false;
    const BenchEntry& wanted = plan_.entries[entry];
    const int side = std::max(wanted.settings.size.x, wanted.settings.size.y), most = gl::info().maxTextureSize;
    if (side > most) {
        problems.push_back(
            {{},
             0,
             {},
             "a side of " + std::to_string(side) + " pixels is more than this GL's " + std::to_string(most),
             "use a smaller --size"});
        return false;
    }
    const bool isNew = !renderers_.contains(keyOf(entry));
    Renderer& renderer = rendererOf(entry);
    renderer.configure(wanted.settings); // before there is a scene, so that no other program is compiled
    return !isNew || renderer.setScene(scenes_[wanted.scene].scene, problems);
}

BenchStep BenchRun::prepareOne(std::size_t entry, Problems& problems) {
    current_ = entry;
    if (!begun_ && !beginEntry(entry, problems)) return BenchStep::Stepped;
    Renderer& renderer = rendererOf(entry);
    const Progress progress = renderer.poll(problems);
    begun_ = progress.compiling();
    if (begun_) return BenchStep::Working;
    if (!progress.ready()) return BenchStep::Stepped;
    BenchCost& cost = costs_[entry];
    if (!cost.drawn) cost.program = renderer.stats();
    const double start = monotonicSeconds();
    draw(entry);
    gl::finish();
    if (!cost.drawn) cost.firstSeconds = monotonicSeconds() - start;
    cost.drawn = gl::check("drawing a frame", problems);
    return BenchStep::Stepped;
}

BenchStep BenchRun::prepare(Problems& problems) {
    if (prepared_ == plan_.entries.size()) return BenchStep::Finished;
    if (prepared_ == 0 && !begun_) prepareStart_ = monotonicSeconds();
    const BenchStep step = prepareOne(prepared_, problems);
    if (step == BenchStep::Stepped) ++prepared_;
    prepareSeconds_ = monotonicSeconds() - prepareStart_;
    return step;
}

void BenchRun::compileNext() {
    Problems none; // what was drawn once is drawn again
    if (prepareOne(stale_.back(), none) == BenchStep::Stepped) stale_.pop_back();
    if (stale_.empty()) before_.clear();
}

Image BenchRun::picture(std::size_t entry, glm::ivec2 size, Problems& problems) {
    Renderer& renderer = rendererOf(entry);
    renderer.configure(plan_.entries[entry].settings);
    View view = viewOf(entry);
    view.width = size.x;
    view.height = size.y;
    return renderer.finish(problems) ? renderer.readPicture(view, problems) : Image{};
}

// --- rounds ---------------------------------------------------------------------------------------------------------

void BenchRun::continueFrom(const std::vector<BenchCost>& earlier) {
    for (std::size_t i = 0; i < costs_.size(); ++i) {
        if (!costs_[i].drawn || !earlier[i].drawn) continue;
        costs_[i] = earlier[i];
        earlierRounds_ = std::max(earlierRounds_, int(earlier[i].wall.size()));
        passes_ = std::max(passes_, earlier[i].passes);
    }
    rounds_ = earlierRounds_;
}

void BenchRun::begin(int rounds, int passes, double deadline) {
    for (std::size_t i = 0; i < costs_.size(); ++i)
        if (costs_[i].drawn) order_.push_back(i);
    allRounds_ = rounds;
    allPasses_ = passes;
    deadline_ = deadline;
    round_ = -2; // the one that is not measured is -1
    nextInRound_ = order_.size();
}

BenchStep BenchRun::measure() {
    if (gpuFrames_ > 0) return takeGpuTime();
    if (nextInRound_ == order_.size() && !nextRound()) return BenchStep::Finished;
    if (!stale_.empty()) {
        compileNext();
        return BenchStep::Working;
    }
    if (nextInRound_ == 0) rounds_ = earlierRounds_ + round_ + 1;
    // Forth in even rounds and back in odd ones, so that what grows during a round favours nobody.
    const bool forth = (earlierRounds_ + round_) % 2 == 0;
    const std::size_t entry = order_[forth ? nextInRound_ : order_.size() - 1 - nextInRound_];
    ++nextInRound_;
    if (costs_[entry].drawn) sample(entry, round_ >= 0);
    return takeGpuTime();
}

bool BenchRun::nextRound() {
    const int next = round_ + 1, roundsOfPass = (allRounds_ + allPasses_ - 1) / allPasses_;
    const double now = monotonicSeconds();
    if (drawn() == 0 || next >= allRounds_ || (next > 0 && now > deadline_)) return false;
    const bool anew = next > 0 && next % roundsOfPass == 0 && now + prepareSeconds_ < deadline_;
    if (anew) {
        std::swap(before_, renderers_);
        stale_.assign(order_.rbegin(), order_.rend());
    }
    passes_ += anew || next == 0;
    round_ = next;
    nextInRound_ = 0;
    return true;
}

void BenchRun::sample(std::size_t entry, bool measured) {
    current_ = entry;
    rendererOf(entry).configure(plan_.entries[entry].settings);
    const int frames = frames_[entry];
    const double calibrationSeconds = std::min(kCalibrationFraction * sampleSeconds_[entry], kMostCalibrationSeconds);
    const double before = measured ? calibration_->draw(calibrationSeconds) : 0;
    if (frames > 1) draw(entry); // a fast GPU's first frame after another program's takes longer
    gl::finish();
    const auto cpuSeconds = [&] { return means_.cpu ? means_.cpu() : 0; };
    const double wallStart = monotonicSeconds(), cpuStart = cpuSeconds(), clockStart = means_.clock();
    if (timer_) timer_->begin();
    for (int i = 0; i < frames; ++i) draw(entry);
    if (timer_) timer_->end();
    gl::finish();
    const double clock = means_.clock() - clockStart, cpu = cpuSeconds() - cpuStart,
                 wall = monotonicSeconds() - wallStart;
    sampleSeconds_[entry] = wall;
    const double least = leastSampleSeconds(means_);
    if (!measured || wall < 0.5 * least) // what a single frame takes is for the most part waiting on a fast GPU
        frames_[entry] = int(std::clamp(std::ceil(frames * least / wall), 1.0, double(kMostFrames)));
    if (!measured) return;
    BenchCost& cost = costs_[entry];
    cost.passes = passes_;
    cost.wall.push_back(wall / frames);
    if (means_.cpu) cost.cpu.push_back(cpu / frames);
    cost.calibrated.push_back(clock / frames / (0.5 * (before + calibration_->draw(calibrationSeconds))));
    gpuFrames_ = timer_ ? frames : 0;
}

BenchStep BenchRun::takeGpuTime() {
    if (gpuFrames_ == 0) return BenchStep::Stepped;
    if (!timer_->ready()) return BenchStep::Working;
    if (const auto gpu = timer_->seconds()) costs_[current_].gpu.push_back(*gpu / gpuFrames_);
    gpuFrames_ = 0;
    return BenchStep::Stepped;
}

// --- a context that goes and comes back -----------------------------------------------------------------------------

void BenchRun::contextLost() {
    renderers_.clear();
    before_.clear();
    gpuFrames_ = 0;
    begun_ = false;
    costs_[current_] = {};
    leftOut_[current_] = true;
    if (prepared_ == current_) ++prepared_;
}

void BenchRun::contextRestored(Problems& problems) {
    calibration_.emplace(means_.clock, leastCalibrationSeconds(means_), problems);
    if (means_.gpuTimed) timer_.emplace(means_.resolver);
    stale_.clear();
    for (std::size_t i = costs_.size(); i-- > 0;)
        if (costs_[i].drawn) stale_.push_back(i);
}

} // namespace gnomon
