// What is read at fixed places, read once before all loops and held in variables, for SwiftShader: its compiler makes each read
// anew, and each calls a function that takes an eighth of the time of a picture.
//
// hold  reads what follows; a shader's main() begins with it
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
