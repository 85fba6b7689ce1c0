/// What ends the program against its will is told in words and with an exit code.
#pragma once

#include <string_view>

namespace gnomon {

/// From here on memory that runs out is told. main() calls it first.
void tellCrashes();

/// From here on a driver's code is part of the program: where it crashes, or its threads run out of memory, that is
/// told as GL that cannot be used. `context` is what messages call it.
void blameGl(std::string_view context);

} // namespace gnomon
