// Objects in a regular block: equal ones, each alone in its cell of a grid, which the ray walks cell by cell. Nothing is
// read on the way: a cell's place tells its object's ball and number. Found by tracer/accel/block.h.
//
// nextInBlock  the next cell, nearer than `t`, whose ball the ray does not pass by, as the number of its object; -1 at the end.
//              The ball of object `self`, on which the ray starts, counts always. A block of `cells` cells is two texels,
//              {corner, radius of the balls} and {size of a cell, 0}; its walk starts at kBeforeBlock
// Error        no ball is missed: it keeps 1/64 of a cell from the walls of its own, and the ray, re-centred on the block, knows
//              them to 2^-20
// Source       J. Amanatides, A. Woo, A Fast Voxel Traversal Algorithm for Ray Tracing, 1987
struct BlockWalk {
    vec3 cell; // the next; one outside of the block ends the walk
    float s;   // where the re-centred ray enters it
};

const BlockWalk kBeforeBlock = BlockWalk(vec3(-2.0), 0.0);

// The ray as the block sees it.
struct BlockRay {
    NearRay near;
    vec3 origin;  // of near, from the block's corner, in cells
    vec3 onward;  // +1 or -1: where the next cell lies
    vec3 perCell; // s from one wall to the next, along each axis
};

BlockRay blockRay(vec3 corner, vec3 size, vec3 cells, Ray ray) {
    NearRay near = recentre(ray.origin, corner + 0.5 * cells * size, ray.direction);
    vec3 direction = ray.direction / size;
    vec3 onward = mix(vec3(-1.0), vec3(1.0), vec3(greaterThanEqual(direction, vec3(0.0))));
    return BlockRay(near, near.origin / size + 0.5 * cells, onward, onward / max(abs(direction), vec3(1e-18)));
}

BlockWalk enterBlock(BlockRay ray, vec3 cells) {
    vec3 enter = (0.5 * cells * (1.0 - ray.onward) - ray.origin) * ray.perCell;
    vec3 leave = (0.5 * cells * (1.0 + ray.onward) - ray.origin) * ray.perCell;
    float s = max(max(enter.x, enter.y), max(enter.z, -ray.near.tHigh - ray.near.tLow));
    bool passes = s > min(leave.x, min(leave.y, leave.z));
    return BlockWalk(passes ? vec3(-1.0) : clamp(floor(ray.origin + s / ray.perCell), vec3(0.0), cells - 1.0), s);
}

// The walk has begun, and its next cell lies outside.
bool leftBlock(vec3 cells, BlockWalk walk) {
    return walk.cell.x > -1.5 && (any(lessThan(walk.cell, vec3(0.0))) || any(greaterThanEqual(walk.cell, cells)));
}

int nextInBlock(int at, vec3 cells, Ray ray, float t, int self, inout BlockWalk walk) {
    vec4 corner = sceneTexel(at);
    vec3 size = sceneTexel(at + 1).xyz;
    // Worked out anew at each call: kept, it would hold registers while objects are asked.
    BlockRay block = blockRay(corner.xyz, size, cells, ray);
    if (walk.cell.x < -1.5) walk = enterBlock(block, cells);
    float last = (t - block.near.tHigh) - block.near.tLow;
    while (walk.s <= last && all(greaterThanEqual(walk.cell, vec3(0.0))) && all(lessThan(walk.cell, cells))) {
#if OUTPUT == WORK
        ++work.x;
#endif
        vec3 cell = walk.cell;
        vec3 wall = (cell + 0.5 + 0.5 * block.onward - block.origin) * block.perCell;
        walk.s = min(wall.x, min(wall.y, wall.z));
        walk.cell += block.onward * vec3(lessThanEqual(wall, vec3(walk.s)));
        int index = int(dot(cell, vec3(1.0, cells.x, cells.x * cells.y)));
        vec3 toOrigin = block.near.origin - (cell + 0.5 - 0.5 * cells) * size;
        if (index == self || !passesBy(toOrigin, ray.direction, corner.w)) return index;
    }
    return -1;
}
