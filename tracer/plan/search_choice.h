/// How rays search the objects of each kind, by what it costs a ray on average.
#pragma once

#include "tracer/plan/prepared_scene.h"
#include "tracer/plan/scene_features.h"

namespace gnomon {

/// The kinds of a prepared scene, counted. `grids`: uniform grids are worth considering.
std::vector<KindCount> countKinds(const PreparedScene&, Accel, bool grids);

} // namespace gnomon
