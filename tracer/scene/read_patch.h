/// Reads the surfaces of a scene file that have nets of control points.
#pragma once

#include "tracer/scene/object_reader.h"
#include "tracer/scene/shapes.h"

namespace gnomon {

/// What stands under "patch".
Shape readPatch(const ObjectReader&, SceneReport&);

} // namespace gnomon
