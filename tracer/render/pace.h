/// How finely to draw so that a picture stays within a tenth of a second: on a slow GPU the user can still steer.
///
/// The time a picture takes goes with its pixels, so what one took tells what any other will. Knows nothing of GL.
#pragma once

namespace gnomon {

class Pace {
  public:
    /// A picture at `scale` of the resolution took `seconds`.
    void took(double seconds, double scale);

    /// Resolution for the next picture over the full one: 1, or the largest of a few steps that keeps the time.
    double scale() const { return scale_; }
    /// A full picture takes longer than a tenth of a second, or nothing is known yet.
    bool slow() const { return scale_ < 1; }
    /// Rows of a full picture of `height` that can be drawn in one step without holding up the user; at least 1.
    int rows(int height) const;

  private:
    double scale_ = 0.25;   ///< the first picture is a quick one, whatever the GPU
    double fullSeconds_ = 0; ///< what a full picture takes
};

} // namespace gnomon
