#include "tracer/shader/shader_builder.h"

#include "tracer/plan/shape_texels.h"
#include "tracer/shader/condition.h"
#include "tracer/shader/library.h"
#include "tracer/shader/scene_constants.h"
#include "tracer/shader/solid_source.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <charconv>
#include <map>
#include <utility>

namespace gnomon {
namespace {

std::atomic<int> built = 0;

/// What the directives of the library can ask about.
struct Names {
    std::map<std::string, int, std::less<>> values;
    std::map<std::string, std::vector<std::string>, std::less<>> lists;
};

/// `LargeSphere` as `large_sphere` or `LARGE_SPHERE`.
std::string mapped(std::string_view text, int (*change)(int)) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto isUpper = [&](std::size_t at) { return std::isupper(static_cast<unsigned char>(text[at])) != 0; };
        if (i > 0 && isUpper(i) && !isUpper(i - 1) && text[i - 1] != '_') out += '_';
        out += char(change(static_cast<unsigned char>(text[i])));
    }
    return out;
}

/// How rays find the objects of a kind.
void addSearch(const KindCount& kind, Names& names) {
    const std::string type = mapped(kind.type(), std::toupper);
    const bool block = kind.latticeMembers() > 0, searched = block || kind.search != Search::Loop;
    names.values[type + "_SEARCH"] = int(kind.search);
    names.values[type + "_SEARCHED"] = searched;
    names.values[type + "_ALONE"] = kind.count == 1;
    names.values[type + "_LATTICE"] = block;
    names.values["SEARCHES"] |= int(searched);
    names.values["LATTICES"] |= int(block);
    names.values["UNIFORM_GRIDS"] |= int(kind.search == Search::Grid);
    names.values["HIERARCHIES"] |= int(kind.search == Search::Hierarchy);
    constexpr int kPart = 4; // balls that GPUs may hold at once
    names.lists[type + "_SPHERE_MASK"];
    for (int i = 0; i < kind.loose() && kind.search == Search::SphereMask; ++i) {
        const std::string part = std::to_string(i / kPart);
        if (i % kPart == 0) names.lists[type + "_SPHERE_MASK"].push_back(part);
        names.lists[type + "_SPHERE_MASK_" + part].push_back(std::to_string(i));
    }
}

/// What is known of a kind's shape, and what its casters ask of the shadow models.
void addShape(const KindCount& kind, Names& names) {
    const std::string type = mapped(kind.type(), std::toupper);
    const bool estimates = kind.solid && estimated(*kind.solid);
    names.values[type + "_IMAGES"] = kind.images;
    names.values["TRIANGLES"] |= int(kind.kind == ShapeKind::Triangle);
    names.values[type + "_CONVEX"] = shapeRow(kind.kind).convex;
    names.values[type + "_BOUNDED"] = shapeRow(kind.kind).extent != nullptr;
    names.values[type + "_SOLID"] = kind.solid != nullptr;
    names.values[type + "_ESTIMATED"] = estimates;
    names.values["ESTIMATED_CASTERS"] |= int(kind.casters > 0 && estimates);
    names.values["MARCHED_CASTERS"] |= int(kind.casters > 0 && kind.solid && !estimates);
}

/// How distances find the object of a kind that is nearest to a point. Boxes leave out nothing where a shape's distance
/// is exact: an estimate may be less than that of the box about it.
void addNearest(const KindCount& kind, Names& names) {
    const std::string type = mapped(kind.type(), std::toupper);
    const bool lattice = kind.latticeMembers() > 0, spheres = lattice && kind.kind == ShapeKind::Sphere;
    const bool exact = !kind.solid && kind.kind != ShapeKind::Mandelbulb;
    const bool nearby = kind.search == Search::Hierarchy && exact && (spheres || !lattice);
    names.values[type + "_SPHERE_LATTICE"] = spheres;
    names.values[type + "_NEARBY"] = nearby;
    names.values["SPHERE_LATTICES"] |= int(spheres && kind.casters > 0);
    names.values["NEARBY"] |= int(nearby && kind.casters > 0);
}

