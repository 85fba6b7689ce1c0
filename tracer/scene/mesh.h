/// Wavefront OBJ files as triangles.
#pragma once

#include "tracer/scene/affine.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gnomon {

/// The triangles of `text`, the OBJ file `file`; a complaint, with its line, where it is none that can be drawn or has
/// more than `most` of them. Polygons are cut into triangles; those without area are left out.
///
/// Read: v, vt, vn, f, with indices from either end. Left out: names, groups, materials, smoothing groups, lines,
/// points; a free-form surface is a complaint. Where `smooth`, corners have the file's normals, or the mean of the
/// faces' about their vertex, by the angles there; else those of their face. A file whose normals point away from what
/// its faces' winding says is right: its faces are turned.
std::variant<std::vector<Shape>, Complaint> meshOf(std::string_view text, const std::string& file, bool smooth,
                                                   std::size_t most);

} // namespace gnomon
