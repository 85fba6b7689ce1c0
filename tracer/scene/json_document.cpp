#include "tracer/scene/json_document.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>

namespace gnomon {

namespace {

using Json = nlohmann::json;
using Kind = JsonValue::Kind;

/// Hands characters to the parser and leaves word of how many it has taken. (The parser copies its iterators.)
class CountingIterator {
  public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* next, std::size_t* taken) : next_(next), taken_(taken) {}
    reference operator*() const { return *next_; }
    CountingIterator& operator++() {
        ++next_;
        ++*taken_;
        return *this;
    }
    CountingIterator operator++(int) {
        CountingIterator before = *this;
        ++*this;
        return before;
    }
    bool operator==(const CountingIterator& other) const { return next_ == other.next_; }
    bool operator!=(const CountingIterator& other) const { return next_ != other.next_; }

  private:
    const char* next_;
    std::size_t* taken_;
};

/// What the parser's own complaint means to someone who edits a scene. The first row whose needle it contains counts.
struct SyntaxRow {
    std::string_view needle;
    std::string_view what; ///< @ stands for the word in the text
    std::string_view remedy;
};

constexpr SyntaxRow kSyntaxTable[] = {
    {"number overflow", "the number @ is too large", "use a finite number"},
    {"missing closing quote", "a string is not closed", "end it with a double quote"},
    {"control character", "a string runs over the end of its line or holds a control character",
     "end it with a double quote on its line, write \\n for a new line and \\t for a tab"},
    {"backslash", "a string holds an escape that JSON does not know", "write \\\\ for a backslash"},
    {"hex digits", "a string holds a broken \\u escape", "write \\u and four hexadecimal digits"},
    {"surrogate", "a string holds half of a \\u surrogate pair", "write the character itself in UTF-8"},
    {"ill-formed UTF-8", "a string is not valid UTF-8", "save the file as UTF-8"},
    {"invalid BOM", "the file begins with a broken byte order mark", "save the file as UTF-8"},
    {"missing closing '*/'", "a comment is not closed", "end it with */"},
    {"invalid comment", "a lone / is not a comment", "begin comments with // or /*"},
    {"invalid number", "@ is not a number that JSON knows", "write digits on both sides of the point, as 0.5 or 1e-3"},
    {"invalid literal", "@ is not a JSON value", "write numbers as 0.5, words in double quotes, or true or false"},
    {"expected end of input", "the file goes on after its last closing brace",
     "remove what follows, or the closing brace that is one too many"},
    {"object separator", "a colon is missing after a key", "write \"key\": value"},
    {"object key", "a key is missing", "write \"key\": value, the key in double quotes"},
    {"expected '}'", "a comma or closing brace is missing before @", "separate members by commas"},
    {"expected ']'", "a comma or closing bracket is missing before @", "separate list entries by commas"},
    {"parsing value", "a value is missing before @", "write the value, or remove its comma or key"},
    {"", "this is not JSON", "compare with one of the scenes in assets/scenes"},
};

bool belongsToWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '+' || c == '-' || c == '_';
}

/// The whole word or string around or just before `offset`, or the single character there.
std::string_view wordAt(std::string_view text, std::size_t offset) {
    if (offset > 0 && !belongsToWord(text[offset]) && belongsToWord(text[offset - 1])) --offset;
    std::size_t begin = offset, end = offset + 1;
    while (belongsToWord(text[offset]) && begin > 0 && belongsToWord(text[begin - 1])) --begin;
    while (belongsToWord(text[offset]) && end < text.size() && belongsToWord(text[end])) ++end;
    return text.substr(begin, end - begin);
}

bool namesNoNumber(std::string_view word) {
    std::string letters;
    for (char c : word)
        if (std::isalpha(static_cast<unsigned char>(c))) letters += char(std::tolower(static_cast<unsigned char>(c)));
    return letters == "nan" || letters == "inf" || letters == "infinity";
}

/// Whether a comma stands before the bracket at `offset`, with nothing but space between.
bool followsComma(std::string_view text, std::size_t offset) {
    if (text[offset] != ']' && text[offset] != '}') return false;
    const std::size_t before = text.substr(0, offset).find_last_not_of(" \t\r\n");
    return before != std::string_view::npos && text[before] == ',';
}

