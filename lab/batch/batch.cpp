#include "lab/batch/batch.h"

#include "tracer/gl/objects.h"
#include "tracer/plan/scene_packer.h"
#include "tracer/render/frame_uniforms.h"
#include "tracer/render/scene_fields.h"
#include "tracer/render/scene_numbers.h"
#include "tracer/shader/program_cache.h"
#include "tracer/shader/shader_builder.h"

namespace gnomon {
namespace {

constexpr int kWidth = 512;               // pixels a row
constexpr int kInputUnit = kDataUnit + 1; // and those after it
constexpr int kMostRows = int(Batch::kMost) / kWidth;

/// No camera, every light with its own radius; nothing is left out for the little that it adds.
FrameUniforms frameOf(const BatchPass& pass) {
    const Settings& settings = pass.settings;
    FrameUniforms uniforms;
    uniforms.pixelAngle = pass.pixelAngle;
    uniforms.coneError = float(settings.epsilon);
    uniforms.lightRadius = -1;
    uniforms.shadowSteps = settings.shadowSteps;
    uniforms.marchSteps = settings.marchSteps;
    uniforms.samples = settings.samples;
    uniforms.firstSample = settings.firstSample;
    return uniforms;
}

} // namespace

struct Batch::Impl {
    BatchPass pass;
    std::vector<ShaderFile> overrides;
    std::string source; ///< what the program is made of
    gl::Program program;
    gl::VertexArray vertexArray = gl::makeVertexArray();
    gl::Buffer frame = gl::makeUniformBuffer();
    SceneNumbers scene;
    std::optional<SceneFields> fields;
    ProgramCache bakes{false};
    std::vector<gl::Texture> inputs, outputs;
    gl::Framebuffer target;
    std::size_t pixels = 0; ///< uploaded
    int rows = 0;

    bool makeTextures() {
        for (std::size_t i = 0; i < pass.inputs.size(); ++i) inputs.push_back(gl::makeDataTexture(kWidth, kMostRows));
        GLuint name = 0;
        glGenFramebuffers(1, &name);
        target = gl::Framebuffer(name);
        glBindFramebuffer(GL_FRAMEBUFFER, name);
        std::vector<GLenum> attachments;
        for (int i = 0; i < pass.outputs; ++i) {
            attachments.push_back(GLenum(GL_COLOR_ATTACHMENT0 + i));
            outputs.push_back(gl::makeDataTexture(kWidth, kMostRows));
            glFramebufferTexture2D(GL_FRAMEBUFFER, attachments.back(), GL_TEXTURE_2D, outputs.back().get(), 0);
        }
        glDrawBuffers(pass.outputs, attachments.data());
        return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    }

    void fillFrame() {
        const FrameUniforms uniforms = frameOf(pass);
        glBindBuffer(GL_UNIFORM_BUFFER, frame.get());
        glBufferData(GL_UNIFORM_BUFFER, sizeof uniforms, &uniforms, GL_DYNAMIC_DRAW);
    }

    /// Bakes all that programs of the plan read, and tells where it lies.
    FieldLayout bake(const PreparedScenePtr& prepared, const Plan& plan, Problems& problems) {
        fields.reset();
        if (!plan.scene.fields) return {};
        fields.emplace(prepared);
        fields->want(pass.settings, gl::info(), problems);
        FieldLayout layout;
        while (fields->baked() < 1 && !fields->failed())
            if (auto baked = fields->step(bakes, plan.target, problems)) layout = std::move(*baked);
        return layout;
    }

