#include "tracer/software/tuning.h"

#include <glm/glm.hpp>

namespace gnomon {

CodegenTarget tunedFor(Rasteriser rasteriser, int mostPoint, CodegenTarget target) {
    /// Pixels: what SwiftShader draws at a time. In squares of 4 `pro` takes 1.04 times as long, of 8 1.12 (320x240).
    constexpr int kTile = 2;
    if (rasteriser == Rasteriser::Gpu) return target;
    target.textureBest = true; // indexing a uniform block costs more than a fetch
    target.split = true;
    target.iterationsCounted = false;
    if (rasteriser == Rasteriser::SwiftShader) {
        target.fallback = kTile <= mostPoint;
        target.tile = target.fallback ? kTile : 0;
    } else {
        target.preloads = true;
    }
    return target;
}

CodegenTarget targetOf(const gl::Info& info) {
    const Rasteriser rasteriser = gl::drawnBySwiftShader(info.renderer) ? Rasteriser::SwiftShader
                                  : gl::drawnByProcessor(info.renderer) ? Rasteriser::Llvmpipe
                                                                        : Rasteriser::Gpu;
    CodegenTarget target;
    target.es300 = info.essl300;
    target.floatTargets = info.floatTargets;
    target.floatFilter = info.floatFilter;
    target.blockTexels = info.maxUniformBlockSize / int(sizeof(glm::vec4));
    return tunedFor(rasteriser, int(info.maxPointSize), target);
}

} // namespace gnomon
