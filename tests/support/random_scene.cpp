#include "tests/support/random_scene.h"

#include "tests/support/clouds.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <initializer_list>
#include <vector>

namespace gnomon::test {
namespace {

using Json = nlohmann::json;
using Text = std::string;

class Choices : public Dice {
  public:
    using Dice::Dice;
    bool chance(double probability) { return number(0, 1) < probability; }
    int whole(int low, int high) { return low + int(number(0, high - low + 1)); }
    Text one(std::initializer_list<const char*> of) { return of.begin()[whole(0, int(of.size()) - 1)]; }
};

/// Of what there is `form` decides, and where and how large it is `value`: only the first tells in shader source.
class RandomScene {
  public:
    RandomScene(std::uint64_t seed, Variety variety)
        : variety_(variety), form_(2 * (seed / kFamily) + 1), value_(2 * seed) {}

    Json make() {
        const int materials = form_.whole(1, 5);
        Json scene{{"background", background()}, {"camera", camera()}, {"objects", Json::array()}};
        for (int i = 0; i < materials; ++i) scene["materials"][materialName(i)] = material();
        for (int i = form_.whole(0, 3); i > 0; --i) scene["lights"].push_back(light());

        std::vector<Json> shapes;
        addShapes(shapes);
        addSolids(shapes);
        if (variety_ == Variety::Full) addTransformed(shapes, scene);
        for (const Json& shape : shapes) scene["objects"].push_back(object(shape, materials));
        return scene;
    }

  private:
    static constexpr double kReach = 2; ///< of what is near the origin

    // --- values

    /// Numbers that several objects have: their faces, middles and rims then lie in one place.
    double snapped(double x) { return value_.chance(0.4) ? 0.25 * std::round(4 * x) : x; }
    double length(double low, double high) { return std::max(low, snapped(value_.number(low, high))); }
    Json vector(glm::dvec3 v) { return {v.x, v.y, v.z}; }
    Json point(double reach) {
        const glm::dvec3 at = value_.point(reach);
        return {snapped(at.x), snapped(at.y), snapped(at.z)};
    }
    Json direction() {
        if (value_.chance(0.3)) {
            Json axis{0, 0, 0};
            axis[std::size_t(value_.whole(0, 2))] = value_.chance(0.5) ? 1 : -1;
            return axis;
        }
        return vector(value_.point(1) + glm::dvec3(1e-3));
    }
    Json color(double high) { return {value_.number(0, high), value_.number(0, high), value_.number(0, high)}; }
    /// Far enough from `from` for a cone or a triangle.
    Json away(const Json& from, double least, double most) {
        Json to = from;
        const auto axis = std::size_t(value_.whole(0, 2));
        for (std::size_t i = 0; i < 3; ++i)
            to[i] = from[i].get<double>() + (i == axis            ? length(least, most)
                                             : value_.chance(0.5) ? 0
                                                                  : value_.number(-0.5, 0.5) * least);
        return to;
    }

    // --- shapes

    Json shape(const Text& kind, double reach, double size) {
        const Json at = point(reach);
        if (kind == "sphere") return {{kind, {{"center", at}, {"radius", length(0.1 * size, size)}}}};
        if (kind == "plane")
            return {{kind, {{"point", {0, snapped(value_.number(-2, -0.5)), 0}}, {"normal", upwards()}}}};
        if (kind == "disc")
            return {{kind, {{"center", at}, {"normal", direction()}, {"radius", length(0.1 * size, 2 * size)}}}};
        if (kind == "triangle") {
            const Json second = away(at, 0.2 * size, 2 * size);
            Json third = at;
            for (std::size_t i = 0; i < 3; ++i) // across the first edge
                third[i] = at[i].get<double>() + (second[(i + 1) % 3].get<double>() - at[(i + 1) % 3].get<double>()) +
                           value_.number(0, 0.2 * size);
            return {{kind, {{"vertices", {at, second, third}}}}};
        }
        if (kind == "torus") {
            const double major = length(0.2 * size, size);
            return {{kind,
                     {{"center", at},
                      {"axis", direction()},
                      {"major_radius", major},
                      {"minor_radius", major * value_.number(0.05, 0.9)}}}};
        }
        if (kind == "box")
            return {
                {kind,
                 {{"center", at},
                  {"half_size", {length(0.05 * size, size), length(0.05 * size, size), length(0.05 * size, size)}}}}};
        return {{kind,
                 {{"from", at}, {"to", away(at, 0.2 * size, 1.5 * size)}, {"radius", length(0.1 * size, 0.6 * size)}}}};
    }

