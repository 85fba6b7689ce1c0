// Torus as textbooks have it: the baseline that shaders/primitive/torus.glsl is measured against.
//
// Source  with z along the axis, (|p|² - R² - r²)² + 4 R² z² = 4 R² r² is the quartic
//             t⁴ + 4 a t³ + 4 b t² + 8 c t + 4 d = 0,
//         depressed to x⁴ + 6 p x² + 4 q x + 3 r = 0 by t = x - a, and parted (Ferrari) into
//             (x² + 2 e x + w - f)(x² - 2 e x + w + f), where w solves w³ - 3 p w² - 3 r w + 9 p r - 2 q² = 0.
//         That resolvent cubic is solved in closed form: by acos and cos where it has three real roots, else by a cube
//         root. The torus of I. Quilez, Intersectors, is of this kind
// Limits  the coefficients grow with the fourth power of the distance: of rays into the bounding sphere (R = 1, r =
//         1/4) 3 of 1000 are answered wrongly from 10 units away, half from 30, three quarters from 100. Unit
//         directions only. An epsilon keeps rays off their own start; side is ignored
struct Torus {
    vec3 center;
    float major;
    vec3 axis;
    float minor;
};

Torus loadTorus(int at) {
    vec4 a = sceneTexel(at);
    vec4 b = sceneTexel(at + 1);
    return Torus(a.xyz, a.w, b.xyz, b.w);
}

// The real root of the resolvent cubic that the factors are made of.
float torusResolvent(float p, float q, float r) {
    float slope = p * p + r;
    float height = 3.0 * r * p - p * p * p - q * q;
    float discriminant = height * height - slope * slope * slope;
    if (discriminant < 0.0) {
        float root = sqrt(slope);
        return p - 2.0 * root * cos(acos(clamp(height / (slope * root), -1.0, 1.0)) / 3.0);
    }
    float root = pow(sqrt(discriminant) + abs(height), 1.0 / 3.0);
    float sum = root + slope / root;
    return height < 0.0 ? p + sum : p - sum;
}

// Takes the nearer root of x² + 2 e x + e² = square that lies ahead, if any.
void torusRoots(float e, float square, float shift, float least, inout float hit) {
    if (square < 0.0) return;
    float root = sqrt(square);
    float first = -e - root - shift;
    float second = -e + root - shift;
    float ahead = first > least ? first : second;
    if (ahead > least && ahead < hit) hit = ahead;
}

bool intersectTorus(Torus torus, Ray ray, float side, inout float t) {
    vec3 o = ray.origin - torus.center;
    float oAlong = dot(o, torus.axis);
    float dAlong = dot(ray.direction, torus.axis);
    float R2 = torus.major * torus.major;
    float r2 = torus.minor * torus.minor;
    float a = dot(o, ray.direction);
    float k = 0.5 * (dot(o, o) - R2 - r2);
    float b = a * a + k + R2 * dAlong * dAlong;
    float c = a * k + R2 * oAlong * dAlong;
    float d = k * k + R2 * (oAlong * oAlong - r2);

    float p = (2.0 * b - 3.0 * a * a) / 3.0;
    float q = 2.0 * (a * a * a - a * b + c);
    float r = (4.0 * a * a * b - 3.0 * a * a * a * a - 8.0 * a * c + 4.0 * d) / 3.0;
    float w = torusResolvent(p, q, r);
    float twiceSquare = w - 3.0 * p; // 2 e²
    if (twiceSquare < -1e-4) return false;
    float e = sqrt(max(0.5 * twiceSquare, 0.0));
    float f = q / max(e, 1e-6);
    if (twiceSquare < 0.05) f = (q < 0.0 ? -1.0 : 1.0) * sqrt(max(w * w - 3.0 * r, 0.0)); // q / e would be rounding
    float least = max(ray.tMin, 1e-4);
    float hit = t;
    torusRoots(e, e * e - w + f, a, least, hit);
    torusRoots(-e, e * e - w - f, a, least, hit);
    if (!(hit < t)) return false;
    t = hit;
    return true;
}

Surface surfaceTorus(Torus torus, Ray ray, float t) {
    vec3 point = ray.origin + t * ray.direction;
    vec3 p = point - torus.center;
    vec3 across = p - dot(p, torus.axis) * torus.axis;
    vec3 outward = normalize(across);
    vec3 normal = normalize(p - torus.major * outward);
    Surface surface = bareSurface(point, normal, 1.0 / torus.minor);
#if IMAGES
    const float kTwoPi = 6.28318530717959;
    vec3 first = normalize(cross(abs(torus.axis.x) < 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), torus.axis));
    surface.tangent = cross(torus.axis, outward);
    float angle = atan(dot(outward, cross(torus.axis, first)), dot(outward, first));
    surface.uv = vec2(angle, atan(-dot(normal, torus.axis), dot(normal, outward))) / kTwoPi + 0.5;
    surface.uvPerUnit = 1.0 / (kTwoPi * vec2(torus.major, torus.minor));
#endif
    return surface;
}
