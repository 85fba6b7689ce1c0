#include "tracer/shader/shader_names.h"

#include "tracer/plan/shape_texels.h"
#include "tracer/shader/solid_source.h"

#include <algorithm>
#include <cctype>

namespace gnomon {

std::string mapped(std::string_view text, int (*change)(int)) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto isUpper = [&](std::size_t at) { return std::isupper(static_cast<unsigned char>(text[at])) != 0; };
        if (i > 0 && isUpper(i) && !isUpper(i - 1) && text[i - 1] != '_') out += '_';
        out += char(change(static_cast<unsigned char>(text[i])));
    }
    return out;
}

namespace {

/// How rays find the objects of a kind.
void addSearch(const KindCount& kind, Names& names) {
    const std::string type = mapped(kind.type(), std::toupper);
    const bool block = kind.latticeMembers() > 0, searched = block || kind.search != Search::Loop;
    names.values[type + "_SEARCH"] = int(kind.search);
    names.values[type + "_SEARCHED"] = searched;
    names.values[type + "_ALONE"] = kind.count == 1;
    names.values[type + "_LATTICE"] = block;
    names.values["SEARCHES"] |= int(searched);
    names.values["LATTICES"] |= int(block);
    names.values["UNIFORM_GRIDS"] |= int(kind.search == Search::Grid);
    names.values["HIERARCHIES"] |= int(kind.search == Search::Hierarchy);
    constexpr int kPart = 4; // balls that GPUs may hold at once
    names.lists[type + "_SPHERE_MASK"];
    for (int i = 0; i < kind.loose() && kind.search == Search::SphereMask; ++i) {
        const std::string part = std::to_string(i / kPart);
        if (i % kPart == 0) names.lists[type + "_SPHERE_MASK"].push_back(part);
        names.lists[type + "_SPHERE_MASK_" + part].push_back(std::to_string(i));
    }
}

/// What is known of a kind's shape, and what its casters ask of the shadow models.
void addShape(const KindCount& kind, Names& names) {
    const std::string type = mapped(kind.type(), std::toupper);
    const bool estimates = kind.solid && estimated(*kind.solid);
    names.values[type + "_IMAGES"] = kind.images;
    names.values[type + "_CONVEX"] = shapeRow(kind.kind).convex;
    names.values[type + "_BOUNDED"] = shapeRow(kind.kind).extent != nullptr;
    names.values[type + "_SOLID"] = kind.solid != nullptr;
    names.values[type + "_ESTIMATED"] = estimates;
    // Silhouettes have no cover of its outline.
    const bool rayCover = estimates || kind.kind == ShapeKind::HeightPatch || kind.kind == ShapeKind::SpacePatch;
    names.values[type + "_RAY_COVER"] = rayCover;
    names.values["RAY_COVERED_CASTERS"] |= int(kind.casters > 0 && rayCover);
    names.values["MARCHED_CASTERS"] |= int(kind.casters > 0 && kind.solid && !estimates);
}

/// How distances find the object of a kind that is nearest to a point. Boxes leave out nothing where a shape's distance
/// is exact: an estimate may be less than that of the box about it.
void addNearest(const KindCount& kind, Names& names) {
    const std::string type = mapped(kind.type(), std::toupper);
    const bool lattice = kind.latticeMembers() > 0, spheres = lattice && kind.kind == ShapeKind::Sphere;
    const bool exact = !kind.solid && kind.kind != ShapeKind::Mandelbulb;
    const bool nearby = kind.search == Search::Hierarchy && exact && (spheres || !lattice);
    names.values[type + "_SPHERE_LATTICE"] = spheres;
    names.values[type + "_NEARBY"] = nearby;
    names.values["SPHERE_LATTICES"] |= int(spheres && kind.casters > 0);
    names.values["NEARBY"] |= int(nearby && kind.casters > 0);
}

} // namespace

