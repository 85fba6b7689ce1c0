#include "tracer/lab/ray_batch.h"

#include "tracer/gl/objects.h"
#include "tracer/render/program_cache.h"
#include "tracer/render/scene_data.h"
#include "tracer/shader/shader_builder.h"

#include <algorithm>
#include <array>

namespace gnomon {
namespace {

constexpr int kWidth = 512;                 // rays a row
constexpr int kMostRows = 512;              // rows a draw
constexpr GLsizeiptr kFrameBytes = 13 * 16; // of the frame block (shaders/frame.glsl): all 0 but for limits.x
constexpr GLintptr kRepeatsAt = 9 * 16;     // of limits.x
constexpr std::size_t kMost = std::size_t(kWidth) * kMostRows; // rays a draw
constexpr int kOrigins = 0, kDirections = 1;                   // texture units

} // namespace

struct RayBatch::Impl {
    gl::Program program;
    gl::VertexArray vertexArray = gl::makeVertexArray();
    gl::Buffer frame = gl::makeUniformBuffer(), scene = gl::makeUniformBuffer();
    gl::Texture origins = gl::makeDataTexture(kWidth, kMostRows), directions = gl::makeDataTexture(kWidth, kMostRows);
    std::array<gl::Texture, 3> outputs;
    gl::Framebuffer target;

    bool makeTarget() {
        GLuint name = 0;
        glGenFramebuffers(1, &name);
        target = gl::Framebuffer(name);
        glBindFramebuffer(GL_FRAMEBUFFER, name);
        for (GLuint i = 0; i < 3; ++i) {
            outputs[i] = gl::makeDataTexture(kWidth, kMostRows);
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + i, GL_TEXTURE_2D, outputs[i].get(), 0);
        }
        const GLenum attachments[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
        glDrawBuffers(3, attachments);
        return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    }

    void fillBlocks(const std::vector<glm::vec4>& texels) {
        const std::vector<std::byte> zeroes(kFrameBytes);
        glBindBuffer(GL_UNIFORM_BUFFER, frame.get());
        glBufferData(GL_UNIFORM_BUFFER, kFrameBytes, zeroes.data(), GL_DYNAMIC_DRAW);
        setRepeats(1);
        glBindBuffer(GL_UNIFORM_BUFFER, scene.get());
        glBufferData(GL_UNIFORM_BUFFER, GLsizeiptr(texels.size() * sizeof texels[0]), texels.data(), GL_STATIC_DRAW);
        glUseProgram(program.get());
        program.bindBlock("Frame", kFrameBinding);
        program.bindBlock("SceneBlock", kSceneBinding);
        program.bindSampler("rayOrigins", kOrigins);
        program.bindSampler("rayDirections", kDirections);
    }

    static void upload(int unit, const gl::Texture& texture, const std::vector<glm::vec4>& texels, int rows) {
        glActiveTexture(GLenum(GL_TEXTURE0 + unit));
        glBindTexture(GL_TEXTURE_2D, texture.get());
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kWidth, rows, GL_RGBA, GL_FLOAT, texels.data());
    }

    static int rowsOf(std::span<const BatchRay> rays) { return int((rays.size() + kWidth - 1) / kWidth); }

    void uploadRays(std::span<const BatchRay> rays) {
        const int rows = rowsOf(rays);
        std::vector<glm::vec4> origin(std::size_t(kWidth) * rows), direction(origin.size(), glm::vec4(0, 0, 1, 0));
        for (std::size_t i = 0; i < rays.size(); ++i) {
            origin[i] = glm::vec4(rays[i].origin, rays[i].side);
            direction[i] = glm::vec4(rays[i].direction, rays[i].tMin);
        }
        upload(kOrigins, origins, origin, rows);
        upload(kDirections, directions, direction, rows);
    }

    void setRepeats(GLint repeats) {
        glBindBuffer(GL_UNIFORM_BUFFER, frame.get());
        glBufferSubData(GL_UNIFORM_BUFFER, kRepeatsAt, sizeof repeats, &repeats);
    }

