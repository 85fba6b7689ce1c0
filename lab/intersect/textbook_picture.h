/// What far distances do to a textbook's intersector, as a picture.
#pragma once

#include "tracer/problem.h"

#include <string>

namespace gnomon {

/// A torus from 3, 30, 100 and 1000 units, each filling its square: above by the textbook's formula, below by the
/// shader's. Draws in the current context. False, with problems, where it cannot be drawn or written.
bool writeTextbookPicture(const std::string& file, Problems&);

} // namespace gnomon
