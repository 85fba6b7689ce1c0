/// How far the picture is from that of the largest depth: rays that meet a mirror or glass at their last surface do not
/// carry what they should have shown.
#pragma once

#include "tracer/image.h"
#include "tracer/render/pass/trace_pass.h"

#include <string>

namespace gnomon {

struct DepthCut {
    static constexpr double kMost = 0.01; ///< that need not be told
    int depth = 0;                        ///< of the settings
    double error = 0;                     ///< mean of the pixels' worst channels, 1 between black and white
    int enough = 0;                       ///< the least depth from there on whose error is at most kMost
};

/// One line; empty where so little is cut that it need not be told.
std::string messageOf(const DepthCut&);

/// Measures it on pictures that are small enough to cost nothing.
class DepthProbe {
  public:
    /// Nothing where the scene ends such rays by itself, the output is no colour, or the GL has no float targets.
    DepthCut measure(const Drawing&, View, Frame&);

  private:
    FloatImage pictureAt(int depth, const Drawing&, const View&, Frame&);

    TracePass trace_;
};

} // namespace gnomon
