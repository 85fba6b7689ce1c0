#include "tracer/plan/scene_packer.h"

#include "tracer/accel/lattice.h"
#include "tracer/accel/node_texels.h"
#include "tracer/plan/drawn.h"
#include "tracer/plan/scene_offsets.h"
#include "tracer/plan/shape_texels.h"
#include "tracer/plan/solid_texels.h"

#include <algorithm>
#include <cassert>
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
    int kind = 0; ///< as kPlain … kMirror in shade/material.glsl
};

Optics opticsOf(const Material& material) {
    if (const auto* conductor = std::get_if<Conductor>(&material.optics))
        return {normalReflectance(conductor->n, conductor->k), 0, 1};
    if (const auto* dielectric = std::get_if<Dielectric>(&material.optics))
        return {normalReflectance(glm::dvec3(dielectric->ior), glm::dvec3(0)), dielectric->ior, 2};
    if (const auto* coat = std::get_if<Coat>(&material.optics))
        return {normalReflectance(glm::dvec3(coat->ior), glm::dvec3(0)), coat->ior, 3};
    if (const auto* mirror = std::get_if<Mirror>(&material.optics)) return {mirror->reflectance, 0, 4};
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

void packMaterial(const Material& m, const TextureSet& textureSet, const Tiles& tiles, double time,
                  std::vector<glm::vec4>& out) {
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

bool isTriangle(ShapeKind kind) { return kind == ShapeKind::Triangle || kind == ShapeKind::SmoothTriangle; }

/// From where a directional light comes: farther than any scene's coordinates tell in float32.
constexpr double kFarAway = 1e12;

/// {v, w} so that dot(v, direction) + w goes from 0, where a spot's light ends, to 1, where it is at full strength.
glm::vec4 coneTexel(const Light& light) {
    if (light.kind != LightKind::Spot) return {0, 0, 0, 1};
    constexpr double kSharpest = 1e-6; // of a cosine: what float32 tells
    const double end = std::cos(glm::radians(light.angle)),
                 full = std::cos(glm::radians(light.angle * (1 - light.softness))),
                 steepness = 1 / std::max(full - end, kSharpest);
    return glm::vec4(steepness * light.direction, -steepness * end);
}

/// Of the box about all triangles. Rays are re-centred on it.
glm::dvec3 middleOfTriangles(const std::vector<Shape>& shapes) {
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
    for (const Shape& shape : shapes)
        for (int i = 0; isTriangle(shape.kind) && i < 3; ++i) {
            low = glm::min(low, vertexOf(shape, i));
            high = glm::max(high, vertexOf(shape, i));
        }
    return 0.5 * (low + high);
}

/// Into the free components of the triangle that `texels` end with.
void setMiddle(glm::dvec3 middle, std::vector<glm::vec4>& texels) {
    for (int i = 0; i < 3; ++i) texels[texels.size() - 3 + std::size_t(i)].w = float(middle[i]);
}

/// A plane told from its point nearest to 0, so that neither that point nor the rounding of the normal is off by what
/// float32 makes of the way to a stated point far from the scene.
Shape toldFromHere(Shape plane) {
    const glm::dvec3 normal = pointOf(plane, "normal");
    setPoint(plane, "point", glm::dot(pointOf(plane, "point"), normal) / glm::dot(normal, normal) * normal);
    return plane;
}

} // namespace

ScenePacker::ScenePacker(PreparedScenePtr prepared) : ScenePacker(prepared, prepared->origin) {}

ScenePacker::ScenePacker(PreparedScenePtr prepared, glm::dvec3 origin)
    : prepared_(std::move(prepared)), origin_(origin), hierarchies_(prepared_->layout.size()) {}

std::span<const glm::vec4> ScenePacker::pack(const Plan& plan, double time, glm::dvec3 eye) {
    shapes_ = shapesAbout(time);
    texels_.clear();
    packShapes(eye - origin_);
    packSearches(plan.scene, glm::vec3(eye - origin_));
    packObjects(plan);
    for (const Material& material : prepared_->scene.materials)
        packMaterial(material, prepared_->textureSet, tiles_, time, texels_);
    packLights();
    if (plan.scene.glows > 0) packGlows();
    if (plan.scene.metals()) packMetals();
    if (plan.scene.media > 0) packMedia(eye - origin_);
    if (plan.scene.checkers) packCheckers();
    if (plan.scene.lightProfiles) packProfiles();
    if (const auto& gradient = prepared_->scene.background.gradient)
        texels_.insert(texels_.end(), {glm::vec4(gradient->bottom, 0), glm::vec4(gradient->top, 0)});
    assert(int(texels_.size()) == sceneTexels(plan.scene));
    return texels_;
}

/// Every object's shape at `time` relative to the origin.
std::vector<Shape> ScenePacker::shapesAbout(double time) const {
    const Scene& scene = prepared_->scene;
    std::vector<Shape> shapes = shapesAt(scene, time);
    if (origin_ == glm::dvec3(0)) return shapes;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        shapes[i] = translated(shapes[i], -origin_);
        // The stated point is where an image on the plane begins.
        if (shapes[i].kind == ShapeKind::Plane &&
            !scene.materials[std::size_t(scene.objects[i].material)].showsImages())
            shapes[i] = toldFromHere(shapes[i]);
    }
    return shapes;
}

