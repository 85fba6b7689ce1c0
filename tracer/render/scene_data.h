/// The scene's numbers as the shader reads them: one array of vec4.
///
/// Order: for each kind present the geometry of its objects (casters first), then per object one texel (material, index
/// in the file), then materials, lights, glows. The offsets are constants of the specialised shader; see constantsOf().
#pragma once

#include "tracer/scene/scene.h"
#include "tracer/shader/features.h"

#include <glm/glm.hpp>

#include <string>
#include <utility>
#include <vector>

namespace gnomon {

inline constexpr int kMaterialTexels = 8;
inline constexpr int kLightTexels = 2;
inline constexpr int kGlowTexels = 2;

/// Number of texels the scene takes.
int sceneTexels(const Scene&);

/// Names and values of the integer constants that tell the shader where things lie.
std::vector<std::pair<std::string, int>> constantsOf(const Features&);

/// All texels at `time`, for a picture taken from `eye`, every point relative to `origin`; what is drawn does not
/// depend on the two, only how exactly.
std::vector<glm::vec4> packScene(const Scene&, const Features&, double time, glm::dvec3 eye, glm::dvec3 origin);
/// From the scene's own camera, in the world's coordinates.
std::vector<glm::vec4> packScene(const Scene&, const Features&, double time);

/// Images in the order of their slots (cube map faces left out), each once.
std::vector<std::string> imageSlots(const Scene&);

} // namespace gnomon
