/// A shader's words and operators, one after another, as a parser takes them.
#pragma once

#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon::test {

/// Scalars and vectors: T(0) is one.
inline bool hasZero(const std::string& type) {
    const bool scalar = type == "float" || type == "int" || type == "uint" || type == "bool";
    return scalar || (type.size() <= 5 && type.find("vec") != type.npos);
}
inline bool isMatrix(const std::string& type) { return type.size() == 4 && type.starts_with("mat"); }

class GlslTokens {
  public:
    /// Of GLSL without comments.
    explicit GlslTokens(std::string_view glsl) {
        for (std::size_t at = 0; at < glsl.size();) {
            const std::size_t length = lengthAt(glsl.substr(at));
            if (!std::isspace(static_cast<unsigned char>(glsl[at]))) all_.emplace_back(glsl.substr(at, length));
            at += length;
        }
    }

    std::size_t position() const { return at_; }
    bool ended() const { return at_ == all_.size(); }
    /// By its position; empty where there is none.
    const std::string& at(std::size_t position) const {
        static const std::string kNone(1, '\0');
        return position < all_.size() ? all_[position] : kNone;
    }
    const std::string& next() const { return at(at_); }
    const std::string& last() const { return at(at_ - 1); }
    bool nextIsWord(std::size_t ahead = 0) const { return startsWord(at(at_ + ahead)[0]); }
    /// One of these lies between two positions.
    bool between(std::size_t from, std::size_t to, std::initializer_list<std::string_view> words) const {
        const auto first = all_.begin() + std::ptrdiff_t(from), end = all_.begin() + std::ptrdiff_t(to);
        return std::find_first_of(first, end, words.begin(), words.end()) != end;
    }

    const std::string& take() { return all_.at(at_++); }
    void skip(std::size_t count = 1) { at_ += count; }
    bool accept(std::string_view token) {
        const bool found = next() == token;
        at_ += found;
        return found;
    }
    /// As it stands, up to the first of `ends` outside of all brackets, or a bracket that nothing opened.
    std::string copyTo(std::string_view ends) {
        std::string out;
        for (int open = 0; !ended(); out += take() + ' ') {
            const bool opens = next() == "(" || next() == "[" || next() == "{";
            const bool closes = next() == ")" || next() == "]" || next() == "}";
            if (open == 0 && (closes || ends.find(next()) != ends.npos)) break;
            open += int(opens) - int(closes);
        }
        return out;
    }
    std::string copyStatement() {
        const std::string out = copyTo(";");
        return out + take() + '\n';
    }

  private:
    static bool isDigit(char c) { return c >= '0' && c <= '9'; }
    static bool startsWord(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }

    static std::size_t lengthAt(std::string_view text) {
        static constexpr std::string_view kOperators[]{
            "<<=", ">>=", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "^^",
            "++",  "--",  "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^="};
        std::size_t length = 1;
        const auto goesOn = [&] { return length < text.size() && (startsWord(text[length]) || isDigit(text[length])); };
        if (isDigit(text[0]) || (text[0] == '.' && text.size() > 1 && isDigit(text[1]))) {
            const bool hex = text.starts_with("0x");
            const auto exponent = [&] { return !hex && std::tolower(text[length - 1]) == 'e'; };
            while (goesOn() || text[length] == '.' || (exponent() && (text[length] == '-' || text[length] == '+')))
                ++length;
        } else if (startsWord(text[0])) {
            while (goesOn()) ++length;
        } else {
            for (const std::string_view op : kOperators)
                if (text.starts_with(op)) return op.size();
        }
        return length;
    }

    std::vector<std::string> all_;
    std::size_t at_ = 0;
};

} // namespace gnomon::test
