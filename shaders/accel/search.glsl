// Searches for the objects of a kind that a ray may meet: those of its lattice by walking from cell to cell, the others
// by a bounding-sphere mask, a hierarchy of boxes, or a uniform grid. Which a kind has is chosen by
// tracer/plan/search_choice.h.
//
// start  begins the search of a ray
// next   number of the next object in its kind that the ray may meet nearer than `t`, -1 at the end; each comes once,
//        or once more from another cell of a grid. The object that the ray starts on always comes.
// ended  that no other one will come, where the search can tell: wide SIMD is spared an iteration that finds nothing
// mask   a bit for each loose object whose ball the ray does not pass by. The balls are read in a fixed order, all
//        lanes of a SIMD together: that costs less than the boxes that might spare some of them
#include "ray/bits.glsl"
#if HIERARCHIES
#include "accel/hierarchy.glsl"
#endif
#if LATTICES
#include "accel/lattice.glsl"
#endif
#if UNIFORM_GRIDS
#include "accel/uniform_grid.glsl"
#endif

#for Shape in SHAPES
#if $SHAPE_SEARCHED
struct Search$Shape {
#if $SHAPE_LATTICE
    GridWalk lattice;
#endif
#if $SHAPE_SEARCH == HIERARCHY
    QuantisedRay boxes;
    int node;
#elif $SHAPE_SEARCH == GRID
    CellWalk cells;
#else
    uint mask;
#endif
};

Search$Shape start$Shape(Ray ray) {
    Search$Shape search;
#if $SHAPE_LATTICE
    search.lattice = enterGrid(loadGrid(k$ShapeLattice), vec3(k$ShapeLatticeX, k$ShapeLatticeY, k$ShapeLatticeZ), ray);
#endif
#if $SHAPE_SEARCH == HIERARCHY
    search.boxes = quantisedRay(k$ShapeQuantisation, ray);
    search.node = 0;
#elif $SHAPE_SEARCH == GRID
    search.cells = enterUniformGrid(k$ShapeGrid, vec3(k$ShapeGridX, k$ShapeGridY, k$ShapeGridZ), ray);
#else
    int self = ray.self - k$ShapeFirst - k$ShapeLoose;
    search.mask = self >= 0 && self < k$ShapeCount - k$ShapeLoose ? 1u << uint(self) : 0u;
    float padded = paddedSquaredLength(ray);
#for Part in $SHAPE_SPHERE_MASK
    // Always true. Without it GPUs load all balls at once, and have no registers for so many.
    if (frame.zero.x == 0u) {
#for Bit in $SHAPE_SPHERE_MASK_$PART
        bool passes$Bit = passesBy(ray, padded, ball$Shape(object$Shape(k$ShapeLoose + $Bit)));
        search.mask |= passes$Bit ? 0u : 1u << $Bitu;
#endfor
    }
#endfor
#endif
    return search;
}

bool ended$Shape(Search$Shape search) {
#if $SHAPE_SEARCH == HIERARCHY
    bool ended = search.node >= k$ShapeNodes;
#elif $SHAPE_SEARCH == GRID
    bool ended = leftUniformGrid(vec3(k$ShapeGridX, k$ShapeGridY, k$ShapeGridZ), search.cells);
#else
    bool ended = search.mask == 0u;
#endif
#if $SHAPE_LATTICE
    ended = ended && leftGrid(vec3(k$ShapeLatticeX, k$ShapeLatticeY, k$ShapeLatticeZ), search.lattice);
#endif
    return ended;
}

int next$Shape(inout Search$Shape search, Ray ray, float t) {
#if $SHAPE_SEARCH == HIERARCHY
    int leaf = nextLeaf(search.boxes, k$ShapeQuantisation + 2, k$ShapeNodes, t, search.node);
    if (leaf >= 0) return k$ShapeLoose + leaf;
#elif $SHAPE_SEARCH == GRID
    int self = ray.self - k$ShapeFirst - k$ShapeLoose;
    float last = lastStep(search.cells.grid, t);
    while (goOn(k$ShapeGrid + 2, vec3(k$ShapeGridX, k$ShapeGridY, k$ShapeGridZ), last, search.cells)) {
        int listed = takeListed(search.cells);
        if (listed < 0) continue;
        int index = k$ShapeLoose + listed;
        if (listed == self || !passesBy(ray, ball$Shape(object$Shape(index)))) return index;
    }
#else
    if (search.mask != 0u) {
        int index = lowestBit(search.mask);
        search.mask &= search.mask - 1u;
        return k$ShapeLoose + index;
    }
#endif
#if $SHAPE_LATTICE
    int own = ray.self - k$ShapeFirst;
    return nextInLattice(vec3(k$ShapeLatticeX, k$ShapeLatticeY, k$ShapeLatticeZ), ray, t, own, search.lattice);
#else
    return -1;
#endif
}
#endif
#endfor
