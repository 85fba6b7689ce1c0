#include "lab/reference/exact/picture.h"

#include "lab/reference/exact/fresnel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <thread>
#include <tuple>

namespace gnomon::oracle {
namespace {

using Real = long double;

Vec asInShader(glm::dvec3 v) { return Vec(glm::vec3(v)); }

/// Off the surface to the side of `normal`, by far more than rounding and far less than anything seen.
Vec startOff(const SceneHit& hit, Vec normal) {
    const Vec size = glm::abs(hit.point);
    return hit.point + 1e-12L * (std::max({size.x, size.y, size.z}) + hit.t) * normal;
}

/// Per channel the index n + ik of what lies under the surface, in the float32 that the shader gets.
std::array<std::complex<Real>, 3> indicesOf(const Material& material) {
    glm::vec3 n(1), k(0);
    if (const auto* conductor = std::get_if<Conductor>(&material.optics)) {
        n = glm::vec3(conductor->n);
        k = glm::vec3(conductor->k);
    }
    if (const auto* dielectric = std::get_if<Dielectric>(&material.optics)) n = glm::vec3(float(dielectric->ior));
    if (const auto* coat = std::get_if<Coat>(&material.optics)) n = glm::vec3(float(coat->ior));
    return {{{n.r, k.r}, {n.g, k.g}, {n.b, k.b}}};
}

/// By Schlick's approximation, which wants the cosine on the thinner side.
Real schlick(std::complex<Real> index, Real cosine) {
    const Real atNormal = std::norm((index - Real(1)) / (index + Real(1)));
    return atNormal + (1 - atNormal) * std::pow(1 - std::clamp<Real>(cosine, 0, 1), Real(5));
}

/// Of a light over its colour, by the way to it: a spot fades in a smooth step of the cosine to its axis.
double strengthOf(const Light& light, Vec way) {
    const double distance = double(glm::length(way));
    double strength = 1;
    if (light.falloff > 0) strength = std::pow(light.falloff / std::max(distance, 1e-3 * light.falloff), 2);
    if (light.kind != LightKind::Spot) return strength;
    const double cosine = -glm::dot(light.direction, glm::dvec3(way)) / distance;
    const double end = std::cos(glm::radians(light.angle)),
                 full = std::cos(glm::radians(light.angle * (1 - light.softness)));
    const double t = full > end ? std::clamp((cosine - end) / (full - end), 0.0, 1.0) : double(cosine > end);
    return strength * t * t * (3 - 2 * t);
}

double largest(glm::dvec3 v) { return std::max({v.x, v.y, v.z}); }

glm::dvec3 background(const Background& background, Vec direction) {
    if (!background.gradient) return background.color;
    const auto& [top, bottom] = *background.gradient;
    return bottom + (top - bottom) * double((1 + direction.y) / 2);
}

/// How far `color` is outside of the range, in its worst channel; at most 0 within.
double beyondRange(glm::dvec3 color, const ColorRange& range) {
    double worst = 0;
    for (int c = 0; c < 3; ++c) {
        if (std::isnan(color[c])) return std::numeric_limits<double>::infinity();
        worst = std::max({worst, range.least[c] - color[c], color[c] - range.most[c]});
    }
    return worst;
}

} // namespace

void ColorRange::widen(glm::dvec3 color) {
    least = glm::min(least, color);
    most = glm::max(most, color);
}

Picture::Picture(const Scene& scene, int width, int height, int depth)
    : scene_(scene), shapes_(exactShapesOf(scene, 0)), width_(width), height_(height), depth_(depth),
      middles_(std::size_t(width) * height) {
    for (std::size_t i = 0; i < shapes_.size(); ++i)
        if (scene.objects[i].castsShadow) casters_.push_back(shapes_[i]);
    const auto rows = [this](int from) {
        for (int y = from; y < height_; y += 2)
            for (int x = 0; x < width_; ++x) {
                Vec origin, direction;
                pixelRay(scene_.camera, x, y, width_, height_, origin, direction);
                middles_[std::size_t(y) * width_ + x] = color(origin, direction);
            }
    };
    std::thread odd(rows, 1);
    rows(0);
    odd.join();
}

ColorRange Picture::pixel(int x, int y) const {
    ColorRange range;
    for (int i = 0; i < kFine * kFine; ++i) {
        Vec origin, direction;
        pixelRay(scene_.camera, x * kFine + i % kFine, y * kFine + i / kFine, width_ * kFine, height_ * kFine, origin,
                 direction);
        const glm::dvec3 sample = color(origin, direction);
        range.widen(sample);
    }
    return range;
}

double Picture::beyond(glm::dvec3 color, int x, int y, double enough) const {
    ColorRange range{middle(x, y), middle(x, y)};
    double by = beyondRange(color, range);
    for (int i = 0; i < 18 && by > enough; ++i) {
        const int neighbour = (i + 4) % 9, atX = x + neighbour % 3 - 1, atY = y + neighbour / 3 - 1; // the pixel first
        if (i < 9) {
            const ColorRange one = pixel(atX, atY);
            range.widen(one.least);
            range.widen(one.most);
        } else {
            widenAtEdges(range, atX, atY);
        }
        by = beyondRange(color, range);
    }
    return by;
}

/// Between each subpixel of a pixel and those right of it and below bisects towards the larger change of colour.
void Picture::widenAtEdges(ColorRange& range, int x, int y) const {
    const auto ray = [&](int i, int j, Vec& origin, Vec& direction) {
        pixelRay(scene_.camera, x * kFine + i, y * kFine + j, width_ * kFine, height_ * kFine, origin, direction);
    };
    for (int i = 0; i < 2 * kFine * kFine; ++i) {
        const int column = i / 2 % kFine, row = i / 2 / kFine;
        Vec origin, from, to;
        ray(column, row, origin, from);
        ray(column + i % 2, row + 1 - i % 2, origin, to);
        glm::dvec3 before = color(origin, from), after = color(origin, to);
        for (int k = 0; k < 40; ++k) {
            const Vec between = glm::normalize(from + to);
            const glm::dvec3 sample = color(origin, between);
            range.widen(sample);
            const bool first = glm::distance(before, sample) > glm::distance(sample, after);
            (first ? to : from) = between;
            (first ? after : before) = sample;
        }
    }
}

/// Surfaces that a ray of the largest depth passes: shaders/integrator/whitted.glsl.
constexpr int kMostStraight = 16;

/// Discs and triangles of one material are the skin of one body.
int Picture::bodyOf(int object) const {
    const auto skin = [&](int i) {
        return !shapes_[std::size_t(i)].closed() && shapes_[std::size_t(i)].kind() != ShapeKind::Plane;
    };
    const auto material = [&](int i) { return scene_.objects[std::size_t(i)].material; };
    if (!skin(object)) return object;
    for (int i = 0; i < object; ++i)
        if (skin(i) && material(i) == material(object)) return i;
    return object;
}

/// By the stated priority, then the smaller by the box about it, then the first.
bool Picture::moreImportant(int body, int than) const {
    const auto rowOf = [&](int i) {
        const Shape& shape = scene_.objects[std::size_t(i)].shape;
        const auto extent = shapeRow(shape.kind).extent;
        const Extent box = extent ? extent(shape) : Extent{glm::dvec3(-1e30), glm::dvec3(1e30)};
        return std::tuple(-mediumOf({i}).priority, glm::distance(box.low, box.high), i);
    };
    return rowOf(body) < rowOf(than);
}

Picture::Bodies Picture::bodiesAt(Vec point) const {
    Bodies bodies;
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        const SceneShape& shape = shapes_[i];
        if (!scene_.materials[std::size_t(scene_.objects[i].material)].refracts()) continue;
        if (!shape.closed() && shape.kind() != ShapeKind::Plane) continue;
        if (shape.distance(Vec3<Real>(point) - shape.middle()) < 0) bodies.push_back(int(i));
    }
    return bodies;
}

