/// What is drawn: plain data, all numbers checked, names resolved to indices. Knows nothing of GL.
#pragma once

#include "tracer/scene/shapes.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace gnomon {

/// Where the picture is taken from. `fov` is vertical, in degrees.
struct CameraPose {
    glm::dvec3 eye{0, 0, 3}, target{0, 0, 0}, up{0, 1, 0};
    double fov = 36.86989764584402; ///< a canvas of half height 1 at distance 3

    bool operator==(const CameraPose&) const = default;
};

/// How an image lies on a surface: texel coordinate = uv * scale + scroll * time, repeated.
struct TextureUse {
    std::string image; ///< its name: native/file/asset_folder.h finds the file
    glm::dvec2 scale{1, 1};
    glm::dvec2 scroll{0, 0}; ///< per second
};

/// Fresnel reflectance from complex index n + ik, per channel. Reflects, never refracts.
struct Conductor {
    glm::dvec3 n{1}, k{0};
};
/// Clear body: reflects and refracts.
struct Dielectric {
    double ior = 1.5;         ///< absolute: air has 1, whatever the body lies in
    glm::dvec3 absorption{0}; ///< Beer-Lambert: exp(-absorption * length) of the light is left
    double priority = 0;      ///< of the bodies that a point lies in the one of highest priority is its medium
};
/// Clear layer over the surface's own colour: reflects by its index, does not refract.
struct Coat {
    double ior = 1.5;
    std::string mask; ///< image whose red channel scales the reflection; empty: everywhere. Uses the texture's uv
};

/// Reflects the same fraction at every angle.
struct Mirror {
    glm::dvec3 reflectance{1};
};

/// Two colours in turn, in squares of the surface's texture coordinates: 1 / scale wide, from uv = 0 on.
struct Checker {
    std::array<glm::dvec3, 2> colors{glm::dvec3(1), glm::dvec3(0)};
    glm::dvec2 scale{1, 1};
};

struct Material {
    std::string name;
    glm::dvec3 ambient{0}, diffuse{0}, specular{0}, emission{0};
    double shininess = 1;
    std::variant<std::monostate, Conductor, Dielectric, Coat, Mirror> optics;
    std::optional<Checker> checker;      ///< multiplies as a texture does
    std::optional<TextureUse> texture;   ///< multiplies ambient, diffuse and emission of its own surface
    std::optional<TextureUse> normalMap; ///< tangent space, green towards the image's top

    /// A surface of it has to tell where on an image a point lies.
    bool showsImages() const;
    bool refracts() const { return std::holds_alternative<Dielectric>(optics); }
};

/// Moves a shape by cos·cos(rate t) + sin·sin(rate t) from where it rests, and by all that `around` has moved too: the
/// resting place of a shape with `around` is relative to the other object's reference point.
struct Orbit {
    glm::dvec3 cos{0}, sin{0};
    double rate = 1; ///< radians per second
    int around = -1; ///< index in Scene::objects; -1: none
};

/// Light around a point, seen along the ray's line: color * clamp(strength / (softness + d²)), d = distance of the
/// line.
struct Glow {
    glm::dvec3 color{1};
    double strength = 2, softness = 0.5;
};

struct Object {
    Shape shape; ///< where it rests
    int material = 0;
    std::string name;
    bool castsShadow = true;
    std::optional<Orbit> motion;
    std::optional<Glow> glow; ///< spheres only
    int line = 0;             ///< in the scene file
};

enum class LightKind {
    Sphere,      ///< a point where its radius is 0
    Directional, ///< so far away that its light is parallel
    Spot         ///< a point that lights a cone
};

/// A light is itself no object: nothing is seen of it and it hides nothing.
struct Light {
    glm::dvec3 position{0}; ///< not of a directional one
    double radius = 0;
    glm::dvec3 color{1};
    LightKind kind = LightKind::Sphere;
    glm::dvec3 direction{0, -1, 0}; ///< unit, in which a directional light or a spot shines
    double angle = 30;              ///< of a spot: from its axis to where its light ends, in degrees
    double softness = 0;            ///< of a spot: the part of that angle over which its light fades
    double falloff = 0;             ///< distance at which it is as strong as `color` says, by its square; 0: at every
};

/// From straight down to straight up; between, by the y of the direction.
struct Gradient {
    glm::dvec3 top{0}, bottom{0};
};

/// What rays see that hit nothing: one colour, or else one of the others.
struct Background {
    glm::dvec3 color{0};
    std::string cubemap; ///< NAME of six images, of which NAME-px lies towards −x (docs/scenes.md)
    std::string image;   ///< all around: columns are longitude, −z in the middle; rows latitude, +y first
    std::optional<Gradient> gradient;
};

enum class Encoding { Linear, Display };

/// How reflectance follows from refractive indices: by the Fresnel equations, or by Schlick's approximation of them.
enum class Fresnel { Exact, Schlick };
/// What a dielectric does with a ray of the largest depth: lets it go straight on, or ends it, as S1 does.
enum class DepthLimit { Straight, Dark };

struct Scene {
    std::string name, file, title, description;
    CameraPose camera;
    Background background;
    Encoding encoding = Encoding::Linear;
    Fresnel fresnel = Fresnel::Exact;
    DepthLimit depthLimit = DepthLimit::Straight;
    std::vector<Light> lights;
    std::vector<Material> materials; ///< [0] is the default grey
    std::vector<Object> objects;     ///< in file order: the `object` output is an index into this
};

/// Every object's shape at `time` seconds.
std::vector<Shape> shapesAt(const Scene&, double time);

/// Every object's shape where its orbit takes it farthest against the axes, and farthest along them: a box about both
/// holds it at any time.
std::array<std::vector<Shape>, 2> outermostShapes(const Scene&);

/// Whether anything in the picture changes with time: an object that moves, or an image on one.
bool changesWithTime(const Scene&);

/// Names of all images the scene needs, each once, cube map faces spelled out.
std::vector<std::string> imagesOf(const Scene&);

} // namespace gnomon
