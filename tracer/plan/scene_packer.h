/// The scene's numbers as the shader reads them: one array of vec4.
///
/// Order: for each kind present the geometry of its objects (casters first), then the hierarchies of the kinds that
/// have one, then per object one texel (material, index in the file, whether the usual program leaves it out), then
/// materials, lights, glows. The offsets are constants of the specialised shader; see constantsOf().
#pragma once

#include "tracer/accel/hierarchy.h"
#include "tracer/plan/layout.h"
#include "tracer/plan/texture_set.h"
#include "tracer/software/screen_partition.h"
#include "tracer/scene/scene.h"
#include "tracer/plan/features.h"

#include <glm/glm.hpp>

#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gnomon {

inline constexpr int kDataWidth = 2048; ///< texels a row of the data texture, as shaders/scene.glsl reads it
inline constexpr int kMaterialTexels = 6;
inline constexpr int kLightTexels = 2;
inline constexpr int kGlowTexels = 2;

/// Names and values of the integer constants that tell the shader where things lie.
std::vector<std::pair<std::string, int>> constantsOf(const Features&);

/// Number of texels the scene takes.
int sceneTexels(const Features&);

/// What each image takes of its layer; all of it where nothing is told.
struct Tiles {
    std::vector<glm::vec2> paints, normals;
};

/// Packs one scene, frame after frame: what stays is worked out once, what moves is fitted to where it has gone.
class ScenePacker {
  public:
    /// Every point is told relative to `origin`: what is drawn does not depend on it, only how exactly.
    explicit ScenePacker(const Scene&, glm::dvec3 origin = glm::dvec3(0));

    /// All texels at `time`, for a picture taken from `eye`, which exactness depends on as well. Features of this
    /// scene; the texels are good until the next call.
    std::span<const glm::vec4> pack(const Features&, double time, glm::dvec3 eye);

    /// What rays from the eye may meet of what was packed last.
    std::vector<ScreenBounds> screenBounds(const Features&) const;

    /// From here on images are told to lie on such tiles.
    void setTiles(Tiles tiles) { tiles_ = std::move(tiles); }

  private:
    std::vector<Shape> shapesAbout(double time) const;
    void packShapes(const std::vector<Shape>&, glm::dvec3 eye);
    void packSearches(const Features&, const std::vector<Shape>&, glm::vec3 eye);
    void packObjects(const Features&);
    void packLights();
    void packGlows(const std::vector<Shape>&);

    Scene scene_;
    glm::dvec3 origin_;
    std::vector<KindLayout> layout_; ///< layoutOf()
    TextureSet textureSet_;
    Tiles tiles_;
    std::vector<Hierarchy> hierarchies_; ///< of each kind of the layout
    std::vector<Shape> shapes_;          ///< packed last
    std::vector<Bounds> bounds_;         ///< of one kind; kept for its memory
    std::vector<glm::vec4> texels_;
};

/// What one picture takes: as ScenePacker, in the world's coordinates and from the scene's own camera.
std::vector<glm::vec4> packScene(const Scene&, const Features&, double time);

} // namespace gnomon
