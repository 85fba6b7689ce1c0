#include "tracer/shader/program_cache.h"

#include "tracer/clock.h"

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
    program.bindSampler("sceneData", kDataUnit);
    program.bindSampler("sky", kSkyUnit);
    program.bindSampler("paints", kPaintUnit);
    program.bindSampler("normals", kNormalUnit);
    program.bindSampler("covered", kCoverageUnit);
    program.bindSampler("picture", kPictureUnit);
}

} // namespace

GlslTarget targetOf(const gl::Info& info) {
    return {info.maxUniformBlockSize / int(sizeof(glm::vec4)), info.essl300, gl::drawnByProcessor(info.renderer),
            gl::drawnBySwiftShader(info.renderer), int(info.maxPointSize), info.floatTargets};
}

std::shared_ptr<CachedProgram> ProgramCache::get(const Features& features, Problems& problems, std::string_view pass) {
    const double start = monotonicSeconds();
    Problems faults;
    ShaderSource source = buildShader(pass, features, faults, overrides_);
    const ShaderSource canvas = buildCanvas(features, faults);
    if (!faults.empty()) {
        problems.insert(problems.end(), faults.begin(), faults.end());
        return nullptr;
    }
    std::shared_ptr<CachedProgram>& entry = programs_[canvas.text + source.text];
    if (entry && (entry->program || entry->state == CompileState::Failed)) return entry;
    entry = std::make_shared<CachedProgram>();
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
