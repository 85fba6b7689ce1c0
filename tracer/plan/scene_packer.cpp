#include "tracer/plan/scene_packer.h"

#include "tracer/accel/lattice.h"
#include "tracer/accel/node_texels.h"
#include "tracer/software/uncommon_features.h"
#include "tracer/shader/solid_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon {
namespace {

/// Reflectance at normal incidence of a surface with complex index n + ik.
glm::dvec3 normalReflectance(glm::dvec3 n, glm::dvec3 k) {
    return ((n - 1.0) * (n - 1.0) + k * k) / ((n + 1.0) * (n + 1.0) + k * k);
}

struct Optics {
    glm::dvec3 f0{0};
    double ior = 0;
    int kind = 0; ///< as kPlain … kCoat in shade/material.glsl
};

Optics opticsOf(const Material& material) {
    if (const auto* conductor = std::get_if<Conductor>(&material.optics))
        return {normalReflectance(conductor->n, conductor->k), 0, 1};
    if (const auto* dielectric = std::get_if<Dielectric>(&material.optics))
        return {normalReflectance(glm::dvec3(dielectric->ior), glm::dvec3(0)), dielectric->ior, 2};
    if (const auto* coat = std::get_if<Coat>(&material.optics))
        return {normalReflectance(glm::dvec3(coat->ior), glm::dvec3(0)), 0, 3};
    return {};
}

/// uv scale and offset at `time`, on a layer of which the image takes `tile`; the offset is reduced to one period in
/// double, so that it never loses bits with time.
glm::vec4 placement(const std::optional<TextureUse>& use, glm::vec2 tile, double time) {
    if (!use) return {tile, 0, 0};
    const glm::dvec2 moved = use->scroll * time;
    return {use->scale * glm::dvec2(tile), (moved - glm::floor(moved)) * glm::dvec2(tile)};
}

/// More than there are layers: two of them in one number, as shaders/shade/material.glsl takes it apart.
constexpr int kLayers = kMostLayers + 1;

void packMaterial(const Material& m, const TextureSet& textureSet, const Tiles& tiles, double time, std::vector<glm::vec4>& out) {
    const Optics optics = opticsOf(m);
    const int paint = textureSet.paintOf(m), normal = textureSet.normalOf(m);
    const auto tile = [](const std::vector<glm::vec2>& of, int layer) {
        return layer >= 0 && std::size_t(layer) < of.size() ? of[std::size_t(layer)] : glm::vec2(1);
    };
    out.insert(out.end(),
               {glm::vec4(m.diffuse, m.shininess), glm::vec4(m.specular, optics.kind),
                glm::vec4(m.ambient + m.emission, optics.ior), glm::vec4(optics.f0, paint + 1 + kLayers * (normal + 1)),
                placement(m.texture, tile(tiles.paints, paint), time),
                placement(m.normalMap, tile(tiles.normals, normal), time)});
}

/// Into the free components of every triangle goes the middle of the box about all of them: rays are re-centred on it.
void noteMiddleOfTriangles(std::vector<Shape>& shapes) {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
    for (const Shape& shape : shapes)
        for (int i = 0; shape.kind == ShapeKind::Triangle && i < 3; ++i) {
            low = glm::min(low, glm::dvec3(shape.texels[std::size_t(i)]));
            high = glm::max(high, glm::dvec3(shape.texels[std::size_t(i)]));
        }
    const glm::dvec3 middle = 0.5 * (low + high);
    for (Shape& shape : shapes)
        for (int i = 0; shape.kind == ShapeKind::Triangle && i < 3; ++i) shape.texels[std::size_t(i)].w = middle[i];
}

/// A plane told from its point nearest to 0, so that neither that point nor the rounding of the normal is off by what
/// float32 makes of the way to a stated point far from the scene.
Shape toldFromHere(Shape plane) {
    const glm::dvec3 normal = pointOf(plane, "normal");
    plane.texels[0] = glm::dvec4(glm::dot(pointOf(plane, "point"), normal) / glm::dot(normal, normal) * normal, 0);
    return plane;
}

} // namespace

int sceneTexels(const Features& features) { return constantsOf(features).back().second; }

std::vector<std::pair<std::string, int>> constantsOf(const Features& features) {
    std::vector<std::pair<std::string, int>> constants;
    int texel = 0, object = 0;
    for (const KindCount& kind : features.shapes) {
        const std::string name = "k" + kind.type();
        constants.insert(constants.end(), {{name + "Base", texel},
                                           {name + "Texels", kind.texels()},
                                           {name + "First", object},
                                           {name + "End", object + kind.count},
                                           {name + "Count", kind.count},
                                           {name + "Casters", kind.casters}});
        texel += kind.texels() * kind.count;
        object += kind.count;
    }
    for (const KindCount& kind : features.shapes) {
        const std::string name = "k" + kind.type();
        if (kind.latticeMembers() > 0) {
            constants.insert(constants.end(), {{name + "Lattice", texel},
                                               {name + "LatticeX", kind.lattice.x},
                                               {name + "LatticeY", kind.lattice.y},
                                               {name + "LatticeZ", kind.lattice.z}});
            texel += kLatticeTexels;
        }
        if (kind.search == Search::Hierarchy) {
            constants.insert(constants.end(), {{name + "Quantisation", texel}, {name + "Nodes", nodesFor(kind.loose())}});
            texel += hierarchyTexels(kind.loose());
        }
        if (kind.search == Search::Grid) {
            constants.insert(constants.end(), {{name + "Grid", texel},
                                               {name + "GridX", kind.grid.count.x},
                                               {name + "GridY", kind.grid.count.y},
                                               {name + "GridZ", kind.grid.count.z}});
            texel += kind.grid.texels();
        }
        if (kind.latticeMembers() > 0 || kind.search != Search::Loop)
            constants.emplace_back(name + "Loose", kind.latticeMembers());
    }
    const auto block = [&](const char* name, int count, int size) {
        constants.emplace_back(std::string("k") + name + "Base", texel);
        constants.emplace_back(std::string("k") + name + "Count", count);
        texel += count * size;
    };
    block("Object", object, 1);
    block("Material", features.materials, kMaterialTexels);
    block("Light", features.lights, kLightTexels);
    if (features.glows > 0) block("Glow", features.glows, kGlowTexels);
    constants.emplace_back("kSceneTexels", texel);
    return constants;
}