/// The most important one's; air where there is none.
Dielectric Picture::mediumOf(const Bodies& bodies) const {
    if (bodies.empty()) return {.ior = 1};
    int top = bodies[0];
    for (const int body : bodies)
        if (body != top && moreImportant(body, top)) top = body;
    return std::get<Dielectric>(scene_.materials[std::size_t(scene_.objects[std::size_t(top)].material)].optics);
}

/// Behind a surface. A skin is believed before what is known of where the ray is.
Picture::Bodies Picture::beyond(const SceneHit& hit, Bodies& inside) const {
    const int body = bodyOf(hit.object);
    const auto with = [body](Bodies bodies) {
        if (std::ranges::find(bodies, body) == bodies.end()) bodies.push_back(body);
        return bodies;
    };
    const auto without = [body](Bodies bodies) {
        std::erase(bodies, body);
        return bodies;
    };
    const SceneShape& shape = shapes_[std::size_t(hit.object)];
    if (!shape.closed() && shape.kind() != ShapeKind::Plane) inside = hit.outside ? without(inside) : with(inside);
    return hit.outside ? with(inside) : without(inside);
}

glm::dvec3 Picture::color(Vec origin, Vec direction, int depth, Bodies inside, int passed) const {
    constexpr int kMostPassed = 100; // a ray that goes along a face may be stopped by its rounding again and again
    if (passed > kMostPassed) return glm::dvec3(0);
    const SceneHit hit = nearestHit(shapes_, origin, direction);
    const double travelled = hit.object < 0 ? 1e30 : double(hit.t);
    const glm::dvec3 left = glm::exp(-travelled * glm::dvec3(glm::vec3(mediumOf(inside).absorption)));
    if (hit.object < 0) return left * background(scene_.background, direction);
    const Material& material = scene_.materials[std::size_t(scene_.objects[std::size_t(hit.object)].material)];
    const auto straightOn = [&](int next, const Bodies& media) {
        return color(startOff(hit, -hit.normal), direction, next, media, passed + 1);
    };
    Bodies behind = inside;
    if (material.refracts()) {
        behind = beyond(hit, inside);
        const Dielectric here = mediumOf(inside), there = mediumOf(behind);
        const bool alike =
            !inside.empty() && !behind.empty() && here.ior == there.ior && here.absorption == there.absorption;
        if (behind.size() == inside.size() || alike) return left * straightOn(depth, behind);
    }
    const glm::dvec3 own = shade(material, hit, direction);
    if (depth < depth_) return left * (own + scattered(material, hit, direction, depth, inside, behind));
    const bool passes = material.refracts() && scene_.depthLimit == DepthLimit::Straight;
    if (!passes) return left * own;
    const bool last = depth >= depth_ + kMostStraight;
    return left * (own + (last ? background(scene_.background, direction) : straightOn(depth + 1, behind)));
}

