/// What the viewer's exports share. The page owns events, time and loading; what they mean is decided in Viewer.
#pragma once

#include "tracer/render/viewer.h"
#include "web/host.h"

#include <memory>

struct ViewerHost {
    std::unique_ptr<gnomon::Viewer> viewer;
    gnomon::Problems problems; ///< of frames, until the page takes them
};
extern ViewerHost host;
