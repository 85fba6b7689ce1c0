#include "tracer/render/pass/bake_pass.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

constexpr int kFinest = 64, kCoarsest = 8; // cells along a side, as in shaders/field/cells.glsl

constexpr const char* kShaders[]{"pass/bake_exact.frag",    "pass/bake_adamax.frag", "pass/bake_adam.frag",
                                 "pass/bake_gradient.frag", "pass/bake_brute.frag",  "pass/bake_lipschitz.frag"};

/// shaders/field/patch.glsl, byte for byte.
struct BakeUniforms {
    glm::mat4 net;
    glm::vec4 low, high, sides, rates;
    glm::ivec4 counts;
    glm::vec4 bounds;
};

/// Small bricks bound better, large ones are fewer.
int brickOf(int resolution) { return resolution < 24 ? 2 : 4; }

/// Of the height above the patch: its slopes are no greater than those of its net.
double lipschitzOf(const BakeUniforms& block) {
    glm::vec2 slope(0);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 3; ++i)
            slope = glm::max(slope, glm::vec2(std::abs(block.net[j][i + 1] - block.net[j][i]),
                                              std::abs(block.net[i + 1][j] - block.net[i][j])));
    slope *= 3.0F / glm::vec2(block.sides);
    return std::sqrt(1 + glm::dot(slope, slope));
}

BakeUniforms uniformsOf(const FieldBake& bake) {
    const double unit = std::max(bake.size.x, bake.size.z);
    const glm::dvec3 corner = bake.center - glm::dvec3(bake.size.x / 2, 0, bake.size.z / 2);
    const glm::dvec2 sides = glm::dvec2(bake.size.x, bake.size.z) / unit;
    BakeUniforms block{};
    double greatest = 0;
    for (int i = 0; i < 16; ++i) {
        const double height = bake.heights[std::size_t(i)] * bake.size.y / unit;
        block.net[i / 4][i % 4] = float(height);
        greatest = std::max(greatest, std::abs(height));
    }
    block.low = glm::vec4((bake.box.low - corner) / unit, 0);
    block.high = glm::vec4((bake.box.high - corner) / unit, 0);
    block.sides = glm::vec4(sides, 1.0 / sides);
    block.rates = glm::vec4(bake.rate, bake.beta1, bake.beta2, unit);
    block.counts = {bake.resolution, brickOf(bake.resolution), bake.iterations,
                    bake.method == BakeMethod::Brute ? bake.samples : bake.starts};
    block.bounds = glm::vec4(bake.lipschitz > 0 ? bake.lipschitz : lipschitzOf(block), 1e-6 * greatest, 0, 0);
    return block;
}

} // namespace

bool BakePass::begin(const FieldBake& bake, const CodegenTarget& target, Problems& problems) {
    bake_ = bake;
    target_ = target;
    programs_ = {};
    return makeTargets(problems);
}

bool BakePass::makeTargets(Problems& problems) {
    slices_ = 0;
    const int n = bake_.resolution, bricks = (n + brickOf(n) - 1) / brickOf(n);
    if (exact() && !cells_) {
        cells_ = gl::makeTarget(kFinest, 2 * kFinest - kCoarsest, GL_RGBA32F);
        slopes_ = gl::makeDataTexture(cells_.width, cells_.height);
        gl::attachSecond(cells_, slopes_);
    }
    if (exact() && (bricks_.width != bricks || !bricks_)) bricks_ = gl::makeTarget(bricks, bricks, GL_RGBA32UI);
    if (!block_) block_ = gl::makeUniformBuffer();
    if (!vertexArray_) vertexArray_ = gl::makeVertexArray();
    if (!exact() || (cells_ && bricks_)) return true;
    problems.push_back({{}, 0, {}, "this GL cannot draw a field of distances", "show the surface without one"});
    return false;
}

CompileState BakePass::poll(ProgramCache& cache, const gl::Volume& into, Problems& problems) {
    const char* shaders[]{"pass/bake_cells.frag", "pass/bake_bricks.frag", kShaders[int(bake_.method)]};
    Plan plan;
    plan.target = target_;
    CompileState all = CompileState::Ready;
    for (std::size_t i = exact() ? 0 : 2; i < 3; ++i) {
        std::shared_ptr<CachedProgram>& program = programs_[i];
        if (!program || !(program->program || program->state == CompileState::Failed))
            program = cache.get(plan, problems, shaders[i]);
        if (!program) return CompileState::Failed;
        const auto warmUp = [&] { drawWith(*program, Part(i), into, {}, 0); };
        const CompileState state = cache.poll(*program, warmUp, problems);
        if (state == CompileState::Failed) return state;
        if (state == CompileState::Compiling) all = state;
    }
    return all;
}

void BakePass::bind(glm::ivec3 at) const {
    BakeUniforms block = uniformsOf(bake_);
    block.bounds.z = float(at.x);
    block.bounds.w = float(at.y);
    glBindVertexArray(vertexArray_.get());
    glBindBuffer(GL_UNIFORM_BUFFER, block_.get());
    glBufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_DYNAMIC_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, kBakeBinding, block_.get());
    const GLuint textures[]{cells_.color.get(), slopes_.get(), bricks_.color.get()};
    for (int i = 0; i < 3; ++i) {
        glActiveTexture(GLenum(GL_TEXTURE0 + kCellUnit + i));
        glBindTexture(GL_TEXTURE_2D, textures[i]);
    }
    glActiveTexture(GL_TEXTURE0 + kDataUnit);
    glDisable(GL_BLEND);
}

void BakePass::drawWith(const CachedProgram& program, Part part, const gl::Volume& into, glm::ivec3 at,
                        int slice) const {
    if (part == Part::Slices) {
        glBindFramebuffer(GL_FRAMEBUFFER, into.framebuffer.get());
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, into.texture.get(), 0, at.z + slice);
        glViewport(at.x, at.y, bake_.resolution, bake_.resolution);
    } else {
        const gl::Target& target = part == Part::Cells ? cells_ : bricks_;
        glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.get());
        glViewport(0, 0, target.width, target.height);
    }
    glUseProgram(program.program.get());
    glUniform1i(glGetUniformLocation(program.program.get(), "slice"), slice);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

bool BakePass::step(ProgramCache& cache, const gl::Volume& into, glm::ivec3 at, int slices, Problems& problems) {
    bind(at);
    const CompileState state = poll(cache, into, problems);
    if (state != CompileState::Ready) return state == CompileState::Compiling;
    const auto draw = [&](Part part, int slice) { drawWith(*programs_[std::size_t(part)], part, into, at, slice); };
    if (exact() && slices_ == 0) draw(Part::Cells, 0);
    const int brick = brickOf(bake_.resolution), end = std::min(slices_ + std::max(slices, 1), bake_.resolution);
    for (; slices_ < end; ++slices_) {
        if (exact() && slices_ % brick == 0) draw(Part::Bricks, slices_ / brick);
        draw(Part::Slices, slices_);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return true;
}

} // namespace gnomon
