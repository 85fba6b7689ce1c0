/// The windows `gnomon view` can open. Each opens one, makes a Session in it, feeds it events and time, and shows its
/// frames.
#pragma once

#include "native/exit.h"
#include "native/file/asset_folder.h"
#include "tracer/settings/settings.h"

namespace gnomon {

struct ViewTask {
    Settings settings;
    Loaded loaded;
    int frames = 0; ///< ends after so many; 0: when the user closes the window
};

/// Each answers the program's exit code.
int viewWithGlfw(ViewTask);
int viewWithSdl(ViewTask);

/// Seconds to sleep where a window has nothing to show yet, so that waiting costs little.
inline constexpr double kIdleSeconds = 0.005;

} // namespace gnomon
