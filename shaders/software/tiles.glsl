// Where base variants have drawn some of the canvas, what is left is drawn in tiles: each vertex from 3 on is a point
// as large as a tile, and lies outside where all pixels of its tile are drawn. A point that is not drawn is the one
// branch that every driver has.
//
// covered     the coverage mask: 0 where nothing is drawn yet
// kTile       pixels along a side of a tile
// placeTile   moves the vertex, where it is a tile's
#if TILES
uniform sampler2D covered;

// Tiles at the ends of rows and columns overlap their neighbours instead of the canvas' edge.
ivec2 cornerOf(int tile, ivec2 canvas) {
    int columns = (canvas.x + kTile - 1) / kTile;
    return max(min(kTile * ivec2(tile % columns, tile / columns), canvas - kTile), 0);
}

bool anyBare(ivec2 corner, ivec2 canvas) {
    ivec2 end = min(corner + kTile, canvas);
    float least = 1.0;
    for (int y = corner.y; y < end.y; ++y)
        for (int x = corner.x; x < end.x; ++x) least = min(least, texelFetch(covered, ivec2(x, y), 0).r);
    return least == 0.0;
}

vec4 tileAt(int tile) {
    ivec2 canvas = textureSize(covered, 0);
    ivec2 corner = cornerOf(tile, canvas);
    vec2 middle = (2.0 * vec2(corner) + float(kTile)) / vec2(canvas) - 1.0;
    return anyBare(corner, canvas) ? vec4(min(middle, 1.0), 0.0, 1.0) : vec4(2.0, 2.0, 0.0, 1.0);
}
#endif

void placeTile() {
#if TILES
    if (gl_VertexID > 2) gl_Position = tileAt(gl_VertexID - 3);
    gl_PointSize = float(kTile);
#endif
}
