// The path of a ray through Whitted's tree, and those that wait: where a surface both reflects and refracts, the refracted ray
// waits on a stack until the reflected one and all that comes of it are traced.
//
// trail     what waits, and the way to the ray in hand; 0 at first
// pushRay   `path` is that of the ray, one deeper than the surface that it leaves
// popRay    the deepest ray that waits, or the primary ray again where that one has lost its entry
// Stack     three entries at every depth: what waits lies in registers of every pixel, and seven keep a GPU from 8 waves. A ray
//           of a deeper tree may lose its entry to another; when its turn comes, the way to it is traced anew from the eye,
//           unseen: one pixel in 600 of `pro` at depth 8 ever needs that. An entry is chosen among the three, not indexed: drivers
//           for wide SIMD gather and scatter what is indexed a lane at a time, at every turn (1/20 of `pro`'s time), and
//           stack[n++].ray = r in an array of structs yields zero rays on Mesa 22.3
// Pencil    each ray carries the width its pixel has grown to and the angle it still grows by; curved mirrors widen it
// Source    the way back without a stack after S. Laine, Restart Trail for Stackless BVH Traversal, 2010; pencils after
//           T. Akenine-Möller et al., Texture Level of Detail Strategies for Real-Time Ray Tracing, Ray Tracing Gems 2019
struct Path {
    vec3 share;   // of this ray in the pixel
    int depth;    // 1 for the primary ray
    float width;  // of the pencil at the ray's start
    float spread; // of the pencil, radians
};

Path primaryPath() { return Path(vec3(1.0), 1, 0.0, frame.pixelAngle); }

#if REFRACTION
#include "ray/bits.glsl"

struct StackEntry {
    vec3 origin, direction;
    uvec2 share; // 21 bits a channel
    uint pencil; // width and spread, the upper half of each
    int tag;     // self, depth and side in one: each entry's numbers are registers of every pixel
};
const int kRayStack = 3;
StackEntry stack[kRayStack];

// The way through the tree, in one register: of a surface at depth d bit d says that its refracted ray is still to come, bit
// 8 + d that this ray, not the reflected one, is on the way. From bit 16 on the depth of the surface whose refracted ray is
// traced anew, 0 for none.
uint pendingIn(uint trail) { return trail & 0xFFu; }
bool anyPending(uint trail) { return pendingIn(trail) != 0u; }
int restartDepthIn(uint trail) { return int(trail >> 16); }

const float kShareSteps = 1048576.0;

// A path as the stack holds it, whether its ray waits or is traced anew: its share to a millionth, of the pencil the two digits
// that a level of detail needs.
float upperHalf(float x) { return uintBitsToFloat(floatBitsToUint(x) & 0xFFFF0000u); }
Path storable(Path path) {
    vec3 share = floor(path.share * kShareSteps + 0.5) / kShareSteps;
    return Path(share, path.depth, upperHalf(path.width), upperHalf(path.spread));
}

int slotOf(int depth) { return depth % kRayStack; }

void pushRay(inout uint trail, Ray ray, Path path) {
    int depth = path.depth - 1;
    uvec3 share = uvec3(path.share * kShareSteps);
    uvec2 bits = uvec2(share.r | share.g << 21, share.g >> 11 | share.b << 10);
    uint pencil = floatBitsToUint(path.width) | (floatBitsToUint(path.spread) >> 16);
    int tag = (ray.self << 5) | (path.depth << 1) | int(ray.side > 0.0);
    for (int slot = 0; slot < kRayStack; ++slot) {
        if (slot == slotOf(depth)) stack[slot] = StackEntry(ray.origin, ray.direction, bits, pencil, tag);
    }
    trail = (trail | 1u << depth) & ~(256u << depth);
}

void popRay(inout uint trail, inout Ray ray, inout Path path) {
    int depth = highestBit(pendingIn(trail));
    StackEntry entry = stack[0];
    for (int slot = 1; slot < kRayStack; ++slot) {
        if (slot == slotOf(depth)) entry = stack[slot];
    }
    bool kept = ((entry.tag >> 1) & 15) == depth + 1;
    trail = (trail & 0xFFFFu & ~(1u << depth)) | 256u << depth | (kept ? 0u : uint(depth) << 16);
    ray = primaryRay();
    path = primaryPath();
    if (kept) {
        uvec2 bits = entry.share;
        vec3 share = vec3(bits.x & 0x1FFFFFu, bits.x >> 21 | (bits.y & 0x3FFu) << 11, bits.y >> 10) / kShareSteps;
        ray = rayFrom(entry.origin, entry.direction, entry.tag >> 5, (entry.tag & 1) == 1 ? 1.0 : -1.0);
        path = Path(share, depth + 1, uintBitsToFloat(entry.pencil & 0xFFFF0000u), uintBitsToFloat(entry.pencil << 16));
    }
}
#else
bool anyPending(uint trail) { return false; }
void popRay(inout uint trail, inout Ray ray, inout Path path) {}
#endif
