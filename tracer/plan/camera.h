/// First-person camera: a place and two look angles, as the first source steers it.
#pragma once

#include "tracer/scene/scene.h"

#include <glm/glm.hpp>

namespace gnomon {

/// Right-handed frame of a camera: `forward`, `right`, `up` are unit and orthogonal.
struct CameraFrame {
    glm::dvec3 eye, forward, right, up;
    double halfHeight = 1.0 / 3.0; ///< tan(fov / 2): half height of the canvas at distance 1
};

/// A pose that looks along its own `up`, or at its own eye, still gives a frame.
CameraFrame frameOf(const CameraPose&);

class Camera {
  public:
    /// Eye, view direction, up and fov from `pose`. Views closer than 0.01 rad to `up` are tilted off it.
    void setPose(const CameraPose& pose);
    CameraPose pose() const;

    /// Turns by angles in radians: `right` about the world's up, `up` towards it; the world never turns upside down.
    void look(double right, double up);
    /// Turns so that what is seen in the middle follows a pointer, by pixels right and down of a view `height` high.
    void drag(double dx, double dy, double height);
    /// Moves along forward, right and up of the camera, in scene units.
    void move(glm::dvec3 forwardRightUp);
    /// Moves towards what is looked at, so that its distance is divided by `ratio`.
    void zoom(double ratio);
    /// Moves sideways so that what is looked at follows a pointer, by pixels right and down of a view `height` high.
    void pan(double dx, double dy, double height);

  private:
    glm::dvec3 eye_{0, 0, 3};
    glm::dvec3 up_{0, 1, 0};         ///< the world's
    double u_ = 0;                   ///< azimuth about up_; for +y, 0 looks along -z and grows to the right
    double v_ = 1.57079632679489662; ///< angle from up_, within [0.01, 3.13]
    double fov_ = CameraPose{}.fov;
    double reach_ = 3; ///< distance eye–target: pose() gives a target back, zoom() and pan() measure by it
};

} // namespace gnomon