Names namesOf(const Plan& plan) {
    const SceneFeatures& f = plan.scene;
    Names names;
    names.values = {
        {"REFLECTION", f.reflection},
        {"REFRACTION", f.refraction},
        {"COATS", f.coats},
        {"PAINTS", f.paints},
        {"NORMAL_MAPS", f.normalMaps},
        {"IMAGES", f.paints + f.normalMaps},
        {"CUBEMAP", f.cubemap},
        {"LINEAR", f.linear},
        {"LIGHTS", f.lights},
        {"GLOWS", f.glows},
        {"DATA_BLOCK", f.dataBlock},
        {"ITERATIONS_COUNTED", plan.target.iterationsCounted},
        {"PRELOADS", plan.target.preloads},
        {"CACHED_LOADS", plan.target.cachedLoads},
        {"FALLBACK", plan.split.fallback},
        {"TILES", plan.split.tile > 0},
        {"FLOAT_TARGETS", plan.target.floatTargets},
        {"COVERAGE_MASK", plan.split.coverageMask},
        {"SHADOWS", f.shadows != ShadowModel::Off},
        {"SHADOW_RAYS", shadowRow(f.shadows).rays},
        {"SHADOWS_IN_TREE", f.shadows == ShadowModel::Hard},
        {"DISTANCES", f.distances},
        {"COVERS", f.shadows == ShadowModel::Silhouette},
        {"FROM_LIGHT", f.fromLight},
        {"MARCH", int(f.march)},
        {"MARCH_STEPS", int(March::Steps)},
        {"MARCH_SPHERE", int(March::Sphere)},
        {"MARCH_CONE", int(March::Cone)},
        {"MARCH_RELAXED", int(March::Relaxed)},
        {"OUTPUT", int(f.output)},
        {"COLOR", int(Aov::Color)},
        {"DISTANCE", int(Aov::Distance)},
        {"POSITION", int(Aov::Position)},
        {"NORMAL", int(Aov::Normal)},
        {"OBJECT", int(Aov::Object)},
        {"VISIBILITY", int(Aov::Visibility)},
        {"WORK", int(Aov::Work)},
        {"STEPS", int(Aov::Steps)},
        {"HIERARCHY", int(Search::Hierarchy)},
        {"GRID", int(Search::Grid)},
    };
    // Of any kind: none in a program that is left with no kind to ask.
    for (const char* name : {"SEARCHES", "LATTICES", "UNIFORM_GRIDS", "HIERARCHIES", "ESTIMATED_CASTERS",
                             "MARCHED_CASTERS", "SPHERE_LATTICES", "NEARBY", "TRIANGLES"})
        names.values[name] = 0;
    // Solids have shapes for parts that the scene has no object of.
    for (const ShapeRow& row : shapeTable()) names.values[mapped(glslTypeOf(row.kind), std::toupper) + "_IMAGES"] = 0;
    auto& shapes = names.lists["SHAPES"];
    auto& casters = names.lists["CASTERS"];
    auto& uncommon = names.lists["UNCOMMON"];
    for (std::size_t k = 0; k < f.shapes.size(); ++k) {
        const KindCount& kind = f.shapes[k];
        if (plan.split.fallback && plan.split.kind(k).shape) {
            uncommon.push_back(kind.type());
            continue;
        }
        shapes.push_back(kind.type());
        if (kind.casters > 0) casters.push_back(kind.type());
        addShape(kind, names);
        addSearch(kind, names);
        addNearest(kind, names);
    }
    std::string model(shadowRow(f.shadows).key);
    std::replace(model.begin(), model.end(), '-', '_');
    names.lists["SHADOW_MODEL"] = {model};
    const auto count = [&](const char* list, int end) {
        auto& numbers = names.lists[list];
        for (int i = 0; i < end; ++i) numbers.push_back(std::to_string(i));
    };
    count("PAINT_LAYERS", f.paints);
    count("NORMAL_LAYERS", f.normalMaps);
    count("LIGHT_NUMBERS", f.lights);
    return names;
}

/// A word in the three spellings `$Word`, `$word`, `$WORD` can ask for.
struct Substitution {
    std::string word, value;
};

std::string substitute(std::string_view line, const std::vector<Substitution>& substitutions) {
    std::string out(line);
    for (const Substitution& s : substitutions) {
        const std::pair<std::string, std::string> spellings[] = {
            {"$" + s.word, s.value},
            {"$" + mapped(s.word, std::tolower), mapped(s.value, std::tolower)},
            {"$" + mapped(s.word, std::toupper), mapped(s.value, std::toupper)}};
        for (const auto& [from, to] : spellings)
            for (std::size_t at = 0; (at = out.find(from, at)) != std::string::npos; at += to.size())
                out.replace(at, from.size(), to);
    }
    return out;
}

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

/// One file's lines with a cursor.
struct Lines {
    std::string_view file;
    std::vector<std::string_view> text;
};

