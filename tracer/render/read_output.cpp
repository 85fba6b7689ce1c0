#include "tracer/render/read_output.h"

#include "tracer/gl/read_top_down.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

/// Samples of a light that one draw takes where its picture is read back: llvmpipe ends all loops of a pixel after
/// 65 536 iterations in all, and other drivers take a long draw for one that hangs.
int batchOf(const Settings& settings) { return shadowRow(settings.shadows).batch; }

bool inBatches(const Settings& settings) {
    return batchOf(settings) > 0 && settings.samples > batchOf(settings) &&
           (settings.aov == Aov::Color || settings.aov == Aov::Visibility);
}

std::uint8_t encoded(float light, bool linear) {
    const float c = std::clamp(light, 0.0f, 1.0f); // the curve: shaders/shade/encode.glsl
    const float curve = c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
    return std::uint8_t(std::lround(255 * (linear ? curve : c)));
}

/// The picture of such values, as the shader would have encoded it.
Image pictureOf(const FloatImage& values, bool linear) {
    Image image{values.width, values.height, {}};
    const std::size_t channels = std::size_t(values.channels);
    for (std::size_t at = 0; at + channels <= values.pixels.size(); at += channels) {
        for (std::size_t c = 0; c < 3; ++c)
            image.rgba.push_back(encoded(values.pixels[at + std::min(c, channels - 1)], linear && channels == 3));
        image.rgba.push_back(255);
    }
    return image;
}

} // namespace

bool OutputReader::draw(const Drawing& drawing, const Settings& settings, const View& view, GLenum format, Frame& frame,
                        const gl::Info& info, Problems& problems) {
    const auto refuse = [&](const std::string& what, const std::string& remedy) {
        problems.push_back({{}, 0, {}, what, remedy});
        return false;
    };
    if (view.width > info.maxTextureSize || view.height > info.maxTextureSize)
        return refuse("a picture of " + std::to_string(view.width) + "x" + std::to_string(view.height) +
                          " is larger than this GL's " + std::to_string(info.maxTextureSize),
                      "use a smaller --size");
    if (format == GL_RGBA32F && !info.floatTargets)
        return refuse("this GL cannot draw float32 pictures (EXT_color_buffer_float is missing)",
                      "use another --context");
    const bool fits = output_ && output_.width == view.width && output_.height == view.height;
    if (!fits || output_.format != format) output_ = gl::makeTarget(view.width, view.height, format);
    if (!output_ || !trace_.begin(drawing, view))
        return refuse("the GL has no memory for a picture of this size", "use a smaller --size");
    trace_.step(drawing, settings, frame);
    fullScreen_.draw(drawing, trace_, format == GL_RGBA8, frame, output_);
    return true;
}

FloatImage OutputReader::valuesOf(const Drawing& drawing, const Settings& settings, const View& view, Frame& frame,
                                  const gl::Info& info, Problems& problems) {
    if (!draw(drawing, settings, view, GL_RGBA32F, frame, info, problems)) return {};
    FloatImage image = gl::readTopDown(view.width, view.height, channelsOf(settings.aov));
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return gl::check("reading the picture back", problems) ? image : FloatImage{};
}

/// The mean of pictures that take a batch of the samples each.
FloatImage OutputReader::meanOfBatches(const Drawing& drawing, const View& view, Frame& frame, const gl::Info& info,
                                       Problems& problems) {
    const Settings& all = drawing.settings;
    const int most = batchOf(all);
    FloatImage sum;
    for (int done = 0; done < all.samples && problems.empty(); done += most) {
        Settings batch = all;
        batch.firstSample = all.firstSample + done;
        batch.samples = std::min(most, all.samples - done);
        FloatImage part = valuesOf(drawing, batch, view, frame, info, problems);
        const float weight = float(batch.samples) / float(all.samples);
        if (sum.pixels.empty()) sum = {part.width, part.height, part.channels, std::vector<float>(part.pixels.size())};
        for (std::size_t i = 0; i < part.pixels.size(); ++i) sum.pixels[i] += weight * part.pixels[i];
    }
    return sum;
}

FloatImage OutputReader::values(const Drawing& drawing, const View& view, Frame& frame, const gl::Info& info,
                                Problems& problems) {
    return inBatches(drawing.settings) ? meanOfBatches(drawing, view, frame, info, problems)
                                       : valuesOf(drawing, drawing.settings, view, frame, info, problems);
}

Image OutputReader::shown(const Drawing& drawing, const View& view, Frame& frame, const gl::Info& info,
                          Problems& problems) {
    if (inBatches(drawing.settings) && info.floatTargets)
        return pictureOf(meanOfBatches(drawing, view, frame, info, problems), drawing.trace.plan().scene.linear);
    if (!draw(drawing, drawing.settings, view, GL_RGBA8, frame, info, problems)) return {};
    Image image = gl::readTopDown(view.width, view.height);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return gl::check("reading the picture back", problems) ? image : Image{};
}

} // namespace gnomon
