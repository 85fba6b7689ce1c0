#include "tracer/shader/shader_builder.h"

#include "tracer/shader/condition.h"
#include "tracer/shader/library.h"
#include "tracer/shader/scene_constants.h"
#include "tracer/shader/shader_names.h"
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
        const ShaderFile* found = fileNamed(name);
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

    /// An override, or the library's.
    const ShaderFile* fileNamed(std::string_view name) const {
        const ShaderFile* found = find(overrides_, name);
        return found ? found : find(shaderLibrary(), name);
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
        const ShaderFile* shared = fileNamed("sdf/solid.glsl");
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