glm::dvec3 Picture::scattered(const Material& material, const SceneHit& hit, Vec direction, int depth,
                              const Bodies& inside, const Bodies& behind) const {
    if (std::holds_alternative<std::monostate>(material.optics)) return glm::dvec3(0);
    const Real cosine = std::clamp<Real>(-glm::dot(direction, hit.normal), 0, 1);
    // Of the medium on the ray's side over that beyond, which a coat and a conductor have of their own; Schlick's form
    // of these is for air.
    const bool inMedium = material.refracts() || scene_.fresnel == Fresnel::Exact;
    const Real here = inMedium ? Real(float(mediumOf(inside).ior)) : 1;
    const Real eta = here / (material.refracts() ? Real(float(mediumOf(behind).ior)) : 1);
    glm::dvec3 sum(0), mirrored = reflectance(material, cosine, eta);
    if (material.refracts()) {
        const Real k = 1 - eta * eta * (1 - cosine * cosine); // squared cosine beyond the surface, by Snell's law
        if (k < 0) {
            mirrored = glm::dvec3(1);
        } else {
            const Vec bent = glm::normalize(eta * direction + (eta * cosine - std::sqrt(k)) * hit.normal);
            sum += (1.0 - mirrored) * color(startOff(hit, -hit.normal), bent, depth + 1, behind);
        }
    }
    const Vec back = glm::normalize(direction + 2 * cosine * hit.normal);
    return sum + mirrored * color(startOff(hit, hit.normal), back, depth + 1, inside);
}

