// Reads at fixed addresses: with CACHED_LOADS they are made once, before all loops, and kept in variables: for
// SwiftShader, whose compiler makes each read anew, and each is a call that samples a texture.
//
// object      record of an object of its kind
// lattice     grid of the kind's lattice
// ball        bounding sphere of the kind's object for one bit of its bounding-sphere mask
// cacheLoads  reads them all
#if LATTICES
#include "accel/walk.glsl"
#endif

#for Shape in SHAPES
#if CACHED_LOADS && $SHAPE_ALONE
$Shape cached$Shape;
$Shape object$Shape(int index) { return cached$Shape; }
#else
$Shape object$Shape(int index) { return load$Shape(k$ShapeBase + index * k$ShapeTexels); }
#endif
#if CACHED_LOADS && $SHAPE_LATTICE
Grid cached$ShapeLattice;
Grid lattice$Shape() { return cached$ShapeLattice; }
#elif $SHAPE_LATTICE
Grid lattice$Shape() { return loadGrid(k$ShapeLattice); }
#endif
#for Part in $SHAPE_SPHERE_MASK
#for Bit in $SHAPE_SPHERE_MASK_$PART
#if CACHED_LOADS
vec4 cached$ShapeBall$Bit;
vec4 ball$Shape$Bit() { return cached$ShapeBall$Bit; }
#else
vec4 ball$Shape$Bit() { return ball$Shape(load$Shape(k$ShapeBase + (k$ShapeLoose + $Bit) * k$ShapeTexels)); }
#endif
#endfor
#endfor
#endfor

#if CACHED_LOADS
void cacheLoads() {
#if TRIANGLES
    cachedMiddleOfTriangles = loadMiddleOfTriangles();
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
#endif
