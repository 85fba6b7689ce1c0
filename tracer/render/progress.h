/// How far all is that the wanted scene and settings take. Every host asks this and nothing else.
#pragma once

namespace gnomon {

struct Progress {
    bool wanted = false; ///< there is a scene to draw
    double compiled = 0; ///< fraction of the programs that are ready
    double images = 0;   ///< fraction of the scene's images that have come
    double baked = 1;    ///< fraction of the scene's fields that are baked
    double samples = 0;  ///< fraction of the picture at full resolution that is drawn since it last changed
    bool failed = false; ///< a program does not compile: what drew before draws on

    /// All programs and fields are there: the picture is the one that was asked for.
    bool ready() const { return wanted && compiled >= 1 && baked >= 1 && !failed; }
    /// Something is on its way that another poll may bring.
    bool compiling() const { return wanted && (compiled < 1 || baked < 1) && !failed; }
};

} // namespace gnomon
