// Objects in a regular block: equal ones, each alone in its cell of a grid, which the ray walks cell by cell. Nothing is
// read on the way: a cell's place tells its object's ball and number. Found by tracer/accel/block.h.
//
// enterBlock   begins a ray's walk. A block of `cells` cells is two texels at `at`, {corner, radius of the balls} and {size of a
//              cell, 0}
// nextInBlock  the next cell, nearer than `t`, whose ball the ray does not pass by, as the number of its object; -1 at the end.
//              The ball of object `self`, on which the ray starts, counts always
// leftBlock    that no other one will come
// Error        no ball is missed: it keeps 1/64 of a cell from the walls of its own, and the ray, re-centred on the block, knows
//              them to 2^-20
// Source       J. Amanatides, A. Woo, A Fast Voxel Traversal Algorithm for Ray Tracing, 1987
struct BlockWalk {
    vec3 origin;   // of the re-centred ray, from the block's corner, in cells
    vec3 perCell;  // s from one wall to the next, along each axis; its sign says where the next cell lies
    vec3 cell;     // the next; one outside of the block ends the walk
    float s;       // where the re-centred ray enters it
    float closest; // t where s is 0
};

BlockWalk enterBlock(int at, vec3 cells, Ray ray) {
    vec3 size = sceneTexel(at + 1).xyz;
    NearRay near = recentre(ray.origin, sceneTexel(at).xyz + 0.5 * cells * size, ray.direction);
    vec3 direction = ray.direction / size;
    vec3 onward = mix(vec3(-1.0), vec3(1.0), vec3(greaterThanEqual(direction, vec3(0.0))));
    vec3 perCell = onward / max(abs(direction), vec3(1e-18));
    vec3 origin = near.origin / size + 0.5 * cells;
    vec3 enter = (0.5 * cells * (1.0 - onward) - origin) * perCell;
    vec3 leave = (0.5 * cells * (1.0 + onward) - origin) * perCell;
    float closest = near.tHigh + near.tLow;
    float s = max(max(enter.x, enter.y), max(enter.z, -closest));
    bool passes = s > min(leave.x, min(leave.y, leave.z));
    vec3 cell = passes ? vec3(-1.0) : clamp(floor(origin + s / perCell), vec3(0.0), cells - 1.0);
    return BlockWalk(origin, perCell, cell, s, closest);
}

bool leftBlock(vec3 cells, BlockWalk walk) {
    return any(lessThan(walk.cell, vec3(0.0))) || any(greaterThanEqual(walk.cell, cells));
}

int nextInBlock(int at, vec3 cells, Ray ray, float t, int self, inout BlockWalk walk) {
    vec4 corner = sceneTexel(at);
    vec3 size = sceneTexel(at + 1).xyz;
    vec3 onward = sign(walk.perCell);
    float last = t - walk.closest + 3e-7 * (t + abs(walk.closest)); // with the room that both roundings need
    while (walk.s <= last && !leftBlock(cells, walk)) {
#if OUTPUT == WORK
        ++work.x;
#endif
        vec3 cell = walk.cell;
        vec3 wall = (cell + 0.5 + 0.5 * onward - walk.origin) * walk.perCell;
        walk.s = min(wall.x, min(wall.y, wall.z));
        walk.cell += onward * vec3(lessThanEqual(wall, vec3(walk.s)));
        int index = int(dot(cell, vec3(1.0, cells.x, cells.x * cells.y)));
        if (index == self || !passesBy(ray, vec4(corner.xyz + (cell + 0.5) * size, corner.w))) return index;
    }
    return -1;
}
