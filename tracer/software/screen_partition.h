/// Which rectangles of a picture the smaller programs may draw (tracer/software/uncommon_features.h): what rays from
/// the eye through them cannot meet is told from the boxes about all objects.
///
/// Error  to the safe side: a pixel of `sky` sees no object, one of `base` none that is uncommon, with a
///        pixel to spare for what float32 makes of rays in the shader (tests/unit/screen_partition_test.cpp)
/// Cost   quarters of the picture are asked until they are settled or a tile of 8 pixels
#pragma once

#include "tracer/accel/bounds.h"
#include "tracer/plan/camera.h"

#include <optional>
#include <span>
#include <vector>

namespace gnomon {

/// An object as eye rays may meet it. Without bounds it may be anywhere.
struct ScreenBounds {
    std::optional<Bounds> bounds;
    bool round = false; ///< inside of the ball within the box, too
    bool uncommon = false;
};

/// In pixels, from the lowest row and the leftmost column.
struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;

    bool operator==(const Rectangle&) const = default;
};

/// Together the rectangles are the picture, and none overlaps another.
struct ScreenPartition {
    std::vector<Rectangle> sky, base, uncommon;
};

/// Of a picture of `width` x `height` pixels. The camera is told in the coordinates of the bounds.
ScreenPartition partitionOf(std::span<const ScreenBounds>, const CameraFrame& camera, int width, int height);

} // namespace gnomon
