/// Files that results go to, pictures and texts alike.
///
/// A regular file is written whole or not at all: into a draft beside it that is renamed, so that a full disk or an
/// interruption leaves what stood there before. Links are followed, and the file keeps its mode and its owner. One that
/// has several names, or whose folder takes no draft, is overwritten once the disk has granted the room. Pipes and
/// devices get the bytes as they are.
/// `-` is standard output.
#pragma once

#include "tracer/problem.h"

#include <string>
#include <string_view>

namespace gnomon {

/// Whether `file` can take a result, to be asked before long work; a problem where not. If it is standard output, then
/// what is printed goes to stderr from here on.
bool prepareOutput(const std::string& file, Problems&);

/// A problem where `file` has been read here: a result would replace it. To be asked once all is read, before long
/// work; an empty name is none.
bool sparesInputs(const std::string& file, Problems&);

/// False, with a problem, where the bytes cannot be written, or would replace what has been read.
bool writeOutput(const std::string& file, std::string_view bytes, Problems&);

/// It has no name whose ending could tell a format: standard output, a pipe or a device.
bool isStream(const std::string& file);

} // namespace gnomon
