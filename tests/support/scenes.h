/// Scenes for tests: those that come with the program, and small ones written in the test.
#pragma once

#include "tracer/scene/scene.h"

#include <string>

namespace gnomon::test {

/// By name, from assets/scenes.
Scene sceneNamed(const std::string& name);
/// From JSON text. Both fail the running test, and answer an empty scene, on any problem.
Scene sceneFrom(const std::string& json);
/// The scene elsewhere in the world, its lights and camera as well.
Scene moved(Scene, glm::dvec3 by);

/// A file's whole text.
std::string textOf(const std::string& file);

/// `what` is within `tolerance` of where it should be.
void expectNear(glm::dvec3 value, glm::dvec3 wanted, double tolerance, const std::string& what);

} // namespace gnomon::test
