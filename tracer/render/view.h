/// All that changes from frame to frame.
#pragma once

#include "tracer/plan/camera.h"

#include <algorithm>
#include <cmath>

namespace gnomon {

struct View {
    CameraPose camera;
    double time = 0;
    int width = 0, height = 0; ///< pixels

    bool operator==(const View&) const = default;
};

/// The same view with fewer pixels.
inline View scaled(View view, double scale) {
    view.width = std::max(1, int(std::lround(view.width * scale)));
    view.height = std::max(1, int(std::lround(view.height * scale)));
    return view;
}

} // namespace gnomon
