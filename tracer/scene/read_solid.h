/// Reads what an object of a scene file is made of: one shape, or a solid of several.
#pragma once

#include "tracer/scene/object_reader.h"
#include "tracer/scene/shapes.h"

namespace gnomon {

/// The shape that `object` names by one of its keys. What is wrong is reported; the shape is then of no use.
Shape readShape(const ObjectReader& object, SceneReport&);

} // namespace gnomon
