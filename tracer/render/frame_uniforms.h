/// The uniform block of shaders/frame.glsl, which says what each member is. Offsets are those of std140: vectors of
/// four at multiples of 16 bytes, then scalars one after another; the block ends at a multiple of 16.
#pragma once

#include <glm/glm.hpp>

#include <cstddef>

namespace gnomon {

struct alignas(16) FrameUniforms {
    glm::vec4 eye{0}, right{0}, up{0}, forward{0}, origin{0}, background{0};
    glm::ivec4 channels{0};
    glm::uvec4 zero{0};
    glm::vec2 canvas{0};
    float pixelAngle = 0;
    float threshold = 0;
    float coneError = 0;
    float lightRadius = 0;
    int depth = 0;
    int light = 0;
    int encode = 0;
    int shadowSteps = 0;
    int marchSteps = 0;
    int samples = 0;
    int firstSample = 0;
    int repeats = 0;
    int fieldSteps = 0;
    float fieldEpsilon = 0, fieldRelaxation = 0;
};

static_assert(offsetof(FrameUniforms, background) == 80 && offsetof(FrameUniforms, channels) == 96 &&
              offsetof(FrameUniforms, zero) == 112 && offsetof(FrameUniforms, canvas) == 128 &&
              offsetof(FrameUniforms, pixelAngle) == 136 && offsetof(FrameUniforms, coneError) == 144 &&
              offsetof(FrameUniforms, encode) == 160 && offsetof(FrameUniforms, firstSample) == 176 &&
              offsetof(FrameUniforms, repeats) == 180 && sizeof(FrameUniforms) == 208);

} // namespace gnomon
