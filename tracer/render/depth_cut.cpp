#include "tracer/render/depth_cut.h"

#include "tracer/gl/read_top_down.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

constexpr int kWidth = 96, kMostHeight = 96;
constexpr int kMostDepth = 8;

/// Of what a screen shows, in a pixel's worst channel, over all pixels.
double meanDifference(const FloatImage& a, const FloatImage& b) {
    double sum = 0;
    for (std::size_t i = 0; i + 3 < a.pixels.size(); i += 4) {
        float worst = 0;
        for (std::size_t c = i; c < i + 3; ++c)
            worst = std::max(worst, std::abs(std::min(a.pixels[c], 1.0f) - std::min(b.pixels[c], 1.0f)));
        sum += worst;
    }
    return 4 * sum / double(std::max<std::size_t>(a.pixels.size(), 1));
}

} // namespace

std::string messageOf(const DepthCut& cut) {
    if (cut.error <= DepthCut::kMost) return {};
    const auto percent = [](double part) { return std::to_string(std::lround(100 * part)) + " %"; };
    return "depth " + std::to_string(cut.depth) + " leaves colours " +
           percent(std::max(cut.error, 2 * DepthCut::kMost)) + " off those of depth " + std::to_string(kMostDepth) +
           ", the mean over the picture; depth " + std::to_string(cut.enough) + " leaves less than " +
           percent(DepthCut::kMost);
}

DepthCut DepthProbe::measure(const Drawing& drawing, View view, Frame& frame) {
    const Plan& plan = drawing.trace.plan();
    DepthCut cut{drawing.settings.depth, 0, drawing.settings.depth};
    if (!plan.scene.passesOn || plan.scene.output != Aov::Color || !plan.target.floatTargets) return cut;
    if (cut.depth == kMostDepth) return cut;
    view.height = std::clamp(kWidth * view.height / std::max(view.width, 1), 1, kMostHeight);
    view.width = kWidth;
    const FloatImage deepest = pictureAt(kMostDepth, drawing, view, frame);
    if (deepest.pixels.empty()) return cut;
    const auto errorAt = [&](int depth) { return meanDifference(pictureAt(depth, drawing, view, frame), deepest); };
    cut.error = errorAt(cut.depth);
    for (double error = cut.error; error > DepthCut::kMost; error = errorAt(cut.enough))
        if (++cut.enough == kMostDepth) break;
    return cut;
}

FloatImage DepthProbe::pictureAt(int depth, const Drawing& drawing, const View& view, Frame& frame) {
    Settings settings = drawing.settings;
    settings.depth = depth;
    settings.samples = 1;
    if (!trace_.begin(drawing, view)) return {};
    trace_.step(drawing, settings, frame);
    glBindFramebuffer(GL_FRAMEBUFFER, trace_.picture().framebuffer.get());
    FloatImage image = gl::readTopDown(view.width, view.height, 4);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return image;
}

} // namespace gnomon
