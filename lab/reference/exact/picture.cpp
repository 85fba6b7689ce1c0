#include "lab/reference/exact/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

namespace gnomon::oracle {
namespace {

using Real = long double;

Vec asInShader(glm::dvec3 v) { return Vec(glm::vec3(v)); }

/// Off the surface to the side of `normal`, by far more than rounding and far less than anything seen.
Vec startOff(const SceneHit& hit, Vec normal) {
    const Vec size = glm::abs(hit.point);
    return hit.point + 1e-12L * (std::max({size.x, size.y, size.z}) + hit.t) * normal;
}

/// Reflectance at normal incidence of a surface with complex index n + ik.
glm::dvec3 normalReflectance(const Material& material) {
    glm::dvec3 n(1), k(0);
    if (const auto* conductor = std::get_if<Conductor>(&material.optics)) {
        n = conductor->n;
        k = conductor->k;
    }
    if (const auto* dielectric = std::get_if<Dielectric>(&material.optics)) n = glm::dvec3(dielectric->ior);
    if (const auto* coat = std::get_if<Coat>(&material.optics)) n = glm::dvec3(coat->ior);
    return ((n - 1.0) * (n - 1.0) + k * k) / ((n + 1.0) * (n + 1.0) + k * k);
}

glm::dvec3 schlick(glm::dvec3 atNormal, double cosine) {
    return atNormal + (1.0 - atNormal) * std::pow(1 - std::clamp(cosine, 0.0, 1.0), 5);
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

glm::dvec3 Picture::color(Vec origin, Vec direction, int depth) const {
    const SceneHit hit = nearestHit(shapes_, origin, direction);
    if (hit.object < 0) return background(scene_.background, direction);
    const Material& material = scene_.materials[std::size_t(scene_.objects[std::size_t(hit.object)].material)];
    glm::dvec3 sum = shade(material, hit, direction);
    if (std::holds_alternative<std::monostate>(material.optics) || depth >= depth_) return sum;

    const Real cosine = std::clamp<Real>(-glm::dot(direction, hit.normal), 0, 1);
    const glm::dvec3 atNormal = normalReflectance(material);
    glm::dvec3 mirrored = schlick(atNormal, double(cosine));
    if (const auto* dielectric = std::get_if<Dielectric>(&material.optics)) {
        const bool entering = hit.outside;
        const Real ior = float(dielectric->ior), eta = entering ? 1 / ior : ior;
        const Real k = 1 - eta * eta * (1 - cosine * cosine); // squared cosine beyond the surface, by Snell's law
        if (k < 0) {
            mirrored = glm::dvec3(1);
        } else {
            if (!entering) mirrored = schlick(atNormal, double(std::sqrt(k)));
            const Vec bent = glm::normalize(eta * direction + (eta * cosine - std::sqrt(k)) * hit.normal);
            sum += (1.0 - mirrored) * color(startOff(hit, -hit.normal), bent, depth + 1);
        }
    }
    const Vec back = glm::normalize(direction + 2 * cosine * hit.normal);
    return sum + mirrored * color(startOff(hit, hit.normal), back, depth + 1);
}

/// Blinn-Phong, each term of each light within [0, 1].
glm::dvec3 Picture::shade(const Material& material, const SceneHit& hit, Vec direction) const {
    glm::dvec3 sum = material.emission + material.ambient;
    const Vec start = startOff(hit, hit.normal);
    for (const Light& light : scene_.lights) {
        const Vec position = asInShader(light.position);
        const Vec toLight = glm::normalize(position - hit.point);
        const double cosine = double(glm::dot(hit.normal, toLight));
        if (cosine <= 0) continue;
        const double highlight = std::max(0.0, double(glm::dot(hit.normal, glm::normalize(toLight - direction))));
        const glm::dvec3 diffuse = glm::clamp(material.diffuse * cosine, 0.0, 1.0);
        const glm::dvec3 specular = glm::clamp(material.specular * std::pow(highlight, material.shininess), 0.0, 1.0);
        const glm::dvec3 most = light.color * (diffuse + specular);
        if (largest(most) > 0 && lit(start, position)) sum += most;
    }
    return sum;
}

bool Picture::lit(Vec start, Vec light) const {
    const SceneHit between = nearestHit(casters_, start, glm::normalize(light - start));
    return between.object < 0 || between.t >= glm::length(light - start);
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
