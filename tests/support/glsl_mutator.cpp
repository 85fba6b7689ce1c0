#include "tests/support/glsl_mutator.h"

#include "tests/support/clouds.h"
#include "tests/support/glsl_tokens.h"

#include <map>
#include <set>
#include <utility>

namespace gnomon::test {
int gLow = 0, gHigh = 1 << 30, gTotal = 0;
namespace {

using Text = std::string;
using Words = std::set<Text, std::less<>>;

const Text kOne = "max(1 - frame.depth, 1)"; ///< which no compiler knows; the depth is 0 where it does not count

/// What an expression is written as, and what may be done with it.
struct Value {
    Text text;
    bool effects = false; ///< it matters when it is evaluated
    bool matrix = false;  ///< one is in it, which commutes with nothing

    Value with(const Text& more) const { return {more, effects, matrix}; }
    Value joined(const Value& other, const Text& both) const {
        return {both, effects || other.effects, matrix || other.matrix};
    }
};

/// Of each type that an operation has; those of floats go through an integer, which no compiler looks through.
Text barriers() {
    Text out;
    for (const Text size : {"", "2", "3", "4"}) {
        for (const Text type : {"int", "uint", "bool"}) {
            const Text of = size.empty() ? type : type.substr(0, 1) + "vec" + size;
            out += of + " rounded(" + of + " x) { return x; }\n";
        }
        const Text of = size.empty() ? "float" : "vec" + size;
        out += of + " rounded(" + of + " x) { return uintBitsToFloat(floatBitsToUint(x) ^ frame.zero.w); }\n";
    }
    out += "mat3 rounded(mat3 x) { return mat3(rounded(x[0]), rounded(x[1]), rounded(x[2])); }\n";
    out += "mat4 rounded(mat4 x) { return mat4(rounded(x[0]), rounded(x[1]), rounded(x[2]), rounded(x[3])); }\n";
    return out;
}

class Mutator {
  public:
    Mutator(std::string_view glsl, const Mutations& mutations)
        : mutations_(mutations), dice_(mutations.seed), tokens_(glsl) {
        for (std::size_t i = 0; tokens_.at(i)[0]; ++i)
            if (isMatrix(tokens_.at(i))) matrices_.insert({tokens_.at(i), tokens_.at(i + 1)});
    }

    Text file() {
        Text out;
        while (!tokens_.ended()) out += global();
        return out;
    }

  private:
    // --- chance

    int whole(int below) { return int(dice_.number(0, below)); }
    bool chance(Mutation kind) {
        if (!((mutations_.kinds & kind) && dice_.number(0, 1) < mutations_.probability)) return false;
        const int n = count_++;
        gTotal = count_;
        return n >= gLow && n < gHigh;
    }
    int count_ = 0;
    Text always() { return whole(2) == 0 ? "frame.canvas.x >= 0.0" : "frame.depth >= 0"; }
    Text never() { return whole(2) == 0 ? "frame.canvas.y < 0.0" : "frame.depth < 0"; }
    Text fresh() { return "mutant" + std::to_string(++names_); }

    // --- outside of functions

    Text global() {
        static const Words kConstant{"const", "uniform", "precision", "struct", "layout"};
        const std::size_t from = tokens_.position();
        const Text head = tokens_.copyTo(";=[{");
        if (tokens_.next() == "{" && tokens_.last() == ")") return head + function(from);
        if (!kConstant.contains(tokens_.at(from))) effects_.insert(tokens_.last());
        if (tokens_.at(from) == "struct") own_.insert(tokens_.last());
        const Text text = head + tokens_.copyStatement();
        return mutations_.barriers && tokens_.at(from + 5) == "Frame" ? text + barriers() : text;
    }

    Text function(std::size_t from) {
        const std::size_t open = tokens_.position();
        result_ = tokens_.at(from);
        own_.insert(tokens_.at(from + 1));
        types_.clear();
        bool effects = false;
        for (std::size_t i = from + 3; i < open; ++i)
            if (tokens_.at(i) == "," || tokens_.at(i) == ")") types_.emplace_back(tokens_.at(i - 1), tokens_.at(i - 2));
        const Text body = block(result_ == "void");
        for (std::size_t i = from; i < tokens_.position(); ++i)
            effects = effects || tokens_.at(i).ends_with("out") || effects_.contains(tokens_.at(i));
        if (effects) effects_.insert(tokens_.at(from + 1));
        return body;
    }

