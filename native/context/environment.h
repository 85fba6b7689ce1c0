/// What numbers of this run depend on: GL and driver, processor, system, the program itself.
#pragma once

#include "native/context/context.h"
#include "lab/results/results.h"

namespace gnomon {

/// Of the current context, which is of that kind.
Environment environmentOf(ContextKind);

} // namespace gnomon
