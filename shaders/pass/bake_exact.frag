// The exact field of a height patch, one sample: the least distance of all feet, found by a walk over its cells.
//
// Error    1e-5 of max(longer side, range of heights), all but 0.1 % 3e-7 (tests/shader/bake_test.cpp; of 3000 random
//          patches, 16 samples along a side, the worst of 12 million is 9.6e-6 off, the second worst 8e-7)
// Source   branch and bound: cells that hold no nearer foot are dropped (field/cells.glsl); where feet are minima
//          each, or a cell is small, Newton's method finds the one in it. A small cell at the border may have one on
//          it and one beside it: there the border is searched, too. The walk needs no stack: its place says what is
//          next
// Limits   what makes a foot a minimum does not prove that a cell holds one only: this is tested, not certified
#include "field/cells.glsl"
#include "field/foot.glsl"
#include "field/store.glsl"

uniform highp usampler2D bricks;

// The exponent of a power of two.
int log2Of(uint power) { return (floatBitsToInt(float(power)) >> 23) - 127; }

// Takes the lowest bit of the mask as a cell; one of no size where none is left.
ivec3 nextCell(inout uvec2 mask) {
    bool lower = mask.x != 0u;
    uint word = lower ? mask.x : mask.y;
    uint bit = word & (0u - word);
    if (lower)
        mask.x ^= bit;
    else
        mask.y ^= bit;
    int index = log2Of(bit) + (lower ? 0 : 32);
    return bit == 0u ? ivec3(0) : ivec3(index & 7, index >> 3, kCoarsest);
}

// What follows a cell and all in it. Cells are walked in fours; after the last of them follows what does their parent.
ivec3 cellAfter(ivec3 cell, inout uvec2 mask) {
    uint lasts = uint(cell.x & cell.y);
    int ups = log2Of(~lasts & (lasts + 1u));
    cell >>= ups;
    if (cell.z <= kCoarsest) return nextCell(mask);
    bool odd = (cell.x & 1) != 0;
    return ivec3(odd ? cell.x - 1 : cell.x + 1, odd ? cell.y + 1 : cell.y, cell.z);
}

void main() {
    vec3 q = samplePoint();
    uvec4 brick = texelFetch(bricks, ivec2(texelOfField()) / bake.counts.y, 0);
    vec2 x = uintBitsToFloat(brick.zw);
    float best = 3e38;
    descend(q, x, vec2(0.0), bake.sides.xy, best);
    uvec2 mask = brick.xy;
    ivec3 cell = nextCell(mask);
    ivec3 leaf = ivec3(0);
    ivec2 ends = ivec2(0); // of the leaf, on the patch's border and still to be searched alone
    for (int runs = 0; runs < 4096; ++runs) {
        bool again = ends.x + ends.y > 0;
        bool convex = true;
        leaf = again ? leaf : ivec3(0);
        for (int tests = 0; tests < 8192 && cell.z > 0 && leaf.z == 0; ++tests) {
            bool open = mayHold(cell, q, vec3(0.0), best, convex);
            bool small = convex || cell.z == kFinest;
            leaf = open && small ? cell : leaf;
            if (open && !small)
                cell *= 2;
            else
                cell = cellAfter(cell, mask);
        }
        if (leaf.z == 0) break;
        vec2 side = bake.sides.xy / float(leaf.z);
        vec2 low = vec2(leaf.xy) * side;
        vec2 high = low + side;
        if (again) {
            vec2 end = mix(high, low, equal(leaf.xy, ivec2(0)));
            bvec2 pinned = bvec2(ends.x > 0, ends.x == 0);
            low = mix(low, end, pinned);
            high = mix(high, end, pinned);
            ends = ends.x > 0 ? ivec2(0, ends.y) : ivec2(0);
        } else if (!convex)
            ends = ivec2(equal(leaf.xy, ivec2(0))) + ivec2(equal(leaf.xy, ivec2(kFinest - 1)));
        x = 0.5 * (low + high);
        descend(q, x, low, high, best);
    }
    storeDistance(q, sqrt(best));
}
