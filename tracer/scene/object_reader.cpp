#include "tracer/scene/object_reader.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace gnomon {

namespace {

using Kind = JsonValue::Kind;

/// One value on its way from the file into the scene: what all complaints about it need.
struct Entry {
    const JsonValue& value;
    std::string path;
    SceneReport& report;

    Entry item(std::size_t i) const { return {value.children[i], path + "[" + std::to_string(i) + "]", report}; }
    bool complain(std::string what, std::string remedy = {}) const {
        report.add(value.line, path, std::move(what), std::move(remedy));
        return false;
    }
    bool expect(Kind kind, const std::string& wanted, std::string example = {}) const {
        if (value.kind == kind) return true;
        return complain("expected " + wanted + ", found " + std::string(describe(value.kind)), std::move(example));
    }
};

std::string spelled(Range range) { return toString(range.min) + " to " + toString(range.max); }

std::string listed(const std::vector<std::string_view>& words) {
    std::string text;
    for (std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
    return text;
}

bool checkNumber(const Entry& entry, Range range, double& target) {
    if (!entry.expect(Kind::Number, "a number")) return false;
    const double number = entry.value.number;
    if (!(number >= range.min && number <= range.max))
        return entry.complain(toString(number) + " is outside the limits",
                              (range.whole ? "use a whole number from " : "use a number from ") + spelled(range));
    if (range.whole && number != std::floor(number))
        return entry.complain(toString(number) + " is no whole number", "use one from " + spelled(range));
    target = number;
    return true;
}

bool expectList(const Entry& entry, std::size_t count, const std::string& what, const std::string& example) {
    const std::string wanted = "a list of " + std::to_string(count) + " " + what;
    const std::size_t found = entry.value.children.size();
    return entry.expect(Kind::Array, wanted, example) &&
           (found == count ||
            entry.complain("expected " + wanted + ", found " + std::to_string(found) + " entries", example));
}

/// `count` numbers in a list, as in `example`. All are checked, even where one is wrong.
bool checkNumbers(const Entry& entry, Range range, std::size_t count, const std::string& example, double* target) {
    const bool more = entry.value.kind == Kind::Array && entry.value.children.size() > count;
    if (!expectList(entry, count, "numbers", more ? example + ", decimals with a point" : example)) return false;
    bool right = true;
    for (std::size_t i = 0; i < count; ++i) right &= checkNumber(entry.item(i), range, target[i]);
    return right;
}

bool checkVector(const Entry& entry, Range range, glm::dvec3& target, const std::string& example = "write [x, y, z]") {
    return checkNumbers(entry, range, 3, example, &target.x);
}

bool checkDirection(const Entry& entry, Range range, glm::dvec3& target) {
    glm::dvec3 direction;
    if (!checkVector(entry, range, direction)) return false;
    const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    if (largest == 0) return entry.complain("the direction is zero", "use a direction as [0, 1, 0]");
    target = glm::normalize(direction / largest); // in two steps: tiny numbers must not vanish when squared
    return true;
}

/// One number stands for all channels.
bool checkColor(const Entry& entry, Range range, glm::dvec3& target) {
    double number;
    if (entry.value.kind == Kind::Array) return checkVector(entry, range, target, "write [r, g, b]");
    if (entry.value.kind != Kind::Number) return entry.expect(Kind::Array, "a number or [r, g, b]");
    if (!checkNumber(entry, range, number)) return false;
    target = glm::dvec3(number);
    return true;
}

std::size_t characters(std::string_view utf8) {
    return std::size_t(std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

bool checkLength(const Entry& entry, Range range, std::string_view text) {
    const double length = double(characters(text));
    if (length >= range.min && length <= range.max) return true;
    return entry.complain("a text of " + toString(length) + " characters", "use " + spelled(range) + " characters");
}

/// A relative path without detours: below the scene's folder.
bool staysInFolder(std::string_view path) {
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        const std::string_view part = path.substr(begin, end - begin);
        if (part.empty() || part == "." || part == "..") return false;
        begin = end + 1;
    }
    return true;
}

bool endsAsHdr(std::string_view name) {
    constexpr std::string_view kEnding = ".hdr";
    return name.size() >= kEnding.size() &&
           std::equal(kEnding.begin(), kEnding.end(), name.end() - std::ptrdiff_t(kEnding.size()),
                      [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

/// The name of a file beside the scene or below; `what` is in it.
bool checkFileName(const Entry& entry, Range range, const std::string& what, std::string_view text) {
    const auto refuse = [&](const char* remedy) { return entry.complain(inQuotes(text) + " is not " + what, remedy); };
    const auto outlawed = [](unsigned char c) { return c < 0x20 || c == 0x7f || c == '\\'; };
    if (!checkLength(entry, range, text)) return false;
    if (std::any_of(text.begin(), text.end(), outlawed))
        return refuse("use no control characters, and / between folders");
    if (!staysInFolder(text))
        return refuse("name a file in the scene's folder or below it: no / at the beginning, no . and .. as folders");
    return true;
}

bool checkImageName(const Entry& entry, ValueType type, std::string_view text) {
    if (!checkFileName(entry, kImageName, "an image's name", text)) return false;
    if (type != ValueType::Panorama && endsAsHdr(text))
        return entry.complain(inQuotes(text) + " is not an image's name",
                              "use a PNG or JPEG: only a background's image may be HDR");
    return true;
}

/// One number stands for all three.
bool checkScales(const Entry& entry, Range range, glm::dvec3& target) {
    double number;
    if (entry.value.kind == Kind::Array) return checkVector(entry, range, target);
    if (entry.value.kind != Kind::Number) return entry.expect(Kind::Array, "a number or [x, y, z]");
    if (!checkNumber(entry, range, number)) return false;
    target = glm::dvec3(number);
    return true;
}

} // namespace

void SceneReport::add(int line, std::string path, std::string what, std::string remedy) {
    problems.add(line, std::move(path), std::move(what), std::move(remedy));
}

std::string SceneReport::suggest(std::string_view word, const std::vector<std::string_view>& candidates,
                                 std::string otherwise) {
    std::size_t letters = 0;
    for (const std::string_view candidate : candidates) letters += word.size() * candidate.size();
    if (!problems.keeps() || letters > lettersLeft) return otherwise;
    lettersLeft -= letters;
    const std::string_view best = closest(word, candidates);
    return best.empty() ? otherwise : "did you mean " + inQuotes(best) + "?";
}

ObjectReader::ObjectReader(const JsonValue& value, const ObjectFormat& format, std::string path, SceneReport& report)
    : value_(&value), format_(&format), path_(std::move(path)), report_(&report),
      problemsBefore_(report.problems.count()) {
    if (!Entry{value, path_, report}.expect(Kind::Object, "an object", "write { \"key\": value, ... }")) return;
    reportUnknownKeys();
    reportMissingKeys();
    reportAlternatives();
    reportExclusions();
}

int ObjectReader::lineOf(std::string_view key) const {
    const JsonValue* value = value_->find(key);
    return value ? value->line : line();
}

/// The group of which one key is required and none is there.
const Alternatives* ObjectReader::unmetAlternatives() const {
    for (const Alternatives& group : format_->alternatives)
        if (group.required && std::none_of(group.keys.begin(), group.keys.end(), [&](auto key) { return has(key); }))
            return &group;
    return nullptr;
}

/// Where a shape (light kind, …) is missing, a key that we do not know may be one that we do not know: it holds an
/// object or a list and is no misspelling of another key.
bool ObjectReader::looksLikeOneOf(const Alternatives& group, const JsonValue& member) const {
    if (member.kind != Kind::Object && member.kind != Kind::Array) return false;
    std::vector<std::string_view> others;
    for (const FieldFormat& field : format_->fields)
        if (std::find(group.keys.begin(), group.keys.end(), field.key) == group.keys.end()) others.push_back(field.key);
    return report_->suggest(member.key, others, "").empty();
}

void ObjectReader::reportUnknownKeys() const {
    std::vector<std::string_view> known;
    for (const FieldFormat& field : format_->fields) known.push_back(field.key);
    const Alternatives* unmet = unmetAlternatives();
    bool met = !unmet;
    for (const JsonValue& member : value_->children) {
        if (format_->find(member.key)) continue;
        if (!report_->problems.keeps()) {
            report_->problems.countOne();
            continue;
        }
        const bool alternative = unmet && looksLikeOneOf(*unmet, member);
        const auto& candidates = alternative ? unmet->keys : known;
        report_->add(member.keyLine, path_,
                     "unknown " + std::string(alternative ? unmet->what : "key") + " " + inQuotes(member.key),
                     report_->suggest(member.key, candidates, "known here: " + listed(candidates)));
        met |= alternative;
    }
    if (!met) report_->add(line(), path_, "no " + std::string(unmet->what), "give one of: " + listed(unmet->keys));
}

void ObjectReader::reportMissingKeys() const {
    for (const FieldFormat& field : format_->fields)
        if (field.required && !has(field.key))
            report_->add(line(), path_, "missing key " + inQuotes(field.key), "it gives: " + std::string(field.help));
}

void ObjectReader::reportAlternatives() const {
    for (const Alternatives& group : format_->alternatives) {
        std::vector<std::string_view> present;
        int lastLine = 0; // where the one was added that is too many
        for (std::string_view key : group.keys) {
            if (!has(key)) continue;
            present.push_back(key);
            lastLine = std::max(lastLine, lineOf(key));
        }
        if (present.size() > 1)
            report_->add(lastLine, path_, "more than one " + std::string(group.what) + ": " + listed(present),
                         "keep one of them");
    }
}

void ObjectReader::reportExclusions() const {
    for (const auto& [key, others, what, remedy] : format_->exclusions)
        if (has(key) && std::any_of(others.begin(), others.end(), [&](auto other) { return has(other); }))
            report_->add(lineOf(key), pathOf(key), std::string(what), std::string(remedy));
}

bool ObjectReader::read(std::string_view key, bool& target) const {
    const JsonValue* value = value_->find(key);
    if (!value || !Entry{*value, pathOf(key), *report_}.expect(Kind::Boolean, "true or false")) return false;
    target = value->boolean;
    return true;
}

bool ObjectReader::read(std::string_view key, double& target) const {
    const JsonValue* value = value_->find(key);
    return value && checkNumber({*value, pathOf(key), *report_}, format_->find(key)->range, target);
}

bool ObjectReader::read(std::string_view key, std::string& target) const {
    const JsonValue* value = value_->find(key);
    const FieldFormat& field = *format_->find(key);
    if (!value) return false;
    const Entry entry{*value, pathOf(key), *report_};
    if (!entry.expect(Kind::String, "a string")) return false;
    if (field.type == ValueType::Text && !checkLength(entry, field.range, value->text)) return false;
    const bool image = field.type == ValueType::Image || field.type == ValueType::Panorama;
    if (image && !checkImageName(entry, field.type, value->text)) return false;
    if (field.type == ValueType::File && !checkFileName(entry, field.range, "a file beside the scene", value->text))
        return false;
    if (field.type == ValueType::Choice) {
        const auto& choices = field.choices;
        if (std::find(choices.begin(), choices.end(), value->text) == choices.end())
            return entry.complain(inQuotes(value->text) + " is not a choice", "use one of: " + listed(choices));
    }
    target = value->text;
    return true;
}

bool ObjectReader::read(std::string_view key, glm::dvec2& target) const {
    const JsonValue* value = value_->find(key);
    const FieldFormat& field = *format_->find(key);
    if (!value) return false;
    const Entry entry{*value, pathOf(key), *report_};
    double numbers[2];
    if (field.type == ValueType::Scale && value->kind == Kind::Number) {
        if (!checkNumber(entry, field.range, numbers[0])) return false;
        numbers[1] = numbers[0];
    } else if (field.type == ValueType::Scale && value->kind != Kind::Array) {
        return entry.expect(Kind::Array, "a number or [u, v]");
    } else if (!checkNumbers(entry, field.range, 2, "write [u, v]", numbers)) {
        return false;
    }
    target = {numbers[0], numbers[1]};
    return true;
}

bool ObjectReader::read(std::string_view key, glm::dvec3& target) const {
    const JsonValue* value = value_->find(key);
    const FieldFormat& field = *format_->find(key);
    if (!value) return false;
    const Entry entry{*value, pathOf(key), *report_};
    switch (field.type) {
    case ValueType::Color: return checkColor(entry, field.range, target);
    case ValueType::Scales: return checkScales(entry, field.range, target);
    case ValueType::Direction: return checkDirection(entry, field.range, target);
    default: return checkVector(entry, field.range, target);
    }
}

bool ObjectReader::read(std::string_view key, std::array<glm::dvec3, 2>& target) const {
    const JsonValue* value = value_->find(key);
    if (!value) return false;
    const Entry entry{*value, pathOf(key), *report_};
    if (!expectList(entry, 2, "colours", "write [[r, g, b], [r, g, b]]")) return false;
    bool right = true;
    for (std::size_t i = 0; i < 2; ++i) right &= checkColor(entry.item(i), format_->find(key)->range, target[i]);
    return right;
}

bool ObjectReader::read(std::string_view key, std::array<glm::dvec3, 3>& target) const {
    const JsonValue* value = value_->find(key);
    if (!value) return false;
    const Entry entry{*value, pathOf(key), *report_};
    if (!expectList(entry, 3, "points", "write [[x, y, z], [x, y, z], [x, y, z]]")) return false;
    bool right = true;
    for (std::size_t i = 0; i < 3; ++i) right &= checkVector(entry.item(i), format_->find(key)->range, target[i]);
    return right;
}

bool ObjectReader::read(std::string_view key, std::array<double, 16>& target) const {
    const JsonValue* value = value_->find(key);
    const char* example = "write four rows of four numbers in one list";
    const Range range = format_->find(key)->range;
    return value && checkNumbers({*value, pathOf(key), *report_}, range, target.size(), example, target.data());
}

bool ObjectReader::read(std::string_view key, std::array<glm::dvec4, 16>& target) const {
    const JsonValue* value = value_->find(key);
    if (!value) return false;
    const Entry entry{*value, pathOf(key), *report_};
    const char* how = "write 16 points as [x, y, z], or all with a weight, [x, y, z, w]";
    if (!expectList(entry, 16, "points", how)) return false;
    bool right = true;
    target.fill(glm::dvec4(1));
    const std::size_t count = value->children[0].children.size() == 4 ? 4 : 3; // and so for the others
    for (std::size_t i = 0; i < 16; ++i)
        right &= checkNumbers(entry.item(i), format_->find(key)->range, count, how, &target[i].x) &&
                 (count == 3 || checkNumber(entry.item(i).item(3), kWeight, target[i].w));
    return right;
}

std::optional<ObjectReader> ObjectReader::object(std::string_view key) const {
    const JsonValue* value = value_->find(key);
    if (!value) return std::nullopt;
    return ObjectReader(*value, *format_->find(key)->format, pathOf(key), *report_);
}

std::optional<ObjectReader> ObjectReader::objectOrImage(std::string_view key, std::string& image) const {
    const JsonValue* value = value_->find(key);
    if (!value || value->kind == Kind::Object) return object(key);
    const Entry entry{*value, pathOf(key), *report_};
    if (entry.expect(Kind::String, "an image's name or an object with \"image\"") &&
        checkImageName(entry, ValueType::Image, value->text))
        image = value->text;
    return std::nullopt;
}

std::vector<ObjectReader::Member> ObjectReader::members(std::string_view key) const {
    const JsonValue* value = value_->find(key);
    const FieldFormat& field = *format_->find(key);
    if (!value) return {};
    const bool map = field.type == ValueType::Map;
    const Entry entry{*value, pathOf(key), *report_};
    if (!entry.expect(map ? Kind::Object : Kind::Array, map ? "an object" : "a list")) return {};
    const double count = double(value->children.size());
    if (!(count >= field.range.min && count <= field.range.max)) {
        entry.complain(toString(count) + " entries", "use " + spelled(field.range) + " entries");
        return {};
    }
    std::vector<Member> all;
    for (std::size_t i = 0; i < value->children.size(); ++i) {
        const JsonValue& child = value->children[i];
        const Entry member{child, map ? memberPath(pathOf(key), child.key) : entry.item(i).path, *report_};
        if (map) checkLength(member, kName, child.key);
        all.push_back({child.key, &child, member.path});
    }
    return all;
}

bool ObjectReader::readsAllOf(std::string_view key, const std::vector<Member>& read) const {
    if (const JsonValue* value = value_->find(key))
        return value->kind == Kind::Object && read.size() == value->children.size();
    return std::none_of(value_->children.begin(), value_->children.end(),
                        [&](const JsonValue& member) { return !closest(member.key, {key}).empty(); });
}

ObjectReader ObjectReader::open(std::string_view key, const Member& member) const {
    return ObjectReader(*member.value, *format_->find(key)->format, member.path, *report_);
}

} // namespace gnomon
