// Searches for those objects of a kind that may be nearer to a point than what is known already: the one of a lattice
// of equal spheres by the cell that the point lies in or next to, those in a hierarchy by their boxes (shaders/accel).
//
// nearestCell  number of the sphere in a lattice of `cells` cells, two texels at `at`, whose centre is nearest to p
// quantisedPoint    a point in the cells that the boxes of a hierarchy are told in
// nextNearby   the next leaf, from `node` on, whose box is nearer than `reach`; its object's number in its kind, -1 at
//              the end
// Error        no box is missed: they are moved outwards as rays see them. Of two spheres that are as near but for
//              rounding either is found
#if SPHERE_LATTICES
int nearestCell(int at, vec3 cells, vec3 p) {
    vec3 position = (p - sceneTexel(at).xyz) / sceneTexel(at + 1).xyz;
    return int(dot(clamp(floor(position), vec3(0.0), cells - 1.0), vec3(1.0, cells.x, cells.x * cells.y)));
}
#endif

#if NEARBY
struct QuantisedPoint {
    vec3 beforeLow;  // the point, as planes that a box begins at see it
    vec3 beforeHigh; // and those that it ends at
    vec3 cell;       // size of one
};

QuantisedPoint quantisedPoint(int grid, vec3 p) {
    vec4 low = sceneTexel(grid);
    vec3 cells = sceneTexel(grid + 1).xyz;
    vec3 offset = p - low.xyz;
    vec3 size = abs(offset);
    vec3 room = 9.5e-7 * (max(size.x, max(size.y, size.z)) + low.w) * cells;
    return QuantisedPoint(offset * cells + room, offset * cells - room, 1.0 / cells);
}

int nextNearby(QuantisedPoint point, int nodes, int end, float reach, inout int node) {
    reach = max(reach, 0.0) * 1.000001; // inside of a solid only what the point is inside of, too, can be nearer
    while (node < end) {
        vec4 box = sceneTexel(nodes + node);
        vec3 high = floor(box.xyz * (1.0 / 4096.0));
        vec3 low = box.xyz - 4096.0 * high;
        vec3 gap = max(max(low - point.beforeLow, point.beforeHigh - high), 0.0) * point.cell;
        bool near = dot(gap, gap) <= reach * reach;
        bool leaf = box.w < 0.0;
        node = near || leaf ? node + 1 : int(box.w);
        if (near && leaf) return -1 - int(box.w);
    }
    return -1;
}
#endif
