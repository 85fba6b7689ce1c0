#include "lab/bench/calibration.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

constexpr int kSide = 192;

// Frozen: earlier measurements lose their meaning with any change of these.
const char* const kVertex = R"(
void main() {
    gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0);
}
)";
const char* const kFragment = R"(
out vec4 color;

void main() {
    vec3 direction = normalize(vec3(gl_FragCoord.xy / 96.0 - 1.0, -2.0));
    float nearness = 0.0;
    for (int i = 1; i <= 32; ++i) {
        vec3 center = vec3(4.0, 4.0, 8.0) * fract(float(i) * vec3(0.618, 0.414, 0.732)) - vec3(2.0, 2.0, 14.0);
        float along = dot(center, direction);
        float inside = along * along - dot(center, center) + 0.25;
        if (inside > 0.0) nearness = max(nearness, 1.0 / (along - sqrt(inside)));
    }
    color = vec4(vec3(nearness), 1.0);
}
)";

} // namespace

CalibrationWorkload::CalibrationWorkload(double (*clock)(), double leastSeconds, Problems& problems)
    : clock_(clock), vertexArray_(gl::makeVertexArray()), target_(gl::makeTarget(kSide, kSide, GL_RGBA8)),
      leastSeconds_(leastSeconds) {
    const std::string prelude = gl::info().es ? "#version 300 es\nprecision highp float;\n" : "#version 330 core\n";
    for (gl::Program& program : programs_) {
        program = gl::Program(prelude + kVertex, prelude + kFragment);
        if (program.finished(false) && program.linked()) continue;
        problems.push_back(
            {"calibration workload", 0, {}, "this GL does not take its shader: " + program.linkLog(), {}});
        return;
    }
    drawOften(1); // some drivers compile at the first draw
    onceSeconds_ = drawOften(1);
}

double CalibrationWorkload::draw(double leastSeconds) {
    const double least = std::max(leastSeconds, leastSeconds_);
    return drawOften(int(std::clamp(std::ceil(least / onceSeconds_), 1.0, 1000.0)));
}

double CalibrationWorkload::drawOften(int times) {
    glBindVertexArray(vertexArray_.get());
    glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer.get());
    glViewport(0, 0, kSide, kSide);
    const double start = clock_();
    for (int i = 0; i < times; ++i)
        for (const gl::Program& program : programs_) {
            glUseProgram(program.get());
            glDrawArrays(GL_TRIANGLES, 0, 3);
        }
    gl::finish();
    return (clock_() - start) / times;
}

} // namespace gnomon
