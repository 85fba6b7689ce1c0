/// The format of scene files as tables: which keys an object of the file may have, of what type, within which limits.
///
/// The reader checks files against these tables and the schema is written from them, so that the two cannot disagree.
#pragma once

#include "tracer/scene/shapes.h"

#include <string_view>
#include <vector>

namespace gnomon {

enum class ValueType {
    Boolean,
    Number,    ///< within `range`
    Scale,     ///< one number or [u, v], each within `range`
    Pair,      ///< [u, v]
    Vector,    ///< [x, y, z]
    Direction, ///< [x, y, z], not all zero
    Color,     ///< one number or [r, g, b]
    Colors,    ///< two of these
    Vertices,  ///< three [x, y, z]
    Numbers,   ///< sixteen
    Points,    ///< sixteen [x, y, z], or all with a weight
    Text,      ///< `range` characters
    Image,     ///< an image's name: a file in the scene's folder or below; `range` characters
    Panorama,  ///< the same, which may hold light beyond white
    File,      ///< a path from the scene's own folder downwards; `range` characters
    Scales,    ///< one number or [x, y, z], each within `range`
    Choice,    ///< one of `choices`
    Object,    ///< of `format`
    ImageOrObject,
    List, ///< `range` objects of `format`
    Map,  ///< `range` objects of `format`, under names of kName characters
    Ignored,
};

/// Of a control point.
inline constexpr Range kWeight{1e-3, 1e3};

struct ObjectFormat;

struct FieldFormat {
    std::string_view key;
    ValueType type;
    Range range;
    std::string_view help;
    bool required = false;
    const ObjectFormat* format = nullptr;
    std::vector<std::string_view> choices{};
};

/// Keys of which an object must have exactly one, or may have at most one.
struct Alternatives {
    std::string_view what; ///< "shape": what each of the keys is
    std::vector<std::string_view> keys;
    bool required;
};

/// A key that may stand beside none of some others, and what is told where it does.
struct Exclusion {
    std::string_view key;
    std::vector<std::string_view> others;
    std::string_view what, remedy;
};

struct ObjectFormat {
    std::string_view help;
    std::vector<FieldFormat> fields;
    std::vector<Alternatives> alternatives{};
    std::string_view name{}; ///< of a format that holds itself: the schema refers to it
    std::vector<Exclusion> exclusions{};

    const FieldFormat* find(std::string_view key) const;
};

inline constexpr Range kName{1, 64};       ///< characters of a name
inline constexpr Range kImageName{1, 200}; ///< and of an image's

/// Objects in all: of a scene after groups and instances are taken apart and meshes are read.
inline constexpr int kMostObjects = 80000;

/// What the values of a shape's field may be.
Range limitsOf(const ShapeField&);

/// The whole file.
const ObjectFormat& sceneFormat();

} // namespace gnomon
