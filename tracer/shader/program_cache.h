/// Compiled programs by their plan: each is built once, in the background where the GL can, and kept until kMostKept
/// others have been asked for. A plan that was asked for before generates no source; plans that come to the same source
/// share its program.
#pragma once

#include "tracer/gl/objects.h"
#include "tracer/plan/plan.h"
#include "tracer/shader/program_stats.h"
#include "tracer/shader/shader_builder.h"

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

/// Binding points and texture units that all programs use.
inline constexpr GLuint kFrameBinding = 0, kSceneBinding = 1, kBakeBinding = 2;
inline constexpr int kDataUnit = 0, kSkyUnit = 1, kPaintUnit = 2, kNormalUnit = 3, kCoverageUnit = 4, kPictureUnit = 5;
inline constexpr int kCellUnit = 6, kBrickUnit = 8, kFieldUnit = 9; ///< cells have two

enum class CompileState { Compiling, Ready, Failed };

/// One specialised program and what it took to make.
struct CachedProgram {
    ShaderSource source;
    gl::Program program;
    CompileState state = CompileState::Compiling;
    ProgramStats stats;
    double started = 0; ///< seconds, monotonic clock
    gl::Fence drawn;    ///< passed when the first draw is done
};

class ProgramCache {
  public:
    /// Programs are kept beside those that somebody draws with.
    static constexpr std::size_t kMostKept = 128;

    /// `overrides` as for buildShader(); their names and texts must outlive the cache.
    explicit ProgramCache(bool pollable, std::span<const ShaderFile> overrides = {})
        : pollable_(pollable), overrides_(overrides.begin(), overrides.end()) {}

    /// Other overrides for the programs to come; those there are stay.
    void setOverrides(std::span<const ShaderFile>);

    /// Some files are not the library's.
    bool overridden() const { return !overrides_.empty(); }

    /// The program for the plan, begun where it is new. Null, with problems, where the library itself is at fault.
    std::shared_ptr<CachedProgram> get(const Plan&, Problems&, std::string_view pass = "pass/trace.frag");

    /// Lets the program go on. `warmUp` draws one pixel with it: some drivers compile at the first draw, not at link.
    CompileState poll(CachedProgram&, const std::function<void()>& warmUp, Problems&);

  private:
    struct Planned {
        Plan key; ///< sourceKeyOf()
        std::string pass;
        std::weak_ptr<CachedProgram> program;
    };

    std::shared_ptr<CachedProgram> build(const Plan&, std::string_view pass, Problems&);
    std::shared_ptr<CachedProgram> keep(std::shared_ptr<CachedProgram>);

    bool pollable_;
    std::vector<ShaderFile> overrides_;
    std::vector<Planned> planned_;                                 ///< with the overrides there are
    std::map<std::string, std::weak_ptr<CachedProgram>> programs_; ///< by the text of both shaders
    std::vector<std::shared_ptr<CachedProgram>> kept_;             ///< the last asked for at the end
};

} // namespace gnomon
