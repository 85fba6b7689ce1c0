#include "tracer/plan/texture_set.h"

#include <algorithm>

namespace gnomon {
namespace {

Paint paintIn(const Material& material) {
    const Coat* coat = std::get_if<Coat>(&material.optics);
    return {material.texture ? material.texture->image : "", coat ? coat->mask : ""};
}

std::string normalIn(const Material& material) { return material.normalMap ? material.normalMap->image : ""; }

template<typename Item>
int layerOf(const std::vector<Item>& layers, const Item& item) {
    return item == Item{} ? -1 : int(std::find(layers.begin(), layers.end(), item) - layers.begin());
}

template<typename Item>
void addOnce(std::vector<Item>& layers, const Item& item) {
    if (layerOf(layers, item) == int(layers.size())) layers.push_back(item);
}

} // namespace

int TextureSet::paintOf(const Material& material) const { return layerOf(paints, paintIn(material)); }
int TextureSet::normalOf(const Material& material) const { return layerOf(normals, normalIn(material)); }

bool TextureSet::shows(const std::string& image) const {
    return std::find(normals.begin(), normals.end(), image) != normals.end() ||
           std::any_of(paints.begin(), paints.end(),
                       [&](const Paint& paint) { return paint.color == image || paint.mask == image; });
}

TextureSet textureSetOf(const Scene& scene) {
    TextureSet textureSet;
    for (const Material& material : scene.materials) {
        addOnce(textureSet.paints, paintIn(material));
        addOnce(textureSet.normals, normalIn(material));
    }
    return textureSet;
}

} // namespace gnomon