    void compile(const Plan& plan, const ShaderSource& made, Problems& problems) {
        program = gl::Program(buildCanvas(plan, problems).text, made.text);
        if (!program.linked()) {
            const Problems mapped = mapLog(program.fragmentLog() + program.linkLog(), made);
            problems.insert(problems.end(), mapped.begin(), mapped.end());
            return;
        }
        source = made.text;
        glUseProgram(program.get());
        program.bindBlock("Frame", kFrameBinding);
        program.bindBlock("SceneBlock", kSceneBinding);
        program.bindSampler("sceneData", kDataUnit);
        program.bindSampler("fields", kFieldUnit);
        for (std::size_t i = 0; i < pass.inputs.size(); ++i) program.bindSampler(pass.inputs[i], kInputUnit + GLint(i));
    }
};

Batch::Batch(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Batch::~Batch() = default;

std::unique_ptr<Batch> Batch::make(const BatchPass& pass, const Scene& scene, Problems& problems,
                                   std::span<const ShaderFile> overrides) {
    std::unique_ptr<Batch> batch(new Batch(std::make_unique<Impl>()));
    Impl& impl = *batch->impl_;
    impl.pass = pass;
    if (pass.settings.data == DataPath::Auto) impl.pass.settings.data = DataPath::Block;
    impl.overrides.assign(overrides.begin(), overrides.end());
    if (!gl::info().floatTargets || !impl.makeTextures()) {
        problems.push_back({{}, 0, {}, "this GL cannot draw float32 pictures", "use another --context"});
        return nullptr;
    }
    impl.fillFrame();
    return batch->setScene(scene, problems) ? std::move(batch) : nullptr;
}

bool Batch::setScene(const Scene& scene, Problems& problems) {
    const Settings& settings = impl_->pass.settings;
    const PreparedScenePtr prepared = prepare(scene);
    const gl::Info info = gl::info();
    Plan plan = planOf(*prepared, settings, {.es300 = info.essl300, .floatFilter = info.floatFilter});
    plan.scene.distances |= impl_->pass.distances;
    plan.scene.fields |= impl_->pass.distances && hasSurfaces(scene);
    Problems faults;
    const ShaderSource made = buildShader(impl_->pass.file, plan, faults, impl_->overrides);
    if (faults.empty() && made.text != impl_->source) impl_->compile(plan, made, faults);
    const FieldLayout fields = impl_->bake(prepared, plan, faults);
    problems.insert(problems.end(), faults.begin(), faults.end());
    if (!faults.empty()) return false;
    impl_->scene.upload(packScene(prepared, plan, settings.time, fields), plan.scene.dataBlock);
    return true;
}

void Batch::upload(std::span<const std::vector<glm::vec4>> inputs) {
    impl_->pixels = inputs.front().size();
    impl_->rows = int((impl_->pixels + kWidth - 1) / kWidth);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        std::vector<glm::vec4> texels = inputs[i];
        texels.resize(std::size_t(kWidth) * std::size_t(impl_->rows), texels.back()); // the last row ends alike
        glActiveTexture(GLenum(GL_TEXTURE0 + kInputUnit + i));
        glBindTexture(GL_TEXTURE_2D, impl_->inputs[i].get());
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kWidth, impl_->rows, GL_RGBA, GL_FLOAT, texels.data());
    }
}

void Batch::draw(int repeats) {
    glBindBuffer(GL_UNIFORM_BUFFER, impl_->frame.get());
    glBufferSubData(GL_UNIFORM_BUFFER, offsetof(FrameUniforms, repeats), sizeof repeats, &repeats);
    glBindVertexArray(impl_->vertexArray.get());
    glUseProgram(impl_->program.get());
    glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, impl_->frame.get());
    impl_->scene.bind();
    if (impl_->fields) impl_->fields->bind();
    glBindFramebuffer(GL_FRAMEBUFFER, impl_->target.get());
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glViewport(0, 0, kWidth, impl_->rows);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Batch::wait() {
    glm::vec4 pixel; // one pixel read back waits on every GL, in browsers too
    glBindFramebuffer(GL_FRAMEBUFFER, impl_->target.get());
    glReadBuffer(GL_COLOR_ATTACHMENT0);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, &pixel);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

std::vector<glm::vec4> Batch::read(int output) {
    std::vector<glm::vec4> texels(std::size_t(kWidth) * std::size_t(impl_->rows));
    glBindFramebuffer(GL_FRAMEBUFFER, impl_->target.get());
    glReadBuffer(GLenum(GL_COLOR_ATTACHMENT0 + output));
    glReadPixels(0, 0, kWidth, impl_->rows, GL_RGBA, GL_FLOAT, texels.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    texels.resize(impl_->pixels);
    return texels;
}

} // namespace gnomon