Lines linesOf(std::string_view file, std::string_view text) {
    Lines lines{file, {}};
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        lines.text.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

class Builder {
  public:
    Builder(const Plan& plan, Problems& problems, std::span<const ShaderFile> overrides = {})
        : names_(namesOf(plan)), overrides_(overrides), problems_(problems) {
        for (const KindCount& kind : plan.scene.shapes)
            if (kind.solid)
                solids_["primitive/" + mapped(kind.type(), std::tolower) + ".glsl"] = {
                    kind.type(), solidSource(*kind.solid, kind.type()), false};
        for (const ShaderFile& file : overrides)
            if (!find(shaderLibrary(), file.name))
                problem(file.name, 0, "an override of a file that the library does not have");
    }

    void generate(const std::string& text) { emit(text, {"(generated)", 0}); }

    void include(std::string_view name, int depth = 0) {
        if (const auto solid = solids_.find(name); solid != solids_.end()) return includeSolid(solid->second, depth);
        const ShaderFile* found = find(overrides_, name);
        if (!found) found = find(shaderLibrary(), name);
        if (!found) return problem("(generated)", 0, "there is no shader file " + std::string(name));
        if (std::find(source_.modules.begin(), source_.modules.end(), found->name) != source_.modules.end()) return;
        source_.modules.push_back(found->name);
        const Lines lines = linesOf(found->name, found->text);
        process(lines, 0, lines.text.size(), {}, depth + 1);
    }

    ShaderSource take() { return std::move(source_); }

  private:
    using Substitutions = std::vector<Substitution>;

    static const ShaderFile* find(std::span<const ShaderFile> files, std::string_view name) {
        const auto found =
            std::find_if(files.begin(), files.end(), [&](const ShaderFile& file) { return file.name == name; });
        return found == files.end() ? nullptr : &*found;
    }

    struct SolidFile {
        std::string type, text;
        bool included = false;
    };

    /// The field of a solid's distances is generated; what rays and shadows do with it is the same for all.
    void includeSolid(SolidFile& solid, int depth) {
        if (std::exchange(solid.included, true)) return;
        const Lines field = linesOf("(generated)", solid.text);
        process(field, 0, field.text.size(), {}, depth + 1);
        const ShaderFile* shared = find(shaderLibrary(), "sdf/solid.glsl");
        const Lines lines = linesOf(shared->name, shared->text);
        process(lines, 0, lines.text.size(), {{"Shape", solid.type}}, depth + 1);
    }

    void process(const Lines& lines, std::size_t from, std::size_t to, const Substitutions& words, int depth) {
        if (depth > kDeepest) return problem(lines.file, int(from) + 1, "includes nest too deeply");
        for (std::size_t i = from; i < to;) {
            const std::string_view line = trimmed(lines.text[i]);
            if (line.starts_with("#include")) {
                includeLine(lines, i, substitute(line, words), depth);
                ++i;
            } else if (line.starts_with("#if")) {
                i = conditional(lines, i, to, words, depth);
            } else if (line.starts_with("#for")) {
                i = loop(lines, i, to, words, depth);
            } else if (line.starts_with("#")) {
                problem(lines.file, int(i) + 1, "unknown directive `" + std::string(line) + "`");
                ++i;
            } else {
                emitCode(substitute(lines.text[i], words), {lines.file, int(i) + 1});
                ++i;
            }
        }
    }

    void includeLine(const Lines& lines, std::size_t at, std::string_view line, int depth) {
        const auto open = line.find('"'), close = line.rfind('"');
        if (open == close) return problem(lines.file, int(at) + 1, "#include needs a file name in quotes");
        include(line.substr(open + 1, close - open - 1), depth);
    }

    /// Lines from `at` at which the branches of the block opened there begin, its end last.
    std::vector<std::size_t> branches(const Lines& lines, std::size_t at, std::size_t to) {
        std::vector<std::size_t> starts{at};
        int open = 0;
        for (std::size_t i = at; i < to; ++i) {
            const std::string_view line = trimmed(lines.text[i]);
            if (line.starts_with("#if") || line.starts_with("#for")) ++open;
            if (open == 1 && (line.starts_with("#elif") || line.starts_with("#else"))) starts.push_back(i);
            if ((line.starts_with("#endif") || line.starts_with("#endfor")) && --open == 0) {
                starts.push_back(i);
                return starts;
            }
        }
        problem(lines.file, int(at) + 1, "this block has no end");
        starts.push_back(to);
        return starts;
    }

    std::size_t conditional(const Lines& lines, std::size_t at, std::size_t to, const Substitutions& words, int depth) {
        const auto starts = branches(lines, at, to);
        for (std::size_t b = 0; b + 1 < starts.size(); ++b) {
            if (!holds(lines, starts[b], words)) continue;
            process(lines, starts[b] + 1, starts[b + 1], words, depth);
            break;
        }
        return starts.back() + 1;
    }

    bool holds(const Lines& lines, std::size_t at, const Substitutions& words) {
        const std::string line = substitute(trimmed(lines.text[at]), words);
        if (line.starts_with("#else")) return true;
        const std::string_view condition = std::string_view(line).substr(line.starts_with("#elif") ? 5 : 3);
        std::string error;
        const auto value = evaluateCondition(
            condition, [this](std::string_view name) { return valueOf(name); }, error);
        if (!value) problem(lines.file, int(at) + 1, error);
        return value.value_or(0) != 0;
    }

    std::optional<int> valueOf(std::string_view name) const {
        const auto found = names_.values.find(name);
        return found == names_.values.end() ? std::nullopt : std::optional(found->second);
    }

    std::size_t loop(const Lines& lines, std::size_t at, std::size_t to, const Substitutions& words, int depth) {
        const auto starts = branches(lines, at, to);
        const std::string text = substitute(trimmed(lines.text[at]), words);
        const std::string_view line = text;
        const auto in = line.find(" in ");
        const auto list =
            in == std::string_view::npos ? names_.lists.end() : names_.lists.find(trimmed(line.substr(in + 4)));
        if (list == names_.lists.end()) {
            problem(lines.file, int(at) + 1, "#for needs `Word in LIST` with a known list");
            return starts.back() + 1;
        }
        for (const std::string& value : list->second) {
            Substitutions inner = words;
            inner.push_back({std::string(trimmed(line.substr(4, in - 4))), value});
            process(lines, at + 1, starts.back(), inner, depth);
        }
        return starts.back() + 1;
    }

    /// Comments stay in the library: what goes to the driver is the code.
    void emitCode(const std::string& line, SourceLine from) {
        const auto comment = line.find("//");
        const std::string_view kept = std::string_view(line).substr(0, std::min(comment, line.size()));
        const auto last = kept.find_last_not_of(" \t\r");
        if (last != std::string_view::npos) emit(std::string(kept.substr(0, last + 1)), from);
    }

    void emit(const std::string& line, SourceLine from) {
        source_.text += line;
        source_.text += '\n';
        source_.lines.push_back(from);
    }

    void problem(std::string_view file, int line, std::string what) {
        problems_.push_back({"shaders/" + std::string(file), line, {}, std::move(what), {}});
    }

    static constexpr int kDeepest = 16;
    Names names_;
    std::span<const ShaderFile> overrides_;
    std::map<std::string, SolidFile, std::less<>> solids_; ///< files that solids are found under
    Problems& problems_;
    ShaderSource source_;
};

/// The only text that differs between the hosts. lowp and mediump ruin pictures and speed on some drivers: all is
/// highp.
void addPrelude(Builder& builder, const CodegenTarget& target) {
    builder.generate(target.es300 ? "#version 300 es" : "#version 330 core");
    for (const char* type : {"float", "int", "sampler2D", "sampler2DArray", "samplerCube"})
        builder.generate("precision highp " + std::string(type) + ";");
}

void addConstant(Builder& builder, const std::string& name, int value) {
    builder.generate("const int " + name + " = " + std::to_string(value) + ";");
}

/// The line number in one line of a compile log, 0 where it has none.
int loggedLine(std::string_view log) {
    // Mesa `0:12(3): error`, ANGLE and glslang `ERROR: 0:12:`, NVIDIA `0(12) : error`
    const auto zero = log.find("0:") != std::string_view::npos ? log.find("0:") : log.find("0(");
    if (zero == std::string_view::npos || zero > 16) return 0;
    int line = 0;
    std::from_chars(log.data() + zero + 2, log.data() + log.size(), line);
    return line;
}

} // namespace

