/// The integer constants of the specialised shader that tell it where the scene's values lie and how many there are.
#pragma once

#include "tracer/plan/scene_features.h"

#include <string>
#include <utility>
#include <vector>

namespace gnomon {

/// Names, as kSphereBase, and values.
std::vector<std::pair<std::string, int>> constantsOf(const SceneFeatures&);

} // namespace gnomon