    Json upwards() { return value_.chance(0.7) ? Json{0, 1, 0} : vector(value_.point(0.3) + glm::dvec3(0, 1, 0)); }

    /// Some kinds, a few or many of each; of one kind perhaps a lattice; perhaps ground, of one sort or the other.
    void addShapes(std::vector<Json>& shapes) {
        for (int kinds = form_.whole(1, 4); kinds > 0; --kinds) {
            const Text kind =
                form_.one({"sphere", "sphere", "disc", "triangle", "torus", "box", "cylinder", "capsule", "cone"});
            const int count = form_.chance(0.2) ? form_.whole(20, 60) : form_.whole(1, 6);
            const double size = count > 6 ? 0.3 : 0.9;
            const std::size_t first = shapes.size();
            for (int i = 0; i < count; ++i)
                shapes.push_back(i > 0 && value_.chance(0.15) // one that is there, once more
                                     ? shapes[first + std::size_t(value_.whole(0, i - 1))]
                                     : shape(kind, kReach, size));
        }
        if (form_.chance(0.15)) addLattice(shapes);
        if (form_.chance(0.3)) shapes.push_back(shape("plane", 0, 0));
        if (form_.chance(0.15)) {
            const double radius = std::pow(10, value_.number(3, 5.5));
            shapes.push_back({{"sphere", {{"center", {value_.number(-9, 9), -radius - 1, 0}}, {"radius", radius}}}});
        }
    }

    void addLattice(std::vector<Json>& shapes) {
        const Text kind = form_.one({"sphere", "box"});
        const int side = form_.whole(2, 4);
        const Json one = shape(kind, 1, 0.2);
        const glm::dvec3 step(length(0.25, 1), length(0.25, 1), length(0.25, 1));
        for (int i = 0; i < side * side * side; ++i) {
            Json copy = one;
            const int cell[3]{i % side, i / side % side, i / side / side};
            for (int axis = 0; axis < 3; ++axis) {
                Json& at = copy[kind]["center"][std::size_t(axis)];
                at = at.get<double>() + cell[axis] * step[axis];
            }
            shapes.push_back(copy);
        }
    }

    // --- what is scaled, rotated and placed

    Json angles() { return {value_.number(5, 85), value_.number(-170, 170), value_.number(-170, 170)}; }
    Json radii(double size) {
        return {value_.number(0.1, 0.5) * size, value_.number(0.51, 0.8) * size, value_.number(0.81, 1) * size};
    }

    void addTransformed(std::vector<Json>& shapes, Json& scene) {
        for (int i = form_.whole(0, 5); i > 0; --i)
            shapes.push_back({{"ellipsoid", {{"center", point(kReach)}, {"radii", radii(0.9)}, {"rotate", angles()}}}});
        for (int i = form_.whole(0, 5); i > 0; --i)
            shapes.push_back({{"box", {{"center", point(kReach)}, {"half_size", radii(0.7)}, {"rotate", angles()}}}});
        if (form_.chance(0.5)) shapes.push_back(transformed({"group", {{"of", grouped(2)}}}, 1));
        if (!form_.chance(0.4)) return;
        scene["definitions"]["defined"] = {{"group", {{"of", grouped(1)}}}};
        for (int i = form_.whole(1, 3); i > 0; --i)
            shapes.push_back(transformed({"instance", {{"of", "defined"}}}, 0.6));
    }

    /// `made`: {key, fields}. Scaled evenly, as all shapes can be.
    Json transformed(std::pair<Text, Json> made, double size) {
        made.second["scale"] = value_.number(0.4, 1) * size;
        made.second["rotate"] = angles();
        made.second["translate"] = point(kReach);
        return {{made.first, made.second}};
    }

    Json grouped(int level) {
        Json of = Json::array();
        for (int i = form_.whole(1, 3); i > 0; --i)
            of.push_back(shape(form_.one({"sphere", "disc", "triangle", "torus", "box", "cylinder", "cone"}), 1, 0.9));
        if (form_.chance(0.6)) of.push_back({{"mesh", {{"file", "dented.obj"}, {"smooth", form_.chance(0.5)}}}});
        if (form_.chance(0.5)) // spheres become ellipsoids
            of.push_back(
                {{"group", {{"of", {shape("sphere", 0.5, 0.9), shape("sphere", 0.5, 0.5)}}, {"scale", radii(1)}}}});
        if (level > 1) of.push_back(transformed({"group", {{"of", grouped(level - 1)}}}, 0.7));
        return of;
    }

