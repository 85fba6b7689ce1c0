#include "lab/intersect/scene_object.h"

#include <algorithm>
#include <cmath>

namespace gnomon::oracle {
namespace {

using Wide3 = Vec3<long double>;

double ulp(double x) { return x == 0 ? 0 : std::ldexp(1.0, std::ilogb(x) - 23); }

/// A ray that starts on a surface is compared from 0.57° off it on, as in tests/shader/intersect_test.cpp.
constexpr double kLeastCosine = 0.01;

/// Every shape that has an intersector of its own.
class ShapeObject : public ExactObject {
  public:
    ShapeObject(const Shape& shape, double extent)
        : ExactObject(shape.kind, boundsOf(shape.kind)), shape_(shape), extent_(shape_.triangle() ? extent : 0) {
        center_ = glm::dvec3(shape_.middle().x, shape_.middle().y, shape_.middle().z);
        if (shape.kind != ShapeKind::Plane) radius_ = shape_.size();
    }

    Meeting meeting(const BatchRay& ray, const RayStart& start) const override {
        Meeting meeting;
        if (start.side != 0 && shape_.flat()) return meeting; // it is met once
        meeting.line = lineOf(shape_, ray.origin, ray.direction);
        const double from = start.side != 0 ? clear(meeting.line) : start.tMin;
        meeting.exact = exactHit(shape_, meeting.line, from);
        const Scale scale = scaleOf(shape_, meeting.line, meeting.exact, meeting.exact.point, extent_);
        const double slack = 4 * ulp(scale.distance), band = bounds_.band * scale.band;
        meeting.decided = meeting.exact.tangency > band && startDecided(meeting, start, from, std::max(slack, band));
        if (!meeting.decided)
            meeting.from = entry(ray, start.tMin);
        else if (meeting.exact.hit)
            bracket(meeting, slack);
        return meeting;
    }

    HitErrors errors(const Meeting& meeting, const BatchHit& answer) const override {
        BatchHit own = answer;
        own.object = 0;
        const Verdict verdict = compareHit(shape_, meeting.line, meeting.exact, own, extent_);
        return {verdict.elsewhere, verdict.ray, verdict.point, verdict.normal};
    }

  private:
    /// t at which a ray that starts on the surface is farther from it than its start may be.
    double clear(const Line<double>& line) const {
        const Vec3<double> start = line.at(line.start);
        return 8 * rounding() / std::max(std::abs(dot(shape_.normal(start), line.d)), kLeastCosine);
    }
    double rounding() const {
        return 0x1p-23 * (std::max({std::abs(center_.x), std::abs(center_.y), std::abs(center_.z)}) + shape_.size());
    }

    bool startDecided(const Meeting& meeting, const RayStart& start, double from, double least) const {
        const Line<double>& line = meeting.line;
        if (shape_.flat()) return !meeting.exact.hit || meeting.exact.s - line.start > 2 * start.tMin;
        const double atStart = std::abs(shape_.distance(line.at(line.start + from)));
        if (start.side == 0) return atStart > least;
        // Two faces at once, or the tip of a cone: what is between is thinner than the start is uncertain.
        const Vec3<double> p = line.at(line.start);
        const double cosine = std::abs(dot(shape_.normal(p), line.d)),
                     thin = std::min(shape_.toEdge(p), cosine * shape_.bend(p));
        return cosine > kLeastCosine && meeting.exact.inside == (start.side < 0) &&
               thin > 1e-5 * shape_.size() + 2 * from && meeting.exact.tangency > 0x1p-21 * shape_.size();
    }

    /// As far about the hit as the ray stays at the surface.
    void bracket(Meeting& meeting, double slack) const {
        const double s = meeting.exact.s;
        const auto stays = [&](double way) {
            for (const double side : {1.0, -1.0})
                if (shape_.nearSurface(meeting.line.at(s + side * way), slack)) return true;
            return false;
        };
        double way = slack;
        for (int i = 0; i < 60 && stays(way); ++i) way *= 2;
        meeting.from = double(meeting.exact.t) - way;
        meeting.by = double(meeting.exact.t) + way;
    }

    ExactShape<double> shape_;
    double extent_;
};

/// A sphere in its anchored form. E(p) is what float32 may put its surface off at p:
/// tests/shader/large_sphere_test.cpp.
class LargeSphereObject : public ExactObject {
  public:
    LargeSphereObject(const Shape& sphere, glm::dvec3 eye)
        : ExactObject(ShapeKind::LargeSphere, kLargeSphereBounds), middle_(pointOf(sphere, "center")),
          size_(lengthOf(sphere, "radius")) {
        center_ = pointOf(sphere, "center");
        radius_ = lengthOf(sphere, "radius");
        anchor_ = middle_ + size_ * unit(Wide3(eye) - middle_);
    }

