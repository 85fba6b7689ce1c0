/// Rays for a GL that only a browser reaches, and the comparison of what it answers with the oracle.
///
///   ray_corpus ask FOLDER RAYS    per body and placing N.json, a scene, and N.rays: RAYS a class of rays and distance
///   ray_corpus compare FOLDER       N.answers against the oracle; exit 1 where a bound does not hold
/// A ray is 8 float32 (origin, side, direction, tMin), an answer 8 (object, t, point, normal): as traceRays() has them.

#include "lab/intersect/compare_hit.h"
#include "lab/intersect/subjects.h"
#include "tracer/scene/read_scene.h"
#include "tracer/scene/rotation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace gnomon::oracle {
namespace {

using Path = std::filesystem::path;

/// A body as it is placed for some classes of rays.
struct Set {
    const Subject* subject;
    std::vector<RayClass> classes;
    std::vector<double> distances;
};

std::vector<Set> allSets() {
    std::vector<Set> sets;
    for (const Subject& subject : subjects()) {
        Set placed{&subject, {}, {3, 100, 10000}};
        for (const RayClass kind : kRayClasses)
            if (fits(kind, subject) && kind != RayClass::Inside && kind != RayClass::Axis)
                placed.classes.push_back(kind);
        sets.push_back(placed);
        sets.push_back({&subject, {RayClass::Axis}, {3, 100, 10000}});
        if (fits(RayClass::Inside, subject)) sets.push_back({&subject, {RayClass::Inside}, {1000}});
    }
    return sets;
}

/// A float32, to the last bit.
std::string number(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", x);
    return text;
}

std::string vector(const double* v) { return "[" + number(v[0]) + ", " + number(v[1]) + ", " + number(v[2]) + "]"; }

/// About x, then y, then z, as scene files tell a rotation.
glm::dvec3 degreesOf(const glm::dmat3& axes) {
    return glm::degrees(glm::dvec3(std::atan2(axes[1].z, axes[2].z), std::asin(std::clamp(-axes[0].z, -1.0, 1.0)),
                                   std::atan2(axes[0].y, axes[0].x)));
}

std::string sceneText(const Shape& shape) {
    std::string fields;
    for (const ShapeField& field : shapeRow(shape.kind).fields) {
        const double* values = &shape.values[std::size_t(field.at)];
        std::string value = vectorCount(field.type) > 0 ? vector(values) : number(*values);
        if (field.type == FieldType::Rotation) {
            const glm::dvec3 degrees = degreesOf(axesOf(pointOf(shape, field.key)));
            value = vector(&degrees.x);
        }
        if (field.type == FieldType::Vertices)
            value = "[" + value + ", " + vector(values + 3) + ", " + vector(values + 6) + "]";
        fields += (fields.empty() ? "\"" : ", \"") + std::string(field.key) + "\": " + value;
    }
    const ShapeKind written = shape.kind == ShapeKind::RotatedBox ? ShapeKind::Box : shape.kind;
    return "{\"objects\": [{\"" + std::string(shapeRow(written).key) + "\": {" + fields + "}}]}\n";
}

/// The shape as a reader of the scene file has it: a direction is made unit anew there.
Shape shapeIn(const Path& file) {
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    Problems problems;
    const auto scene = readScene(text, file.string(), problems);
    if (!scene) std::fprintf(stderr, "ray_corpus: error: %s\n", toString(problems).c_str());
    return scene ? scene->objects.at(0).shape : Shape{};
}

std::vector<BatchRay> raysOf(const Set& set, const Shape& shape, int each) {
    std::vector<BatchRay> rays;
    for (const RayClass kind : set.classes)
        for (const double distance : set.distances) {
            RayStream stream(shape, kind, distance, 11);
            for (int i = 0; i < each; ++i) rays.push_back(stream.next());
        }
    return rays;
}

int ask(const Path& folder, int each) {
    const std::vector<Set> sets = allSets();
    for (std::size_t i = 0; i < sets.size(); ++i) {
        const Path name = folder / std::to_string(i);
        const RayClass placing = sets[i].classes.front();
        std::ofstream(name.string() + ".json")
            << sceneText(placed(*sets[i].subject, placing, sets[i].distances.front()));
        std::ofstream out(name.string() + ".rays", std::ios::binary);
        for (const BatchRay& ray : raysOf(sets[i], shapeIn(name.string() + ".json"), each)) {
            const float numbers[] = {ray.origin.x,    ray.origin.y,    ray.origin.z,    ray.side,
                                     ray.direction.x, ray.direction.y, ray.direction.z, ray.tMin};
            out.write(reinterpret_cast<const char*>(numbers), sizeof numbers);
        }
        if (!out.flush()) return std::fprintf(stderr, "ray_corpus: error: cannot write %s\n", name.c_str()), 1;
    }
    std::printf("%zu\n", sets.size());
    return 0;
}

template<class Entry>
std::vector<Entry> readAll(const Path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    std::vector<Entry> entries(bytes.size() / sizeof(Entry));
    std::memcpy(entries.data(), bytes.data(), entries.size() * sizeof(Entry));
    return entries;
}

/// What is no small whole number is an object that no scene has.
int objectIn(float n) { return n >= -1 && n < 1000 && n == std::floor(n) ? int(n) : 1000; }

bool compareSet(const Set& set, const Path& name) {
    using Eight = std::array<float, 8>;
    const Shape shape = shapeIn(name.string() + ".json");
    std::vector<BatchRay> rays;
    for (const Eight& n : readAll<Eight>(name.string() + ".rays"))
        rays.push_back({{n[0], n[1], n[2]}, n[3], {n[4], n[5], n[6]}, n[7]});
    std::vector<BatchHit> answers;
    for (const Eight& n : readAll<Eight>(name.string() + ".answers"))
        answers.push_back({objectIn(n[0]), n[1], {n[2], n[3], n[4]}, {n[5], n[6], n[7]}});
    if (rays.empty() || answers.size() != rays.size())
        return std::printf("%s: %zu answers for %zu rays\n", name.c_str(), answers.size(), rays.size()), false;
    const Tally tally = compareHits(shape, rays, answers);
    double needed = 0; // decided
    for (const RayClass kind : set.classes)
        for (const double distance : set.distances)
            needed += leastDecided(kind, shape.kind, distance) * double(rays.size()) /
                      double(set.classes.size() * set.distances.size());
    const bool holds = within(tally, boundsOf(shape.kind)) && double(tally.decided) >= needed && tally.hits > 0;
    std::printf("%-13s %-8s %6zu rays, %6zu decided: %zu wrong; ray %.2f ulp, point %.2f, normal %.2f roundings%s\n",
                set.subject->name().c_str(), std::string(nameOf(set.classes.front())).c_str(), rays.size(),
                std::size_t(tally.decided), std::size_t(tally.wrong()), tally.ray.worst, tally.point.worst,
                tally.normal.worst, holds ? "" : "  OUT OF BOUNDS");
    return holds;
}

int compareFolder(const Path& folder) {
    const std::vector<Set> sets = allSets();
    bool holds = true;
    for (std::size_t i = 0; i < sets.size(); ++i) holds &= compareSet(sets[i], folder / std::to_string(i));
    return holds ? 0 : 1;
}

} // namespace
} // namespace gnomon::oracle

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "";
    if (what == "ask" && argc == 4) return gnomon::oracle::ask(argv[2], std::atoi(argv[3]));
    if (what == "compare" && argc == 3) return gnomon::oracle::compareFolder(argv[2]);
    std::fprintf(stderr, "usage: ray_corpus ask FOLDER RAYS | ray_corpus compare FOLDER\n");
    return 2;
}