    // --- statements

    Text block(bool whole = true) {
        const std::size_t known = types_.size();
        tokens_.skip();
        Text body;
        while (!tokens_.accept("}")) {
            body += deadCode();
            body += statement();
        }
        types_.resize(known);
        return whole && chance(kConditions) ? "{ if (" + always() + ") {\n" + body + "} }\n" : "{\n" + body + "}\n";
    }

    Text deadCode() {
        if (!chance(kDeadCode)) return {};
        std::vector<Text> ways{"discard;"};
        if (loops_ > 0) ways.insert(ways.end(), {"break;", "continue;"});
        if (result_ == "void") ways.push_back("return;");
        if (hasZero(result_)) ways.push_back("return " + result_ + "(0);");
        return "if (" + never() + ") " + ways[std::size_t(whole(int(ways.size())))] + '\n';
    }

    /// Of a choice or a loop: in braces where it is not in them.
    Text body() { return tokens_.next() == "{" ? block() : "{ " + statement() + "}\n"; }
    Text loopBody() {
        ++loops_;
        const Text text = body();
        --loops_;
        return text;
    }
    Text condition() {
        const Text text = expression().text;
        tokens_.skip();
        return text;
    }

    Text statement() {
        const std::size_t from = tokens_.position();
        const Text first = tokens_.next();
        if (first == "return") return returned();
        if (first == "break" || first == "continue" || first == "discard" || first == ";" || first == "const")
            return tokens_.copyStatement();
        if (tokens_.nextIsWord() && tokens_.nextIsWord(1) && first != "do") return declaration();
        if (first == "for") return once(forLoop());
        if (first == "while") return once(whileLoop());
        if (first == "do") return once(doLoop());
        const Text text = first == "{" ? block() : first == "if" ? choice() : assignment();
        const bool leaves = tokens_.between(from, tokens_.position(), {"break", "continue"});
        return leaves && !chance(kConditions) ? text : once(text, leaves);
    }

    /// A statement under a condition that holds, or in a loop that runs once, which what leaves a loop must not be.
    Text once(const Text& text, bool leaves = false) {
        if (leaves || chance(kConditions)) return "if (" + always() + ") {\n" + text + "}\n";
        if (!chance(kLoops)) return text;
        const Text i = fresh();
        return "for (int " + i + " = 0; " + i + " < " + kOne + "; ++" + i + ") {\n" + text + "}\n";
    }

    Text returned() {
        tokens_.skip();
        if (tokens_.accept(";")) return "return;\n";
        const Text value = condition();
        return "return " + identity(value, result_) + ";\n";
    }

    Text choice() {
        tokens_.skip(2);
        const Text when = condition();
        const Text then = body();
        if (!tokens_.accept("else")) return "if (" + when + ") " + then;
        const Text otherwise = body();
        return chance(kChoices) ? "if (!(" + when + ")) " + otherwise + "else " + then
                                : "if (" + when + ") " + then + "else " + otherwise;
    }

    Text forLoop() {
        const std::size_t known = types_.size();
        tokens_.skip(2);
        const Text first = tokens_.copyStatement();
        const Text when = tokens_.accept(";") ? "true" : condition();
        const Text step = tokens_.copyTo(")");
        tokens_.skip();
        const std::size_t from = tokens_.position();
        const Text body = loopBody();
        types_.resize(known);
        const bool simple =
            tokens_.position() - from < 120 && !tokens_.between(from, tokens_.position(), {"break", "for"});
        if (!simple || step.empty() || !chance(kLoops)) return "for (" + first + when + "; " + step + ") " + body;
        const Text i = fresh();
        return "{ " + first + "for (int " + i + " = 0; " + i + " < " + kOne + " && (" + when + "); ++" + i + ", " +
               step + ") " + body + "for (; " + when + "; " + step + ") " + body + "}\n";
    }

