/// The picture that the shader ought to draw, by a ray tracer on the CPU.
///
/// Whitted's tree over the oracle's nearest hits: Blinn-Phong with hard shadows, conductors, dielectrics and coats by
/// the Fresnel equations or Schlick's formula, as the scene says, mirrors, media that lie in one another, overlap and
/// absorb, lights of every kind, one background colour. Left out: textures, checkers, normal maps, cube maps, glow, and
/// the threshold below which the shader follows no ray. Rays are long double, since what they meet is decided from 1e4
/// units away; colours are double. A secondary ray starts 1e-12 of its coordinates off the surface, on the side it
/// travels on, and knows nothing else of where it starts: no object numbers, no sides, no tMin as in the shader.
#pragma once

#include "lab/reference/exact/scene_hit.h"
#include "tracer/image.h"
#include "tracer/scene/scene.h"

#include <vector>

namespace gnomon::oracle {

/// Least and most of samples, each channel by itself.
struct ColorRange {
    glm::dvec3 least{1e30}, most{-1e30};
    void widen(glm::dvec3 color);
};

class Picture {
  public:
    static constexpr int kFine = 4; ///< subpixels a side

    /// Traces the middle of every pixel, on two threads. `depth` as in Settings.
    Picture(const Scene&, int width, int height, int depth);

    /// Of the linear light along a ray.
    glm::dvec3 color(Vec origin, Vec direction) const { return color(origin, direction, 1, bodiesAt(origin)); }
    glm::dvec3 middle(int x, int y) const { return middles_[std::size_t(y) * width_ + x]; }
    /// Over the subpixels of a pixel, which may lie outside of the picture.
    ColorRange pixel(int x, int y) const;
    /// How far a colour is beyond the range over a pixel and its eight neighbours, the pixel's middle included, in the
    /// worst channel; infinite for what is no number. Where the subpixels' range is not enough, edges between subpixels
    /// are searched for the colours at their very brink: towards a silhouette a colour changes ever faster, as the
    /// square root of the distance. Looks no further than to find that it is at most `enough`.
    double beyond(glm::dvec3 color, int x, int y, double enough) const;

    int width() const { return width_; }
    int height() const { return height_; }

  private:
    /// Dielectric bodies that a ray is inside of, each by its first object; by what importance they have.
    using Bodies = std::vector<int>;
    Bodies bodiesAt(Vec point) const;
    int bodyOf(int object) const;
    bool moreImportant(int body, int than) const;
    Bodies beyond(const SceneHit&, Bodies& inside) const;
    Dielectric mediumOf(const Bodies&) const;

    /// `passed`: surfaces since the last that bent or mirrored.
    glm::dvec3 color(Vec origin, Vec direction, int depth, Bodies inside, int passed = 0) const;
    glm::dvec3 scattered(const Material&, const SceneHit&, Vec direction, int depth, const Bodies& inside,
                         const Bodies& beyond) const;
    void widenAtEdges(ColorRange&, int x, int y) const;
    glm::dvec3 reflectance(const Material&, long double cosine, long double eta) const;
    glm::dvec3 shade(const Material&, const SceneHit&, Vec direction) const;
    bool lit(Vec start, Vec way, long double end) const;

    Scene scene_;
    std::vector<SceneShape> shapes_, casters_;
    int width_, height_, depth_;
    std::vector<glm::dvec3> middles_;
};

/// How a picture of the shader's differs from the oracle's.
struct Difference {
    static constexpr int kMost = 8; ///< outliers counted: each takes seconds to make sure of
    int outliers = 0;               ///< pixels outside of what the oracle sees around them, by more than the tolerance
    double worst = 0;               ///< farthest of the outliers
    glm::ivec2 worstAt{-1};
    int moved = 0;   ///< pixels that differ from the oracle's middle by more than the tolerance
    double rmse = 0; ///< over all channels, to the middles
};

/// Each pixel must lie within the oracle's range over its 3 x 3 neighbourhood, give or take `tolerance` in each
/// channel.
Difference compare(const FloatImage&, const Picture&, double tolerance);

} // namespace gnomon::oracle
