/// Files that users give: measured before they are read, and read no further than they may be long.
#pragma once

#include "tracer/problem.h"

#include <cstddef>
#include <optional>
#include <string>

namespace gnomon {

/// All bytes of a regular file, of a pipe, or of standard input, which is called `-`. Nothing, with a problem, where
/// there are more than `most` (`remedy` says what to do then), where it is a folder or a device, or cannot be read.
std::optional<std::string> readInput(const std::string& file, std::size_t most, const std::string& remedy, Problems&);

/// Whether it is a regular file that has been read here, under whatever name.
bool wasRead(const std::string& file);

/// As messages call it.
std::string inputName(const std::string& file);

} // namespace gnomon
