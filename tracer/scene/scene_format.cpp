#include "tracer/scene/scene_format.h"

#include "tracer/scene/shapes.h"

#include <algorithm>

namespace gnomon {

namespace {

using enum ValueType;

// Limits keep every number, and the products that the shaders form of them, well inside float32.
constexpr Range kAny{0, 0};
constexpr Range kCoordinate{-1e6, 1e6};
constexpr Range kLength{1e-6, 1e6};
constexpr Range kColor{0, 1000};
constexpr Range kReflectance{0, 1};
constexpr Range kShininess{1, 10000};
constexpr Range kIor{1, 4};
constexpr Range kBodyIor{0.05, 4};
constexpr Range kAbsorption{0, 1000};
constexpr Range kPriority{-1000, 1000};
constexpr Range kComplexIndex{0, 20};
constexpr Range kFov{0.001, 170};
constexpr Range kRate{-1000, 1000};
constexpr Range kTexelScale{-1000, 1000};
constexpr Range kSpotAngle{1, 90};
constexpr Range kPart{0, 1};
constexpr Range kGlow{1e-6, 1000};
constexpr Range kTitle{0, 200};
constexpr Range kDescription{0, 4000};
constexpr Range kObjects{1, kMostObjects};
constexpr Range kDefinitions{0, 256};
constexpr Range kFile{1, 200};
constexpr Range kParts{1, 63}; // with the operation 64, as many as a solid may have
constexpr Range kOffset{-1e6, 1e6};
constexpr Range kDegrees{-360, 360};
constexpr Range kScale{1e-3, 1e3};
constexpr Range kPeriod{0, 1e6};
constexpr Range kCopies{1, 1000, true};
constexpr Range kSeed{0, 4294967295, true};
constexpr Range kLights{0, 16};
constexpr Range kMaterials{0, 256};

const ObjectFormat& cameraFormat() {
    static const ObjectFormat format{
        "Where the picture is taken from",
        {{"eye", Vector, kCoordinate, "Where the camera stands; default [0, 0, 3]"},
         {"target", Vector, kCoordinate, "What it looks at; default [0, 0, 0]"},
         {"up", Direction, kCoordinate, "Which way is up in the picture; default [0, 1, 0]"},
         {"fov", Number, kFov,
          "Vertical field of view in degrees; default 36.87, a canvas of half height 1 at distance 3"}}};
    return format;
}

const ObjectFormat& gradientFormat() {
    static const ObjectFormat format{
        "From one colour straight down to another straight up: bottom + (top - bottom) (1 + y) / 2 in direction y",
        {{"top", Color, kColor, "Straight up", true}, {"bottom", Color, kColor, "Straight down", true}}};
    return format;
}

const ObjectFormat& backgroundFormat() {
    static const ObjectFormat format{
        "What rays see that hit nothing; default black",
        {{"color", Color, kColor, "The same colour everywhere"},
         {"gradient", Object, kAny, "From one colour to another", false, &gradientFormat()},
         {"image", Panorama, kImageName,
          "An image all around, equirectangular: -z in the middle, +x on its right, +y at the top"},
         {"cubemap", Image, kImageName,
          "Six images NAME-px, NAME-nx, NAME-py, NAME-ny, NAME-pz, NAME-nz, as seen from within; those of z and y lie "
          "towards +z, -z, +y, -y, NAME-px lies towards -x and NAME-nx towards +x"}},
        {{"background", {"color", "gradient", "image", "cubemap"}, true}}};
    return format;
}

const ObjectFormat& pointLightFormat() {
    static const ObjectFormat format{"Light from one point",
                                     {{"position", Vector, kCoordinate, "Where the light is", true}}};
    return format;
}

const ObjectFormat& sphereLightFormat() {
    static const ObjectFormat format{
        "Light from a sphere that is not seen itself",
        {{"center", Vector, kCoordinate, "Its centre", true},
         {"radius", Number, kLength, "Its radius: the larger, the softer shadows are", true}}};
    return format;
}

const ObjectFormat& directionalLightFormat() {
    static const ObjectFormat format{
        "Parallel light from far away",
        {{"direction", Direction, kCoordinate, "In which it shines: from the light to the scene", true}}};
    return format;
}

const ObjectFormat& spotLightFormat() {
    static const ObjectFormat format{
        "Light from one point that is kept within a cone",
        {{"position", Vector, kCoordinate, "Where the light is", true},
         {"direction", Direction, kCoordinate, "Along the cone's axis, away from the light", true},
         {"angle", Number, kSpotAngle, "From the axis to where the light ends, in degrees; default 30"},
         {"softness", Number, kPart, "The part of the angle over which the light fades to its end; default 0"}}};
    return format;
}

const ObjectFormat& lightFormat() {
    static const ObjectFormat format{
        "A light",
        {{"point", Object, kAny, "Light from one point", false, &pointLightFormat()},
         {"sphere", Object, kAny, "Light from a sphere", false, &sphereLightFormat()},
         {"directional", Object, kAny, "Light from far away", false, &directionalLightFormat()},
         {"spot", Object, kAny, "A cone of light", false, &spotLightFormat()},
         {"color", Color, kColor, "Colour and strength; default [1, 1, 1]"},
         {"falloff", Number, kLength,
          "Distance at which the light is as strong as its colour says; it falls with the square of the distance. "
          "Default: equally strong at every distance"}},
        {{"light kind", {"point", "sphere", "directional", "spot"}, true}},
        {},
        {{"falloff",
          {"directional"},
          "a directional light is at no distance from which it could fall off",
          "remove \"falloff\""}}};
    return format;
}

const ObjectFormat& textureFormat() {
    static const ObjectFormat format{
        "How an image lies on a surface: texel coordinate = uv * scale + scroll * time, repeated",
        {{"image", Image, kImageName,
          "Name of a PNG or JPEG beside the scene or in the texture folder, with or without extension", true},
         {"scale", Scale, kTexelScale, "Repetitions over the surface's uv; default 1"},
         {"scroll", Pair, kTexelScale, "Motion of the texel coordinate per second; default [0, 0]"}}};
    return format;
}

const ObjectFormat& conductorFormat() {
    static const ObjectFormat format{
        "A metal by its complex refractive index n + ik: reflects, never refracts",
        {{"n", Color, kComplexIndex, "Real part, one number or one for each of red, green, blue", true},
         {"k", Color, kComplexIndex, "Imaginary part", true}}};
    return format;
}

const ObjectFormat& dielectricFormat() {
    static const ObjectFormat format{
        "A clear body: reflects and refracts",
        {{"ior", Number, kBodyIor, "Refractive index, absolute: air has 1, inside of other bodies too", true},
         {"absorption", Color, kAbsorption, "Of the light exp(-absorption * length) is left; default 0"},
         {"priority", Number, kPriority,
          "Where bodies overlap the one of highest priority counts, of equals the smaller; default 0"}}};
    return format;
}

const ObjectFormat& coatFormat() {
    static const ObjectFormat format{
        "A clear layer over the surface's own colour: reflects, does not refract",
        {{"ior", Number, kIor, "Refractive index", true},
         {"mask", Image, kImageName, "Image whose red channel scales the reflection; default: everywhere"}}};
    return format;
}

const ObjectFormat& checkerFormat() {
    static const ObjectFormat format{
        "Two colours in turn, in squares of the surface's texture coordinates",
        {{"colors", Colors, kColor, "Of the square from uv = 0 on, and of those beside it", true},
         {"scale", Scale, kTexelScale, "Squares over one unit of the surface's uv; default 1"}}};
    return format;
}

const ObjectFormat& materialFormat() {
    static const ObjectFormat format{
        "A material; what is not given is 0",
        {{"ambient", Color, kColor, "Reflected of light from everywhere"},
         {"diffuse", Color, kColor, "Reflected evenly of each light"},
         {"specular", Color, kColor, "Strength of the highlight of each light"},
         {"emission", Color, kColor, "Given off by the surface itself"},
         {"shininess", Number, kShininess, "Exponent of the highlight; default 1"},
         {"conductor", Object, kAny, "Mirror of a metal", false, &conductorFormat()},
         {"dielectric", Object, kAny, "Clear as glass", false, &dielectricFormat()},
         {"coat", Object, kAny, "Clear layer, as varnish or water", false, &coatFormat()},
         {"mirror", Color, kReflectance, "Fraction that it reflects at every angle"},
         {"checker", Object, kAny, "Squares that multiply ambient, diffuse and emission", false, &checkerFormat()},
         {"texture", ImageOrObject, kAny, "Image that multiplies ambient, diffuse and emission", false,
          &textureFormat()},
         {"normal_map", ImageOrObject, kAny, "Tangent space normals, green towards +v", false, &textureFormat()}},
        {{"optics", {"conductor", "dielectric", "coat", "mirror"}, false}}};
    return format;
}

const ObjectFormat& orbitFormat() {
    static const ObjectFormat format{
        "Moves a shape by cos * cos(rate t) + sin * sin(rate t) from where it rests",
        {{"cos", Vector, kCoordinate, "Default [0, 0, 0]"},
         {"sin", Vector, kCoordinate, "Default [0, 0, 0]"},
         {"rate", Number, kRate, "Radians per second; default 1"},
         {"around", Text, kName, "Name of the object that the shape's resting place is relative to"}}};
    return format;
}

const ObjectFormat& motionFormat() {
    static const ObjectFormat format{"How an object moves",
                                     {{"orbit", Object, kAny, "Along an ellipse", true, &orbitFormat()}}};
    return format;
}

const ObjectFormat& glowFormat() {
    static const ObjectFormat format{"Light around a sphere, seen along a line that passes its centre at d: color * "
                                     "clamp(strength / (softness + d^2))",
                                     {{"color", Color, kColor, "Default [1, 1, 1]"},
                                      {"strength", Number, kGlow, "Default 2"},
                                      {"softness", Number, kGlow, "Default 0.5"}}};
    return format;
}

ValueType valueType(FieldType type) {
    switch (type) {
    case FieldType::Point: return Vector;
    case FieldType::Direction: return Direction;
    case FieldType::Length:
    case FieldType::Scalar: return Number;
    case FieldType::Lengths:
    case FieldType::Rotation: return Vector;
    case FieldType::Vertices: return Vertices;
    }
    return Ignored;
}

const ObjectFormat& shapeFormat(const ShapeRow& row) {
    static const std::vector<ObjectFormat> formats = [] {
        std::vector<ObjectFormat> all;
        for (const ShapeRow& shape : shapeTable()) {
            ObjectFormat& format = all.emplace_back();
            for (const ShapeField& field : writtenRow(shape).fields) {
                const bool required = field.type != FieldType::Rotation;
                format.fields.push_back({field.key, valueType(field.type), limitsOf(field), field.help, required});
            }
        }
        return all;
    }();
    return formats[std::size_t(row.kind)];
}

const ObjectFormat& partFormat();

const ObjectFormat& offsetFormat() {
    static const ObjectFormat format{"A solid grown or shrunk all around",
                                     {{"of", Object, kAny, "What is grown", true, &partFormat()},
                                      {"by", Number, kOffset, "Outwards; negative: inwards", true}}};
    return format;
}

const ObjectFormat& transformFormat() {
    static const ObjectFormat format{
        "A solid scaled, turned and moved, in this order",
        {{"of", Object, kAny, "What is moved", true, &partFormat()},
         {"scale", Scales, kScale, "Factor of all lengths, or [x, y, z]; default 1"},
         {"rotate", Vector, kDegrees, "Degrees about x, then y, then z; default [0, 0, 0]"},
         {"translate", Vector, kCoordinate, "Default [0, 0, 0]"}}};
    return format;
}

const ObjectFormat& repetitionFormat() {
    static const ObjectFormat format{
        "Copies of a solid in rows; where one reaches over others, at most 64 may meet",
        {{"of", Object, kAny, "What is repeated; it is the first copy", true, &partFormat()},
         {"period", Vector, kPeriod, "From copy to copy along x, y and z", true},
         {"count", Vector, kCopies, "Copies along x, y and z", true}}};
    return format;
}

/// The shapes and what can be made of them, as keys of which one is given.
void addShapes(ObjectFormat& object) {
    Alternatives shapes{"shape", {}, true};
    const auto add = [&](const FieldFormat& field) {
        object.fields.push_back(field);
        shapes.keys.push_back(field.key);
    };
    for (const ShapeRow& row : shapeTable()) add({row.key, Object, kAny, "The shape", false, &shapeFormat(row)});
    add({"union", List, kParts, "All of these", false, &partFormat()});
    add({"intersection", List, kParts, "What these have in common", false, &partFormat()});
    add({"difference", List, kParts, "The first without the others", false, &partFormat()});
    add({"smooth_union", List, kParts, "All of these, melted together where they meet", false, &partFormat()});
    add({"offset", Object, kAny, "A solid grown or shrunk", false, &offsetFormat()});
    add({"transform", Object, kAny, "A solid moved", false, &transformFormat()});
    add({"repetition", Object, kAny, "Copies of a solid", false, &repetitionFormat()});
    object.alternatives.push_back(shapes);
    object.fields.push_back({"blend", Number, kLength, "How far from a seam smooth_union still bends; default 0.25"});
}

/// A shape within a solid. It refers to itself, so the schema needs its name.
const ObjectFormat& partFormat() {
    static ObjectFormat format{"A shape or a solid", {}, {}, "part"};
    static bool complete = false;
    if (!complete) {
        complete = true;
        addShapes(format);
    }
    return format;
}

const ObjectFormat& objectFormat();

/// Where a group or an instance stands: the same three keys in both.
void addPlacement(ObjectFormat& format) {
    for (const FieldFormat& field : {
             FieldFormat{"scale", Scales, kScale, "Factor of all lengths, or [x, y, z]; default 1"},
             FieldFormat{"rotate", Vector, kDegrees, "Degrees about x, then y, then z; default [0, 0, 0]"},
             FieldFormat{"translate", Vector, kCoordinate, "Default [0, 0, 0]"},
         })
        format.fields.push_back(field);
}

const ObjectFormat& groupFormat() {
    static const ObjectFormat format = [] {
        ObjectFormat group{"Objects scaled, rotated and moved together, in this order",
                           {{"of", List, kObjects, "The objects, which may be groups", true, &objectFormat()}}};
        addPlacement(group);
        return group;
    }();
    return format;
}

const ObjectFormat& instanceFormat() {
    static const ObjectFormat format = [] {
        ObjectFormat instance{"What stands under a name in \"definitions\", scaled, rotated and moved, in this order",
                              {{"of", Text, kName, "The name", true}}};
        addPlacement(instance);
        return instance;
    }();
    return format;
}

const ObjectFormat& meshFormat() {
    static const ObjectFormat format{
        "The triangles of a Wavefront OBJ file",
        {{"file", File, kFile, "The file, beside the scene or in a folder beside it", true},
         {"smooth", Boolean, kAny, "Normals from the file, or from the faces about each vertex; default true"}}};
    return format;
}

const ObjectFormat& patchFormat() {
    static const ObjectFormat format{
        "A bicubic Bézier surface, over a rectangle or in space. Over one, at (u, v), x = center.x + (u - 1/2) size.x, "
        "y = center.y + height size.y, z = center.z + (v - 1/2) size.z",
        {{"heights", Numbers, kCoordinate, "Of its net of 4 x 4 control points, row by row along u"},
         {"random", Number, kSeed, "A seed: random heights, each of which moves the surface by at most 1"},
         {"points", Points, kCoordinate, "Its 4 x 4 control points in space, row by row along u, all with weights or none"},
         {"center", Vector, kCoordinate, "Where the middle of the rectangle lies at height 0; default [0, 0, 0]"},
         {"size", Scales, kLength, "Factors of all lengths, or [x, y, z]; default 1"}},
        {{"net", {"heights", "random", "points"}, true}},
        {},
        {{"points", {"center", "size"}, "points lie where they say", "move the patch by a group, or remove this"}}};
    return format;
}

const ObjectFormat& surfaceFormat() {
    static const ObjectFormat format{
        "The bicubic Bézier patches of a BPT file",
        {{"file", File, kFile, "The file, beside the scene or in a folder beside it", true}}};
    return format;
}

/// An object refers to itself within groups, so the schema needs its name.
const ObjectFormat& objectFormat() {
    static ObjectFormat format{"One shape, solid, surface, group, instance or mesh, with its material", {}, {}, "object"};
    static bool complete = false;
    if (complete) return format;
    complete = true;
    addShapes(format);
    for (const FieldFormat& field : {
             FieldFormat{"group", Object, kAny, "Objects moved together", false, &groupFormat()},
             FieldFormat{"instance", Object, kAny, "What \"definitions\" has under a name", false, &instanceFormat()},
             FieldFormat{"mesh", Object, kAny, "Triangles from a file", false, &meshFormat()},
             FieldFormat{"patch", Object, kAny, "A bicubic Bézier surface", false, &patchFormat()},
             FieldFormat{"surface", Object, kAny, "Such surfaces from a file", false, &surfaceFormat()},
         }) {
        format.fields.push_back(field);
        format.alternatives.front().keys.push_back(field.key);
    }
    for (const FieldFormat& field : {
             FieldFormat{"name", Text, kName, "For messages and for other objects to move around; unique"},
             FieldFormat{"material", Text, kName,
                         "Name of a material of this file; default: that of the group around it, else a plain grey"},
             FieldFormat{"casts_shadow", Boolean, kAny, "Whether it stands in the way of light; default true"},
             FieldFormat{"motion", Object, kAny, "Default: at rest, or as the group around it", false, &motionFormat()},
             FieldFormat{"glow", Object, kAny, "Spheres only; default: none", false, &glowFormat()},
         })
        format.fields.push_back(field);
    format.exclusions = {
        {"name",
         {"group", "instance", "mesh", "surface"},
         "only a single object has a name",
         "remove it, or name an object inside"},
        {"glow", format.alternatives.front().keys, "only spheres can glow", "remove \"glow\" or use a sphere"}};
    std::erase(format.exclusions.back().others, "sphere");
    return format;
}

} // namespace

Range limitsOf(const ShapeField& field) {
    switch (field.type) {
    case FieldType::Length:
    case FieldType::Lengths: return kLength;
    case FieldType::Scalar: return field.scalar;
    case FieldType::Rotation: return kDegrees;
    default: return kCoordinate;
    }
}

const FieldFormat* ObjectFormat::find(std::string_view key) const {
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const FieldFormat& f) { return f.key == key; });
    return field == fields.end() ? nullptr : &*field;
}

