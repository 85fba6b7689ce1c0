#include "tracer/scene/mesh.h"

#include "tracer/problem.h"
#include "tracer/scene/obj_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace gnomon {
namespace {

using Corner = ObjFile::Corner;
using Triangle = std::array<Corner, 3>;

/// Cuts a polygon's ears off, as its own plane sees them; where it has none, as of a polygon that crosses itself,
/// whatever comes first.
class Polygon {
  public:
    Polygon(const ObjFile& obj, const ObjFile::Face& face) {
        for (int i = 0; i < face.count; ++i) left_.push_back(obj.corners[face.first + std::size_t(i)]);
        // Newell's normal: twice the area of the polygon, seen along each axis.
        glm::dvec3 normal{0};
        for (std::size_t i = 0; i < left_.size(); ++i)
            normal += glm::cross(at(obj, i) - at(obj, 0), at(obj, i + 1) - at(obj, 0));
        int axis = 0;
        for (int i = 1; i < 3; ++i)
            if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
        for (std::size_t i = 0; i < left_.size(); ++i) {
            const glm::dvec3 p = at(obj, i);
            flat_.push_back(glm::dvec2(p[(axis + 1) % 3], p[(axis + 2) % 3]) *
                            glm::dvec2(normal[axis] < 0 ? -1 : 1, 1));
        }
    }

    void cutInto(std::vector<Triangle>& triangles) {
        while (left_.size() > 3) cut(firstEar(), triangles);
        triangles.push_back({left_[0], left_[1], left_[2]});
    }

  private:
    const glm::dvec3& at(const ObjFile& obj, std::size_t i) const {
        return obj.positions[std::size_t(left_[i % left_.size()].position)];
    }
    static double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    }
    /// The corner itself and its neighbours.
    std::array<std::size_t, 3> about(std::size_t i) const {
        return {(i + left_.size() - 1) % left_.size(), i, (i + 1) % left_.size()};
    }

    bool isEar(std::size_t i) const {
        const auto [before, here, after] = about(i);
        const glm::dvec2 a = flat_[before], b = flat_[here], c = flat_[after];
        if (!(turn(a, b, c) > 0)) return false;
        for (std::size_t k = 0; k < flat_.size(); ++k) {
            const glm::dvec2 p = flat_[k];
            if (k == before || k == here || k == after || p == a || p == b || p == c) continue;
            if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
        }
        return true;
    }
    std::size_t firstEar() const {
        for (std::size_t i = 1; i < left_.size(); ++i)
            if (isEar(i)) return i;
        return isEar(0) ? 0 : 1;
    }
    void cut(std::size_t ear, std::vector<Triangle>& triangles) {
        const auto [before, here, after] = about(ear);
        triangles.push_back({left_[before], left_[here], left_[after]});
        left_.erase(left_.begin() + std::ptrdiff_t(ear));
        flat_.erase(flat_.begin() + std::ptrdiff_t(ear));
    }

    std::vector<Corner> left_;
    std::vector<glm::dvec2> flat_;
};

/// Cross product of the sides, twice the area long; 0 where the shape table refuses it.
glm::dvec3 acrossOf(const ObjFile& obj, const Triangle& triangle) {
    const auto at = [&](int i) { return obj.positions[std::size_t(triangle[std::size_t(i)].position)]; };
    const Shape shape = makeShape(ShapeKind::Triangle, {at(0), at(1), at(2)});
    return shapeRow(ShapeKind::Triangle).check(shape)[0].empty() ? glm::cross(at(1) - at(0), at(2) - at(0))
                                                                 : glm::dvec3(0);
}

