/// The measurements of `gnomon bench` and of the page's compare(): what a frame of each entry of a plan takes in one
/// context. A host asks for one step after the other, so that a page lives meanwhile.
#pragma once

#include "lab/bench/bench_plan.h"
#include "lab/bench/calibration.h"
#include "tracer/gl/gpu_timer.h"
#include "tracer/render/renderer.h"

#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace gnomon {

struct BenchScene {
    Scene scene;
    std::vector<std::pair<std::string, Image>> images;
};

/// What a host measures with.
struct BenchMeans {
    double (*clock)();         ///< seconds of frames over those of the calibration workload
    double (*cpu)() = nullptr; ///< seconds of the process, all threads; null where the host cannot tell
    double clockStep = 0;      ///< no less can be told apart by the clocks
    bool gpuTimed = true;      ///< no: llvmpipe's timer covers a fraction of the frame that changes with its length
    gl::Resolver resolver = nullptr;
};

/// Of one entry. Times are seconds a frame, one for each round that came to it.
struct BenchCost {
    bool drawn = false; ///< compiled, and drawn once
    int passes = 0;     ///< so often was it compiled for the rounds
    ProgramStats program;
    double firstSeconds = 0;            ///< of the first frame, from asking for it to its last pixel
    std::vector<double> wall, cpu, gpu; ///< of the clock; of the process and of the GPU, where they can be told
    std::vector<double> calibrated; ///< BenchMeans::clock over that of the calibration workload right before and after
};

/// Programs are compiled anew so often for a measurement, for where a program's code comes to lie in memory changes its
/// times: by up to a fifth on llvmpipe (docs/bench.md).
inline constexpr int kBenchPasses = 3;

/// What came of asking for a step: nothing yet, ask again after a moment; one more entry or sample; all is done.
enum class BenchStep { Working, Stepped, Finished };

class BenchRun {
  public:
    /// In the current context. Plan and scenes have to outlive it.
    BenchRun(const BenchPlan&, const std::vector<BenchScene>&, const BenchMeans&, Problems&);
    ~BenchRun();

    /// Before the first step: the entry will not be drawn.
    void leaveOut(std::size_t entry) { leftOut_[entry] = true; }

    /// A step for each entry: compiles it and draws it once. What cannot be drawn is told and left out.
    BenchStep prepare(Problems&);
    /// Before begin(): what another run measured of the same plan stands before what this one will.
    void continueFrom(const std::vector<BenchCost>& earlier);
    /// Rounds in so many passes, each of which compiles anew where the time allows. A round takes one sample of each
    /// entry: one frame, or as many as take a while. The first round is not measured. None begins after `deadline` on
    /// the monotonic clock, but one is drawn in any case. Then a step of measure() for each sample.
    void begin(int rounds, int passes, double deadline);
    BenchStep measure();

    /// What an entry that was drawn looks like, at a size of its own.
    Image picture(std::size_t entry, glm::ivec2 size, Problems&);

    const std::vector<BenchCost>& costs() const { return costs_; }
    /// Entries that can be drawn.
    std::size_t drawn() const;
    /// Rounds that were begun and measured, with those of earlier runs.
    int rounds() const { return rounds_; }
    /// The entry of the last step.
    std::size_t current() const { return current_; }

    /// The GL objects are gone with a lost context, and the entry of the last step with them: it may be why.
    void contextLost();
    /// In the new context. The programs are compiled again before the next sample.
    void contextRestored(Problems&);

  private:
    /// Entries of one scene and size share programs, images and the target.
    using RendererKey = std::tuple<std::size_t, int, int>;
    using Renderers = std::map<RendererKey, std::unique_ptr<Renderer>>;
    RendererKey keyOf(std::size_t entry) const;
    Renderer& rendererOf(std::size_t entry);
    View viewOf(std::size_t entry) const;
    void draw(std::size_t entry);
    bool beginEntry(std::size_t entry, Problems&);
    BenchStep prepareOne(std::size_t entry, Problems&);
    void compileNext();
    bool nextRound();
    void sample(std::size_t entry, bool measured);
    BenchStep takeGpuTime();

    const BenchPlan& plan_;
    const std::vector<BenchScene>& scenes_;
    BenchMeans means_;
    std::optional<gl::GpuTimer> timer_;
    std::optional<CalibrationWorkload> calibration_;
    Renderers renderers_;
    std::vector<BenchCost> costs_;
    std::vector<bool> leftOut_;
    std::vector<int> frames_;           ///< of a sample
    std::vector<double> sampleSeconds_; ///< of the last one

    std::size_t current_ = 0;
    bool begun_ = false; ///< the current entry is being compiled
    std::size_t prepared_ = 0;
    double prepareStart_ = 0, prepareSeconds_ = 0;

    std::vector<std::size_t> order_; ///< entries that are drawn, as in even rounds
    std::vector<std::size_t> stale_; ///< of those, to be compiled anew, the next one last
    Renderers before_;               ///< kept meanwhile, so that the new programs lie elsewhere
    int allRounds_ = 0, allPasses_ = 0, round_ = 0, passes_ = 0;
    int earlierRounds_ = 0, rounds_ = 0; ///< rounds_ with the earlier ones
    double deadline_ = 0;
    std::size_t nextInRound_ = 0;
    int gpuFrames_ = 0; ///< the GPU's time of so many is awaited
};

} // namespace gnomon
