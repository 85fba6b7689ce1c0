/// What the shader draws a scene as: the kind of each object's shape, and what coordinates are relative to. Neither
/// time nor moving the eye counts, so that both stay while a scene is shown, and moving never recompiles.
#pragma once

#include "tracer/scene/scene.h"

#include <glm/glm.hpp>

#include <vector>

namespace gnomon {

/// The kind that each object is drawn as: a sphere that is huge for its scene as a large sphere, all else as what it
/// is. Huge is a radius above 100 times the size of some object of the scene, or the height of the scene's camera above
/// that sphere. Up to there the float32 of a sphere, 2^-22 of its radius, is less than 3e-5 of the least thing to be
/// seen on it. The scene's unit does not count.
std::vector<ShapeKind> drawnKinds(const Scene&);

/// A shape as the shader reads it where it is drawn as `kind`: itself, or a sphere as a large sphere. That one is told
/// from its point nearest to `eye`, where the picture is taken from: its errors grow with the distance from there, as
/// what they look like shrinks. Near `eye` it is within float32 of what is near, where centre and radius are within
/// float32 of the radius only.
Shape drawnAs(ShapeKind kind, const Shape&, glm::dvec3 eye);

/// What the shader's coordinates are relative to: 0 for a scene about the world's origin, else a point near the scene,
/// so that float32 resolves a scene far away as finely as one at home. It lies on a grid whose step is the power of two
/// above 8 times the reach of the bounded objects, their orbits included, and above twice their distance from the
/// scene's camera: the grid point next to the middle of these objects, towards the world's origin. So no coordinate of
/// theirs or of the camera's grows, and those that float32 holds it holds still. Large spheres and planes say nothing
/// of where the scene is; in a scene of nothing else the camera does.
glm::dvec3 originOf(const Scene&);

} // namespace gnomon
