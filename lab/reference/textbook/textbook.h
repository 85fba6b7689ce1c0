/// The baselines, under the names of the library's files that they take the place of: overrides for buildShader,
/// RayBatch and Renderer.
#pragma once

#include "tracer/shader/library.h"

namespace gnomon {

/// The textbook intersectors, a baseline for cost and error: one file a shape, sorted by name, as
/// `primitive/torus.glsl`.
std::span<const ShaderFile> textbookShaders();

/// The source document's way of tracing, a baseline for speed: the textbook intersectors and the rays that ask them,
/// sorted by name. It draws sourceScene() of lab/reference/textbook/source_scene.h.
std::span<const ShaderFile> sourceShaders();

} // namespace gnomon