/// `0,8` where the 8 at `offset` is no key; empty where there is none.
std::string_view decimalComma(std::string_view text, std::size_t offset) {
    const auto digit = [&](std::size_t at) { return std::isdigit(static_cast<unsigned char>(text[at])); };
    const std::string_view after = wordAt(text, offset);
    const std::size_t begin = std::size_t(after.data() - text.data());
    if (begin < 2 || !digit(begin) || text[begin - 1] != ',' || !digit(begin - 2)) return {};
    const std::size_t before = std::size_t(wordAt(text, begin - 2).data() - text.data());
    return text.substr(before, begin + after.size() - before);
}

/// Receives the parser's events (the names are nlohmann's) and grows the tree.
class TreeBuilder {
  public:
    TreeBuilder(std::string_view text, ProblemCounter& problems) : text_(text), problems_(problems) {}

    bool parse() {
        const CountingIterator begin(text_.data(), &taken_), end(text_.data() + text_.size(), &taken_);
        return Json::sax_parse(begin, end, this, Json::input_format_t::json, true, true);
    }
    JsonValue takeRoot() { return std::move(root_); }

    bool null() { return add(Kind::Null) != nullptr; }
    bool boolean(bool value) {
        JsonValue* added = add(Kind::Boolean);
        if (added) added->boolean = value;
        return added;
    }
    bool number_integer(Json::number_integer_t value) { return number(double(value)); }
    bool number_unsigned(Json::number_unsigned_t value) { return number(double(value)); }
    bool number_float(Json::number_float_t value, const std::string&) { return number(value); }
    bool string(std::string& value) {
        JsonValue* added = add(Kind::String);
        if (added) added->text = std::move(value);
        return added;
    }
    bool binary(Json::binary_t&) { return false; } // only in binary formats
    bool start_object(std::size_t) { return open(Kind::Object); }
    bool start_array(std::size_t) { return open(Kind::Array); }
    bool key(std::string& value) {
        key_ = std::move(value);
        keyLine_ = lineNow();
        return true;
    }
    bool end_object() {
        reportDuplicates(*open_.back());
        open_.pop_back();
        return true;
    }
    bool end_array() {
        open_.pop_back();
        return true;
    }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& error) {
        reportSyntax(error.what());
        return false;
    }

  private:
    /// Of the last character of the event's token. The parser has read at most one character past it (behind a
    /// number), so the last character taken never counts: it is the token's own, or what ended it.
    std::size_t offsetNow() const { return taken_ > 0 ? taken_ - 1 : 0; }

    int lineNow() {
        for (; counted_ < offsetNow(); ++counted_) line_ += text_[counted_] == '\n';
        return line_;
    }

    bool number(double value) {
        JsonValue* added = add(Kind::Number);
        if (added) added->number = value;
        return added;
    }

    bool open(Kind kind) {
        if (open_.size() >= kMaxJsonDepth) {
            report(lineNow(), "",
                   "lists and objects are nested deeper than " + std::to_string(kMaxJsonDepth) + " levels",
                   "remove brackets that are too many");
            return false;
        }
        JsonValue* added = add(kind);
        if (added) open_.push_back(added);
        return added;
    }

    /// Pointers in `open_` stay valid: only the innermost open container grows.
    JsonValue* add(Kind kind) {
        if (++values_ > kMaxJsonValues) {
            report(lineNow(), "", "the file holds more than " + std::to_string(kMaxJsonValues) + " values",
                   "use a smaller scene");
            return nullptr;
        }
        JsonValue& added = open_.empty() ? root_ : open_.back()->children.emplace_back();
        added.kind = kind;
        added.line = lineNow();
        if (!open_.empty() && open_.back()->kind == Kind::Object) {
            added.key = std::move(key_);
            added.keyLine = keyLine_;
        }
        return &added;
    }

    void reportDuplicates(const JsonValue& object) {
        std::map<std::string_view, int> lines;
        for (const JsonValue& member : object.children) {
            const auto [first, isNew] = lines.emplace(member.key, member.keyLine);
            if (isNew) continue;
            if (!problems_.keeps())
                problems_.countOne();
            else
                report(member.keyLine, pathOfInnermost(), "duplicate key " + inQuotes(member.key),
                       "line " + std::to_string(first->second) + " has it already: remove one");
        }
    }

    std::string pathOfInnermost() const {
        std::string path;
        for (std::size_t i = 1; i < open_.size(); ++i) {
            const JsonValue &outer = *open_[i - 1], &inner = *open_[i];
            if (outer.kind == Kind::Array)
                path += "[" + std::to_string(outer.children.size() - 1) + "]";
            else
                path = memberPath(path, inner.key);
        }
        return path;
    }

    void reportSyntax(std::string_view parserText) {
        const bool atEnd = parserText.find("unexpected end of input") != std::string_view::npos;
        if (atEnd) return reportEnd();
        const std::size_t offset = offsetNow();
        const std::string_view word = wordAt(text_, offset);
        if (namesNoNumber(word))
            return report(lineNow(), "", inQuotes(word) + " is not a number that JSON knows", "use a finite number");
        const bool inObject = !open_.empty() && open_.back()->kind == Kind::Object;
        if (const std::string_view number = decimalComma(text_, offset); inObject && !number.empty())
            return report(lineNow(), "", inQuotes(number) + " is not a number that JSON knows",
                          "write a decimal point, as 0.8");
        if (followsComma(text_, offset))
            return report(lineNow(), "", "a comma stands before " + inQuotes(word) + " with nothing behind it",
                          "remove the comma");
        const SyntaxRow& row = *std::find_if(std::begin(kSyntaxTable), std::end(kSyntaxTable), [&](const SyntaxRow& r) {
            return parserText.find(r.needle) != std::string_view::npos;
        });
        std::string what(row.what);
        if (const std::size_t at = what.find('@'); at != std::string::npos) what.replace(at, 1, inQuotes(word));
        report(lineNow(), "", what, std::string(row.remedy));
    }

    void reportEnd() {
        if (open_.empty()) return report(lineNow(), "", "the file is empty", "write a scene: {\"objects\": [ ... ]}");
        const bool list = open_.back()->kind == Kind::Array;
        report(lineNow(), "",
               std::string("the file ends inside the ") + (list ? "list" : "object") + " that begins on line " +
                   std::to_string(open_.back()->line),
               std::string("close it with ") + (list ? "]" : "}"));
    }

    void report(int line, std::string path, std::string what, std::string remedy) {
        problems_.add(line, std::move(path), std::move(what), std::move(remedy));
    }

    std::string_view text_;
    ProblemCounter& problems_;

    std::size_t taken_ = 0;   ///< characters the parser has read
    std::size_t counted_ = 0; ///< characters whose newlines are in `line_`
    int line_ = 1;

    JsonValue root_;
    std::vector<JsonValue*> open_; ///< from the root to the innermost container not yet closed
    std::size_t values_ = 0;
    std::string key_;
    int keyLine_ = 0;
};

} // namespace