void ScenePacker::packShapes(glm::dvec3 eye) {
    const glm::dvec3 middle = middleOfTriangles(shapes_);
    for (const KindLayout& kind : prepared_->layout)
        for (const int i : kind.objects) {
            const Shape& shape = shapes_[std::size_t(i)];
            if (kind.solid) {
                appendTexels(shape, texels_);
            } else {
                appendShape(drawnAs(kind.kind, shape, eye), texels_);
                if (isTriangle(kind.kind)) setMiddle(middle, texels_);
                if (kind.kind == ShapeKind::HeightPatch) setField(i);
                appendNet(shape, texels_);
            }
        }
}

/// Into the free components of the patch that the texels end with: samples, height of the box, place in the texture.
void ScenePacker::setField(int object) {
    if (fields_.slots.empty()) return;
    const FieldSlot& slot = fields_.slots[std::size_t(fields_.slotOf[std::size_t(object)])];
    glm::vec4* texels = &texels_[texels_.size() - 5];
    texels[0].w = float(fields_.samples);
    texels[1].w = float(slot.size.y);
    for (int i = 0; i < 3; ++i) texels[2 + i].w = float(slot.at[i]);
}

void ScenePacker::packSearches(const SceneFeatures& features, glm::vec3 eye) {
    for (std::size_t k = 0; k < prepared_->layout.size(); ++k) {
        const KindCount& kind = features.shapes[k];
        const std::span<const int> objects = prepared_->layout[k].objects;
        const auto shape = [&](std::size_t i) { return shapes_[std::size_t(objects[i])]; };
        const auto members = std::size_t(kind.latticeMembers());
        if (members > 0) appendTexels(kind.lattice, shape(0), shape(members - 1), texels_);
        if (kind.search != Search::Hierarchy && kind.search != Search::Grid) continue;
        bounds_.clear();
        for (const int i : objects.subspan(members)) bounds_.push_back(*boundsOf(shapes_[std::size_t(i)]));
        if (kind.search == Search::Grid) {
            appendGrid(kind.grid, bounds_, texels_);
        } else {
            update(hierarchies_[k], bounds_);
            appendTexels(hierarchies_[k], eye, texels_);
        }
    }
}

void ScenePacker::packObjects(const Plan& plan) {
    const Scene& scene = prepared_->scene;
    for (std::size_t k = 0; k < prepared_->layout.size(); ++k)
        for (const int i : prepared_->layout[k].objects) {
            const int material = scene.objects[std::size_t(i)].material;
            const bool discarded = plan.split.fallsBack(k, scene.materials[std::size_t(material)]);
            const int rank = plan.scene.media > 0 ? prepared_->media.ranks[std::size_t(i)] : 0;
            texels_.emplace_back(float(material), float(i), float(discarded), float(rank));
        }
}

void ScenePacker::packLights() {
    for (const Light& light : prepared_->scene.lights) {
        const bool far = light.kind == LightKind::Directional;
        texels_.emplace_back(glm::vec4(far ? -kFarAway * light.direction : light.position - origin_, light.radius));
        texels_.emplace_back(glm::vec4(light.color, light.falloff * light.falloff));
    }
}

void ScenePacker::packGlows() {
    const std::vector<Object>& objects = prepared_->scene.objects;
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (const auto& glow = objects[i].glow) {
            texels_.emplace_back(glm::vec4(pointOf(shapes_[i], "center"), glow->strength));
            texels_.emplace_back(glm::vec4(glow->color, glow->softness));
        }
}

/// Of every material, so that its number tells where: of others than conductors 1 + 0i.
void ScenePacker::packMetals() {
    for (const Material& material : prepared_->scene.materials) {
        const auto* conductor = std::get_if<Conductor>(&material.optics);
        const Conductor index = conductor ? *conductor : Conductor{};
        texels_.insert(texels_.end(), {glm::vec4(index.n, 0), glm::vec4(index.k, 0)});
    }
}

void ScenePacker::packMedia(glm::dvec3 eye) {
    const Media& media = prepared_->media;
    texels_.emplace_back(0.0f, 0.0f, 0.0f, 1.0f); // air
    for (std::size_t rank = 1; rank < media.materials.size(); ++rank) {
        const Material& material = prepared_->scene.materials[std::size_t(media.materials[rank])];
        const auto& dielectric = std::get<Dielectric>(material.optics);
        texels_.emplace_back(glm::vec4(dielectric.absorption, dielectric.ior));
    }
    texels_.emplace_back(glm::vec4(mediaAt(media, shapes_, glm::dvec3(glm::vec3(eye)))));
}

/// Of every material; white of those that have none.
void ScenePacker::packCheckers() {
    for (const Material& material : prepared_->scene.materials) {
        const Checker white{{glm::dvec3(1), glm::dvec3(1)}, {0, 0}};
        const Checker& checker = material.checker ? *material.checker : white;
        texels_.emplace_back(glm::vec4(checker.colors[0], checker.scale.x));
        texels_.emplace_back(glm::vec4(checker.colors[1], checker.scale.y));
    }
}

void ScenePacker::packProfiles() {
    for (const Light& light : prepared_->scene.lights) texels_.push_back(coneTexel(light));
}

std::vector<glm::vec4> packScene(PreparedScenePtr prepared, const Plan& plan, double time, FieldLayout fields) {
    const glm::dvec3 eye = prepared->scene.camera.eye;
    ScenePacker packer(std::move(prepared), glm::dvec3(0));
    packer.setFields(std::move(fields));
    const auto texels = packer.pack(plan, time, eye);
    return {texels.begin(), texels.end()};
}

} // namespace gnomon
