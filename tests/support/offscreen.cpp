#include "tests/support/offscreen.h"

#include "native/file/asset_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include <cstdio>
#include <cstdlib>

namespace gnomon::test {

namespace {

struct Current {
    std::unique_ptr<Context> context;
    ContextKind kind = ContextKind::OsMesa;
};
Current current;

void begin(ContextKind kind) {
    current.context.reset();
    Problems problems;
    current = {makeContext(kind, problems), kind};
    if (current.context) return;
    std::fprintf(stderr, "no %s context, so nothing can be tested: %s\n", std::string(nameOf(kind)).c_str(),
                 toString(problems).c_str());
    std::abort();
}

} // namespace

Context& offscreen(ContextKind kind) {
    if (!current.context || current.kind != kind) begin(kind);
    return *current.context;
}

void renewContext() { begin(current.kind); }

Drawing::Drawing(const Scene& scene, Settings settings, std::span<const ShaderFile> overrides) : renderer_(overrides) {
    view = {scene.camera, settings.time, settings.size.x, settings.size.y};
    if (settings.eye) view.camera.eye = *settings.eye;
    if (settings.target) view.camera.target = *settings.target;
    if (settings.fov) view.camera.fov = *settings.fov;
    Problems problems;
    const auto assets = AssetFolder(std::string(GNOMON_SOURCE_DIR) + "/assets");
    if (const auto images = assets.readImages(scene, problems))
        for (const auto& [name, image] : *images) renderer_.setImage(name, image);
    renderer_.setScene(scene, problems);
    renderer_.configure(settings);
    renderer_.finish(problems);
    EXPECT_EQ(toString(problems), "");
}

FloatImage Drawing::output() {
    Problems problems;
    FloatImage image = renderer_.readOutput(view, problems);
    EXPECT_EQ(toString(problems), "");
    return image;
}

Image Drawing::picture() {
    Problems problems;
    Image image = renderer_.readPicture(view, problems);
    EXPECT_EQ(toString(problems), "");
    return image;
}

std::string difference(const FloatImage& a, const FloatImage& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    std::size_t count = 0, first = 0;
    for (std::size_t i = std::min(a.pixels.size(), b.pixels.size()); i-- > 0;)
        if (std::bit_cast<std::uint32_t>(a.pixels[i]) != std::bit_cast<std::uint32_t>(b.pixels[i])) ++count, first = i;
    if (count == 0) return {};
    return std::to_string(count) + " floats differ, first at " + std::to_string(first) + ": " +
           std::to_string(a.pixels[first]) + " and " + std::to_string(b.pixels[first]);
}

FloatImage outputOf(const Scene& scene, Settings settings, Aov aov) {
    offscreen();
    settings.aov = aov;
    return Drawing(scene, settings).output();
}

} // namespace gnomon::test
