// What a ray of a path carries beside its origin and direction.
//
// Ray cone  each ray carries the width that its pixel has grown to and the angle that it still grows by; curved mirrors
//           widen it
// Source    T. Akenine-Möller et al., Texture Level of Detail Strategies for Real-Time Ray Tracing, Ray Tracing Gems
//           2019
struct Path {
    vec3 throughput; // of this ray to the pixel
    int depth;       // 1 for the primary ray
    float width;     // of the ray cone at the ray's start
    float spread;    // of the ray cone, radians
};

Path primaryPath() { return Path(vec3(1.0), 1, 0.0, frame.pixelAngle); }