ShaderSource buildShader(std::string_view pass, const Plan& plan, Problems& problems,
                         std::span<const ShaderFile> overrides) {
    ++built;
    if (const std::string found = contradictionIn(plan); !found.empty())
        problems.push_back({"shaders", 0, {}, "the plan contradicts itself: " + found, {}});
    Builder builder(plan, problems, overrides);
    addPrelude(builder, plan.target);
    for (const auto& [name, value] : constantsOf(plan.scene)) addConstant(builder, name, value);
    builder.include(pass);
    return builder.take();
}

int builtShaders() { return built; }

ShaderSource buildCanvas(const Plan& plan, Problems& problems) {
    Builder builder(plan, problems);
    addPrelude(builder, plan.target);
    if (plan.split.tile > 0) addConstant(builder, "kTile", plan.split.tile);
    builder.include("pass/canvas.vert");
    return builder.take();
}

Problems mapLog(std::string_view log, const ShaderSource& source) {
    Problems problems;
    for (const std::string_view text : linesOf("log", log).text) {
        const std::string_view line = trimmed(text);
        if (line.empty() || line.front() == '\0') continue;
        const int number = loggedLine(line);
        Problem problem{{}, 0, {}, std::string(line), {}};
        if (number >= 1 && number <= int(source.lines.size())) {
            const SourceLine& from = source.lines[std::size_t(number) - 1];
            problem.file = "shaders/" + std::string(from.file);
            problem.line = from.line;
        }
        problems.push_back(problem);
    }
    return problems;
}

} // namespace gnomon
