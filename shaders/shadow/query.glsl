// The light that a surface point asks for: what every shadow model is given.
//
// ray          from the surface point to the light's centre; it leaves on the side where the light stands
// normal       of the surface, unit, on that side
// distance     to the light's centre; what lies beyond is no occluder
// lightRadius  0: a point
// pixelRadius  of the surface sphere: half of what a pixel covers there. It touches the surface and nothing else
//
// Every model is one file shaders/shadow/MODEL.glsl with float visibility(ShadowQuery): the fraction of the light's
// disc that is seen. The disc lies about the light's centre across the ray, and its rim on the cone that touches the
// light's sphere.
struct ShadowQuery {
    Ray ray;
    vec3 normal;
    float distance;
    float lightRadius;
    float pixelRadius;
};

ShadowQuery shadowQueryTo(Surface surface, int self, Light light, float width) {
    vec3 toLight = light.position - surface.point;
    float distance = length(toLight);
    vec3 direction = distance > 0.0 ? toLight / distance : surface.normal;
    float side = dot(direction, surface.normal) >= 0.0 ? 1.0 : -1.0;
    return ShadowQuery(rayFrom(surface.point, direction, self, side), side * surface.normal, distance, light.radius,
        0.5 * width);
}

// Radius of the light's disc over its distance, at most that of a light which the point all but touches.
float discSlope(float distance, float radius) {
    float sine = min(radius / distance, 0.999);
    return sine * inversesqrt(1.0 - sine * sine);
}