    // --- solids

    void addSolids(std::vector<Json>& shapes) {
        if (!form_.chance(0.4)) return;
        for (int forms = form_.chance(0.3) ? 2 : 1; forms > 0; --forms) {
            const Choices as = form_;
            const int copies = form_.whole(1, 3);
            Choices after = form_;
            for (int i = 0; i < copies; ++i) {
                form_ = as; // all have one form
                const Json part = form_.chance(0.1) ? mandelbulb() : solid(form_.whole(1, 3));
                after = form_;
                const bool again = i > 0 && value_.chance(0.3);
                shapes.push_back(again ? shapes.back()
                                       : Json{{"transform", {{"of", part}, {"translate", point(kReach)}}}});
            }
            form_ = after;
        }
    }

    Json mandelbulb() {
        return {{"mandelbulb", {{"center", {0, 0, 0}}, {"radius", length(0.5, 1)}, {"power", 8}, {"iterations", 4}}}};
    }

    Json part(int level) {
        if (level > 0 && form_.chance(0.5)) return solid(level);
        return shape(form_.one({"sphere", "box", "cylinder", "capsule", "cone", "torus"}), 0.5, 0.6);
    }

    Json parts(int level, int count) {
        Json all = Json::array();
        for (int i = 0; i < count; ++i) all.push_back(part(level - 1));
        if (value_.chance(0.1)) all.back() = all.front().size() == all.back().size() ? all.back() : all.front();
        return all;
    }

    Json solid(int level) {
        const Text operation = form_.one(
            {"union", "intersection", "difference", "difference", "smooth_union", "offset", "transform", "repetition"});
        if (operation == "offset") return {{operation, {{"of", part(level - 1)}, {"by", value_.number(-0.03, 0.15)}}}};
        if (operation == "transform")
            return {{operation,
                     {{"of", part(level - 1)},
                      {"rotate", {angle(), angle(), angle()}},
                      {"scale", value_.number(0.5, 1.5)},
                      {"translate", point(0.3)}}}};
        if (operation == "repetition")
            return {{operation,
                     {{"of", part(level - 1)},
                      {"period", {length(1, 2), length(1, 2), length(1, 2)}},
                      {"count", {form_.whole(1, 3), 1, form_.whole(1, 2)}}}}};
        Json made{{operation, parts(level, form_.whole(2, level > 1 ? 2 : 3))}}; // compiling takes long of many
        if (operation == "smooth_union") made["blend"] = value_.number(0.05, 0.5);
        return made;
    }

    double angle() { return value_.chance(0.4) ? 45 * value_.whole(-4, 4) : value_.number(-180, 180); }

    // --- what they look like

    static Text materialName(int i) { return "m" + std::to_string(i); }

    Json material() {
        Json made{{"ambient", value_.number(0, 0.3)},
                  {"diffuse", color(1)},
                  {"specular", value_.number(0, 1)},
                  {"shininess", value_.number(1, 100)}};
        if (form_.chance(0.15)) made["emission"] = color(0.5);
        const bool painted = form_.chance(0.2);
        if (painted) made["texture"] = {{"image", "paint"}, {"scale", value_.number(0.5, 4)}, {"scroll", {0.1, 0}}};
        if (form_.chance(0.15)) made["normal_map"] = {{"image", "bumps"}, {"scale", value_.number(0.5, 4)}};
        const Text optics = form_.one({"none", "none", "conductor", "dielectric", "dielectric", "coat"});
        if (optics == "conductor") made[optics] = {{"n", color(3)}, {"k", color(5)}};
        if (optics == "dielectric") made[optics] = {{"ior", value_.number(1, 2.5)}};
        if (optics == "coat") {
            made[optics] = {{"ior", value_.number(1.1, 2)}};
            if (painted && form_.chance(0.5)) made[optics]["mask"] = "mask";
        }
        return made;
    }

