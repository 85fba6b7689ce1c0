/// Evaluates the conditions of `#if` lines: integers and known names with ! && || == != < > <= >= and parentheses.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace gnomon {

/// The value of a name; empty where the name is not known.
using NameValue = std::function<std::optional<int>(std::string_view)>;

/// Empty, with `error` saying why, where the text is no condition.
std::optional<int> evaluateCondition(std::string_view text, const NameValue&, std::string& error);

} // namespace gnomon
