// From cell to cell of a grid along the axes, as a ray crosses them.
//
// loadGrid   of two texels, {corner, …} and {size of a cell, …}
// enterGrid  begins a ray's walk through a grid of `cells` cells
// leftGrid   the next cell lies outside
// lastStep   s up to which the walk continues: nearer than t
// stepOn     to the next cell; answers the number of the one before, x fastest
// Error      the ray, re-centred on the grid, knows its walls to 2^-20 of a cell
// Source     J. Amanatides, A. Woo, A Fast Voxel Traversal Algorithm for Ray Tracing, 1987
struct Grid {
    vec4 corner;
    vec3 size; // of a cell
};

Grid loadGrid(int at) { return Grid(sceneTexel(at), sceneTexel(at + 1).xyz); }

struct GridWalk {
    vec3 origin;   // of the re-centred ray, from the grid's corner, in cells
    vec3 perCell;  // s from one wall to the next, along each axis; its sign says where the next cell lies
    vec3 cell;     // the next; one outside of the grid ends the walk
    float s;       // where the re-centred ray enters it
    float closest; // t where s is 0
    Grid grid;
};

GridWalk enterGrid(Grid grid, vec3 cells, Ray ray) {
    NearRay near = recentre(ray.origin, grid.corner.xyz + 0.5 * cells * grid.size, ray.direction);
    vec3 direction = ray.direction / grid.size;
    vec3 onward = mix(vec3(-1.0), vec3(1.0), vec3(greaterThanEqual(direction, vec3(0.0))));
    vec3 perCell = onward / max(abs(direction), vec3(1e-18));
    vec3 origin = near.origin / grid.size + 0.5 * cells;
    vec3 enter = (0.5 * cells * (1.0 - onward) - origin) * perCell;
    vec3 leave = (0.5 * cells * (1.0 + onward) - origin) * perCell;
    float closest = near.tHigh + near.tLow;
    float s = max(max(enter.x, enter.y), max(enter.z, -closest));
    bool passes = s > min(leave.x, min(leave.y, leave.z));
    vec3 cell = passes ? vec3(-1.0) : clamp(floor(origin + s / perCell), vec3(0.0), cells - 1.0);
    return GridWalk(origin, perCell, cell, s, closest, grid);
}

bool leftGrid(vec3 cells, GridWalk walk) {
    return any(lessThan(walk.cell, vec3(0.0))) || any(greaterThanEqual(walk.cell, cells));
}

// With the room that its own roundings need.
float lastStep(GridWalk walk, float t) { return t - walk.closest + 3e-7 * (t + abs(walk.closest)); }

int stepOn(vec3 cells, inout GridWalk walk) {
#if OUTPUT == WORK
    ++work.x;
#endif
    int index = int(dot(walk.cell, vec3(1.0, cells.x, cells.x * cells.y)));
    vec3 onward = sign(walk.perCell);
    vec3 wall = (walk.cell + 0.5 + 0.5 * onward - walk.origin) * walk.perCell;
    walk.s = min(wall.x, min(wall.y, wall.z));
    walk.cell += onward * vec3(lessThanEqual(wall, vec3(walk.s)));
    return index;
}
