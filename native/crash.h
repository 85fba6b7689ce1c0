/// What ends the program against its will is told in words and with an exit code: memory that runs out from the start
/// of any program that links this, a driver's crash from blameGl() on.
#pragma once

#include <string_view>

namespace gnomon {

/// From here on a driver's code is part of the program: where it crashes, or its threads run out of memory, that is
/// told as GL that cannot be used. `context` is what messages call it.
void blameGl(std::string_view context);

} // namespace gnomon
