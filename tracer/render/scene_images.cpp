#include "tracer/render/scene_images.h"

#include "tracer/image_memory.h"
#include "tracer/shader/program_cache.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gnomon {
namespace {

// Where images would take too much memory: the finest levels of paints and normals together, and a side of the sky's.
constexpr std::size_t kReducedBytes = std::size_t(1) << 28;
constexpr int kReducedSky = 2048;

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

void SceneImages::tellReduced(const std::string& why, Problems& problems) const {
    problems.push_back(
        {prepared_->scene.file, 0, {}, why + ": the largest are drawn smaller", "use fewer or smaller images"});
}

void SceneImages::tellTooWide(glm::ivec2 size, Problems& problems) const {
    if (std::max(size.x, size.y) > maxSide_)
        tellReduced("its images are wider or higher than " + std::to_string(maxSide_) + " pixels, the most of this GL",
                    problems);
}

SceneImages::LayerSizes SceneImages::layerSizes(const Pictures& pictures) const {
    const Image none, standIn = flat(0, 0, 0);
    const auto size = [&](const std::string& name) {
        return sizeOf(name.empty() ? none : pictureOr(standIn, pictures, name));
    };
    LayerSizes sizes;
    for (const Paint& paint : prepared_->textureSet.paints)
        sizes.paints.push_back(paintedSize(size(paint.color), size(paint.mask)));
    for (const std::string& name : prepared_->textureSet.normals) sizes.normals.push_back(size(name));
    return sizes;
}

std::size_t SceneImages::peakMemory(const Pictures& pictures, const LayerSizes& sizes) const {
    std::vector<std::string> counted;
    const auto bytesOf = [&](const std::string& name) {
        const auto found = pictures.images.find(name);
        return found == pictures.images.end() ? 0 : found->second.rgba.size();
    };
    std::array<ImageUpload, 3> uploads;
    auto& [paints, normals, sky] = uploads; // the order in which they are made
    const auto wait = [&](ImageUpload& upload, const std::string& name) {
        if (std::find(counted.begin(), counted.end(), name) != counted.end()) return;
        counted.push_back(name);
        upload.images += bytesOf(name);
    };
    for (const std::string& name : prepared_->skyFaces) wait(sky, name); // from the end: they wait for their last use
    wait(sky, prepared_->scene.background.image);
    for (const std::string& name : prepared_->textureSet.normals) wait(normals, name);
    std::size_t color = 0, mask = 0, normal = 0; // the largest
    for (const std::string& name : prepared_->textureSet.normals) normal = std::max(normal, bytesOf(name));
    for (const Paint& paint : prepared_->textureSet.paints) {
        wait(paints, paint.color);
        wait(paints, paint.mask);
        color = std::max(color, bytesOf(paint.color));
        mask = std::max(mask, bytesOf(paint.mask));
    }
    const auto fitting = [](std::size_t image, std::size_t layer) { return image < layer ? layer : 0; };
    const std::size_t paint = layerBytes(sizes.paints), level = layerBytes(sizes.normals);
    paints.texels = paint * sizes.paints.size();
    paints.scratch = paint / 4 + fitting(color, paint) + (mask > 0 ? fitting(mask, paint) : 0);
    normals.texels = level * sizes.normals.size();
    normals.scratch = level / 4 + fitting(normal, level);
    sky.texels = sky.images;
    sky.scratch = sky.images / 4;
    return gnomon::peakMemory(uploads);
}

SceneImages::Most SceneImages::most(const Pictures& pictures, Problems& problems) const {
    const LayerSizes sizes = layerSizes(pictures);
    const std::size_t paints = layerBytes(sizes.paints) * sizes.paints.size();
    const std::size_t normals = layerBytes(sizes.normals) * sizes.normals.size();
    const std::size_t peak = peakMemory(pictures, sizes);
    if (peak <= kMostImageMemory) return {paints, normals, maxSide_};
    tellReduced("its images and the textures that they become take " + std::to_string(peak >> 20) + " MB; " +
                    std::to_string(kMostImageMemory >> 20) + " MB are the most",
                problems);
    const double share = double(paints) / double(std::max<std::size_t>(paints + normals, 1));
    return {std::size_t(share * kReducedBytes), std::size_t((1 - share) * kReducedBytes),
            std::min(maxSide_, kReducedSky)};
}

gl::Texture SceneImages::upload(const std::vector<glm::ivec2>& sizes, const gl::ImageSource& imageOf, gl::Texels texels,
                                std::size_t bytes, std::vector<glm::vec2>& tiles, Problems& problems) const {
    if (sizes.empty()) return {};
    const Layers layers(sizes, texels == gl::Texels::Srgb, maxSide_, bytes);
    for (int i = 0; i < layers.count(); ++i) tiles.push_back(layers.tile(i));
    glm::ivec2 side(0);
    for (const glm::ivec2 size : sizes) side = glm::max(side, size);
    tellTooWide(side, problems);
    return gl::makeImages(layers, imageOf, texels);
}

Tiles SceneImages::uploadLayers(Pictures& pictures, const Most& most, Problems& problems) {
    const Image none, grey = flat(128, 128, 128), level = flat(128, 128, 255), dry = flat(0, 0, 0);
    const std::vector<Paint>& paints = prepared_->textureSet.paints;
    const std::vector<std::string>& normals = prepared_->textureSet.normals;
    const auto colorOf = [&](const Paint& paint) -> const Image& { return paint.color.empty() ? none : grey; };
    const auto maskOf = [&](const Paint& paint) -> const Image& { return paint.mask.empty() ? none : dry; };
    const LayerSizes sizes = layerSizes(pictures);
    const auto paintOf = [&](int i) {
        const Paint& paint = paints[std::size_t(i)];
        return painted(taken(pictures, paint.color, colorOf(paint)), taken(pictures, paint.mask, maskOf(paint)));
    };
    const auto normalOf = [&](int i) { return taken(pictures, normals[std::size_t(i)], level); };
    Tiles tiles;
    paints_ = upload(sizes.paints, paintOf, coding(), most.paintBytes, tiles.paints, problems);
    normals_ = upload(sizes.normals, normalOf, gl::Texels::Display, most.normalBytes, tiles.normals, problems);
    return tiles;
}

void SceneImages::uploadCubemap(Pictures& pictures, int side, Problems& problems) {
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
    tellTooWide(size, problems);
    sky_ = gl::makeCubemap(faceOf, coding(), side);
}

void SceneImages::uploadPanorama(Pictures& pictures, int side, Problems& problems) {
    Image image = taken(pictures, prepared_->scene.background.image, night());
    tellTooWide(sizeOf(image), problems);
    sky_ = gl::makePanorama(std::move(image), coding(), side);
}

std::optional<Tiles> SceneImages::bind(Pictures& pictures, Problems& problems) {
    const auto lost = [](const gl::Texture& texture, bool wanted) { return wanted && !texture; };
    const bool cubemap = !prepared_->skyFaces.empty(), panorama = !prepared_->scene.background.image.empty();
    std::optional<Tiles> tiles;
    const bool layers = layersStale_ || lost(paints_, !prepared_->textureSet.paints.empty()) ||
                        lost(normals_, !prepared_->textureSet.normals.empty());
    const bool sky = (cubemap || panorama) && (skyStale_ || !sky_);
    if (layers || sky) {
        const Most room = most(pictures, problems);
        if (layers) tiles = uploadLayers(pictures, room, problems);
        if (sky && cubemap) uploadCubemap(pictures, room.skySide, problems);
        if (sky && panorama) uploadPanorama(pictures, room.skySide, problems);
    }
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
