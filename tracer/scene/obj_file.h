/// Wavefront OBJ files as they stand.
#pragma once

#include "tracer/scene/affine.h"

#include <glm/glm.hpp>

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gnomon {

struct ObjFile {
    struct Corner {
        int position, uv, normal; ///< indices from 0; -1 where there is none
    };
    struct Face {
        std::size_t first; ///< in `corners`
        int count;         ///< at least 3
    };
    std::vector<glm::dvec3> positions, normals;
    std::vector<glm::dvec2> uvs;
    std::vector<Corner> corners;
    std::vector<Face> faces;
};

/// Positions, image coordinates, normals and faces, all indices checked; a complaint with its line where it is wrong.
std::variant<ObjFile, Complaint> readObj(std::string_view text, const std::string& file);

} // namespace gnomon