// clang-format off
const ObjectFormat& sceneFormat() {
    static const ObjectFormat format{
        "A scene: y up, right-handed",
        {{"$schema", Ignored, kAny, "For editors; ignored"},
         {"title", Text, kTitle, "One line for lists and captions"},
         {"description", Text, kDescription, "What there is to see"},
         {"encoding", Choice, kAny,
          "linear: colours are linear light and the picture is sRGB-encoded; display: colours are display values as "
          "they are; default linear",
          false, nullptr, {"linear", "display"}},
         {"fresnel", Choice, kAny,
          "exact: materials reflect by the Fresnel equations; schlick: by Schlick's approximation; default exact",
          false, nullptr, {"exact", "schlick"}},
         {"depth_limit", Choice, kAny,
          "What dielectrics do with rays of the largest depth: straight lets them go on unbent, dark ends them; "
          "default straight",
          false, nullptr, {"straight", "dark"}},
         {"camera", Object, kAny, "Where the picture is taken from", false, &cameraFormat()},
         {"background", Object, kAny, "What rays see that hit nothing; default black", false, &backgroundFormat()},
         {"lights", List, kLights, "Lights; default none", false, &lightFormat()},
         {"materials", Map, kMaterials, "Materials by name", false, &materialFormat()},
         {"definitions", Map, kDefinitions, "Objects by name, drawn where an instance places them", false,
          &objectFormat()},
         {"objects", List, kObjects, "What is drawn", true, &objectFormat()}}};
    return format;
}
// clang-format on

} // namespace gnomon
