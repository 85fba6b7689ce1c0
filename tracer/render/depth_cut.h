/// How much light the largest depth keeps from a picture: rays that meet a mirror or glass there carry what they should
/// have shown.
#pragma once

#include "tracer/render/pass/trace_pass.h"

#include <string>

namespace gnomon {

struct DepthCut {
    static constexpr double kMost = 0.01; ///< that need not be told
    int depth = 0;                        ///< of the settings
    double part = 0;                      ///< of the picture's light, at that depth
    int enough = 0;                       ///< the least depth that leaves at most kMost, 0 where none does
};

/// One line; empty where so little is cut that it need not be told.
std::string messageOf(const DepthCut&);

/// Measures it on a picture that is small enough to cost nothing: the trace pass leaves it in alpha.
class DepthProbe {
  public:
    /// Nothing where the scene ends such rays by itself, the output is no colour, or the GL has no float targets.
    DepthCut measure(const Drawing&, View, Frame&);

  private:
    double partAt(int depth, const Drawing&, const View&, Frame&);

    TracePass trace_;
};

} // namespace gnomon
