#include "lab/intersect/compare_hit.h"

#include <cmath>
#include <limits>
#include <thread>

namespace gnomon::oracle {
namespace {

double ulp(double x) { return std::ldexp(1.0, std::ilogb(x) - 23); }

bool finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The surface point is off the line, or elsewhere along it.
bool strays(const ExactShape<double>& shape, const Line<double>& line, double met, const Vec3<double>& p,
            double slack) {
    const double s = dot(p - line.p, line.d) / dot(line.d, line.d);
    return length(p - line.at(s)) > slack || leavesSurface(shape, line, met, s, slack);
}

} // namespace

bool leavesSurface(const ExactShape<double>& shape, const Line<double>& line, double met, double s, double slack) {
    const int steps = 32;
    for (int i = 0; i <= steps; ++i)
        if (!shape.nearSurface(line.at(met + (s - met) * i / steps), slack)) return true;
    return false;
}

Bounds boundsOf(ShapeKind kind) {
    switch (kind) {
    case ShapeKind::Sphere:
    case ShapeKind::Torus: return {0x1p-22, 1.5, 2, 2};
    case ShapeKind::Box: return {0x1p-23, 1.5, 1, 1};
    case ShapeKind::RotatedBox: return {0x1p-22, 1.5, 2, 1};
    case ShapeKind::Ellipsoid: return {0x1p-22, 1.5, 2, 2};
    case ShapeKind::Cylinder: return {0x1p-22, 1.5, 2, 2};
    case ShapeKind::Capsule: return {0x1p-22, 2, 2, 2};
    case ShapeKind::Cone: return {0x1p-21, 2, 2, 2};
    case ShapeKind::Disc: return {0x1p-22, 1.5, 2, 1};
    case ShapeKind::Plane: return {0x1p-22, 4, 2, 1};
    case ShapeKind::Triangle:
    case ShapeKind::SmoothTriangle: return {0x1p-22, 1.5, 2, 1};
    case ShapeKind::HeightPatch: return {0x1p-20, 2, 2, 4};
    case ShapeKind::SpacePatch:  // tests/shader/space_patch_test.cpp
    case ShapeKind::LargeSphere: // tests/shader/large_sphere_test.cpp
    case ShapeKind::Mandelbulb:  // have no intersector
    case ShapeKind::Solid: break;
    }
    return {};
}

Scale scaleOf(const ExactShape<double>& shape, const Line<double>& line, const ExactHit<double>& exact,
              const Vec3<double>& p, double extent) {
    const double size = std::max(shape.size(), extent), away = std::abs(line.start) + length(line.p) + size;
    const bool sizeless = shape.kind() == ShapeKind::Plane;
    Scale scale;
    scale.bend = shape.bend(exact.point);
    scale.band = sizeless ? away : size;
    scale.distance = std::max({double(exact.t), 3 * size, sizeless ? away : 0});
    if (shape.triangle()) scale.distance *= shape.size() / scale.bend;
    const Vec3<long double> middle = shape.middle();
    const double written = double(std::max({std::abs(middle.x), std::abs(middle.y), std::abs(middle.z)}));
    scale.rounding = 0x1p-23 * (written + size + (sizeless ? length(p) : 0));
    return scale;
}

Verdict compareHit(const ExactShape<double>& shape, const BatchRay& ray, const BatchHit& answer) {
    const Line<double> line = lineOf(shape, ray.origin, ray.direction);
    return compareHit(shape, line, exactHit(shape, line), answer);
}

Verdict compareHit(const ExactShape<double>& shape, const Line<double>& line, const ExactHit<double>& exact,
                   const BatchHit& answer, double extent) {
    const Vec3<double> p(Vec3<long double>(answer.point) - shape.middle());
    const Scale scale = scaleOf(shape, line, exact, p, extent);
    const bool got = answer.object >= 0;
    const Bounds bounds = boundsOf(shape.kind());
    const double band = bounds.band * scale.band;
    Verdict verdict;
    verdict.decided = exact.tangency > band;
    verdict.hit = exact.hit && got;
    if (exact.hit != got) verdict.margin = exact.tangency / scale.band;
    verdict.missed = verdict.decided && exact.hit && !got;
    verdict.invented = verdict.decided && !exact.hit && got;
    const bool numbers = std::isfinite(answer.t) && finite(answer.point) && finite(answer.normal);
    verdict.elsewhere = got && (answer.object != 0 || !numbers);
    if (!verdict.hit || verdict.elsewhere) return verdict;
    const double s = line.local(answer.t), slack = 4 * ulp(scale.distance);
    const bool otherSheet = !shape.flat() && leavesSurface(shape, line, exact.s, s, slack);
    // The ray is known to the band across itself, the surface to some roundings; and a point that is the nearest of the
    // surface to o + t d is where t, rounded, has it.
    double known = band + 4 * scale.rounding + bounds.ray * ulp(scale.distance);
    // A triangle's is of weights, quotients of areas as the eye sees them.
    if (shape.triangle()) known /= std::abs(dot(line.d, shape.axis()));
    // A patch's is that of its surface above or below o + t d.
    if (shape.kind() == ShapeKind::HeightPatch) known /= dot(shape.normal(p), shape.axis());
    const bool otherPoint = strays(shape, line, exact.s, p, known);
    verdict.elsewhere = verdict.decided && (otherSheet || otherPoint);
    verdict.t = std::abs(double(Wide<double>(answer.t) - exact.t)) / ulp(scale.distance);
    verdict.ray = std::abs(shape.distance(line.at(s))) / ulp(scale.distance);
    verdict.point = std::abs(shape.distance(p)) / scale.rounding;
    if (shape.flat() || shape.toEdge(p) > 1e-5 * shape.size() + 4 * scale.rounding)
        verdict.normal = length(Vec3<double>(answer.normal) - shape.normal(p)) * scale.bend / scale.rounding;
    return verdict;
}

Spread spreadOf(std::vector<double> values) {
    if (values.empty()) return {};
    for (double& value : values)
        if (std::isnan(value)) value = std::numeric_limits<double>::infinity();
    std::sort(values.begin(), values.end());
    const auto at = [&](double part) { return values[std::size_t(part * double(values.size() - 1))]; };
    return {at(0.5), at(0.999), values.back()};
}

bool within(const Tally& tally, const Bounds& bounds) {
    return tally.wrong() == 0 && tally.ray.worst <= bounds.ray && tally.point.worst <= bounds.point &&
           tally.normal.worst <= bounds.normal; // NaN is not
}

Tally compareHits(const Shape& shape, const std::vector<BatchRay>& rays, const std::vector<BatchHit>& answers) {
    const ExactShape<double> exactShape(shape);
    std::vector<Verdict> verdicts(rays.size());
    const std::size_t workers = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::thread> threads;
    for (std::size_t worker = 0; worker < workers; ++worker)
        threads.emplace_back([&, worker] {
            for (std::size_t i = worker; i < rays.size(); i += workers)
                verdicts[i] = compareHit(exactShape, rays[i], answers[i]);
        });
    for (std::thread& thread : threads) thread.join();
    Tally tally;
    std::vector<double> t, ray, point, normal;
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
        const Verdict& verdict = verdicts[i];
        if (verdict.wrong()) tally.wrongRays.push_back(i);
        ++tally.rays;
        tally.decided += verdict.decided;
        tally.hits += verdict.hit && verdict.decided;
        tally.missed += verdict.missed;
        tally.invented += verdict.invented;
        tally.elsewhere += verdict.elsewhere;
        tally.worstMargin = std::max(tally.worstMargin, verdict.margin);
        if (!verdict.hit || !verdict.decided) continue;
        t.push_back(verdict.t);
        ray.push_back(verdict.ray);
        point.push_back(verdict.point);
        normal.push_back(verdict.normal);
    }
    tally.t = spreadOf(std::move(t));
    tally.ray = spreadOf(std::move(ray));
    tally.point = spreadOf(std::move(point));
    tally.normal = spreadOf(std::move(normal));
    return tally;
}

} // namespace gnomon::oracle
