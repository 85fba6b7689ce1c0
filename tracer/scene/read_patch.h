/// Reads the surfaces of a scene file that have nets of control points.
#pragma once

#include "tracer/scene/object_reader.h"
#include "tracer/scene/shapes.h"

namespace gnomon {

/// The shape of a net of control points about an anchor.
Shape spacePatch(const ControlPoints&, glm::dvec3 anchor);
Shape spacePatchOf(const SpaceNet&, glm::dvec3 anchor);

/// What stands under "patch".
Shape readPatch(const ObjectReader&, SceneReport&);

} // namespace gnomon
