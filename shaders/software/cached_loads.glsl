// What is read at fixed places, read once before all loops and held in variables: for SwiftShader, whose compiler makes each
// read anew, and each is a call that samples a texture. The library's own files do so; where one is overridden, none does.
//
// hold  reads them all; main() begins with it
#if LATTICES
#include "accel/walk.glsl"
#endif

#for Shape in SHAPES
#if $SHAPE_ALONE
$Shape cached$Shape;
#endif
#if $SHAPE_LATTICE
Grid cached$ShapeLattice;
#endif
#for Part in $SHAPE_SPHERE_MASK
#for Bit in $SHAPE_SPHERE_MASK_$PART
vec4 cached$ShapeBall$Bit;
#endfor
#endfor
#endfor

void cacheLoads() {
#if TRIANGLES
    heldMiddleOfTriangles = loadMiddleOfTriangles();
#endif
#for Shape in SHAPES
#if $SHAPE_ALONE
    cached$Shape = load$Shape(k$ShapeBase);
#endif
#if $SHAPE_LATTICE
    cached$ShapeLattice = loadGrid(k$ShapeLattice);
#endif
#for Part in $SHAPE_SPHERE_MASK
#for Bit in $SHAPE_SPHERE_MASK_$PART
    cached$ShapeBall$Bit = ball$Shape(load$Shape(k$ShapeBase + (k$ShapeLoose + $Bit) * k$ShapeTexels));
#endfor
#endfor
#endfor
}
