/// What of the shader library a scene needs, and nothing about how large its values are.
#pragma once

#include "tracer/accel/uniform_grid.h"
#include "tracer/scene/scene.h"
#include "tracer/settings/settings.h"

#include <memory>
#include <string>
#include <vector>

namespace gnomon {

/// How rays find those objects of a kind that they may meet.
enum class Search {
    Loop,       ///< all are asked
    SphereMask, ///< the bounding spheres of all, then the objects whose spheres the ray does not pass by
    Hierarchy,  ///< of boxes
    Grid        ///< the lists of a uniform grid's cells
};

/// Objects of one kind, in the order that layoutOf() gives them: the first `casters` of them cast shadows.
struct KindCount {
    ShapeKind kind = ShapeKind::Sphere;
    int count = 0, casters = 0;
    glm::ivec3 lattice{0};        ///< that the first objects make and rays walk through; else 0
    Search search = Search::Loop; ///< for the others
    GridPlan grid{};              ///< where that is the search
    bool images = false;          ///< on some of them: their surfaces tell where on an image a point lies
    int form = 0;                 ///< of solids: one value for each form
    std::shared_ptr<const Solid> solid{};

    int latticeMembers() const { return lattice.x * lattice.y * lattice.z; }
    int loose() const { return count - latticeMembers(); }
    /// In GLSL: Sphere, …, Solid0, Solid1, …
    std::string type() const;
    int texels() const; ///< of the geometry of one object

    /// The same source reads both: solids of one form differ in their values only.
    bool operator==(const KindCount&) const;
};

/// Facts of the scene and the choices of the settings that become source.
struct SceneFeatures {
    std::vector<KindCount> shapes; ///< kinds drawn, in the order of PreparedScene::layout
    int materials = 0, lights = 0, glows = 0;
    int paints = 0, normalMaps = 0; ///< layers of images, none where no material in use shows one
    bool reflection = false, refraction = false, coats = false, conductors = false, mirrors = false;
    bool exactFresnel = false;  ///< where materials reflect by indices
    int media = 0;              ///< bodies that rays track what they are inside of; 0 where none may overlap
    bool absorption = false;    ///< by one of them
    bool passesOn = false;      ///< dielectrics let rays of the largest depth go straight on; what is cut is counted
    bool checkers = false;      ///< on materials in use
    bool directional = false;   ///< lights without end
    bool lightProfiles = false; ///< lights that are not equally strong in every direction and at every distance
    bool cubemap = false, panorama = false, gradient = false; ///< at most one: else the background has one colour
    bool linear = false;
    ShadowModel shadows = ShadowModel::Off;
    March march = March::Cone;
    bool fromLight = false; ///< shadow cones are marched from the light
    bool distances = false; ///< of shapes are asked for
    bool fields = false;    ///< of parametric surfaces are baked
    bool surfaceInField = false; ///< rays find them there
    FieldMarch fieldMarch = FieldMarch::Sphere;
    Aov output = Aov::Color;
    bool dataBlock = false; ///< scene data in a uniform block, else in a texture

    int objects() const;
    /// Conductors are told by their complex indices, not by what they reflect at normal incidence.
    bool metals() const { return exactFresnel && conductors; }
    bool operator==(const SceneFeatures&) const = default;
};

/// Materials in use reflect or refract.
inline bool reflects(const SceneFeatures& f) { return f.conductors || f.refraction || f.coats || f.mirrors; }

} // namespace gnomon
