// Covers the canvas with one triangle, vertices 0 to 2. There is no vertex data: all comes from the vertex's number.
#include "software/tiles.glsl"

void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
    placeTile();
}
