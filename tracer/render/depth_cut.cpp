#include "tracer/render/depth_cut.h"

#include "tracer/gl/read_top_down.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

constexpr int kWidth = 96, kMostHeight = 96;
constexpr int kMostDepth = 8;

} // namespace

std::string messageOf(const DepthCut& cut) {
    if (cut.part <= DepthCut::kMost) return {};
    const auto percent = [](double part) { return std::to_string(std::lround(100 * part)) + " %"; };
    return "depth " + std::to_string(cut.depth) + " cuts rays that carry " +
           percent(std::max(cut.part, 2 * DepthCut::kMost)) + " of the picture's light; " +
           (cut.enough > 0 ? "depth " + std::to_string(cut.enough) + " leaves less than " + percent(DepthCut::kMost)
                           : "the largest depth, " + std::to_string(kMostDepth) + ", would not do either");
}

DepthCut DepthProbe::measure(const Drawing& drawing, View view, Frame& frame) {
    const Plan& plan = drawing.trace.plan();
    DepthCut cut{drawing.settings.depth};
    if (!plan.scene.passesOn || plan.scene.output != Aov::Color || !plan.target.floatTargets) return cut;
    view.height = std::clamp(kWidth * view.height / std::max(view.width, 1), 1, kMostHeight);
    view.width = kWidth;
    cut.part = partAt(cut.depth, drawing, view, frame);
    for (int depth = cut.depth + 1; depth <= kMostDepth && cut.part > DepthCut::kMost && cut.enough == 0; ++depth)
        if (partAt(depth, drawing, view, frame) <= DepthCut::kMost) cut.enough = depth;
    return cut;
}

double DepthProbe::partAt(int depth, const Drawing& drawing, const View& view, Frame& frame) {
    Settings settings = drawing.settings;
    settings.depth = depth;
    settings.samples = 1;
    if (!trace_.begin(drawing, view)) return 0;
    trace_.step(drawing, settings, frame);
    glBindFramebuffer(GL_FRAMEBUFFER, trace_.picture().framebuffer.get());
    const FloatImage image = gl::readTopDown(view.width, view.height, 4);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    double sum = 0;
    for (std::size_t i = 3; i < image.pixels.size(); i += 4) sum += 1 - double(image.pixels[i]);
    return sum / (double(view.width) * view.height);
}

} // namespace gnomon