ScenePacker::ScenePacker(const Scene& scene, glm::dvec3 origin)
    : scene_(scene), origin_(origin), layout_(layoutOf(scene)), textureSet_(textureSetOf(scene)), hierarchies_(layout_.size()) {}

std::span<const glm::vec4> ScenePacker::pack(const Features& features, double time, glm::dvec3 eye) {
    shapes_ = shapesAbout(time);
    noteMiddleOfTriangles(shapes_);
    texels_.clear();
    packShapes(shapes_, eye - origin_);
    packSearches(features, shapes_, glm::vec3(eye - origin_));
    packObjects(features);
    for (const Material& material : scene_.materials) packMaterial(material, textureSet_, tiles_, time, texels_);
    packLights();
    if (features.glows > 0) packGlows(shapes_);
    return texels_;
}

/// Every object's shape at `time` relative to the origin.
std::vector<Shape> ScenePacker::shapesAbout(double time) const {
    std::vector<Shape> shapes = shapesAt(scene_, time);
    if (origin_ == glm::dvec3(0)) return shapes;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        shapes[i] = translated(shapes[i], -origin_);
        // The stated point is where an image on the plane begins.
        if (shapes[i].kind == ShapeKind::Plane &&
            !scene_.materials[std::size_t(scene_.objects[i].material)].showsImages())
            shapes[i] = toldFromHere(shapes[i]);
    }
    return shapes;
}

void ScenePacker::packShapes(const std::vector<Shape>& shapes, glm::dvec3 eye) {
    for (const KindLayout& kind : layout_)
        for (const int i : kind.objects) {
            if (kind.solid) {
                appendTexels(shapes[std::size_t(i)], texels_);
                continue;
            }
            const Shape drawn = drawnAs(kind.kind, shapes[std::size_t(i)], eye);
            for (int k = 0; k < shapeRow(kind.kind).texels; ++k) texels_.emplace_back(drawn.texels[std::size_t(k)]);
        }
}

void ScenePacker::packSearches(const Features& features, const std::vector<Shape>& shapes, glm::vec3 eye) {
    for (std::size_t k = 0; k < layout_.size(); ++k) {
        const KindCount& kind = features.shapes[k];
        const std::span<const int> objects = layout_[k].objects;
        const auto shape = [&](std::size_t i) { return shapes[std::size_t(objects[i])]; };
        const auto members = std::size_t(kind.latticeMembers());
        if (members > 0) appendTexels(kind.lattice, shape(0), shape(members - 1), texels_);
        if (kind.search != Search::Hierarchy && kind.search != Search::Grid) continue;
        bounds_.clear();
        for (const int i : objects.subspan(members)) bounds_.push_back(*boundsOf(shapes[std::size_t(i)]));
        if (kind.search == Search::Grid) {
            appendGrid(kind.grid, bounds_, texels_);
        } else {
            update(hierarchies_[k], bounds_);
            appendTexels(hierarchies_[k], eye, texels_);
        }
    }
}

void ScenePacker::packObjects(const Features& features) {
    for (std::size_t k = 0; k < layout_.size(); ++k)
        for (const int i : layout_[k].objects) {
            const int material = scene_.objects[std::size_t(i)].material;
            const bool left = fallsBack(features, features.shapes[k], scene_.materials[std::size_t(material)]);
            texels_.emplace_back(float(material), float(i), float(left), 0.0f);
        }
}

void ScenePacker::packLights() {
    for (const Light& light : scene_.lights) {
        texels_.emplace_back(glm::vec4(light.position - origin_, light.radius));
        texels_.emplace_back(glm::vec4(light.color, 0));
    }
}

void ScenePacker::packGlows(const std::vector<Shape>& shapes) {
    for (std::size_t i = 0; i < scene_.objects.size(); ++i)
        if (const auto& glow = scene_.objects[i].glow) {
            texels_.emplace_back(glm::vec4(pointOf(shapes[i], "center"), glow->strength));
            texels_.emplace_back(glm::vec4(glow->color, glow->softness));
        }
}

std::vector<ScreenBounds> ScenePacker::screenBounds(const Features& features) const {
    std::vector<ScreenBounds> screenBounds;
    for (std::size_t k = 0; k < layout_.size(); ++k)
        for (const int i : layout_[k].objects) {
            const Shape& shape = shapes_[std::size_t(i)];
            const Material& material = scene_.materials[std::size_t(scene_.objects[std::size_t(i)].material)];
            ScreenBounds bounds{{}, shape.kind == ShapeKind::Sphere, fallsBack(features, features.shapes[k], material)};
            if (layout_[k].kind != ShapeKind::LargeSphere) bounds.bounds = boundsOf(shape); // a large sphere has no end
            screenBounds.push_back(bounds);
        }
    return screenBounds;
}

std::vector<glm::vec4> packScene(const Scene& scene, const Features& features, double time) {
    ScenePacker packer(scene);
    const auto texels = packer.pack(features, time, scene.camera.eye);
    return {texels.begin(), texels.end()};
}

} // namespace gnomon
