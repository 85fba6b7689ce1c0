/// How a picture is shared out among shader variants: which features of a scene are uncommon, so that a base variant
/// does without them and falls back to the full one where a ray may meet one. Plain data; tracer/software decides it.
#pragma once

#include "tracer/scene/scene.h"

#include <cstddef>
#include <vector>

namespace gnomon {

struct ScreenSplit {
    struct Kind {
        bool shape = false;  ///< few pixels meet one, and it is expensive to intersect: a base variant has only its
                             ///< bounding sphere
        bool images = false; ///< few pixels meet one that shows an image: a base variant has none of the images
        bool operator==(const Kind&) const = default;
    };

    bool on = false;                             ///< several variants draw
    bool refraction = false, normalMaps = false; ///< uncommon
    std::vector<Kind> kinds;                     ///< of SceneFeatures::shapes; empty: nothing is uncommon
    bool fallback = false;                       ///< this plan is of the base variant
    int tile = 0; ///< side in pixels of the squares in which the full variant draws discarded pixels; 0: stencil test

    bool coverageMask = false; ///< this plan's variant marks what it draws in a mask, for such squares

    /// The base variant has something less than the full one.
    bool anyUncommon() const;
    Kind kind(std::size_t i) const { return i < kinds.size() ? kinds[i] : Kind{}; }
    /// The base variant cannot draw an object of kind `i` and this material.
    bool fallsBack(std::size_t i, const Material&) const;

    bool operator==(const ScreenSplit&) const = default;
};

} // namespace gnomon
