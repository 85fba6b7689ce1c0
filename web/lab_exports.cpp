// What the laboratory measures for page/lab.js of this browser's GL.
#include "lab/batch/numerics_self_test.h"
#include "lab/batch/ray_batch.h"
#include "tracer/gl/gl.h"
#include "tracer/scene/read_scene.h"
#include "web/host.h"

#include <cstring>
#include <optional>

namespace {

using namespace gnomon;

constexpr int kRayFloats = 8; ///< a ray: origin, side, direction, tMin; its answer: object, t, point, normal
static_assert(sizeof(BatchRay) == kRayFloats * sizeof(float));

std::vector<BatchHit> hits; ///< of the rays traced last

std::vector<BatchRay> raysFrom(const float* values, int count) {
    std::vector<BatchRay> rays(std::size_t(count), BatchRay{});
    std::memcpy(rays.data(), values, rays.size() * sizeof(BatchRay));
    return rays;
}

/// Float32 pictures are an extension here, and the library's advice is the desktop's.
bool hasFloatTargets(Problems& problems) {
    if (gl::info().floatTargets) return true;
    problems.push_back({{},
                        0,
                        {},
                        "this browser's WebGL cannot draw float32 pictures (EXT_color_buffer_float is missing)",
                        "use another browser or graphics driver"});
    return false;
}

} // namespace

extern "C" {

/// How exact this GL's numbers are, measured now: JSON, see toJson(NumericsSelfTest).
EMSCRIPTEN_KEEPALIVE const char* measureNumerics() {
    Problems problems;
    NumericsSelfTest selfTest;
    if (hasFloatTargets(problems))
        selfTest = runNumericsSelfTest();
    else
        selfTest.problem = toString(problems);
    return give(toJson(selfTest));
}

/// Traces `count` rays of kRayFloats values each through the scene of the text.
EMSCRIPTEN_KEEPALIVE const char* traceRays(const char* text, const float* values, int count) {
    Problems problems;
    hits.clear();
    const std::optional<Scene> scene = readScene(text, "traceRays", problems);
    if (scene && hasFloatTargets(problems)) {
        RayBatch batch(*scene, problems);
        if (batch.valid()) hits = batch.trace(raysFrom(values, count));
        gl::check("tracing rays", problems);
    }
    return give(toString(problems));
}

/// The answers to the rays traced last: rows of kRayFloats floats.
EMSCRIPTEN_KEEPALIVE const int* tracedRays() {
    static std::vector<float> answers;
    answers.clear();
    for (const BatchHit& hit : hits)
        for (const float value : {float(hit.object), hit.t, hit.point.x, hit.point.y, hit.point.z, hit.normal.x,
                                  hit.normal.y, hit.normal.z})
            answers.push_back(value);
    return hand(kRayFloats, int(hits.size()), 1, answers.data());
}

} // extern "C"
