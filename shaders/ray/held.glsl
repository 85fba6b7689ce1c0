// What is read at fixed places, read once before all loops and held in variables: for SwiftShader, whose compiler makes each
// read anew, and each is a call that samples a texture. The library's own files do so; where one is overridden, none does.
//
// hold  reads them all; main() begins with it
#if BLOCKS
#include "accel/walk.glsl"
#endif

#for Shape in SHAPES
#if $SHAPE_ALONE
$Shape held$Shape;
#endif
#if $SHAPE_BLOCK
Grid held$ShapeBlock;
#endif
#for Part in $SHAPE_SIEVE
#for Bit in $SHAPE_SIEVE_$PART
vec4 held$ShapeBall$Bit;
#endfor
#endfor
#endfor

void hold() {
#if TRIANGLES
    heldMiddleOfTriangles = loadMiddleOfTriangles();
#endif
#for Shape in SHAPES
#if $SHAPE_ALONE
    held$Shape = load$Shape(k$ShapeBase);
#endif
#if $SHAPE_BLOCK
    held$ShapeBlock = loadGrid(k$ShapeBlock);
#endif
#for Part in $SHAPE_SIEVE
#for Bit in $SHAPE_SIEVE_$PART
    held$ShapeBall$Bit = ball$Shape(load$Shape(k$ShapeBase + (k$ShapeLoose + $Bit) * k$ShapeTexels));
#endfor
#endfor
#endfor
}
