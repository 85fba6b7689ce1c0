// Objects in a lattice: equal ones, each alone in its cell of a grid, which the ray walks cell by cell. Nothing is
// read on the way: a cell's position tells its object's ball and number. Found by tracer/accel/lattice.h.
//
// nextInLattice  the next cell, nearer than `t`, whose ball the ray does not pass by, as the number of its object; -1
//                at the end.
//              The ball of object `self`, on which the ray starts, counts always. The radius of the balls is the fourth
//              number of the grid's first texel
// Error        no ball is missed: it keeps 1/64 of a cell from the walls of its own
#include "accel/walk.glsl"

int nextInLattice(vec3 cells, Ray ray, float t, int self, inout GridWalk walk) {
    float last = lastStep(walk, t);
    float paddedSquare = paddedSquaredLength(ray);
    while (walk.s <= last && !leftGrid(cells, walk)) {
        vec3 middle = walk.grid.corner.xyz + (walk.cell + 0.5) * walk.grid.size;
        int index = stepOn(cells, walk);
        if (index == self || !passesBy(ray, paddedSquare, vec4(middle, walk.grid.corner.w))) return index;
    }
    return -1;
}