Names namesOf(const Plan& plan) {
    const SceneFeatures& f = plan.scene;
    Names names;
    names.values = {
        {"REFLECTION", f.reflection},
        {"REFRACTION", f.refraction},
        {"COATS", f.coats},
        {"MIRRORS", f.mirrors},
        {"EXACT_FRESNEL", f.exactFresnel},
        {"METALS", f.metals()},
        {"MEDIA", f.refraction && f.media > 0},
        {"ABSORPTION", f.refraction && f.absorption},
        {"PASSES_ON", f.refraction && f.passesOn},
        {"PAINTS", f.paints},
        {"NORMAL_MAPS", f.normalMaps},
        {"IMAGES", f.paints + f.normalMaps + f.checkers},
        {"CHECKERS", f.checkers},
        {"DIRECTIONAL", f.directional},
        {"LIGHT_PROFILES", f.lightProfiles},
        {"CUBEMAP", f.cubemap},
        {"PANORAMA", f.panorama},
        {"GRADIENT", f.gradient},
        {"LINEAR", f.linear},
        {"LIGHTS", f.lights},
        {"GLOWS", f.glows},
        {"DATA_BLOCK", f.dataBlock},
        {"ITERATIONS_COUNTED", plan.target.iterationsCounted},
        {"PRELOADS", plan.target.preloads},
        {"FALLBACK", plan.split.fallback},
        {"TILES", plan.split.tile > 0},
        {"FLOAT_TARGETS", plan.target.floatTargets},
        {"COVERAGE_MASK", plan.split.coverageMask},
        {"SHADOWS", f.shadows != ShadowModel::Off},
        {"SHADOW_RAYS", shadowRow(f.shadows).rays},
        {"SHADOWS_IN_TREE", f.shadows == ShadowModel::Hard},
        {"DISTANCES", f.distances},
        {"COVERS", f.shadows == ShadowModel::Silhouette},
        {"FROM_LIGHT", f.fromLight},
        {"MARCH", int(f.march)},
        {"MARCH_STEPS", int(March::Steps)},
        {"MARCH_SPHERE", int(March::Sphere)},
        {"MARCH_CONE", int(March::Cone)},
        {"MARCH_RELAXED", int(March::Relaxed)},
        {"FIELDS", f.fields},
        {"FILTERED_FIELDS", plan.target.floatFilter},
        {"SURFACE_IN_FIELD", f.surfaceInField},
        {"FIELD_MARCH", int(f.fieldMarch)},
        {"FIELD_MARCH_VOXEL", int(FieldMarch::Voxel)},
        {"FIELD_MARCH_RELAXED", int(FieldMarch::Relaxed)},
        {"OUTPUT", int(f.output)},
        {"COLOR", int(Aov::Color)},
        {"DISTANCE", int(Aov::Distance)},
        {"POSITION", int(Aov::Position)},
        {"NORMAL", int(Aov::Normal)},
        {"OBJECT", int(Aov::Object)},
        {"VISIBILITY", int(Aov::Visibility)},
        {"WORK", int(Aov::Work)},
        {"STEPS", int(Aov::Steps)},
        {"HIERARCHY", int(Search::Hierarchy)},
        {"GRID", int(Search::Grid)},
    };
    const auto has = [&](ShapeKind kind) {
        return std::any_of(f.shapes.begin(), f.shapes.end(), [&](const KindCount& k) { return k.kind == kind; });
    };
    names.values["TRIANGLES"] = has(ShapeKind::Triangle);
    names.values["SMOOTH"] = has(ShapeKind::SmoothTriangle);
    // Of any kind: none in a program that is left with no kind to ask.
    for (const char* name : {"SEARCHES", "LATTICES", "UNIFORM_GRIDS", "HIERARCHIES", "RAY_COVERED_CASTERS",
                             "MARCHED_CASTERS", "SPHERE_LATTICES", "NEARBY"})
        names.values[name] = 0;
    // Solids have shapes for parts that the scene has no object of.
    for (int i = 0; i < kShapeKinds; ++i) names.values[mapped(glslTypeOf(ShapeKind(i)), std::toupper) + "_IMAGES"] = 0;
    auto& shapes = names.lists["SHAPES"];
    auto& casters = names.lists["CASTERS"];
    auto& uncommon = names.lists["UNCOMMON"];
    for (std::size_t k = 0; k < f.shapes.size(); ++k) {
        const KindCount& kind = f.shapes[k];
        if (plan.split.fallback && plan.split.kind(k).shape) {
            uncommon.push_back(kind.type());
            continue;
        }
        shapes.push_back(kind.type());
        if (kind.casters > 0) casters.push_back(kind.type());
        addShape(kind, names);
        addSearch(kind, names);
        addNearest(kind, names);
    }
    names.values["BOX_IMAGES"] |= names.values["ROTATED_BOX_IMAGES"]; // whose surface is that of a box
    std::string model(shadowRow(f.shadows).key);
    std::replace(model.begin(), model.end(), '-', '_');
    names.lists["SHADOW_MODEL"] = {model};
    const auto count = [&](const char* list, int end) {
        auto& numbers = names.lists[list];
        for (int i = 0; i < end; ++i) numbers.push_back(std::to_string(i));
    };
    count("PAINT_LAYERS", f.paints);
    count("NORMAL_LAYERS", f.normalMaps);
    count("LIGHT_NUMBERS", f.lights);
    return names;
}

} // namespace gnomon
