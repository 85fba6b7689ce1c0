#include "tracer/shader/program_cache.h"

#include "tracer/clock.h"

#include <algorithm>
#include <utility>

namespace gnomon {
namespace {

/// Why the program did not link, in the words of the driver and the places of the library.
void explain(const CachedProgram& entry, Problems& problems) {
    Problems found = mapLog(entry.program.fragmentLog(), entry.source);
    if (found.empty()) found = mapLog(entry.program.linkLog() + entry.program.vertexLog(), {});
    if (found.empty()) found.push_back({"shaders", 0, {}, "the driver refuses the program without a reason", {}});
    problems.insert(problems.end(), found.begin(), found.end());
}

/// Uniform blocks and samplers keep their places for the program's life.
void bindInterface(const CachedProgram& entry) {
    const gl::Program& program = entry.program;
    glUseProgram(program.get());
    program.bindBlock("Frame", kFrameBinding);
    program.bindBlock("SceneBlock", kSceneBinding);
    program.bindBlock("Bake", kBakeBinding);
    program.bindSampler("sceneData", kDataUnit);
    program.bindSampler("sky", kSkyUnit);
    program.bindSampler("panorama", kSkyUnit);
    program.bindSampler("paints", kPaintUnit);
    program.bindSampler("normals", kNormalUnit);
    program.bindSampler("fields", kFieldUnit);
    program.bindSampler("covered", kCoverageUnit);
    program.bindSampler("picture", kPictureUnit);
    program.bindSampler("cellHeights", kCellUnit);
    program.bindSampler("cellSlopes", kCellUnit + 1);
    program.bindSampler("bricks", kBrickUnit);
}

/// Its context is not gone with it.
bool isThere(const CachedProgram& entry) { return entry.program || entry.state == CompileState::Failed; }

} // namespace

void ProgramCache::setOverrides(std::span<const ShaderFile> overrides) {
    overrides_.assign(overrides.begin(), overrides.end());
    planned_.clear(); // they come to other sources now
}

std::shared_ptr<CachedProgram> ProgramCache::get(const Plan& plan, Problems& problems, std::string_view pass) {
    Plan key = sourceKeyOf(plan);
    const auto known = std::find_if(planned_.begin(), planned_.end(),
                                    [&](const Planned& one) { return one.pass == pass && one.key == key; });
    if (known != planned_.end())
        if (auto program = known->program.lock(); program && isThere(*program)) return keep(std::move(program));
    auto program = build(plan, pass, problems);
    if (!program) return nullptr;
    std::erase_if(planned_, [](const Planned& one) { // what is forgotten, or gone with its context
        const auto old = one.program.lock();
        return !old || !isThere(*old);
    });
    planned_.push_back({std::move(key), std::string(pass), program});
    return keep(std::move(program));
}

std::shared_ptr<CachedProgram> ProgramCache::keep(std::shared_ptr<CachedProgram> program) {
    std::erase_if(kept_, [&](const auto& one) { return one == program || !isThere(*one); });
    kept_.push_back(program);
    if (kept_.size() > kMostKept) kept_.erase(kept_.begin());
    return program;
}

std::shared_ptr<CachedProgram> ProgramCache::build(const Plan& plan, std::string_view pass, Problems& problems) {
    const double start = monotonicSeconds();
    Problems faults;
    ShaderSource source = buildShader(pass, plan, faults, overrides_);
    const ShaderSource canvas = buildCanvas(plan, faults);
    if (!faults.empty()) {
        problems.insert(problems.end(), faults.begin(), faults.end());
        return nullptr;
    }
    std::erase_if(programs_, [](const auto& one) { return one.second.expired(); });
    std::weak_ptr<CachedProgram>& known = programs_[canvas.text + source.text];
    if (auto program = known.lock(); program && isThere(*program)) return program;
    const auto entry = std::make_shared<CachedProgram>();
    known = entry;
    entry->stats.sourceBytes = source.text.size();
    entry->started = monotonicSeconds();
    entry->stats.buildMs = (entry->started - start) * 1e3;
    entry->program = gl::Program(canvas.text, source.text);
    entry->source = std::move(source);
    return entry;
}

CompileState ProgramCache::poll(CachedProgram& entry, const std::function<void()>& warmUp, Problems& problems) {
    if (entry.state != CompileState::Compiling) return entry.state;
    if (!entry.drawn.isSet()) {
        if (!entry.program.finished(pollable_)) return entry.state;
        if (!entry.program.linked()) {
            explain(entry, problems);
            return entry.state = CompileState::Failed;
        }
        bindInterface(entry);
        warmUp();
        entry.drawn.set();
    }
    if (!entry.drawn.passed()) return entry.state;
    entry.stats.compileMs = (monotonicSeconds() - entry.started) * 1e3;
    return entry.state = CompileState::Ready;
}

} // namespace gnomon