    Meeting meeting(const BatchRay& ray, const RayStart& start) const override {
        Meeting meeting;
        if (start.side > 0) return meeting;
        const Wide3 o(ray.origin), d(ray.direction), off = o - middle_;
        const long double a = dot(d, d), t = -dot(off, d) / a, gap = length(off + t * d), depth = size_ - gap;
        const long double high = length(off) - size_, half = depth > 0 ? std::sqrt(depth * (size_ + gap) / a) : 0;
        const bool inside = start.side < 0 || (start.side == 0 && high < 0);
        const long double cosine = std::abs(dot(off, d)) / length(off);
        const bool started = start.side == 0 ? std::abs(high) > off_(o) + start.tMin : cosine > kLeastCosine;
        const bool grazes = !inside && t > 0 && std::abs(depth) < off_(o + t * d);
        meeting.decided = started && !grazes;
        if (!meeting.decided) {
            meeting.from = started ? double(t - 2 * std::sqrt(off_(o + t * d) * size_)) : start.tMin;
            return meeting;
        }
        const long double wanted = inside ? t + half : t - half;
        if (depth <= 0 || wanted <= 0) return meeting;
        const Wide3 met = o + wanted * d;
        const long double slant = std::abs(dot(d, met - middle_)) / size_;
        const double room = double(ulp(double(wanted)) + off_(met) / slant);
        meeting.exact.t = wanted;
        meeting.from = double(wanted) - room;
        meeting.by = double(wanted) + room;
        return meeting;
    }

    HitErrors errors(const Meeting& meeting, const BatchHit& answer) const override {
        const double room = meeting.by - double(meeting.exact.t);
        const Wide3 p(answer.point), n(answer.normal);
        double rounding = 0; // each coordinate's half ulp, by the normal's component along it
        glm::dvec3 halves;
        for (int i = 0; i < 3; ++i) {
            halves[i] = ulp(answer.point[i]) / 2;
            rounding += halves[i] * std::abs(answer.normal[i]);
        }
        const Wide3 outward = unit(p - middle_);
        HitErrors errors;
        errors.ray = double(std::abs(answer.t - meeting.exact.t)) / room;
        errors.point = double(std::abs(length(p - middle_) - size_) / (off_(p) + rounding));
        errors.normal = double(length(n - outward) / (3e-7L + glm::length(halves) / size_));
        errors.elsewhere = !(errors.ray <= 1);
        return errors;
    }

  private:
    long double off_(const Wide3& p) const {
        const long double away = length(p - anchor_);
        return std::ldexp(away * (1 + away / (2 * size_)), -22);
    }

    Wide3 middle_, anchor_;
    long double size_;
};

/// A Mandelbulb is in it.
bool estimates(const SolidNode& node) {
    return (node.op == SolidOp::Shape && node.shape.kind == ShapeKind::Mandelbulb) ||
           std::any_of(node.of.begin(), node.of.end(), estimates);
}

/// What is marched to. `slack` is the 2^-18 of its bounding sphere that shaders/sdf/solid.glsl states.
class SolidObject : public ExactObject {
  public:
    explicit SolidObject(const Shape& solid)
        : ExactObject(ShapeKind::Solid, kSolidBounds), field_(solid.solid->root), home_(solid.home) {
        for (int i = 0; i < 3; ++i) center_[i] = inFloat(pointOf(solid, "center")[i]);
        radius_ = lengthOf(solid, "radius");
        slack_ = bounds_.band * radius_;
        estimated_ = estimates(solid.solid->root);
    }

    Meeting meeting(const BatchRay& ray, const RayStart& start) const override {
        Meeting meeting;
        meeting.line = about(ray);
        const Line<double>& line = meeting.line;
        const glm::dvec3 p = glm::dvec3(line.p.x, line.p.y, line.p.z) + home_, d(ray.direction);
        const double rounding = 0x1p-23 * std::abs(line.start), slack = slack_ + rounding;
        const double square = radius_ * radius_ - dot(line.p, line.p), half = square > 0 ? std::sqrt(square) : 0;
        double first = std::max(line.start + (estimated_ ? 0 : start.tMin), -half);
        bool started = true;
        if (start.side != 0 && !estimated_) {
            const double cosine = std::abs(glm::dot(slope(p + line.start * d), d));
            started = cosine > 0.05;
            first = line.start + 4 * slack / std::max(cosine, 0.05);
        }
        meeting.from = started ? first : line.start;
        meeting.decided = started && !estimated_;
        if (half == 0 || first >= half)
            meeting.decided = started, meeting.from = started ? Meeting::kNever : line.start;
        else if (meeting.decided)
            follow(meeting, p, d, first, half, slack, start);
        meeting.from += double(line.middle) - rounding;
        meeting.by += double(line.middle) + rounding;
        return meeting;
    }