    Text whileLoop() {
        tokens_.skip(2);
        const Text when = condition();
        const Text body = loopBody();
        return chance(kLoops) ? "for (; " + when + ";) " + body : "while (" + when + ") " + body;
    }

    Text doLoop() {
        tokens_.skip();
        const Text body = loopBody();
        tokens_.skip(2);
        const Text when = condition();
        tokens_.skip();
        if (!chance(kLoops)) return "do " + body + "while (" + when + ");\n";
        const Text first = fresh();
        return "for (bool " + first + " = true; " + first + " || (" + when + "); " + first + " = false) " + body;
    }

    Text declaration() {
        const Text type = tokens_.take();
        Text out;
        do {
            const Text name = tokens_.take();
            const Text size = tokens_.copyTo(",;=");
            out += tokens_.accept("=") ? given(type, name) : type + ' ' + name + size + ";\n";
            types_.emplace_back(name, type);
        } while (tokens_.accept(","));
        tokens_.skip();
        return out;
    }

    /// A variable and its first value.
    Text given(const Text& type, const Text& name) {
        const Text value = identity(expression().text, type);
        if (chance(kConditions)) return type + ' ' + name + ";\nif (" + always() + ") " + name + " = " + value + ";\n";
        if (!chance(kCopies)) return type + ' ' + name + " = " + value + ";\n";
        const Text copy = fresh();
        return type + ' ' + copy + " = " + value + ";\n" + type + ' ' + name + " = " + copy + ";\n";
    }

    Text assignment() {
        if (!tokens_.nextIsWord() || tokens_.at(tokens_.position() + 1) != "=") return condition() + ";\n";
        const Text name = tokens_.take();
        tokens_.skip();
        if (chance(kChoices)) return chosen(name);
        const Text value = condition();
        return name + " = " + identity(value, typeOf(name)) + ";\n";
    }

    /// name = c ? a : b by if and else.
    Text chosen(const Text& name) {
        const Text when = binary(0).text;
        if (tokens_.accept(";")) return name + " = " + when + ";\n";
        tokens_.skip();
        const Text then = condition();
        const Text otherwise = condition();
        return "if (" + when + ") " + name + " = " + then + ";\nelse " + name + " = " + otherwise + ";\n";
    }

    Text typeOf(const Text& name) const {
        const auto found =
            std::find_if(types_.rbegin(), types_.rend(), [&](const auto& one) { return one.first == name; });
        return found == types_.rend() ? Text() : found->second;
    }

    Text identity(const Text& value, const Text& type) {
        if (!hasZero(type) || !chance(kIdentities)) return value;
        if ((type == "float" || type.starts_with("vec")) && whole(2) == 0)
            return rounded('(' + value + ") * float(" + kOne + ")");
        return '(' + always() + " ? " + value + " : " + type + "(0))";
    }

    // --- expressions

    Value expression() {
        static const Words kOperators{"=", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "<<=", ">>="};
        const Value first = binary(0);
        if (kOperators.contains(tokens_.next())) return {assigned(first), true};
        if (!tokens_.accept("?")) return first;
        const Value then = expression();
        tokens_.skip();
        const Value otherwise = expression();
        const Text text = chance(kChoices) ? "(!(" + first.text + ") ? " + otherwise.text + " : " + then.text + ')'
                                           : '(' + first.text + " ? " + then.text + " : " + otherwise.text + ')';
        return first.joined(then.joined(otherwise, {}), text);
    }

    Text assigned(const Value& left) {
        const Text op = tokens_.take();
        const Value value = expression();
        const bool once = op == "=" || left.effects || value.effects;
        if (once || !(mutations_.barriers || chance(kCopies))) return left.text + ' ' + op + ' ' + value.text;
        return left.text + " = " + rounded(left.text + ' ' + op.substr(0, op.size() - 1) + " (" + value.text + ')');
    }

    Text rounded(const Text& text) const { return mutations_.barriers ? "rounded(" + text + ')' : text; }

    static int levelOf(const Text& op) {
        static const std::vector<Words> kLevels{{"||"},       {"^^"},     {"&&"},         {"|"},
                                                {"^"},        {"&"},      {"==", "!="},   {"<", ">", "<=", ">="},
                                                {"<<", ">>"}, {"+", "-"}, {"*", "/", "%"}};
        for (int level = int(kLevels.size()) - 1; level >= 0; --level)
            if (kLevels[std::size_t(level)].contains(op)) return level;
        return -1;
    }

