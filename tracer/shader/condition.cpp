#include "tracer/shader/condition.h"

#include <array>
#include <cctype>
#include <charconv>

namespace gnomon {
namespace {

/// Binary operators from the loosest to the tightest.
struct Operator {
    std::string_view sign;
    int level;
    int (*apply)(int, int);
};
constexpr std::array<Operator, 8> kOperators{{
    {"||", 0, [](int a, int b) { return int(a || b); }},
    {"&&", 1, [](int a, int b) { return int(a && b); }},
    {"==", 2, [](int a, int b) { return int(a == b); }},
    {"!=", 2, [](int a, int b) { return int(a != b); }},
    {"<=", 3, [](int a, int b) { return int(a <= b); }},
    {">=", 3, [](int a, int b) { return int(a >= b); }},
    {"<", 3, [](int a, int b) { return int(a < b); }},
    {">", 3, [](int a, int b) { return int(a > b); }},
}};
constexpr int kTightest = 4;

class Evaluator {
  public:
    Evaluator(std::string_view text, const NameValue& value, std::string& error)
        : rest_(text), value_(value), error_(error) {}

    std::optional<int> run() {
        const int result = binary(0);
        skipSpace();
        if (!rest_.empty()) fail("unexpected `" + std::string(rest_) + "`");
        return error_.empty() ? std::optional(result) : std::nullopt;
    }

  private:
    int binary(int level) {
        if (level == kTightest) return unary();
        int left = binary(level + 1);
        while (const Operator* op = takeOperator(level)) {
            const int right = binary(level + 1);
            left = op->apply(left, right);
        }
        return left;
    }

    int unary() {
        if (take("!")) return !unary();
        if (take("(")) {
            const int inside = binary(0);
            if (!take(")")) fail("a `)` is missing");
            return inside;
        }
        return word();
    }

    int word() {
        skipSpace();
        std::size_t length = 0;
        while (length < rest_.size() &&
               (std::isalnum(static_cast<unsigned char>(rest_[length])) || rest_[length] == '_'))
            ++length;
        const std::string_view token = rest_.substr(0, length);
        rest_.remove_prefix(length);
        int number = 0;
        const auto parsed = std::from_chars(token.data(), token.data() + token.size(), number);
        if (!token.empty() && parsed.ec == std::errc{} && parsed.ptr == token.data() + token.size()) return number;
        if (const auto known = value_(token)) return *known;
        fail("unknown name `" + std::string(token) + "`");
        return 0;
    }

    const Operator* takeOperator(int level) {
        skipSpace();
        for (const Operator& op : kOperators)
            if (op.level == level && take(op.sign)) return &op;
        return nullptr;
    }

    bool take(std::string_view sign) {
        skipSpace();
        if (!rest_.starts_with(sign)) return false;
        rest_.remove_prefix(sign.size());
        return true;
    }

    void skipSpace() {
        while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front()))) rest_.remove_prefix(1);
    }

    void fail(const std::string& why) {
        if (error_.empty()) error_ = why;
        rest_ = {};
    }

    std::string_view rest_;
    const NameValue& value_;
    std::string& error_;
};

} // namespace

std::optional<int> evaluateCondition(std::string_view text, const NameValue& value, std::string& error) {
    error.clear();
    return Evaluator(text, value, error).run();
}

} // namespace gnomon
