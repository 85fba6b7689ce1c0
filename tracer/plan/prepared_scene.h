/// A scene with all that is worked out of it once and handed on: nothing here depends on settings, time or the GL.
#pragma once

#include "tracer/accel/uniform_grid.h"
#include "tracer/plan/layout.h"
#include "tracer/plan/media.h"
#include "tracer/plan/texture_set.h"
#include "tracer/scene/scene.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gnomon {

/// What searching the objects of a kind that make no lattice takes a ray, at rest, on average.
struct SearchCost {
    int objects = 0;
    double boxes = 0;             ///< of a hierarchy that it asks
    double primitives = 0;        ///< that it asks of those found by their boxes or spheres
    std::optional<GridPlan> grid; ///< where a uniform grid may be searched
};

struct PreparedScene {
    Scene scene;
    glm::dvec3 origin{0};             ///< originOf(): what the shader's coordinates are relative to
    std::vector<Shape> shapes;        ///< at rest, relative to the origin
    std::vector<KindLayout> layout;   ///< the kinds drawn
    std::vector<SearchCost> searches; ///< of each of them; no objects where there is nothing to search
    Media media;
    TextureSet textureSet;
    std::vector<std::string> skyFaces; ///< the cube map's images towards +x −x +y −y +z −z; none without one
    bool moves = false;                ///< changesWithTime()
};

using PreparedScenePtr = std::shared_ptr<const PreparedScene>;

PreparedScenePtr prepare(Scene);

/// Scenes that this process has prepared: tests hold it against the number of scenes that they draw.
int preparedScenes();

} // namespace gnomon
