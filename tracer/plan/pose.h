/// Where a picture of a scene is taken from.
#pragma once

#include "tracer/problem.h"
#include "tracer/scene/scene.h"
#include "tracer/settings/settings.h"

#include <optional>
#include <string_view>

namespace gnomon {

/// The scene's camera with what the settings say instead. None, with a problem, where settings and scene do not fit
/// together; `source` is where the settings were given, as for setFromText().
std::optional<CameraPose> poseOf(const Scene&, const Settings&, std::string_view source, Problems&);

} // namespace gnomon
