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

} // namespace gnomon::test
