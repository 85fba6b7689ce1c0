/// How finely to draw so that a moving picture stays within a fraction of a second: on a slow GPU the user can still
/// steer.
///
/// Only feedback: what a picture took holds time that does not go with its pixels (the browser's own, the wait for the
/// next frame), so a finer one is tried, not computed; where it proves too slow, the next try waits twice as long.
/// Knows nothing of GL.
#pragma once

namespace gnomon {

class AdaptiveResolution {
  public:
    /// The last picture, drawn at scale(), took `seconds`.
    void tookPicture(double seconds);
    /// Resolution for the next picture over the full one.
    double scale() const;
    /// Moving pictures are drawn coarser than the full one.
    bool slow() const { return level_ > 0; }

    /// The last band of a still picture took `seconds`.
    void tookBand(double seconds);
    /// Rows of a still picture of `height` to draw in the next step; at least 1.
    int rows(int height) const;

  private:
    int level_ = 3; ///< of the scales, 0 = full: the first picture is a quick one, whatever the GPU
    int wait_ = 0;  ///< pictures until a finer one is tried
    int patience_ = 1;
    double band_ = 1.0 / 16; ///< of a still picture
};

} // namespace gnomon
