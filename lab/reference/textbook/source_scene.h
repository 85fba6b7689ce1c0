/// A scene as the source document had to model it.
#pragma once

#include "tracer/scene/scene.h"

#include <string>

namespace gnomon {

/// The same picture from other shapes: each box as twelve triangles of its name, material and motion, and the cube map
/// as six planes 10 000 units from the world's origin, which show its faces and cast no shadow. The nearest plane ahead
/// is the sky, so the camera must stay between them. An image on a box is lost: textbook triangles have no coordinates.
/// Reflectance is by Schlick's approximation.
Scene sourceScene(const Scene&);

/// What of the scene the source document's shaders cannot draw, as `spot lights`; empty where they draw it all.
std::string beyondSource(const Scene&);

} // namespace gnomon
