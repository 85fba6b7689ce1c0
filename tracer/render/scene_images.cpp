#include "tracer/render/scene_images.h"

#include "tracer/shader/program_cache.h"

#include <algorithm>
#include <utility>

namespace gnomon {
namespace {

/// Of the finest levels of all images of a purpose; docs/scenes.md tells it.
constexpr std::size_t kMostImageBytes = std::size_t(1) << 29;

Image flat(std::uint8_t r, std::uint8_t g, std::uint8_t b) { return {1, 1, {r, g, b, 255}}; }

/// As it came; `standIn` until it does.
const Image& pictureOr(const Image& standIn, const Pictures& pictures, const std::string& name) {
    const auto found = pictures.find(name);
    return found == pictures.end() ? standIn : found->second;
}

} // namespace

SceneImages::SceneImages(PreparedScenePtr prepared, int maxSide) : prepared_(std::move(prepared)), maxSide_(maxSide) {}

gl::Texels SceneImages::coding() const {
    return prepared_->scene.encoding == Encoding::Linear ? gl::Texels::Srgb : gl::Texels::Display;
}

void SceneImages::arrived(const std::string& name) {
    layersStale_ |= prepared_->textureSet.shows(name);
    skyStale_ |= std::find(prepared_->skyFaces.begin(), prepared_->skyFaces.end(), name) != prepared_->skyFaces.end();
}

double SceneImages::fraction(const Pictures& pictures) const {
    int wanted = 0, there = 0;
    const auto count = [&](const std::string& name) {
        if (name.empty()) return;
        ++wanted;
        there += int(pictures.contains(name));
    };
    for (const Paint& paint : prepared_->textureSet.paints) {
        count(paint.color);
        count(paint.mask);
    }
    for (const std::string& name : prepared_->textureSet.normals) count(name);
    for (const std::string& name : prepared_->skyFaces) count(name);
    return wanted == 0 ? 1 : double(there) / wanted;
}

gl::Texture SceneImages::upload(std::vector<Image> images, gl::Texels texels, std::vector<glm::vec2>& tiles,
                                Problems& problems) const {
    if (images.empty()) return {};
    const Layers layers(std::move(images), texels == gl::Texels::Srgb, maxSide_, kMostImageBytes);
    for (int i = 0; i < layers.count(); ++i) tiles.push_back(layers.tile(i));
    if (layers.reduced())
        problems.push_back({prepared_->scene.file,
                            0,
                            {},
                            "the images take more than 512 MB, or are larger than this GL takes them: the largest are "
                            "drawn smaller",
                            "use fewer or smaller images"});
    return gl::makeImages(layers, texels);
}

Tiles SceneImages::uploadLayers(const Pictures& pictures, Problems& problems) {
    const Image none, grey = flat(128, 128, 128), level = flat(128, 128, 255), dry = flat(0, 0, 0);
    std::vector<Image> paints, normals;
    for (const Paint& paint : prepared_->textureSet.paints)
        paints.push_back(painted(paint.color.empty() ? none : pictureOr(grey, pictures, paint.color),
                                 paint.mask.empty() ? none : pictureOr(dry, pictures, paint.mask)));
    for (const std::string& name : prepared_->textureSet.normals) normals.push_back(pictureOr(level, pictures, name));
    Tiles tiles;
    paints_ = upload(std::move(paints), coding(), tiles.paints, problems);
    normals_ = upload(std::move(normals), gl::Texels::Display, tiles.normals, problems);
    return tiles;
}

void SceneImages::uploadSky(const Pictures& pictures) {
    std::vector<Image> faces;
    for (const std::string& name : prepared_->skyFaces)
        if (const auto found = pictures.find(name); found != pictures.end()) faces.push_back(found->second);
    const bool complete = faces.size() == 6 && std::all_of(faces.begin(), faces.end(), [&](const Image& face) {
                              return face.width == face.height && face.width == faces[0].width;
                          });
    if (!complete) faces.assign(6, flat(8, 10, 18)); // night, until all six faces are there
    for (Image& face : faces) mirror(face);          // as GL wants them: seen from without
    sky_ = gl::makeCubemap(faces, coding());
}

std::optional<Tiles> SceneImages::bind(const Pictures& pictures, Problems& problems) {
    const auto lost = [](const gl::Texture& texture, bool wanted) { return wanted && !texture; };
    std::optional<Tiles> tiles;
    if (layersStale_ || lost(paints_, !prepared_->textureSet.paints.empty()) ||
        lost(normals_, !prepared_->textureSet.normals.empty()))
        tiles = uploadLayers(pictures, problems);
    if (!prepared_->skyFaces.empty() && (skyStale_ || !sky_)) uploadSky(pictures);
    layersStale_ = skyStale_ = false;
    glActiveTexture(GL_TEXTURE0 + kPaintUnit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, paints_.get());
    glActiveTexture(GL_TEXTURE0 + kNormalUnit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, normals_.get());
    glActiveTexture(GL_TEXTURE0 + kSkyUnit);
    glBindTexture(GL_TEXTURE_CUBE_MAP, sky_.get());
    glActiveTexture(GL_TEXTURE0 + kDataUnit);
    return tiles;
}

} // namespace gnomon
