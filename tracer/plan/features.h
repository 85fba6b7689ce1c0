/// Which parts of the shader library a scene needs, and nothing about how large its numbers are.
#pragma once

#include "tracer/accel/uniform_grid.h"
#include "tracer/settings/settings.h"
#include "tracer/scene/scene.h"

#include <array>
#include <string>
#include <vector>

namespace gnomon {

/// How rays find those objects of a kind that they may meet.
enum class Search {
    Loop,      ///< all are asked
    SphereMask, ///< the balls of all, then the objects whose balls the ray does not pass by
    Hierarchy, ///< boxes
    Grid       ///< the lists of a grid's cells
};

/// Objects of one kind, numbered as layoutOf() says: the first `casters` of them cast shadows.
struct KindCount {
    ShapeKind kind = ShapeKind::Sphere;
    int count = 0, casters = 0;
    glm::ivec3 lattice{0};          ///< cells of the block that the first objects make and rays walk through; else 0
    Search search = Search::Loop; ///< for the others
    GridPlan grid{};             ///< where that is the search
    bool images = false;          ///< on some of them: their surfaces tell where on an image a point lies
    bool uncommon = false;            ///< few pixels meet one, and asking it is expensive: the usual program has only its ball
    bool imagesUncommon = false;      ///< few pixels meet one that shows an image: the usual program has none of them
    int form = 0;                 ///< of solids: a number for each form
    std::shared_ptr<const Solid> solid{};

    int latticeMembers() const { return lattice.x * lattice.y * lattice.z; }
    int loose() const { return count - latticeMembers(); }
    /// In GLSL: Sphere, …, Solid0, Solid1, …
    std::string type() const;
    int texels() const; ///< of the geometry of one object
};

struct Features {
    std::vector<KindCount> shapes; ///< kinds drawn, in the order of ShapeKind
    int materials = 0, lights = 0, glows = 0;
    int paints = 0, normalMaps = 0; ///< layers of images, none where no material in use shows one
    bool reflection = false, refraction = false, coats = false, conductors = false;
    bool cubemap = false, linear = false;
    ShadowModel shadows = ShadowModel::Off;
    March march = March::Cone;
    bool fromLight = false; ///< shadow cones are marched from the light
    bool distances = false; ///< of shapes are asked for
    Aov output = Aov::Color;
    bool dataBlock = false;                              ///< numbers in a uniform block, else in a texture
    bool parted = false;                                 ///< smaller programs draw what they can: tracer/software/uncommon_features.h
    bool refractionUncommon = false, normalMapsUncommon = false; ///< few pixels meet them: the usual program does without
    bool fallsBack = false; ///< the usual program itself, which leaves pixels to the whole one
    int tile = 0; ///< side in pixels of the squares in which the whole one draws them; 0: where no depth is written
    bool iterationsCounted = false; ///< by the loop of shadow rays, which ends by itself: shaders/integrator/shadow_rays.glsl
    bool preloads = false;    ///< numbers at fixed places are read before all loops: shaders/software/preloads.glsl
    bool cachedLoads = false;         ///< they are held in variables instead: shaders/software/cached_loads.glsl
    bool es300 = true;         ///< prelude `#version 300 es`, else `330 core`
    bool floatTargets = true;  ///< the linear picture is of floats, else of their bits: shaders/pass/linear_picture.glsl
    bool coverageMask = false; ///< what is drawn is marked in a mask of its own: tracer/software/coverage.h

    int objects() const;
};

/// The GL that a shader is written for.
struct GlslTarget {
    int blockTexels = 1024; ///< vec4 that a uniform block holds: 16 KiB, as every GL does
    bool es300 = true;
    bool processor = false;   ///< the processor draws: indexing a block costs it more than a fetch from a texture
    bool swiftShader = false; ///< it does: draws a pixel before it tests the depth, reads again what it has read before
    int mostPoint = 64;       ///< side of the largest point in pixels
    bool floatTargets = true; ///< can draw to RGBA32F
};

/// Pure: the same scene, settings and target give the same features. `settings.data` Auto takes a block where that
/// holds the scene and a GPU draws.
Features featuresOf(const Scene&, const Settings&, const GlslTarget&);

} // namespace gnomon