    Value binary(int least) {
        Value left = unary();
        for (int level = levelOf(tokens_.next()); level >= least; level = levelOf(tokens_.next())) {
            const Text op = tokens_.take();
            left = applied(left, op, binary(level + 1));
        }
        return left;
    }

    Value applied(const Value& left, const Text& op, const Value& right) {
        static const std::map<Text, Text> kReversed{{"+", "+"},   {"*", "*"},   {"&", "&"},  {"|", "|"},
                                                    {"^", "^"},   {"==", "=="}, {"<", ">"},  {">", "<"},
                                                    {"<=", ">="}, {">=", "<="}, {"!=", "!="}};
        static const Words kArithmetic{"+", "-", "*", "/"};
        const auto written = [&](const Text& text) { return kArithmetic.contains(op) ? rounded(text) : text; };
        const Value result = left.joined(right, written('(' + left.text + ' ' + op + ' ' + right.text + ')'));
        if ((op == "&&" || op == "||") && chance(kChoices))
            return result.with("(!(!" + left.text + (op == "&&" ? " || !" : " && !") + right.text + "))");
        const auto reversed = kReversed.find(op);
        if (reversed == kReversed.end() || result.effects || result.matrix || !chance(kOperands)) return result;
        return result.with(written('(' + right.text + ' ' + reversed->second + ' ' + left.text + ')'));
    }

    Value unary() {
        static const Words kOperators{"-", "+", "!", "~"};
        if (kOperators.contains(tokens_.next())) {
            const Text op = tokens_.take();
            const Value value = unary();
            return value.with('(' + op + value.text + ')');
        }
        if (tokens_.next() != "++" && tokens_.next() != "--") return postfix();
        const Text op = tokens_.take();
        return {op + unary().text, true};
    }

    Value postfix() {
        Value value = primary();
        for (;;) {
            if (tokens_.accept("(") || tokens_.accept("[")) {
                const bool call = tokens_.last() == "(";
                const bool builtIn =
                    call && !own_.contains(value.text) && !hasZero(value.text) && !isMatrix(value.text);
                value.text += tokens_.last();
                while (!tokens_.accept(call ? ")" : "]")) {
                    const Value argument = expression();
                    value.effects = value.effects || argument.effects;
                    value.matrix = value.matrix || argument.matrix;
                    value.text += argument.text + (tokens_.accept(",") ? ", " : "");
                }
                value.text += call ? ')' : ']';
                if (builtIn) value.text = rounded(value.text);
            } else if (tokens_.accept(".")) {
                value.matrix = value.matrix || matrices_.contains(tokens_.next());
                value.text += '.' + tokens_.take();
            } else if (tokens_.next() == "++" || tokens_.next() == "--") {
                value.text += tokens_.take();
                value.effects = true;
            } else {
                return value;
            }
        }
    }

    Value primary() {
        if (tokens_.accept("(")) {
            const Value value = expression();
            tokens_.skip();
            return value.with('(' + value.text + ')');
        }
        const Text name = tokens_.take();
        return {name, effects_.contains(name), matrices_.contains(name)};
    }

    Mutations mutations_;
    Dice dice_;
    GlslTokens tokens_;
    Words matrices_; ///< names of matrices
    Words own_;      ///< functions and structs of the shader
    Words effects_;  ///< variables outside of functions, and functions that change them or what they are given
    std::vector<std::pair<Text, Text>> types_; ///< of the variables in scope
    Text result_;                              ///< type of the function
    int loops_ = 0;                            ///< about the statement
    int names_ = 0;
};

} // namespace

std::string mutated(std::string_view glsl, const Mutations& mutations) {
    const bool withFrame = glsl.find("uniform Frame") != glsl.npos;
    if (!withFrame) return std::string(glsl);
    const std::size_t line = glsl.find('\n'); // #version, the only directive
    return std::string(glsl.substr(0, line + 1)) + Mutator(glsl.substr(line), mutations).file();
}

} // namespace gnomon::test
