#include "tracer/render/scene_images.h"

#include "tracer/shader/program_cache.h"

#include <algorithm>
#include <utility>

namespace gnomon {
namespace {

/// Of the finest levels of all images of a purpose; docs/scenes.md tells it.
constexpr std::size_t kMostImageBytes = std::size_t(1) << 29;

Image flat(std::uint8_t r, std::uint8_t g, std::uint8_t b) { return {1, 1, {r, g, b, 255}}; }

Image night() { return flat(8, 10, 18); }

/// As it came; `standIn` until it does.
const Image& pictureOr(const Image& standIn, const Pictures& pictures, const std::string& name) {
    const auto found = pictures.images.find(name);
    return found == pictures.images.end() || found->second.empty() ? standIn : found->second;
}

glm::ivec2 sizeOf(const Image& image) { return {image.width, image.height}; }

/// Every image of the scene, as often as it is uploaded.
std::vector<std::string> uploadsOf(const PreparedScene& prepared) {
    std::vector<std::string> names = prepared.skyFaces;
    names.push_back(prepared.scene.background.image);
    for (const Paint& paint : prepared.textureSet.paints) {
        names.push_back(paint.color);
        names.push_back(paint.mask);
    }
    names.insert(names.end(), prepared.textureSet.normals.begin(), prepared.textureSet.normals.end());
    std::erase(names, "");
    return names;
}

} // namespace

SceneImages::SceneImages(PreparedScenePtr prepared, int maxSide) : prepared_(std::move(prepared)), maxSide_(maxSide) {
    for (const std::string& name : uploadsOf(*prepared_)) ++uses_[name];
}

gl::Texels SceneImages::coding() const {
    return prepared_->scene.encoding == Encoding::Linear ? gl::Texels::Srgb : gl::Texels::Display;
}

void SceneImages::arrived(const std::string& name) {
    const auto& faces = prepared_->skyFaces;
    layersStale_ |= prepared_->textureSet.shows(name);
    skyStale_ |=
        std::find(faces.begin(), faces.end(), name) != faces.end() || prepared_->scene.background.image == name;
}

double SceneImages::fraction(const Pictures& pictures) const {
    const auto there =
        std::count_if(uses_.begin(), uses_.end(), [&](const auto& use) { return pictures.images.contains(use.first); });
    return uses_.empty() ? 1 : double(there) / double(uses_.size());
}

/// The picture, out of memory where it has served its last use.
Image SceneImages::taken(Pictures& pictures, const std::string& name, const Image& standIn) {
    const auto found = pictures.images.find(name);
    if (found == pictures.images.end() || found->second.empty()) return standIn;
    return pictures.once && --uses_[name] == 0 ? std::exchange(found->second, {}) : found->second;
}

void SceneImages::tellReduced(Problems& problems) const {
    problems.push_back({prepared_->scene.file,
                        0,
                        {},
                        "the images take more than 512 MB, or are larger than this GL takes them: the largest are "
                        "drawn smaller",
                        "use fewer or smaller images"});
}

gl::Texture SceneImages::upload(const std::vector<glm::ivec2>& sizes, const gl::ImageSource& imageOf, gl::Texels texels,
                                std::vector<glm::vec2>& tiles, Problems& problems) const {
    if (sizes.empty()) return {};
    const Layers layers(sizes, texels == gl::Texels::Srgb, maxSide_, kMostImageBytes);
    for (int i = 0; i < layers.count(); ++i) tiles.push_back(layers.tile(i));
    if (layers.reduced()) tellReduced(problems);
    return gl::makeImages(layers, imageOf, texels);
}

Tiles SceneImages::uploadLayers(Pictures& pictures, Problems& problems) {
    const Image none, grey = flat(128, 128, 128), level = flat(128, 128, 255), dry = flat(0, 0, 0);
    const std::vector<Paint>& paints = prepared_->textureSet.paints;
    const std::vector<std::string>& normals = prepared_->textureSet.normals;
    const auto colorOf = [&](const Paint& paint) -> const Image& { return paint.color.empty() ? none : grey; };
    const auto maskOf = [&](const Paint& paint) -> const Image& { return paint.mask.empty() ? none : dry; };
    std::vector<glm::ivec2> paintSizes, normalSizes;
    for (const Paint& paint : paints)
        paintSizes.push_back(paintedSize(sizeOf(pictureOr(colorOf(paint), pictures, paint.color)),
                                         sizeOf(pictureOr(maskOf(paint), pictures, paint.mask))));
    for (const std::string& name : normals) normalSizes.push_back(sizeOf(pictureOr(level, pictures, name)));
    const auto paintOf = [&](int i) {
        const Paint& paint = paints[std::size_t(i)];
        return painted(taken(pictures, paint.color, colorOf(paint)), taken(pictures, paint.mask, maskOf(paint)));
    };
    const auto normalOf = [&](int i) { return taken(pictures, normals[std::size_t(i)], level); };
    Tiles tiles;
    paints_ = upload(paintSizes, paintOf, coding(), tiles.paints, problems);
    normals_ = upload(normalSizes, normalOf, gl::Texels::Display, tiles.normals, problems);
    return tiles;
}

void SceneImages::uploadCubemap(Pictures& pictures) {
    const Image none, dark = night();
    const auto& names = prepared_->skyFaces;
    const glm::ivec2 size = sizeOf(pictureOr(none, pictures, names[0]));
    const bool complete =
        size.x > 0 && size.x == size.y && std::all_of(names.begin(), names.end(), [&](const std::string& name) {
            return sizeOf(pictureOr(none, pictures, name)) == size;
        });
    const auto faceOf = [&](int i) {
        if (!complete) return dark; // until all six faces are there
        Image face = taken(pictures, names[std::size_t(i)], dark);
        mirror(face); // as GL wants it: seen from without
        return face;
    };
    sky_ = gl::makeCubemap(faceOf, coding());
}

void SceneImages::uploadPanorama(Pictures& pictures, Problems& problems) {
    Image image = taken(pictures, prepared_->scene.background.image, night());
    if (std::max(image.width, image.height) > maxSide_) tellReduced(problems);
    sky_ = gl::makePanorama(std::move(image), coding(), maxSide_);
}

std::optional<Tiles> SceneImages::bind(Pictures& pictures, Problems& problems) {
    const auto lost = [](const gl::Texture& texture, bool wanted) { return wanted && !texture; };
    const bool cubemap = !prepared_->skyFaces.empty(), panorama = !prepared_->scene.background.image.empty();
    std::optional<Tiles> tiles;
    if (layersStale_ || lost(paints_, !prepared_->textureSet.paints.empty()) ||
        lost(normals_, !prepared_->textureSet.normals.empty()))
        tiles = uploadLayers(pictures, problems);
    if (cubemap && (skyStale_ || !sky_)) uploadCubemap(pictures);
    if (panorama && (skyStale_ || !sky_)) uploadPanorama(pictures, problems);
    layersStale_ = skyStale_ = false;
    glActiveTexture(GL_TEXTURE0 + kPaintUnit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, paints_.get());
    glActiveTexture(GL_TEXTURE0 + kNormalUnit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, normals_.get());
    glActiveTexture(GL_TEXTURE0 + kSkyUnit);
    glBindTexture(panorama ? GL_TEXTURE_2D : GL_TEXTURE_CUBE_MAP, sky_.get());
    glActiveTexture(GL_TEXTURE0 + kDataUnit);
    return tiles;
}

} // namespace gnomon
