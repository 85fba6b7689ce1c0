#include "lab/intersect/compare_scene_hit.h"

#include "tracer/plan/drawn.h"
#include "tracer/plan/prepared_scene.h"
#include "tracer/plan/shape_texels.h"
#include "tracer/plan/solid_texels.h"

#include <algorithm>
#include <cmath>

namespace gnomon::oracle {
namespace {

/// Radius of all triangles about the middle of their box, which the shader re-centres rays on.
double extentOfTriangles(const std::vector<Shape>& shapes) {
    std::vector<glm::dvec3> vertices;
    glm::dvec3 low(1e30), high(-1e30);
    for (const Shape& shape : shapes)
        for (int i = 0; i < 3 && (shape.kind == ShapeKind::Triangle || shape.kind == ShapeKind::SmoothTriangle); ++i) {
            vertices.push_back(vertexOf(shape, i));
            low = glm::min(low, vertices.back());
            high = glm::max(high, vertices.back());
        }
    double extent = 0;
    for (const glm::dvec3 vertex : vertices) extent = std::max(extent, glm::distance(vertex, 0.5 * (low + high)));
    return extent;
}

/// As rayFrom() in shaders/ray/ray.glsl.
float leastT(glm::vec3 origin) {
    return 4.8e-7f * (std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)}) + 1e-3f);
}

bool finite(const BatchHit& hit) {
    const auto is = [](glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    return std::isfinite(hit.t) && is(hit.point) && is(hit.normal);
}

} // namespace

std::string_view nameOf(Fault fault) {
    switch (fault) {
    case Fault::None: return "none";
    case Fault::Missed: return "missed";
    case Fault::Invented: return "invented";
    case Fault::NotFirst: return "not the first of equals";
    case Fault::Elsewhere: return "elsewhere";
    case Fault::Beyond: return "beyond its bounds";
    }
    return "";
}

SceneOracle::SceneOracle(const Scene& scene, double time) {
    const std::vector<Shape> shapes = shapesAt(scene, time);
    const double extent = extentOfTriangles(shapes);
    const PreparedScenePtr prepared = prepare(scene);
    for (const KindLayout& kind : prepared->layout)
        for (const int i : kind.objects) {
            const Shape& shape = shapes[std::size_t(i)];
            objects_.push_back(exactObject(shape, kind.kind, extent, scene.camera.eye));
            shapes_.push_back(shape);
            fileIndices_.push_back(i);
            values_.emplace_back(1, glm::vec4(float(&kind - prepared->layout.data())));
            if (kind.solid)
                appendTexels(shape, values_.back());
            else
                appendShape(drawnAs(kind.kind, shape, scene.camera.eye), values_.back());
        }
}

Meeting SceneOracle::meetingWith(int object, const BatchRay& ray) const {
    const RayStart start{ray.tMin < 0 ? leastT(ray.origin) : ray.tMin, object == ray.self() ? ray.side : 0};
    return objects_[std::size_t(object)]->meeting(ray, start);
}

/// With all objects that the ray may meet.
std::vector<SceneOracle::Met> SceneOracle::meetings(const BatchRay& ray) const {
    std::vector<Met> met;
    for (int i = 0; i < int(objects_.size()); ++i) {
        if (!objects_[std::size_t(i)]->near(ray)) continue;
        Meeting meeting = meetingWith(i, ray);
        if (!meeting.none()) met.push_back({i, std::move(meeting)});
    }
    return met;
}

/// First what is wrong however the undecided ones are decided; then, of decided rays, the numbers.
Fault SceneOracle::faultOf(const std::vector<Met>& met, const BatchHit& answer, SceneVerdict& verdict) const {
    if (answer.object >= int(objects_.size()) || (answer.object >= 0 && !finite(answer))) return Fault::Invented;
    const Met* told = nullptr;
    for (const Met& one : met)
        if (one.object == answer.object) told = &one;
    if (answer.object >= 0 && !told) return Fault::Invented;
    for (const Met& one : met) {
        if (&one == told || (told && together(one, *told))) continue;
        if (one.meeting.by < (told ? told->meeting.from : Meeting::kNever)) return Fault::Missed;
    }
    if (!told || !verdict.decided) return Fault::None;
    if (told->object != verdict.object) return Fault::NotFirst;
    const ExactObject& object = *objects_[std::size_t(told->object)];
    const Bounds bounds = object.bounds();
    verdict.errors = object.errors(told->meeting, answer);
    if (verdict.errors.elsewhere) return Fault::Elsewhere;
    const bool within = verdict.errors.ray <= bounds.ray && verdict.errors.point <= bounds.point &&
                        verdict.errors.normal <= bounds.normal; // NaN is not
    return within ? Fault::None : Fault::Beyond;
}

SceneVerdict SceneOracle::compare(const BatchRay& ray, const BatchHit& answer) const {
    const std::vector<Met> met = meetings(ray);
    SceneVerdict verdict;
    const Met* first = nullptr;
    for (const Met& one : met)
        if (!first || one.meeting.by < (together(*first, one) ? first->meeting.from : first->meeting.by)) first = &one;
    verdict.decided = true;
    for (const Met& one : met) {
        const bool rival = !one.meeting.decided || !together(*first, one);
        if (&one != first || !one.meeting.decided)
            verdict.decided = verdict.decided && !(rival && one.meeting.from <= first->meeting.by);
    }
    if (verdict.decided && first) verdict.object = first->object;
    verdict.fault = faultOf(met, answer, verdict);
    return verdict;
}

} // namespace gnomon::oracle
