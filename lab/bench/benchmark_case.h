/// A scene drawn in one way: what a frame costs, what work it is, what the program took; and several cases timed
/// in turn, so that what disturbs the machine disturbs all alike.
#pragma once

#include "lab/progress.h"
#include "lab/results/quartiles.h"
#include "native/file/asset_folder.h"
#include "tracer/render/renderer.h"

#include <optional>
#include <vector>

namespace gnomon {

/// Of `--aov=work` (docs/outputs.md), means over the picture's pixels.
struct Work {
    double boxes = 0, objects = 0, shadowRays = 0;
};

class BenchmarkCase {
  public:
    /// Compiles; problems where the scene cannot be drawn so.
    BenchmarkCase(const Scene&, const NamedImages&, const Settings&, std::span<const ShaderFile> overrides, Problems&);

    /// Seconds on `clock` from asking for a frame to its last pixel.
    double draw(const View&, double (*clock)());
    /// Compiles a program that counts instead of showing.
    std::optional<std::vector<Work>> count(std::span<const View>, Problems&);
    /// The output that `settings` name; back to what it drew before. Empty, with problems, where that fails.
    FloatImage read(const Settings&, const View&, Problems&);
    /// The same of what a window would show.
    Image picture(const Settings&, const View&, Problems&);
    /// Other numbers from here on: no setting that needs another program.
    void use(const Settings& settings) { renderer_.configure(settings_ = settings); }
    const ProgramStats& program() const { return program_; }

  private:
    Renderer renderer_;
    Settings settings_;
    ProgramStats program_;
};

/// A case with what it draws in each round.
struct TimedCase {
    BenchmarkCase* benchmarkCase;
    View view;
    const Settings* settings = nullptr; ///< that it draws with; null: those it was made with
};

/// Seconds of each case in each round, once an unmeasured frame has been drawn. The order alternates from round to
/// round, so that what grows during a round favours no case. Only whole rounds: fewer, or none, where the user wants no
/// more.
std::vector<std::vector<double>> timeInRounds(std::span<const TimedCase>, int rounds, double (*clock)(), LabProgress&);

} // namespace gnomon
