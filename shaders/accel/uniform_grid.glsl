// Uniform grid over resting objects, each cell with a list of those that reach into it. Written by
// tracer/accel/uniform_grid.h.
//
// enterUniformGrid  begins a ray's walk through the grid at `at`: two texels, then one a cell
// goOn        reads on in the list in hand where all that is read of it has been taken, or the next cell's; false past
//             the grid, or past `last` (lastStep() in accel/walk.glsl)
// takeListed  the next object in the list, -1 where there is none. One that comes twice in a row is passed over
// Lists       {three objects, -1 for none, the texel at which the list continues, -1 at its end}
// Error       no object is missed: it is in the lists of all cells that it comes nearer to than 1/64 of a cell
#include "accel/walk.glsl"

struct CellWalk {
    GridWalk grid;
    vec4 list; // what is left of the one in hand
    int taken; // last
};

CellWalk enterUniformGrid(int at, vec3 cells, Ray ray) {
    return CellWalk(enterGrid(loadGrid(at), cells, ray), vec4(-1.0), -1);
}

bool leftUniformGrid(vec3 cells, CellWalk walk) {
    return max(walk.list.x, walk.list.w) < 0.0 && leftGrid(cells, walk.grid);
}

bool goOn(int lists, vec3 cells, float last, inout CellWalk walk) {
    if (walk.list.x >= 0.0) return true;
    int at = int(walk.list.w);
    if (at < 0) {
        if (walk.grid.s > last || leftGrid(cells, walk.grid)) return false;
        at = stepOn(cells, walk.grid);
    }
    walk.list = sceneTexel(lists + at);
    return true;
}

int takeListed(inout CellWalk walk) {
    int listed = int(walk.list.x);
    walk.list.xyz = vec3(walk.list.yz, -1.0);
    bool again = listed == walk.taken;
    if (listed >= 0) walk.taken = listed;
    return again ? -1 : listed;
}
