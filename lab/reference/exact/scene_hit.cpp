#include "lab/reference/exact/scene_hit.h"

#include "lab/reference/exact/exact_hit.h"
#include "tracer/plan/drawn.h"

#include <algorithm>
#include <cmath>

namespace gnomon::oracle {
namespace {

Vec asInShader(glm::dvec3 v) { return Vec(glm::vec3(v)); }
Vec toGlm(const Vec3<long double>& v) { return {v.x, v.y, v.z}; }

SceneHit described(int object, const SceneShape& shape, const ExactHit<long double>& exact, Vec direction) {
    SceneHit hit;
    hit.object = object;
    hit.t = exact.t;
    hit.point = toGlm(shape.middle() + exact.point);
    hit.normal = toGlm(exact.normal);
    const bool against = glm::dot(hit.normal, direction) <= 0;
    if (!against) hit.normal = -hit.normal;
    hit.outside = shape.closed() ? !exact.inside : against;
    if (!shape.closed()) return hit;
    hit.edge = shape.toEdge(exact.point);
    if (shape.kind() == ShapeKind::Cone) hit.turn = 1 / shape.bend(exact.point);
    return hit;
}

} // namespace

std::vector<SceneShape> exactShapesOf(const Scene& scene, double time) {
    const std::vector<Shape> shapes = shapesAt(scene, time);
    const std::vector<ShapeKind> drawn = drawnKinds(scene);
    std::vector<SceneShape> exactShapes;
    for (std::size_t i = 0; i < shapes.size(); ++i)
        exactShapes.emplace_back(shapes[i],
                                 drawn[i] == ShapeKind::LargeSphere ? Values::OfTheScene : Values::OfTheShader);
    return exactShapes;
}

SceneHit nearestHit(const std::vector<SceneShape>& exactShapes, Vec origin, Vec direction) {
    SceneHit hit;
    long double margin = hit.margin;
    for (std::size_t i = 0; i < exactShapes.size(); ++i) {
        const auto line = lineOf(exactShapes[i], Vec3<long double>(origin), Vec3<long double>(direction));
        const ExactHit<long double> exact = exactHit(exactShapes[i], line);
        margin = std::min(margin, exact.tangency);
        if (!exact.hit) continue;
        // Two surfaces at nearly one distance: which is first may be rounding.
        if (hit.object >= 0) margin = std::min(margin, std::abs(exact.t - hit.t));
        if (hit.object < 0 || exact.t < hit.t) hit = described(int(i), exactShapes[i], exact, direction);
    }
    hit.margin = margin;
    return hit;
}

void pixelRay(const CameraPose& pose, int x, int y, int width, int height, Vec& origin, Vec& direction) {
    const CameraFrame frame = frameOf(pose);
    const long double u = 2 * (x + 0.5L) / width - 1, v = 1 - 2 * (y + 0.5L) / height;
    const glm::dvec3 right = frame.right * frame.halfHeight * (double(width) / height);
    origin = asInShader(frame.eye);
    direction =
        glm::normalize(asInShader(frame.forward) + u * asInShader(right) + v * asInShader(frame.up * frame.halfHeight));
}

} // namespace gnomon::oracle
