/// Lines of words and numbers, as the text files of models have them.
#pragma once

#include <string>
#include <string_view>

namespace gnomon {

bool isBlank(char); ///< a space or a tab

/// The next word of a line, which loses it.
std::string_view nextWord(std::string_view& line);

/// The next line of a text, which loses it. Lines end as on any system: with \n, \r\n or \r.
std::string_view nextLine(std::string_view& text);

/// The text without the mark of its byte order.
std::string_view withoutMark(std::string_view text);

/// Whether `word` is a decimal number, without what strtod takes besides: hexadecimal, inf and nan.
bool decimal(std::string_view word, double& number);

} // namespace gnomon