double angleAt(const ObjFile& obj, const Triangle& triangle, std::size_t i) {
    const auto at = [&](std::size_t k) { return obj.positions[std::size_t(triangle[k % 3].position)]; };
    const glm::dvec3 a = at(i + 1) - at(i), b = at(i + 2) - at(i);
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Of each position: the mean of the faces' normals about it.
std::vector<glm::dvec3> normalsOf(const ObjFile& obj, const std::vector<Triangle>& triangles) {
    std::vector<glm::dvec3> normals(obj.positions.size(), glm::dvec3(0));
    for (const Triangle& triangle : triangles) {
        const glm::dvec3 normal = glm::normalize(acrossOf(obj, triangle));
        for (std::size_t i = 0; i < 3; ++i)
            normals[std::size_t(triangle[i].position)] += angleAt(obj, triangle, i) * normal;
    }
    return normals;
}

class MeshMaker {
  public:
    MeshMaker(const ObjFile& obj, const std::vector<Triangle>& triangles, bool smooth) : obj_(obj), smooth_(smooth) {
        if (smooth) means_ = normalsOf(obj, triangles);
    }

    Shape shapeOf(Triangle triangle) const {
        glm::dvec3 normal = glm::normalize(acrossOf(obj_, triangle));
        glm::dvec3 told{0};
        for (const Corner& corner : triangle)
            if (corner.normal >= 0) told += obj_.normals[std::size_t(corner.normal)];
        if (glm::dot(told, normal) < 0) {
            std::swap(triangle[1], triangle[2]);
            normal = -normal;
        }
        const auto at = [&](int i) { return obj_.positions[std::size_t(triangle[std::size_t(i)].position)]; };
        const bool images = std::all_of(triangle.begin(), triangle.end(), [](const Corner& c) { return c.uv >= 0; });
        if (!smooth_ && !images) return makeShape(ShapeKind::Triangle, {at(0), at(1), at(2)});
        Shape shape = makeShape(ShapeKind::SmoothTriangle, {at(0), at(1), at(2)});
        Corners corners;
        for (std::size_t i = 0; i < 3; ++i) {
            corners.normals[i] = smooth_ ? normalAt(triangle[i], normal) : normal;
            corners.uv[i] = {double(i == 1), double(i == 2)};
            if (!images) continue;
            const glm::dvec2 uv = obj_.uvs[std::size_t(triangle[i].uv)];
            corners.uv[i] = {uv.x, 1 - uv.y}; // images begin at their top here
        }
        shape.corners = std::make_shared<const Corners>(corners);
        return shape;
    }

  private:
    glm::dvec3 normalAt(const Corner& corner, glm::dvec3 ofFace) const {
        const glm::dvec3 sum =
            corner.normal >= 0 ? obj_.normals[std::size_t(corner.normal)] : means_[std::size_t(corner.position)];
        const double length = glm::length(sum);
        if (length < 1e-9) return ofFace;
        const glm::dvec3 normal = sum / length;
        return corner.normal < 0 && glm::dot(normal, ofFace) < 0 ? -normal : normal;
    }

    const ObjFile& obj_;
    bool smooth_;
    std::vector<glm::dvec3> means_; ///< of no length fixed
};

} // namespace

std::variant<std::vector<Shape>, Complaint> meshOf(std::string_view text, const std::string& file, bool smooth,
                                                   std::size_t most) {
    const auto read = readObj(text, file);
    if (const auto* complaint = std::get_if<Complaint>(&read)) return *complaint;
    const ObjFile& obj = std::get<ObjFile>(read);
    std::size_t count = 0;
    for (const ObjFile::Face& face : obj.faces) count += std::size_t(face.count) - 2;
    if (count > most)
        return Complaint{file + " has " + std::to_string(count) + " triangles; a scene has at most " +
                             std::to_string(most) + " objects",
                         "use a coarser mesh"};
    std::vector<Triangle> triangles;
    for (const ObjFile::Face& face : obj.faces) Polygon(obj, face).cutInto(triangles);
    std::erase_if(triangles, [&](const Triangle& triangle) { return acrossOf(obj, triangle) == glm::dvec3(0); });
    if (triangles.empty()) return Complaint{file + ": none of its faces has an area", "use a mesh of some size"};
    const MeshMaker maker(obj, triangles, smooth);
    std::vector<Shape> shapes;
    shapes.reserve(triangles.size());
    for (const Triangle& triangle : triangles) shapes.push_back(maker.shapeOf(triangle));
    return shapes;
}

} // namespace gnomon
