// The dielectric bodies that a ray is inside of: its medium is that of the highest rank among them. So bodies may lie
// in one another, overlap and touch: where the medium stays the same a surface is no interface, and the ray goes
// straight on.
//
// inside       of the current ray: four ranks, from the highest down, 0 where there are fewer; of more bodies the
//              highest four count. tracer/plan/media.h ranks the bodies of a scene
// beyond       the same behind the surface that it meets
// resetMedia   for the ray that starts at the eye
// crossMedia   at a surface of `object`, met on `side`: sets `beyond`; the index where the ray is, over that behind the
//              surface, 0 where it is no interface. A surface that tells otherwise than `inside`, since it was crossed
//              already with one that it touches, changes nothing. The skin of a body (rank negative), which may have
//              holes, is believed before what is known
// coincide     whether two surfaces that the ray meets at t and u are one within rounding: crossed together they leave
//              no film of air between water and its glass
// absorbed     of the light that travels t in the ray's medium, what is left
// Limits       surfaces nearer than 4e-6 of the distance from the ray's start and of its coordinates are one
// Source       C. Schmidt and B. Budge, Simple Nested Dielectrics in Ray Traced Images, 2002; A. Beer, Bestimmung der
//              Absorption des rothen Lichts in farbigen Flüssigkeiten, 1852
uvec4 inside;
uvec4 beyond;

void resetMedia() { inside = uvec4(sceneTexel(kMediaBase + kMediaCount + 1)); }

uvec4 with(uvec4 set, uint rank) {
    uvec4 grown = max(set, min(uvec4(0xFFFFu, set.xyz), uvec4(rank)));
    return any(equal(set, uvec4(rank))) ? set : grown;
}

uvec4 without(uvec4 set, uint rank) {
    uvec4 higher = uvec4(greaterThan(set, uvec4(rank)));
    return any(equal(set, uvec4(rank))) ? higher * set + (1u - higher) * uvec4(set.yzw, 0u) : set;
}

float rankOf(int object) { return object < 0 ? 0.0 : sceneTexel(kObjectBase + object).w; }
vec4 mediumOf(uvec4 set) { return sceneTexel(kMediaBase + int(set.x)); } // absorption, index

bool coincide(Ray ray, float t, float u, float cosine) {
    vec3 size = abs(ray.origin);
    // At most 8e-5 along the ray: nearestHit() knows what follows within 1e-4, and farther only by chance.
    return (u - t) * max(cosine, 0.05) <= 4e-6 * (t + max(size.x, max(size.y, size.z)));
}

float crossMedia(int object, float side, int touching) {
    float told = rankOf(object);
    uint rank = uint(abs(told)), other = uint(abs(rankOf(touching)));
    bool enters = side > 0.0;
    if (told < 0.0) inside = enters ? without(inside, rank) : with(inside, rank);
    beyond = enters ? with(inside, rank) : without(inside, rank);
    if (other != rank) beyond = any(equal(inside, uvec4(other))) ? without(beyond, other) : with(beyond, other);
    vec4 here = mediumOf(inside);
    vec4 there = mediumOf(beyond);
    bool alike = inside.x > 0u && beyond.x > 0u && here == there;
    return inside.x == beyond.x || alike ? 0.0 : here.w / there.w;
}

#if ABSORPTION
vec3 absorbed(float t) { return exp(-min(t, 1e30) * mediumOf(inside).rgb); }
#endif
