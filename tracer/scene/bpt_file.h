/// BPT files: models of bicubic Bézier patches, as Newell's teapot.
#pragma once

#include "tracer/scene/affine.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gnomon {

/// The patches of `text`, the BPT file `file`; a complaint, with its line, where it is none that can be drawn or has
/// more than `most` of them.
///
/// A line with the number of patches; for each a line with its degrees, `3 3`, and 16 lines with its control points,
/// row by row along u: x, y and z, and for a rational patch the weight of the point, which its place is not multiplied
/// by. Lines may be blank; comments the format has none.
std::variant<std::vector<Shape>, Complaint> patchesOf(std::string_view text, const std::string& file, std::size_t most);

} // namespace gnomon