const JsonValue* JsonValue::find(std::string_view wanted) const {
    if (kind != Kind::Object) return nullptr;
    const auto member =
        std::find_if(children.begin(), children.end(), [&](const JsonValue& child) { return child.key == wanted; });
    return member != children.end() ? &*member : nullptr;
}

std::string memberPath(const std::string& path, std::string_view key) {
    constexpr std::size_t kLongestWord = 64;
    const bool plain = !key.empty() && key.size() <= kLongestWord && std::all_of(key.begin(), key.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '$';
    });
    if (!plain) return path + "[" + inQuotes(key) + "]";
    return path.empty() ? std::string(key) : path + "." + std::string(key);
}

std::string_view describe(JsonValue::Kind kind) {
    switch (kind) {
    case Kind::Null: return "null";
    case Kind::Boolean: return "true or false";
    case Kind::Number: return "a number";
    case Kind::String: return "a string";
    case Kind::Array: return "a list";
    case Kind::Object: return "an object";
    }
    return "";
}

std::optional<JsonValue> parseJson(std::string_view text, ProblemCounter& problems) {
    if (text.size() > kMaxJsonBytes) {
        problems.add(0, "",
                     "the file has " + std::to_string(text.size()) + " bytes; at most " +
                         std::to_string(kMaxJsonBytes) + " are read",
                     "use a smaller scene");
        return std::nullopt;
    }
    // The parser takes a zero byte for the end of its input.
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        const int line = 1 + int(std::count(text.begin(), text.begin() + std::ptrdiff_t(zero), '\n'));
        problems.add(line, "", "the file holds a zero byte: it is not a text file", "save it as UTF-8");
        return std::nullopt;
    }
    TreeBuilder builder(text, problems);
    if (!builder.parse()) return std::nullopt;
    return builder.takeRoot();
}

std::optional<JsonValue> parseJson(std::string_view text, const std::string& file, Problems& problems) {
    ProblemCounter counter(file, problems);
    return parseJson(text, counter);
}

} // namespace gnomon
