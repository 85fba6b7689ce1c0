/// The files of lab/reference/textbook/source, without the intersectors.
#pragma once

#include "tracer/shader/library.h"

namespace gnomon {

/// Sorted by name, as `ray/tree.glsl`.
std::span<const ShaderFile> sourceTracing();

} // namespace gnomon
