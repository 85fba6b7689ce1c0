/// A JSON text as a small tree that remembers its lines, so that every later complaint can say where it stands.
///
/// Accepts JSON with comments and a UTF-8 byte order mark. Refuses texts that are too large, too deep or not JSON with
/// one problem in plain words; duplicate keys are problems too, but the tree is still returned so that the rest is
/// checked.
#pragma once

#include "tracer/problem.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

struct JsonValue {
    enum class Kind { Null, Boolean, Number, String, Array, Object };

    Kind kind = Kind::Null;
    int line = 0; ///< where the value begins
    bool boolean = false;
    double number = 0; ///< finite
    std::string text;
    std::string key; ///< in an object: under which key; keys may occur twice
    int keyLine = 0;
    std::vector<JsonValue> children; ///< of an array or object, in file order

    /// The first member of that key, or null.
    const JsonValue* find(std::string_view wanted) const;
};

/// "a number", "a list", …: what a user calls a value of this kind.
std::string_view describe(JsonValue::Kind);

/// `path` followed by a member: `path.key`, or `path["key"]` where the key is not a plain word.
std::string memberPath(const std::string& path, std::string_view key);

inline constexpr std::size_t kMaxJsonBytes = 16 << 20;
inline constexpr std::size_t kMaxJsonDepth = 64;
inline constexpr std::size_t kMaxJsonValues = 2'000'000;

std::optional<JsonValue> parseJson(std::string_view text, ProblemCounter&);
std::optional<JsonValue> parseJson(std::string_view text, const std::string& file, Problems&);

} // namespace gnomon
