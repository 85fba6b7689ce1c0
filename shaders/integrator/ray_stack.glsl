// The refracted rays of Whitted's tree that are still to be traced: where a surface both reflects and refracts, the
// refracted ray is pushed until the reflected one and all that comes of it are traced.
//
// trail     which rays are pending, and the way to the current ray; 0 at first
// pushRay   `path` is that of the ray, one deeper than the surface that it leaves
// popRay    the deepest pending ray, or the primary ray again where that one has lost its entry
// retraced  whether what the current ray sees has been added already: it is only on the way to a ray that lost its
//           entry
// onRetrace whether that way takes the refracted ray of the surface at `depth`
// Stack     three entries at every depth: they lie in registers of every pixel, and seven keep a GPU from 8 waves. A
//           ray of a deeper tree may lose its entry to another; then the way to it is traced anew from the eye, unseen:
//           one pixel in 600 of `pro` at depth 8 ever needs that. An entry is chosen among the three, not indexed:
//           drivers for wide SIMD gather and scatter what is indexed a lane at a time, in every iteration (1/20 of
//           `pro`'s time), and stack[n++].ray = r in an array of structs yields zero rays on Mesa 22.3
// Source    S. Laine, Restart Trail for Stackless BVH Traversal, 2010
#if REFRACTION
#include "ray/bits.glsl"

struct StackEntry {
    vec3 origin, direction;
    uvec2 throughput; // 21 bits a channel
    uint cone;        // width and spread, the upper half of each
    int tag;          // self, depth and side in one: each member is a register of every pixel
};
const int kRayStack = 3;
StackEntry stack[kRayStack];
#if MEDIA
uvec2 media[kRayStack]; // that the entries' rays are inside of: 16 bits each
#endif

// The way through the tree, in one register: of a surface at depth d bit d says that its refracted ray is still to
// come, bit 8 + d that this ray, not the reflected one, is on the way. From bit 16 on the depth of the surface whose
// refracted ray is traced anew, 0 for none.
uint pendingIn(uint trail) { return trail & 0xFFu; }
bool anyPending(uint trail) { return pendingIn(trail) != 0u; }
bool retraced(uint trail, int depth) { return depth <= int(trail >> 16); }
bool onRetrace(uint trail, int depth) { return (trail & 256u << depth) != 0u; }

const float kThroughputSteps = 1048576.0;

// A path as the stack holds it, whether its ray is pushed or traced anew: its throughput to a millionth, of the ray
// cone the two digits that a level of detail needs.
float upperHalf(float x) { return uintBitsToFloat(floatBitsToUint(x) & 0xFFFF0000u); }
Path storable(Path path) {
    vec3 throughput = floor(path.throughput * kThroughputSteps + 0.5) / kThroughputSteps;
    return Path(throughput, path.depth, upperHalf(path.width), upperHalf(path.spread));
}

int slotOf(int depth) { return depth % kRayStack; }

void pushRay(inout uint trail, Ray ray, Path path) {
    int depth = path.depth - 1;
    uvec3 steps = uvec3(path.throughput * kThroughputSteps);
    uvec2 bits = uvec2(steps.r | steps.g << 21, steps.g >> 11 | steps.b << 10);
    uint cone = floatBitsToUint(path.width) | (floatBitsToUint(path.spread) >> 16);
    int tag = (ray.self << 5) | (path.depth << 1) | int(ray.side > 0.0);
    for (int slot = 0; slot < kRayStack; ++slot) {
        if (slot == slotOf(depth)) stack[slot] = StackEntry(ray.origin, ray.direction, bits, cone, tag);
#if MEDIA
        if (slot == slotOf(depth)) media[slot] = beyond.xz | beyond.yw << 16;
#endif
    }
    trail = (trail | 1u << depth) & ~(256u << depth);
}

void popRay(inout uint trail, inout Ray ray, inout Path path) {
    int depth = highestBit(pendingIn(trail));
    StackEntry entry = stack[0];
#if MEDIA
    uvec2 ranks = media[0];
#endif
    for (int slot = 1; slot < kRayStack; ++slot) {
        if (slot == slotOf(depth)) entry = stack[slot];
#if MEDIA
        if (slot == slotOf(depth)) ranks = media[slot];
#endif
    }
    bool kept = ((entry.tag >> 1) & 15) == depth + 1;
    trail = (trail & 0xFFFFu & ~(1u << depth)) | 256u << depth | (kept ? 0u : uint(depth) << 16);
    ray = primaryRay();
    path = primaryPath();
#if MEDIA
    resetMedia();
    if (kept) inside = uvec4(ranks & 0xFFFFu, ranks >> 16).xzyw;
#endif
    if (kept) {
        uvec2 bits = entry.throughput;
        uvec3 steps = uvec3(bits.x & 0x1FFFFFu, bits.x >> 21 | (bits.y & 0x3FFu) << 11, bits.y >> 10);
        ray = rayFrom(entry.origin, entry.direction, entry.tag >> 5, (entry.tag & 1) == 1 ? 1.0 : -1.0);
        path = Path(vec3(steps) / kThroughputSteps, depth + 1, uintBitsToFloat(entry.cone & 0xFFFF0000u),
                    uintBitsToFloat(entry.cone << 16));
    }
}
#else
bool anyPending(uint trail) { return false; }
bool retraced(uint trail, int depth) { return false; }
void popRay(inout uint trail, inout Ray ray, inout Path path) {}
#endif
