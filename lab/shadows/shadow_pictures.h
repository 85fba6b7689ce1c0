/// What shadow models look like beside the reference.
#pragma once

#include "lab/shadows/shadow_lab.h"

#include <string>

namespace gnomon {

/// FOLDER/SCENE-MODEL.png for each model of the plan that is not sampled, at its first radius and the epsilon nearest
/// to 1/30: the model, the reference, and four times their difference. False, with problems, where one cannot be
/// written.
bool writePictures(const std::string& folder, const Loaded&, const ShadowPlan&, Problems&);

} // namespace gnomon
