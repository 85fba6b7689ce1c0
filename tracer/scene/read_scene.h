/// Scene files: strict JSON (comments allowed) to a checked Scene. The format stands in
/// assets/scenes/scene.schema.json.
#pragma once

#include "tracer/problem.h"
#include "tracer/scene/scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace gnomon {

/// Reads `text`; `file` stands in messages. Every problem of the file is reported in one pass, each with its line and
/// path; with any problem the answer is empty: nothing is ever drawn from a bad file.
std::optional<Scene> readScene(std::string_view text, const std::string& file, Problems&);

/// The JSON schema (draft 2020-12) of scene files, generated from the same tables that the reader uses.
std::string sceneSchema();

} // namespace gnomon
