/// A picture shared out among shader variants, each pixel drawn by the smallest that can: on a software rasteriser all
/// that a program has is paid for by every pixel, and few pixels need most of it.
///
/// sky   where rays from the eye meet nothing: tracer/software/screen_partition.h tells which pixels those are
/// base  all but the uncommon features; a pixel of which a ray meets one, or may, is discarded and falls back to full
///       (shaders/software/fallback.glsl)
/// full  everything, for the pixels that are left
///
/// What is uncommon is told from the scene and its camera alone: neither time nor moving the eye makes new programs.
/// The picture is the same with one variant and with several, to every float (tests/shader/variants_test.cpp).
#pragma once

#include "tracer/plan/plan.h"
#include "tracer/software/screen_partition.h"

#include <span>
#include <vector>

namespace gnomon {

/// The plan of a scene, split where settings and target ask for it.
Plan splitScreen(Plan, const PreparedScene&, const Settings&);

/// planOf() and splitScreen().
Plan splitPlanOf(const PreparedScene&, const Settings&, const CodegenTarget&);

/// Of the base variant, whose values lie where the full one's do; the full one's where nothing is uncommon.
Plan baseOf(Plan full);

/// Of the sky's variant.
Plan skyOf(Plan full);

/// What rays from the eye may meet of `shapes`, which are the scene's objects.
std::vector<ScreenBounds> screenBoundsOf(const PreparedScene&, const Plan&, std::span<const Shape> shapes);

} // namespace gnomon
