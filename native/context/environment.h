/// What numbers of this run depend on: GL and driver, processor, system, the program itself.
#pragma once

#include "lab/results/results.h"
#include "native/context/context.h"

namespace gnomon {

/// Of the current context, which is of that kind.
Environment environmentOf(ContextKind);

} // namespace gnomon