    /// Intersects the rays uploaded last.
    void draw(int rows) {
        glBindVertexArray(vertexArray.get());
        glUseProgram(program.get());
        glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, frame.get());
        glBindBufferBase(GL_UNIFORM_BUFFER, kSceneBinding, scene.get());
        glBindFramebuffer(GL_FRAMEBUFFER, target.get());
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_BLEND);
        glViewport(0, 0, kWidth, rows);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

    static std::vector<glm::vec4> read(int attachment, int rows) {
        std::vector<glm::vec4> texels(std::size_t(kWidth) * rows);
        glReadBuffer(GLenum(GL_COLOR_ATTACHMENT0 + attachment));
        glReadPixels(0, 0, kWidth, rows, GL_RGBA, GL_FLOAT, texels.data());
        return texels;
    }

    void trace(std::span<const BatchRay> rays, std::vector<BatchHit>& hits) {
        const int rows = rowsOf(rays);
        uploadRays(rays);
        draw(rows);
        const auto hit = read(0, rows), point = read(1, rows), normal = read(2, rows);
        for (std::size_t i = 0; i < rays.size(); ++i)
            hits.push_back({int(hit[i].y), hit[i].x, glm::vec3(point[i]), glm::vec3(normal[i])});
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    }

    /// Until all pixels drawn so far are there: a pixel read back waits on every GL, in browsers too.
    static void wait() {
        glm::vec4 pixel;
        glReadBuffer(GL_COLOR_ATTACHMENT0);
        glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, &pixel);
    }

    double seconds(std::span<const BatchRay> rays, int repeats, double (*clock)()) {
        const int rows = rowsOf(rays);
        uploadRays(rays);
        draw(rows); // once before: some drivers compile and upload at the first draw
        wait();
        setRepeats(repeats);
        const double start = clock();
        draw(rows);
        wait();
        const double taken = clock() - start;
        setRepeats(1);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        return taken;
    }
};

RayBatch::RayBatch(const Scene& scene, Problems& problems, std::span<const ShaderFile> overrides) {
    const gl::Info info = gl::info();
    Settings settings;
    settings.data = DataPath::Block;
    const Features features = featuresOf(scene, settings, 0, info.essl300);
    Problems faults;
    const ShaderSource source = buildShader("pass/intersect.frag", features, faults, overrides);
    auto impl = std::make_unique<Impl>();
    impl->program = gl::Program(buildCanvas(features, faults).text, source.text);
    if (!impl->program.linked()) {
        const Problems mapped = mapLog(impl->program.fragmentLog() + impl->program.linkLog(), source);
        faults.insert(faults.end(), mapped.begin(), mapped.end());
    } else if (!info.floatTargets || !impl->makeTarget()) {
        faults.push_back({{}, 0, {}, "this GL cannot draw float32 pictures", "use another --context"});
    }
    problems.insert(problems.end(), faults.begin(), faults.end());
    if (!faults.empty()) return;
    impl->fillBlocks(packScene(scene, features, 0));
    impl_ = std::move(impl);
}

RayBatch::~RayBatch() = default;

std::vector<BatchHit> RayBatch::trace(std::span<const BatchRay> rays) {
    std::vector<BatchHit> hits;
    hits.reserve(rays.size());
    for (std::size_t from = 0; from < rays.size(); from += kMost)
        impl_->trace(rays.subspan(from, std::min(kMost, rays.size() - from)), hits);
    return hits;
}

double RayBatch::seconds(std::span<const BatchRay> rays, int repeats, double (*clock)()) {
    double sum = 0;
    for (std::size_t from = 0; from < rays.size(); from += kMost)
        sum += impl_->seconds(rays.subspan(from, std::min(kMost, rays.size() - from)), repeats, clock);
    return sum;
}

} // namespace gnomon
