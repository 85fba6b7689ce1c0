#include "tracer/render/frame_block.h"

#include "tracer/shader/program_cache.h"

namespace gnomon {

FrameUniforms frameUniforms(const View& view, const PreparedScene& prepared, const Settings& settings, bool shown) {
    const glm::dvec3 origin = prepared.origin;
    const CameraFrame camera = frameOf(view.camera);
    const double aspect = double(view.width) / view.height;
    const std::string_view channels = colorModes()[std::size_t(settings.colorMode)];
    const auto channel = [&](std::size_t i) { return int(std::string_view("rgb").find(channels[i])); };
    FrameUniforms frame;
    frame.eye = glm::vec4(camera.eye - origin, 0);
    frame.right = glm::vec4(camera.right * camera.halfHeight * aspect, 0);
    frame.up = glm::vec4(camera.up * camera.halfHeight, 0);
    frame.forward = glm::vec4(camera.forward, 0);
    frame.origin = glm::vec4(origin, 0);
    frame.background = glm::vec4(prepared.scene.background.color, 1);
    frame.channels = glm::ivec4(channel(0), channel(1), channel(2), 0);
    frame.canvas = glm::vec2(view.width, view.height);
    frame.pixelAngle = float(2 * camera.halfHeight / view.height);
    frame.threshold = float(settings.threshold);
    frame.coneError = float(settings.epsilon);
    frame.lightRadius = float(settings.lightRadius.value_or(-1));
    frame.depth = settings.depth;
    frame.light = settings.light;
    frame.encode = shown;
    frame.shadowSteps = settings.shadowSteps;
    frame.marchSteps = settings.marchSteps;
    frame.samples = settings.samples;
    frame.firstSample = settings.firstSample;
    frame.fieldSteps = settings.fieldSteps;
    frame.fieldEpsilon = float(settings.fieldEpsilon);
    frame.fieldRelaxation = float(settings.fieldRelaxation);
    return frame;
}

FrameBlock::FrameBlock() : vertexArray_(gl::makeVertexArray()), buffer_(gl::makeUniformBuffer()) {}

void FrameBlock::upload(const FrameUniforms& frame) const {
    glBindVertexArray(vertexArray_.get());
    glBindBuffer(GL_UNIFORM_BUFFER, buffer_.get());
    glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_DYNAMIC_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, buffer_.get());
}

} // namespace gnomon
