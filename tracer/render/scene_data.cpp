#include "tracer/render/scene_data.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon {
namespace {

/// Object indices in the shader's order: by kind, within a kind the casters first, else as in the file.
std::vector<int> shaderOrder(const Scene& scene, const std::vector<ShapeKind>& kinds) {
    std::vector<int> order(scene.objects.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = int(i);
    const auto place = [&](int i) {
        return std::pair(kinds[std::size_t(i)], !scene.objects[std::size_t(i)].castsShadow);
    };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return place(a) < place(b); });
    return order;
}

int slotOf(const std::vector<std::string>& images, const std::string& name) {
    return name.empty() ? -1 : int(std::find(images.begin(), images.end(), name) - images.begin());
}

/// Reflectance at normal incidence of a surface with complex index n + ik.
glm::dvec3 normalReflectance(glm::dvec3 n, glm::dvec3 k) {
    return ((n - 1.0) * (n - 1.0) + k * k) / ((n + 1.0) * (n + 1.0) + k * k);
}

struct Optics {
    glm::dvec3 f0{0};
    double ior = 0;
    int kind = 0; ///< as kPlain … kCoat in shade/material.glsl
    int mask = -1;
};

Optics opticsOf(const Material& material, const std::vector<std::string>& images) {
    if (const auto* conductor = std::get_if<Conductor>(&material.optics))
        return {normalReflectance(conductor->n, conductor->k), 0, 1, -1};
    if (const auto* dielectric = std::get_if<Dielectric>(&material.optics))
        return {normalReflectance(glm::dvec3(dielectric->ior), glm::dvec3(0)), dielectric->ior, 2, -1};
    if (const auto* coat = std::get_if<Coat>(&material.optics))
        return {normalReflectance(glm::dvec3(coat->ior), glm::dvec3(0)), 0, 3, slotOf(images, coat->mask)};
    return {};
}

/// uv scale and offset at `time`; the offset is reduced to one period in double, so that it never loses bits with time.
glm::vec4 placement(const std::optional<TextureUse>& use, double time) {
    if (!use) return {};
    const glm::dvec2 moved = use->scroll * time;
    return glm::vec4(use->scale, moved - glm::floor(moved));
}

void packMaterial(const Material& m, const std::vector<std::string>& images, double time, std::vector<glm::vec4>& out) {
    const Optics optics = opticsOf(m, images);
    const auto slot = [&](const std::optional<TextureUse>& use) { return use ? slotOf(images, use->image) : -1; };
    out.insert(out.end(),
               {glm::vec4(m.ambient, m.shininess), glm::vec4(m.diffuse, optics.ior), glm::vec4(m.specular, optics.kind),
                glm::vec4(m.emission, slot(m.texture)), glm::vec4(optics.f0, slot(m.normalMap)),
                placement(m.texture, time), placement(m.normalMap, time), glm::vec4(optics.mask, 0, 0, 0)});
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

bool showsImages(const Material& m) {
    const auto* coat = std::get_if<Coat>(&m.optics);
    return m.texture || m.normalMap || (coat && !coat->mask.empty());
}

/// A plane told from its point nearest to 0, so that neither that point nor the rounding of the normal is off by what
/// float32 makes of the way to a stated point far from the scene.
Shape toldFromHere(Shape plane) {
    const glm::dvec3 normal = pointOf(plane, "normal");
    plane.texels[0] = glm::dvec4(glm::dot(pointOf(plane, "point"), normal) / glm::dot(normal, normal) * normal, 0);
    return plane;
}

/// Every object's shape at `time` relative to `origin`.
std::vector<Shape> shapesAbout(glm::dvec3 origin, const Scene& scene, double time) {
    std::vector<Shape> shapes = shapesAt(scene, time);
    if (origin == glm::dvec3(0)) return shapes;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        shapes[i] = translated(shapes[i], -origin);
        // The stated point is where an image on the plane begins.
        if (shapes[i].kind == ShapeKind::Plane && !showsImages(scene.materials[std::size_t(scene.objects[i].material)]))
            shapes[i] = toldFromHere(shapes[i]);
    }
    return shapes;
}

int texelsOf(const Scene& scene, const std::vector<ShapeKind>& kinds) {
    int texels = int(scene.materials.size()) * kMaterialTexels + int(scene.lights.size()) * kLightTexels;
    for (const ShapeKind kind : kinds) texels += shapeRow(kind).texels + 1;
    for (const Object& object : scene.objects) texels += object.glow ? kGlowTexels : 0;
    return texels;
}

} // namespace

int sceneTexels(const Scene& scene) { return texelsOf(scene, drawnKinds(scene)); }

std::vector<std::pair<std::string, int>> constantsOf(const Features& features) {
    std::vector<std::pair<std::string, int>> constants;
    int texel = 0, object = 0;
    for (const KindCount& kind : features.shapes) {
        const ShapeRow& row = shapeRow(kind.kind);
        const std::string name = "k" + std::string(row.type);
        constants.insert(constants.end(), {{name + "Base", texel},
                                           {name + "Texels", row.texels},
                                           {name + "First", object},
                                           {name + "End", object + kind.count},
                                           {name + "Count", kind.count},
                                           {name + "Casters", kind.casters}});
        texel += row.texels * kind.count;
        object += kind.count;
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

std::vector<glm::vec4> packScene(const Scene& scene, const Features& features, double time) {
    return packScene(scene, features, time, scene.camera.eye, glm::dvec3(0));
}

std::vector<glm::vec4> packScene(const Scene& scene, const Features& features, double time, glm::dvec3 eye,
                                 glm::dvec3 origin) {
    std::vector<Shape> shapes = shapesAbout(origin, scene, time);
    noteMiddleOfTriangles(shapes);
    const std::vector<ShapeKind> kinds = drawnKinds(scene);
    const std::vector<int> order = shaderOrder(scene, kinds);
    const std::vector<std::string> images = imageSlots(scene);
    std::vector<glm::vec4> texels;
    texels.reserve(std::size_t(texelsOf(scene, kinds)));
    for (int i : order) {
        const Shape drawn = drawnAs(kinds[i], shapes[i], eye - origin);
        for (int k = 0; k < shapeRow(drawn.kind).texels; ++k) texels.emplace_back(drawn.texels[k]);
    }
    for (int i : order) texels.emplace_back(float(scene.objects[i].material), float(i), 0.0f, 0.0f);
    for (const Material& material : scene.materials) packMaterial(material, images, time, texels);
    for (const Light& light : scene.lights) {
        texels.emplace_back(glm::vec4(std::get<PointLight>(light.shape).position - origin, 0));
        texels.emplace_back(glm::vec4(light.color, 0));
    }
    if (features.glows > 0)
        for (std::size_t i = 0; i < scene.objects.size(); ++i)
            if (const auto& glow = scene.objects[i].glow) {
                texels.emplace_back(glm::vec4(pointOf(shapes[i], "center"), glow->strength));
                texels.emplace_back(glm::vec4(glow->color, glow->softness));
            }
    return texels;
}

std::vector<std::string> imageSlots(const Scene& scene) {
    std::vector<std::string> slots;
    const auto add = [&](const std::string& name) {
        if (!name.empty() && std::find(slots.begin(), slots.end(), name) == slots.end()) slots.push_back(name);
    };
    for (const Material& material : scene.materials) {
        if (material.texture) add(material.texture->image);
        if (material.normalMap) add(material.normalMap->image);
        if (const auto* coat = std::get_if<Coat>(&material.optics)) add(coat->mask);
    }
    return slots;
}

} // namespace gnomon
