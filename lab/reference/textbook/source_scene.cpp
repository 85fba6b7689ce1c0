#include "lab/reference/textbook/source_scene.h"

#include <algorithm>
#include <array>

namespace gnomon {
namespace {

constexpr double kSkyDistance = 10000;

/// A face of a cube map: where it lies, and the ways in which its image's columns and rows run: OpenGL 4.6, table 8.19,
/// with x mirrored (docs/scenes.md).
struct SkyFace {
    const char* suffix;
    glm::dvec3 outward, across, down;
};
constexpr std::array<SkyFace, 6> kSkyFaces{{
    {"-px", {-1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
    {"-nx", {1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
    {"-py", {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}},
    {"-ny", {0, -1, 0}, {-1, 0, 0}, {0, 0, -1}},
    {"-pz", {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}},
    {"-nz", {0, 0, -1}, {1, 0, 0}, {0, -1, 0}},
}};

/// Shows all of the image once: a plane's uv is in scene units, from the stated point on
/// (shaders/primitive/planar.glsl).
Material skyMaterial(const SkyFace& face, const std::string& cubemap) {
    const glm::dvec3 tangent = face.outward.x == 0 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, -1);
    const glm::dvec3 bitangent = glm::cross(tangent, -face.outward);
    const glm::dvec2 along(glm::dot(face.across, tangent), glm::dot(face.down, bitangent));
    Material material;
    material.name = cubemap + face.suffix;
    material.emission = glm::dvec3(1);
    material.texture = TextureUse{material.name, along / (2 * kSkyDistance), {0, 0}};
    return material;
}

/// Through the corner of the cube where the image begins, facing the scene.
Shape skyPlane(const SkyFace& face) {
    return makeShape(ShapeKind::Plane, {kSkyDistance * (face.outward - face.across - face.down), -face.outward});
}

void addSky(Scene& scene) {
    for (const SkyFace& face : kSkyFaces) {
        Object plane;
        plane.shape = skyPlane(face);
        plane.material = int(scene.materials.size());
        plane.castsShadow = false;
        scene.objects.push_back(plane);
        scene.materials.push_back(skyMaterial(face, scene.background.cubemap));
    }
    scene.background.cubemap.clear();
}

Shape triangle(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) { return makeShape(ShapeKind::Triangle, {a, b, c}); }

/// Two a face, wound so that their normals point out of the box.
std::vector<Shape> trianglesOf(const Shape& box) {
    const glm::dvec3 center = pointOf(box, "center"), half = pointOf(box, "half_size");
    std::vector<Shape> triangles;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 out(0), u(0), v(0);
            out[axis] = side * half[axis];
            u[(axis + 1) % 3] = half[(axis + 1) % 3];
            v[(axis + 2) % 3] = side * half[(axis + 2) % 3];
            const glm::dvec3 face = center + out;
            triangles.push_back(triangle(face - u - v, face + u - v, face + u + v));
            triangles.push_back(triangle(face - u - v, face + u + v, face - u + v));
        }
    return triangles;
}

std::vector<Shape> partsOf(const Shape& shape) {
    return shape.kind == ShapeKind::Box ? trianglesOf(shape) : std::vector{shape};
}

/// From what its parts are known by to what the whole is known by: what moves around a box moves around its centre.
glm::dvec3 toReference(const Shape& shape) { return referencePoint(shape) - referencePoint(partsOf(shape).front()); }

} // namespace

Scene sourceScene(const Scene& scene) {
    Scene source = scene;
    source.fresnel = Fresnel::Schlick;
    source.objects.clear();
    std::vector<int> first; // part of each object
    for (const Object& object : scene.objects) {
        first.push_back(int(source.objects.size()));
        for (const Shape& part : partsOf(object.shape)) {
            source.objects.push_back(object);
            source.objects.back().shape = part;
        }
    }
    for (Object& object : source.objects) {
        if (!object.motion || object.motion->around < 0) continue;
        const std::size_t around = std::size_t(object.motion->around);
        object.shape = translated(object.shape, toReference(scene.objects[around].shape));
        object.motion->around = first[around];
    }
    if (!scene.background.cubemap.empty()) addSky(source);
    return source;
}

std::string beyondSource(const Scene& scene) {
    const auto anyLight = [&](auto which) { return std::any_of(scene.lights.begin(), scene.lights.end(), which); };
    const auto anyMaterial = [&](auto which) {
        return std::any_of(scene.materials.begin(), scene.materials.end(), which);
    };
    if (anyLight([](const Light& light) { return light.kind == LightKind::Spot; })) return "spot lights";
    if (anyLight([](const Light& light) { return light.falloff > 0; })) return "lights that fall off with distance";
    if (anyMaterial([](const Material& m) { return m.checker.has_value(); })) return "checkers";
    if (anyMaterial([](const Material& m) { return std::holds_alternative<Mirror>(m.optics); })) return "mirrors";
    return {};
}

} // namespace gnomon
