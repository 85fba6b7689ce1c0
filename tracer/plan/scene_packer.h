/// The scene's values as the shader reads them: one array of vec4, in the order of scene_offsets.h.
#pragma once

#include "tracer/accel/hierarchy.h"
#include "tracer/plan/field_layout.h"
#include "tracer/plan/plan.h"

#include <glm/glm.hpp>

#include <span>
#include <utility>
#include <vector>

namespace gnomon {

/// What each image takes of its layer; all of it where nothing is told.
struct Tiles {
    std::vector<glm::vec2> paints, normals;
};

/// Packs one scene, frame after frame: what stays is worked out once, what moves is fitted to where it has gone.
class ScenePacker {
  public:
    /// Every point is told relative to the scene's origin.
    explicit ScenePacker(PreparedScenePtr);
    /// Relative to another one: what is drawn does not depend on it, only how exactly.
    ScenePacker(PreparedScenePtr, glm::dvec3 origin);

    /// All texels at `time`, for a picture taken from `eye`, which exactness depends on as well. A plan of this scene;
    /// the texels are good until the next call.
    std::span<const glm::vec4> pack(const Plan&, double time, glm::dvec3 eye);

    /// Every object's shape as it was packed last, relative to the origin.
    const std::vector<Shape>& shapes() const { return shapes_; }

    /// From here on images are told to lie on such tiles.
    void setTiles(Tiles tiles) { tiles_ = std::move(tiles); }
    /// And surfaces to have such fields.
    void setFields(FieldLayout fields) { fields_ = std::move(fields); }

  private:
    std::vector<Shape> shapesAbout(double time) const;
    void packShapes(glm::dvec3 eye);
    void setField(int object);
    void packSearches(const SceneFeatures&, glm::vec3 eye);
    void packObjects(const Plan&);
    void packLights();
    void packGlows();
    void packMetals();
    void packMedia(glm::dvec3 eye);
    void packCheckers();
    void packProfiles();

    PreparedScenePtr prepared_;
    glm::dvec3 origin_;
    Tiles tiles_;
    FieldLayout fields_;
    std::vector<Hierarchy> hierarchies_; ///< of each kind of the layout
    std::vector<Shape> shapes_;          ///< packed last
    std::vector<Bounds> bounds_;         ///< of one kind; kept for its memory
    std::vector<glm::vec4> texels_;
};

/// What one picture takes: as ScenePacker, in the world's coordinates and from the scene's own camera.
std::vector<glm::vec4> packScene(PreparedScenePtr, const Plan&, double time, FieldLayout = {});

} // namespace gnomon
