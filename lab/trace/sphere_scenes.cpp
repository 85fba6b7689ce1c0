#include "lab/trace/sphere_scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace gnomon {
namespace {

constexpr double kCoverage = 0.5; ///< cross-sections, in faces of the cube
constexpr int kHeaps = 8;
constexpr double kHeapSize = 0.16 * kSphereCube; ///< most that one of three random steps leads along each axis

double radiusFor(int count) { return kSphereCube * std::sqrt(kCoverage / (std::numbers::pi * count)); }

/// Numbers that do not depend on the standard library, as its distributions do.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : bits_(seed) {}
    /// In [-1, 1) along each axis.
    glm::dvec3 point() {
        const double x = number(), y = number(), z = number();
        return {x, y, z};
    }

  private:
    double number() { return double(bits_() >> 11) * 0x1p-52 - 1; }
    std::mt19937_64 bits_;
};

/// Along each axis at most `limit` from the middle of the cube.
bool within(glm::dvec3 point, double limit) {
    const glm::dvec3 off = glm::abs(point);
    return std::max({off.x, off.y, off.z}) <= limit;
}

/// Spheres that neither leave the cube nor overlap, at what `propose` gives.
template<class Propose>
std::vector<glm::dvec3> placed(int count, double radius, const Propose& propose) {
    std::vector<glm::dvec3> centers;
    const auto free = [&](glm::dvec3 point) {
        return std::all_of(centers.begin(), centers.end(), [&](glm::dvec3 other) {
            return glm::dot(point - other, point - other) > 4 * radius * radius;
        });
    };
    while (int(centers.size()) < count) {
        const glm::dvec3 point = propose();
        if (within(point, 0.5 * kSphereCube - radius) && free(point)) centers.push_back(point);
    }
    return centers;
}

std::vector<glm::dvec3> clustered(int count, double radius, Dice& dice) {
    std::vector<glm::dvec3> heaps;
    for (int i = 0; i < kHeaps; ++i) { // one in each eighth of the cube, so that they stay apart
        const glm::dvec3 eighth(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        heaps.push_back(kSphereCube * (0.25 * eighth + 0.05 * dice.point()));
    }
    std::size_t next = 0;
    return placed(count, radius, [&] {
        const glm::dvec3 heap = heaps[next++ % heaps.size()];
        return heap + kHeapSize * (dice.point() + dice.point() + dice.point()) / 3.0;
    });
}

std::vector<glm::dvec3> lattice(int side) {
    std::vector<glm::dvec3> centers;
    for (int z = 0; z < side; ++z)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                centers.push_back(kSphereCube * ((glm::dvec3(x, y, z) + 0.5) / double(side) - 0.5));
    return centers;
}

std::vector<glm::dvec3> centersOf(Arrangement arrangement, int count, double radius, Dice& dice) {
    switch (arrangement) {
    case Arrangement::Random: break;
    case Arrangement::Clustered: return clustered(count, radius, dice);
    case Arrangement::Regular: return lattice(int(std::lround(std::cbrt(count))));
    }
    return placed(count, radius, [&] { return 0.5 * kSphereCube * dice.point(); });
}

std::vector<Material> materials() {
    constexpr std::array colors{glm::dvec3(0.75, 0.2, 0.15), glm::dvec3(0.8, 0.6, 0.2), glm::dvec3(0.25, 0.55, 0.3),
                                glm::dvec3(0.2, 0.4, 0.75),  glm::dvec3(0.6, 0.3, 0.6), glm::dvec3(0.8, 0.8, 0.75),
                                glm::dvec3(0.35, 0.35, 0.4)};
    std::vector<Material> all(1);
    for (const glm::dvec3 color : colors) {
        Material matte;
        matte.ambient = 0.15 * color;
        matte.diffuse = color;
        all.push_back(matte);
    }
    Material mirror;
    mirror.specular = glm::dvec3(0.8);
    mirror.shininess = 120;
    mirror.optics = Conductor{{0.14, 0.16, 0.13}, {4.1, 2.3, 3.1}}; // silver
    all.push_back(mirror);
    return all;
}

Shape sphere(glm::dvec3 center, double radius) { return makeShape(ShapeKind::Sphere, {center}, {radius}); }

/// At time 0 where it rests.
Orbit orbit(double radius, Dice& dice) { return {glm::dvec3(0), 0.5 * radius * dice.point(), 2, -1}; }

} // namespace

std::string_view nameOf(Arrangement arrangement) {
    constexpr std::array<std::string_view, kArrangements.size()> names{"random", "clustered", "regular"};
    return names[std::size_t(arrangement)];
}

int spheresIn(Arrangement arrangement, int count) {
    if (arrangement != Arrangement::Regular) return count;
    const int side = std::max(2, int(std::lround(std::cbrt(count))));
    return side * side * side;
}

Scene sphereScene(Arrangement arrangement, int count, std::uint64_t seed) {
    Scene scene;
    count = spheresIn(arrangement, count);
    scene.name = std::string(nameOf(arrangement)) + " " + std::to_string(count);
    scene.camera = {{9, 8, 24}, {0, -1, 0}, {0, 1, 0}, 30.5};
    scene.background.color = {0.35, 0.45, 0.6};
    scene.lights = {{{12, 20, 16}}};
    scene.materials = materials();
    Dice dice(seed);
    const double radius = radiusFor(count);
    for (const glm::dvec3 center : centersOf(arrangement, count, radius, dice)) {
        Object object;
        object.shape = sphere(center, radius);
        object.material = 1 + int(scene.objects.size() % (scene.materials.size() - 1));
        if (arrangement != Arrangement::Regular) object.motion = orbit(radius, dice);
        scene.objects.push_back(object);
    }
    return scene;
}

std::string sphereScenesText() {
    return "equal, apart, in a cube, cross-sections half of its face; one lamp, every eighth a mirror; "
           "regular: the nearest cube number; numbers in a texture";
}

} // namespace gnomon
