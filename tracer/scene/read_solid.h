/// Reads what an object of a scene file is made of: one shape, or a solid of several.
#pragma once

#include "tracer/scene/affine.h"
#include "tracer/scene/object_reader.h"
#include "tracer/scene/shapes.h"

namespace gnomon {

/// The shape that `object` names by one of its keys. What is wrong is reported; the shape is then of no use.
Shape readShape(const ObjectReader& object, SceneReport&);

/// How far from its seams a smooth union bends; beside another shape it means nothing, but is checked.
double readBlend(const ObjectReader&);

/// Where something is put: scaled, then rotated, then moved.
struct Placement {
    glm::dvec3 scale{1};
    glm::dquat rotate{1, 0, 0, 0};
    glm::dvec3 translate{0};
};
/// From the keys "scale", "rotate" and "translate".
Placement readPlacement(const ObjectReader&);

/// What keeps a solid from being drawn; {} where nothing does.
Complaint complaintOf(const SolidNode&);

} // namespace gnomon
