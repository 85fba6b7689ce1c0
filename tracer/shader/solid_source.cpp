#include "tracer/shader/solid_source.h"

#include "tracer/plan/shape_texels.h"
#include "tracer/plan/solid_texels.h"

#include <algorithm>
#include <set>

namespace gnomon {
namespace {

std::string_view joinOf(SolidOp op) {
    switch (op) {
    case SolidOp::Union: return "unite";
    case SolidOp::Intersection: return "intersect";
    case SolidOp::Difference: return "subtract";
    default: return "melt";
    }
}

/// Writes the code of a tree: variables p0, p1, … for points and d0, d1, … for distances with their gradients.
class Writer {
  public:
    /// The variable that holds what the node is at `point`.
    std::string write(const SolidNode& node, const std::string& point) {
        const int own = texel_;
        texel_ += ownTexels(node);
        const std::string distance = "d" + std::to_string(next_++);
        switch (node.op) {
        case SolidOp::Shape: writeShape(node, own, point, distance); break;
        case SolidOp::Offset:
            line("vec4 " + distance + " = " + write(node.of[0], point) + ";");
            line(distance + ".w -= " + texel(own) + ".x;");
            break;
        case SolidOp::Transform: writeTransform(node, own, point, distance); break;
        case SolidOp::Repetition: writeCopies(node, own, point, distance); break;
        default: writeMany(node, own, point, distance); break;
        }
        return distance;
    }

    const std::string& code() const { return code_; }

  private:
    static std::string texel(int i) { return "sceneTexel(at + " + std::to_string(i) + ")"; }
    void line(const std::string& text) { code_ += "    " + text + "\n"; }

    void writeShape(const SolidNode& node, int own, const std::string& point, const std::string& distance) {
        const std::string type = glslTypeOf(node.shape.kind), shape = "s" + distance.substr(1);
        line(type + " " + shape + " = load" + type + "(at + " + std::to_string(own) + ");");
        // A plane's normal points away from the half space that it is here.
        const bool plane = node.shape.kind == ShapeKind::Plane;
        const std::string from = plane ? shape + ".point + " + shape + ".normal" : "vec3(0.0)";
        line("vec4 " + distance + " = distance" + type + "(" + shape + ", " + point + ", " + from + ");");
    }

    void writeMany(const SolidNode& node, int own, const std::string& point, const std::string& distance) {
        std::string all = write(node.of[0], point);
        for (std::size_t i = 1; i < node.of.size(); ++i) {
            const std::string part = write(node.of[i], point);
            const std::string bend = node.op == SolidOp::SmoothUnion ? ", " + texel(own) + ".x" : "";
            line(all + " = " + std::string(joinOf(node.op)) + "(" + all + ", " + part + bend + ");");
        }
        line("vec4 " + distance + " = " + all + ";");
    }

    void writeTransform(const SolidNode& node, int own, const std::string& point, const std::string& distance) {
        const std::string inner = "p" + distance.substr(1);
        line("vec3 " + inner + " = unplaced(" + point + ", " + texel(own) + ", " + texel(own + 1) + ");");
        line("vec4 " + distance + " = placed(" + write(node.of[0], inner) + ", " + texel(own) + ", " + texel(own + 1) +
             ".w);");
    }

    /// The copies that a point may be nearest to.
    void writeCopies(const SolidNode& node, int own, const std::string& point, const std::string& distance) {
        const std::string inner = "p" + distance.substr(1), copy = "i" + distance.substr(1);
        const glm::ivec3 window = copiesAbout(node);
        const std::string x = std::to_string(window.x), y = std::to_string(window.y), z = std::to_string(window.z);
        line("vec4 " + distance + " = kNothing;");
        line("for (int " + copy + " = 0; " + copy + " < " + x + " * " + y + " * " + z + "; ++" + copy + ") {");
        line("vec3 " + inner + " = inCopy(" + point + " - " + texel(own + 2) + ".xyz, " + texel(own) + ".xyz, " +
             texel(own + 1) + ".xyz, vec3(" + x + ", " + y + ", " + z + "), vec3(" + copy + " % " + x + ", " + copy +
             " / " + x + " % " + y + ", " + copy + " / (" + x + " * " + y + ")));");
        const std::string part = write(node.of[0], inner);
        line(distance + " = unite(" + distance + ", " + part + ");");
        line("}");
    }

    int texel_ = 1, next_ = 0;
    std::string code_;
};

void collectKinds(const SolidNode& node, std::set<ShapeKind>& kinds) {
    if (node.op == SolidOp::Shape) kinds.insert(node.shape.kind);
    for (const SolidNode& part : node.of) collectKinds(part, kinds);
}

} // namespace

bool estimated(const Solid& solid) {
    std::set<ShapeKind> kinds;
    collectKinds(solid.root, kinds);
    return kinds.contains(ShapeKind::Mandelbulb);
}

std::string solidSource(const Solid& solid, const std::string& type) {
    std::set<ShapeKind> kinds;
    collectKinds(solid.root, kinds);
    std::string text = "#include \"sdf/operators.glsl\"\n";
    for (const ShapeKind kind : kinds) text += "#include \"primitive/" + std::string(shapeRow(kind).key) + ".glsl\"\n";
    Writer writer;
    const std::string root = writer.write(solid.root, "p");
    return text + "vec4 field" + type + "(int at, vec3 p) {\n" + writer.code() + "    return " + root + ";\n}\n";
}

} // namespace gnomon