glm::dvec3 Picture::reflectance(const Material& material, Real cosine, Real eta) const {
    if (const auto* mirror = std::get_if<Mirror>(&material.optics)) return mirror->reflectance;
    const auto indices = indicesOf(material);
    glm::dvec3 reflected(0);
    for (int c = 0; c < 3; ++c) {
        const std::complex<Real> index = material.refracts() ? 1 / eta : indices[std::size_t(c)] / eta;
        const Real squared = 1 - (1 - cosine * cosine) / std::norm(index); // of the cosine beyond, of clear media
        const bool fromThicker = material.refracts() && eta > 1;
        const Real thinner = fromThicker ? std::sqrt(std::max<Real>(squared, 0)) : cosine;
        reflected[c] =
            double(scene_.fresnel == Fresnel::Schlick ? schlick(index, thinner) : fresnelReflectance(cosine, index));
    }
    return reflected;
}

/// Blinn-Phong, each term of each light within [0, 1].
glm::dvec3 Picture::shade(const Material& material, const SceneHit& hit, Vec direction) const {
    glm::dvec3 sum = material.emission + material.ambient;
    const Vec start = startOff(hit, hit.normal);
    for (const Light& light : scene_.lights) {
        const bool parallel = light.kind == LightKind::Directional;
        const Vec way = parallel ? -Vec(light.direction) : asInShader(light.position) - hit.point;
        const Vec toLight = glm::normalize(way);
        const double cosine = double(glm::dot(hit.normal, toLight));
        if (cosine <= 0) continue;
        const double highlight = std::max(0.0, double(glm::dot(hit.normal, glm::normalize(toLight - direction))));
        const glm::dvec3 diffuse = glm::clamp(material.diffuse * cosine, 0.0, 1.0);
        const glm::dvec3 specular = glm::clamp(material.specular * std::pow(highlight, material.shininess), 0.0, 1.0);
        const glm::dvec3 most = light.color * strengthOf(light, way) * (diffuse + specular);
        const Real end = parallel ? std::numeric_limits<Real>::infinity() : glm::length(way);
        if (largest(most) > 0 && lit(start, parallel ? toLight : way + hit.point - start, end)) sum += most;
    }
    return sum;
}

bool Picture::lit(Vec start, Vec way, Real end) const {
    const SceneHit between = nearestHit(casters_, start, glm::normalize(way));
    return between.object < 0 || between.t >= end;
}

Difference compare(const FloatImage& image, const Picture& picture, double tolerance) {
    Difference difference;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const float* p = image.at(x, y);
            const glm::dvec3 color(p[0], p[1], p[2]), middle = picture.middle(x, y);
            difference.rmse += glm::dot(color - middle, color - middle);
            if (beyondRange(color, {middle, middle}) <= tolerance) continue;
            ++difference.moved;
            if (difference.outliers == Difference::kMost) continue;
            const double by = picture.beyond(color, x, y, tolerance);
            if (by <= tolerance) continue;
            ++difference.outliers;
            if (by <= difference.worst) continue;
            difference.worst = by;
            difference.worstAt = {x, y};
        }
    difference.rmse = std::sqrt(difference.rmse / (3.0 * picture.width() * picture.height()));
    return difference;
}

} // namespace gnomon::oracle
