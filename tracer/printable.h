/// Names and titles that users' files bring, on their way to a terminal.
#pragma once

#include <string>
#include <string_view>

namespace gnomon {

/// `text` with every character that would steer a terminal rather than be seen as JSON escapes it, \u001b: controls,
/// changes of direction, line separators; and bytes that are no UTF-8 as \xNN. Line ends are among them unless they are
/// `lines` of a text.
std::string printable(std::string_view text, bool lines = false);

} // namespace gnomon
