/// The measurements of `gnomon bench`: what a frame of each entry of a plan takes in one context.
#pragma once

#include "native/bench_plan.h"
#include "native/gpu_timer.h"
#include "native/lab_command.h"
#include "native/yardstick.h"
#include "tracer/render/renderer.h"

#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace gnomon {

/// Of one entry. Times are seconds a frame, one for each round that came to it.
struct BenchCost {
    bool drawn = false; ///< compiled, and drawn once
    int passes = 0;     ///< so often was it compiled for the rounds
    ProgramStats program;
    double firstSeconds = 0;            ///< of the first frame, from asking for it to its last pixel
    std::vector<double> wall, cpu, gpu; ///< of the clock; of the process, all threads; of the GPU, where it has timers
    std::vector<double> yards;          ///< labClock() beside that of a yardstick, drawn right before and after
};

class BenchLab {
  public:
    /// In the current context. Plan and scenes have to outlive it.
    BenchLab(const BenchPlan&, const std::vector<Loaded>& scenes, const Context&, Problems&);
    ~BenchLab();

    /// Compiles every entry and draws it once. What cannot be drawn is told and left out.
    void prepare(LabProgress&, Problems&);
    /// Rounds in three passes, each of which compiles anew where the time allows. All take turns, in rounds, after one
    /// round that is not measured. A turn is one frame, or as many as take a while. No round begins after `deadline` on
    /// the monotonic clock, but one is drawn in any case.
    void race(int rounds, double deadline, LabProgress&);

    /// What an entry that was drawn looks like, at a size of its own.
    Image picture(std::size_t entry, glm::ivec2 size, Problems&);

    const std::vector<BenchCost>& costs() const { return costs_; }
    /// Rounds that were begun and measured.
    int rounds() const { return rounds_; }

  private:
    /// Entries of one scene and size share programs, images and the target.
    using RendererKey = std::tuple<std::size_t, int, int>;
    Renderer& rendererOf(std::size_t entry);
    View viewOf(std::size_t entry) const;
    void draw(std::size_t entry);
    void prepareOne(std::size_t entry, Problems&);
    void turn(std::size_t entry, bool measured);
    /// False where the user wants no more.
    bool compileAgain(const std::vector<std::size_t>& entries);

    const BenchPlan& plan_;
    const std::vector<Loaded>& scenes_;
    double (*clock_)();
    GpuTimer timer_;
    Yardstick yardstick_;
    std::map<RendererKey, std::unique_ptr<Renderer>> renderers_;
    std::vector<BenchCost> costs_;
    std::vector<int> frames_; ///< of a turn
    int rounds_ = 0, passes_ = 0;
    double prepareSeconds_ = 0;
};

} // namespace gnomon
