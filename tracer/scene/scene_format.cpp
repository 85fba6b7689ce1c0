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
constexpr Range kShininess{1, 10000};
constexpr Range kIor{1, 4};
constexpr Range kComplexIndex{0, 20};
constexpr Range kFov{0.001, 170};
constexpr Range kRate{-1000, 1000};
constexpr Range kTexelScale{-1000, 1000};
constexpr Range kGlow{1e-6, 1000};
constexpr Range kTitle{0, 200};
constexpr Range kDescription{0, 4000};
constexpr Range kObjects{1, 20000};
constexpr Range kParts{1, 64};
constexpr Range kOffset{-1e6, 1e6};
constexpr Range kDegrees{-360, 360};
constexpr Range kScale{1e-3, 1e3};
constexpr Range kPeriod{0, 1e6};
constexpr Range kCopies{1, 1000, true};
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
    static const ObjectFormat format{"Light from one point, equally strong at every distance",
                                     {{"position", Vector, kCoordinate, "Where the light is", true}}};
    return format;
}

const ObjectFormat& sphereLightFormat() {
    static const ObjectFormat format{
        "Light from a sphere that is not seen itself, equally strong at every distance",
        {{"center", Vector, kCoordinate, "Its centre", true},
         {"radius", Number, kLength, "Its radius: the larger, the softer shadows are", true}}};
    return format;
}

const ObjectFormat& lightFormat() {
    static const ObjectFormat format{"A light",
                                     {{"point", Object, kAny, "Light from one point", false, &pointLightFormat()},
                                      {"sphere", Object, kAny, "Light from a sphere", false, &sphereLightFormat()},
                                      {"color", Color, kColor, "Colour and strength; default [1, 1, 1]"}},
                                     {{"light kind", {"point", "sphere"}, true}}};
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
    static const ObjectFormat format{"A clear body: reflects and refracts",
                                     {{"ior", Number, kIor, "Refractive index", true}}};
    return format;
}

const ObjectFormat& coatFormat() {
    static const ObjectFormat format{
        "A clear layer over the surface's own colour: reflects, does not refract",
        {{"ior", Number, kIor, "Refractive index", true},
         {"mask", Image, kImageName, "Image whose red channel scales the reflection; default: everywhere"}}};
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
         {"texture", ImageOrObject, kAny, "Image that multiplies ambient, diffuse and emission", false,
          &textureFormat()},
         {"normal_map", ImageOrObject, kAny, "Tangent space normals, green towards +v", false, &textureFormat()}},
        {{"optics", {"conductor", "dielectric", "coat"}, false}}};
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
    case FieldType::Lengths: return Vector;
    case FieldType::Vertices: return Vertices;
    }
    return Ignored;
}

const ObjectFormat& shapeFormat(const ShapeRow& row) {
    static const std::vector<ObjectFormat> formats = [] {
        std::vector<ObjectFormat> all;
        for (const ShapeRow& shape : shapeTable()) {
            ObjectFormat& format = all.emplace_back();
            for (const ShapeField& field : shape.fields) {
                const bool length = field.type == FieldType::Length || field.type == FieldType::Lengths;
                const Range range = length ? kLength : field.type == FieldType::Scalar ? field.scalar : kCoordinate;
                format.fields.push_back({field.key, valueType(field.type), range, field.help, true});
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
         {"scale", Number, kScale, "Factor of all lengths; default 1"},
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

const ObjectFormat& objectFormat() {
    static const ObjectFormat format = [] {
        ObjectFormat object{"One shape or solid with its material", {}};
        addShapes(object);
        for (const FieldFormat& field : {
                 FieldFormat{"name", Text, kName, "For messages and for other objects to move around; unique"},
                 FieldFormat{"material", Text, kName, "Name of a material of this file; default: a plain grey"},
                 FieldFormat{"casts_shadow", Boolean, kAny, "Whether it stands in the way of light; default true"},
                 FieldFormat{"motion", Object, kAny, "Default: at rest", false, &motionFormat()},
                 FieldFormat{"glow", Object, kAny, "Spheres only; default: none", false, &glowFormat()},
             })
            object.fields.push_back(field);
        return object;
    }();
    return format;
}

} // namespace

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
         {"camera", Object, kAny, "Where the picture is taken from", false, &cameraFormat()},
         {"background", Object, kAny, "What rays see that hit nothing; default black", false, &backgroundFormat()},
         {"lights", List, kLights, "Lights; default none", false, &lightFormat()},
         {"materials", Map, kMaterials, "Materials by name", false, &materialFormat()},
         {"objects", List, kObjects, "What is drawn", true, &objectFormat()}}};
    return format;
}
// clang-format on

} // namespace gnomon
