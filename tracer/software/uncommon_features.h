/// A picture in parts, each drawn by the smallest program that can. Where the processor draws, all that a program has
/// is paid for by every pixel; and few pixels need most of it.
///
/// sky    where rays from the eye meet nothing: tracer/software/screen_partition.h tells which pixels those are
/// usual  all but what is rare; a pixel of which a ray meets something rare, or may, is left to the whole program
///        (shaders/software/fallback.glsl)
/// whole  everything, for the pixels that are left
///
/// What is rare is told from the scene and its camera alone: neither time nor moving the eye makes new programs. The
/// picture is the same with parts and without, to every float (tests/shader/variants_test.cpp).
#pragma once

#include "tracer/plan/features.h"

namespace gnomon {

/// Notes in the features of a scene what is rare in it.
void markUncommon(const Scene&, Features&);

/// The usual program has something less than the whole one.
bool anyUncommon(const Features&);

/// Of the usual program. Its numbers lie where the whole one's do.
Features baseOf(Features whole);

/// The usual program cannot draw an object of this kind and material. Features of the whole one.
bool fallsBack(const Features&, const KindCount&, const Material&);

} // namespace gnomon
