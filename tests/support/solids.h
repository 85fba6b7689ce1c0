/// One solid of each operation, and some of several: what is known of solids is tested on all of them.
#pragma once

#include <string_view>

namespace gnomon::test {

struct SolidExample {
    std::string_view name, json; ///< keys of an object of a scene file
};

inline constexpr SolidExample kSolids[] = {
    {"Union",
     R"("union": [{"sphere": {"center": [-0.6, 0, 0], "radius": 0.7}}, {"box": {"center": [0.5, 0.1, 0],
          "half_size": [0.5, 0.4, 0.6]}}])"},
    {"Intersection",
     R"("intersection": [{"sphere": {"center": [0, 0, 0], "radius": 1}}, {"box": {"center": [0.4, 0, 0],
          "half_size": [0.8, 0.6, 0.5]}},
        {"plane": {"point": [0, 0.4, 0], "normal": [0.1, 1, 0]}}])"},
    {"Difference",
     R"("difference": [{"box": {"center": [0, 0, 0], "half_size": [0.9, 0.8, 0.7]}},
          {"cylinder": {"from": [0, -2, 0], "to": [0, 2, 0.2], "radius": 0.4}},
        {"sphere": {"center": [0.9, 0.8, 0.7], "radius": 0.5}}])"},
    {"SmoothUnion",
     R"("blend": 0.5, "smooth_union": [{"sphere": {"center": [-0.5, 0, 0], "radius": 0.5}},
          {"capsule": {"from": [0.3, -0.5, 0], "to": [0.4, 0.7, 0.3], "radius": 0.25}},
        {"torus": {"center": [0, -0.2, 0], "axis": [0.2, 1, 0], "major_radius": 0.8, "minor_radius": 0.15}}])"},
    {"Offset", R"("offset": {"by": 0.2, "of": {"box": {"center": [0, 0, 0], "half_size": [0.6, 0.3, 0.5]}}})"},
    {"Plate",
     R"("offset": {"by": 0.2, "of": {"triangle": {"vertices": [[-0.7, -0.5, 0], [0.7, -0.4, 0.2],
          [0.1, 0.7, -0.1]]}}})"},
    {"Puck",
     R"("offset": {"by": 0.2, "of": {"disc": {"center": [0, 0, 0.1], "normal": [0.2, 1, 0.3], "radius": 0.8}}})"},
    {"Shrunk", R"("offset": {"by": -0.2, "of": {"cone": {"from": [0, -1, 0], "to": [0, 1.2, 0], "radius": 1}}})"},
    {"Transform",
     R"("transform": {"rotate": [30, -40, 70], "scale": 0.6, "translate": [0.2, 0.1, -0.3],
          "of": {"difference": [{"box": {"center": [0.2, 0, 0], "half_size": [1.2, 0.8, 0.9]}},
        {"capsule": {"from": [0, -2, 0], "to": [0.5, 2, 0], "radius": 0.5}}]}})"},
    {"Repetition",
     R"("repetition": {"period": [0.7, 0, 0.9], "count": [3, 1, 2],
          "of": {"union": [{"capsule": {"from": [-0.7, -0.5, -0.4], "to": [-0.7, 0.3, -0.4], "radius": 0.12}},
        {"sphere": {"center": [-0.7, 0.5, -0.4], "radius": 0.22}}]}})"},
    {"LongCopies",
     R"("repetition": {"period": [0.25, 0, 0], "count": [4, 1, 1],
          "of": {"union": [{"sphere": {"center": [-1, -0.4, 0], "radius": 0.2}},
        {"capsule": {"from": [-1, -0.4, 0], "to": [0, 0.3, 0], "radius": 0.12}}]}})"},
    {"FlushCut",
     R"("difference": [{"box": {"center": [0, 0, 0], "half_size": [1, 0.4, 1]}},
          {"cylinder": {"from": [0, -0.4, 0], "to": [0, 0.4, 0], "radius": 0.7}}])"},
    {"Nested",
     R"("smooth_union": [{"transform": {"translate": [0.3, 0, 0], "rotate": [0, 0, 45],
          "of": {"offset": {"by": 0.05, "of": {"box": {"center": [0, 0, 0], "half_size": [0.3, 0.3, 0.3]}}}}}},
        {"transform": {"scale": 0.5, "of": {"transform": {"translate": [-1.4, 0, 0.2], "rotate": [20, 0, 10],
            "of": {"cylinder": {"from": [0, -1, 0], "to": [0, 1, 0], "radius": 0.6}}}}}}],
        "blend": 0.2)"},
    {"ScaledUnevenly",
     R"("transform": {"rotate": [30, -40, 70], "scale": [0.6, 0.3, 0.9],
          "of": {"difference": [{"sphere": {"center": [0.2, 0, 0], "radius": 1}},
        {"box": {"center": [0.9, 0.5, 0.2], "half_size": [0.6, 0.5, 0.4]}}]}})"},
    {"Mandelbulb", R"("mandelbulb": {"center": [0.1, 0, 0], "radius": 0.9, "power": 8, "iterations": 6})"},
};

} // namespace gnomon::test
