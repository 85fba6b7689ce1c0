/// The textbook intersectors: a baseline for cost and error, under the names of the library's files that they take the
/// place of.
#pragma once

#include "tracer/shader/library.h"

namespace gnomon {

/// One file a shape, sorted by name, as `primitive/torus.glsl`: overrides for buildShader, RayBatch and Renderer.
std::span<const ShaderFile> naiveShaders();

} // namespace gnomon
