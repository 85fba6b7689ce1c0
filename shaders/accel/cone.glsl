// Searches for the objects that a cone of light may meet: those in a hierarchy by the balls about its boxes, those of a
// lattice by the ball about all of it.
//
// nextInCone   the next leaf, from `node` on, whose box the cone may meet; its object's number in its kind, -1 at the
//              end
// latticePassed  whether the cone passes by a lattice of `cells` cells, two texels at `at`
// Error        nothing is missed: balls are larger than boxes by what rounding may be
#if HIERARCHIES
int nextInCone(int grid, int nodes, LightCone cone, inout int node) {
    vec3 corner = sceneTexel(grid).xyz;
    vec3 cell = 1.0 / sceneTexel(grid + 1).xyz;
    while (node < nodes) {
        vec4 box = sceneTexel(grid + 2 + node);
        vec3 high = floor(box.xyz * (1.0 / 4096.0));
        vec3 low = box.xyz - 4096.0 * high;
        vec3 middle = corner + 0.5 * (low + high) * cell;
        float room = 1e-6 * (abs(middle.x) + abs(middle.y) + abs(middle.z));
        bool met = !passesBy(cone, vec4(middle, 0.5 * length((high - low) * cell) + room));
        bool leaf = box.w < 0.0;
        node = met || leaf ? node + 1 : int(box.w);
        if (met && leaf) return -1 - int(box.w);
    }
    return -1;
}
#endif

#if LATTICES
bool latticePassed(int at, vec3 cells, LightCone cone) {
    vec3 reach = 0.5 * cells * sceneTexel(at + 1).xyz;
    return passesBy(cone, vec4(sceneTexel(at).xyz + reach, length(reach)));
}
#endif
