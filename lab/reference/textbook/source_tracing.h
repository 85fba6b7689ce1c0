/// The files of lab/reference/textbook/source, without the intersectors.
#pragma once

#include "tracer/shader/library.h"

namespace gnomon {

/// Sorted by name, as `integrator/whitted.glsl`.
std::span<const ShaderFile> sourceTracing();

} // namespace gnomon
