/// Scene files: strict JSON (comments allowed) to a checked Scene. The format stands in
/// assets/scenes/scene.schema.json.
#pragma once

#include "tracer/problem.h"
#include "tracer/scene/scene.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

/// The bytes of a file that a scene names, by its path from the scene's own folder; a problem where there is none.
using SceneFiles = std::function<std::optional<std::string>(const std::string& path, Problems&)>;

inline constexpr std::size_t kMaxSceneFileBytes = std::size_t(64) << 20;

/// Reads `text`; `file` stands in messages. Every problem of the file is reported in one pass, each with its line and
/// path; with any problem the answer is empty: nothing is ever drawn from a bad file.
std::optional<Scene> readScene(std::string_view text, const std::string& file, Problems&, const SceneFiles& = {});

/// The files that a scene's text names, each once: what readScene() is going to ask for.
std::vector<std::string> filesOf(std::string_view text);

/// The JSON schema (draft 2020-12) of scene files, generated from the same tables that the reader uses.
std::string sceneSchema();

} // namespace gnomon