    Json object(Json made, int materials) {
        // How often a ray passes a Mandelbulb of glass seems to hang on single roundings of its estimate: one pixel in
        // 6656 scenes differed between two programs on llvmpipe, none with the same GLSL on softpipe.
        const bool dust = made.dump().find("mandelbulb") != std::string::npos;
        if (form_.chance(0.9) && !dust) made["material"] = materialName(form_.whole(0, materials - 1));
        if (form_.chance(0.15)) made["casts_shadow"] = false;
        if (form_.chance(0.2))
            made["motion"]["orbit"] = {{"cos", point(0.5)}, {"sin", point(0.5)}, {"rate", value_.number(-3, 3)}};
        if (form_.chance(0.15) && made.contains("sphere") && made["sphere"]["radius"] < 10)
            made["glow"] = {{"color", color(1)}, {"strength", value_.number(0.01, 0.5)}, {"softness", 0.5}};
        return made;
    }

    Json background() {
        if (form_.chance(0.2)) return {{"cubemap", "sky"}};
        return {{"color", color(1)}};
    }

    Json light() {
        Json made = form_.chance(0.7) ? Json{{"point", {{"position", point(6)}}}}
                                      : Json{{"sphere", {{"center", point(6)}, {"radius", value_.number(0.1, 1)}}}};
        made["color"] = color(1.5);
        return made;
    }

    /// From among the objects, from outside, or through a long lens.
    Json camera() {
        const double far = value_.chance(0.25) ? value_.number(0.1, 1) : value_.chance(0.8) ? value_.number(4, 9) : 400;
        glm::dvec3 eye = glm::normalize(value_.point(1) + glm::dvec3(0, 0.3, 1e-3)) * far;
        eye.y = std::max(eye.y, -0.4);
        return {{"eye", vector(eye)},
                {"target", vector(value_.point(0.5))},
                {"fov", far > 100 ? 1 : value_.number(25, 100)}};
    }

    Variety variety_;
    Choices form_, value_;
};

} // namespace

std::string randomScene(std::uint64_t seed, Variety variety) { return RandomScene(seed, variety).make().dump(1); }

std::string randomMesh(std::uint64_t seed) {
    constexpr int kAround = 8, kRings = 3; // and a pole at either end
    Dice dice(seed);
    std::string vertices, faces;
    const auto add = [&](glm::dvec3 p) {
        p *= dice.number(0.7, 1);
        vertices += "v " + std::to_string(p.x) + ' ' + std::to_string(p.y) + ' ' + std::to_string(p.z) + '\n';
    };
    const auto face = [&](int a, int b, int c) {
        faces += "f " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n';
    };
    for (int ring = 1; ring <= kRings; ++ring)
        for (int i = 0; i < kAround; ++i) {
            const double down = 3.14159265 * ring / (kRings + 1), around = 2 * 3.14159265 * i / kAround;
            add({std::sin(down) * std::sin(around), std::cos(down), std::sin(down) * std::cos(around)});
        }
    add({0, 1, 0});
    add({0, -1, 0});
    const int north = kRings * kAround + 1, south = north + 1;
    for (int i = 0; i < kAround; ++i) {
        const int next = (i + 1) % kAround;
        face(north, 1 + i, 1 + next);
        face(south, north - kAround + next, north - kAround + i);
        for (int ring = 0; ring + 1 < kRings; ++ring) {
            const int above = 1 + ring * kAround, below = above + kAround;
            face(above + i, below + i, below + next);
            face(above + i, below + next, above + next);
        }
    }
    return vertices + faces;
}

Settings randomSettings(std::uint64_t seed) {
    Choices choices(seed / kFamily);
    Settings settings;
    settings.depth = choices.whole(1, 5);
    settings.shadows = choices.chance(0.7) ? ShadowModel::Hard : ShadowModel::Off;
    settings.march = March(choices.whole(int(March::Steps), int(March::Relaxed)));
    settings.time = choices.number(0, 9);
    return settings;
}

Image noise(const std::string& name, int side) {
    Image image{side, side, {}};
    std::uint32_t state = 1;
    for (const char letter : name) state = 31 * state + std::uint32_t(letter);
    for (int i = 0; i < 4 * image.width * image.height; ++i) {
        state = 1664525 * state + 1013904223;
        image.rgba.push_back(i % 4 == 3 ? 255 : std::uint8_t(state >> 24));
    }
    return image;
}

} // namespace gnomon::test
