// Hierarchy of boxes, one a kind of objects, walked without a stack: a ray that misses a box continues at the node
// after all below it. Written by tracer/accel/node_texels.h, which says what a node holds; a leaf holds one object.
//
// quantisedRay   the ray in the cells that the boxes of a hierarchy are told in
// nextLeaf  the next leaf, from `node` on, whose box the ray meets nearer than `t`; answers its object's number in its
//           kind, -1 at the end. Only this loop reads nodes: on wide SIMD objects are asked by all lanes together.
// Error     no box is missed: the planes are moved outwards, along every axis by 2^-20 of the way to the boxes and
//           across them, twice what rounding may be here and more than a shape's own (tests/unit/node_texels_test.cpp)
// Source    threaded traversal: B. Smits, Efficiency Issues for Ray Tracing, 1998
struct QuantisedRay {
    vec3 beforeLow;  // the ray's origin, as planes that a box begins at see it
    vec3 beforeHigh; // and those that it ends at
    vec3 perCell;    // t from one cell to the next, along each axis
};

QuantisedRay quantisedRay(int grid, Ray ray) {
    vec4 low = sceneTexel(grid);
    vec3 cells = sceneTexel(grid + 1).xyz;
    vec3 offset = ray.origin - low.xyz;
    vec3 size = abs(offset);
    vec3 room = 9.5e-7 * (max(size.x, max(size.y, size.z)) + low.w) * cells;
    vec3 origin = offset * cells;
    vec3 direction = ray.direction * cells;
    vec3 steep = vec3(lessThan(abs(direction), vec3(1e-18)));
    return QuantisedRay(origin + room, origin - room, 1.0 / mix(direction, vec3(1e-18), steep));
}

int nextLeaf(QuantisedRay ray, int nodes, int end, float t, inout int node) {
    while (node < end) {
#if OUTPUT == WORK
        ++work.x;
#endif
        vec4 box = sceneTexel(nodes + node);
        vec3 high = floor(box.xyz * (1.0 / 4096.0));
        vec3 toLow = (box.xyz - 4096.0 * high - ray.beforeLow) * ray.perCell;
        vec3 toHigh = (high - ray.beforeHigh) * ray.perCell;
        // As whole numbers, which compare alike but where both are negative, and there the box lies behind either way:
        // drivers for SIMD look for NaN in each minimum of floats.
        ivec3 enter = min(floatBitsToInt(toLow), floatBitsToInt(toHigh));
        ivec3 leave = max(floatBitsToInt(toLow), floatBitsToInt(toHigh));
        int last = min(min(leave.x, leave.y), min(leave.z, floatBitsToInt(t)));
        bool met = max(max(enter.x, enter.y), max(enter.z, 0)) <= last;
        bool leaf = box.w < 0.0;
        node = met || leaf ? node + 1 : int(box.w);
        if (met && leaf) return -1 - int(box.w);
    }
    return -1;
}