    HitErrors errors(const Meeting& meeting, const BatchHit& answer) const override {
        HitErrors errors;
        const glm::dvec3 p = glm::dvec3(answer.point) - center_ + home_;
        const Line<double>& line = meeting.line;
        const Vec3<double> at = line.at(line.local(answer.t));
        const double ray_ = std::abs(field_.at(glm::dvec3(at.x, at.y, at.z) + home_));
        errors.ray = std::max(ray_ - 0x1p-23 * std::abs(answer.t), 0.0) / slack_;
        errors.point = std::abs(field_.at(p)) / slack_;
        errors.elsewhere = !(answer.t >= meeting.from && answer.t <= meeting.by);
        const glm::dvec3 n(answer.normal);
        if (smoothAt(p)) errors.normal = glm::degrees(std::acos(std::clamp(glm::dot(n, slope(p)), -1.0, 1.0)));
        return errors;
    }

  private:
    Line<double> about(const BatchRay& ray) const {
        const Wide3 o = Wide3(ray.origin) - Wide3(center_), d(ray.direction);
        const long double middle = -dot(o, d) / dot(d, d);
        return {Vec3<double>(o + middle * d), Vec3<double>(d), middle, double(-middle)};
    }
    void follow(Meeting& meeting, glm::dvec3 p, glm::dvec3 d, double first, double last, double slack,
                const RayStart& start) const {
        const bool begins = first > -last; // within its bounding sphere
        const double atStart = field_.at(p + first * d);
        if (begins && (std::abs(atStart) <= slack || (start.side != 0 && (atStart < 0) != (start.side < 0)))) {
            meeting.decided = false;
            meeting.from = meeting.line.start;
            return;
        }
        const Passage passage = passageInto(field_, p, d, first, last, slack);
        meeting.from = passage.from;
        meeting.by = passage.by;
        meeting.decided = passage.decided;
    }

    glm::dvec3 gradient(glm::dvec3 p) const {
        const double h = 1e-5 * radius_;
        glm::dvec3 slope;
        for (int i = 0; i < 3; ++i) {
            glm::dvec3 step(0);
            step[i] = h;
            slope[i] = (field_.at(p + step) - field_.at(p - step)) / (2 * h);
        }
        return slope;
    }
    glm::dvec3 slope(glm::dvec3 p) const {
        const glm::dvec3 slope = gradient(p);
        const double steep = glm::length(slope);
        return steep > 0 ? slope / steep : glm::dvec3(0);
    }
    /// Where the field bends within 1e-4, as about an edge of it, differences say nothing.
    bool smoothAt(glm::dvec3 p) const {
        const glm::dvec3 here = gradient(p);
        for (int i = 0; i < 6; ++i) {
            glm::dvec3 step(0);
            step[i / 2] = (i % 2 ? 1e-4 : -1e-4) * radius_;
            if (glm::distance(gradient(p + step), here) > 1e-2) return false;
        }
        return true;
    }

    SolidField field_;
    glm::dvec3 home_;
    double slack_;
    bool estimated_;
};

} // namespace

bool ExactObject::near(const BatchRay& ray) const {
    if (radius_ == Meeting::kNever) return true;
    const glm::dvec3 way = center_ - glm::dvec3(ray.origin), d(ray.direction);
    const double room = 1.001 * radius_ + 1e-6 * (std::abs(way.x) + std::abs(way.y) + std::abs(way.z));
    const double along = glm::dot(way, d);
    const glm::dvec3 across = way - along / glm::dot(d, d) * d;
    return along > -room && glm::dot(across, across) < room * room;
}

double ExactObject::entry(const BatchRay& ray, double start) const {
    if (radius_ == Meeting::kNever) return start;
    const glm::dvec3 way = center_ - glm::dvec3(ray.origin);
    return std::max(start, glm::dot(way, glm::dvec3(ray.direction)) - 1.01 * radius_);
}

std::unique_ptr<ExactObject> exactObject(const Shape& shape, ShapeKind drawn, double extent, glm::dvec3 eye) {
    if (shape.solid) return std::make_unique<SolidObject>(shape);
    if (drawn == ShapeKind::LargeSphere) return std::make_unique<LargeSphereObject>(shape, eye);
    return std::make_unique<ShapeObject>(shape, extent);
}

} // namespace gnomon::oracle
