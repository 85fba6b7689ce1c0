/// Results of earlier versions in today's words, so that they can be compared with those of today.
#pragma once

#include "lab/results/results.h"

namespace gnomon {

/// Columns and key cells that were once called otherwise get their present names. What is up to date stays as it is.
void bringUpToDate(Results&);

} // namespace gnomon
