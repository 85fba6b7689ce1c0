// Fields: signed distances sampled at the corners of cubes of voxels that fill boxes, all in one texture.
//
// Field          where its samples lie in the texture, how many to a side, and the size of its box
// inVoxels       a point, from the middle of the box, in voxels from its lowest corner
// Voxel          the samples at the corners of one: near and far face across z, each as x + 2 y
// voxelAt        that of a cell
// trilinear      what the samples make of a point in it
// Error          that of the samples, and what a surface bends within a voxel: docs/fields.md
// fieldAt        the same, by the GL's own filter where it has one for float32: 0.6 of the time on llvmpipe. GPUs may
//                round its weights to 1/256
uniform highp sampler3D fields;

struct Field {
    ivec3 at;
    int samples;
    vec3 size;
};

vec3 inVoxels(Field field, vec3 p) { return (p / field.size + 0.5) * float(field.samples - 1); }
vec3 voxelSize(Field field) { return field.size / float(field.samples - 1); }
ivec3 cellAt(Field field, vec3 g) { return clamp(ivec3(floor(g)), ivec3(0), ivec3(field.samples - 2)); }

struct Voxel {
    vec4 near;
    vec4 far;
};

Voxel voxelAt(Field field, ivec3 cell) {
    ivec3 at = field.at + cell;
    vec4 near = vec4(texelFetch(fields, at, 0).r, texelFetch(fields, at + ivec3(1, 0, 0), 0).r,
        texelFetch(fields, at + ivec3(0, 1, 0), 0).r, texelFetch(fields, at + ivec3(1, 1, 0), 0).r);
    vec4 far = vec4(texelFetch(fields, at + ivec3(0, 0, 1), 0).r, texelFetch(fields, at + ivec3(1, 0, 1), 0).r,
        texelFetch(fields, at + ivec3(0, 1, 1), 0).r, texelFetch(fields, at + ivec3(1, 1, 1), 0).r);
    return Voxel(near, far);
}

float trilinear(Voxel voxel, vec3 at) {
    vec4 face = mix(voxel.near, voxel.far, at.z);
    vec2 edge = mix(face.xy, face.zw, at.y);
    return mix(edge.x, edge.y, at.x);
}

// Its gradient, in voxels.
vec3 trilinearSlope(Voxel voxel, vec3 at) {
    vec4 face = mix(voxel.near, voxel.far, at.z);
    vec4 back = voxel.far - voxel.near;
    vec2 along = face.yw - face.xz, up = face.zw - face.xy, deep = mix(back.xy, back.zw, at.y);
    return vec3(mix(along.x, along.y, at.y), mix(up.x, up.y, at.x), mix(deep.x, deep.y, at.x));
}

// What they make of a point of the box.
float fieldAt(Field field, vec3 g) {
#if FILTERED_FIELDS
    vec3 at = vec3(field.at) + clamp(g, 0.0, float(field.samples - 1)) + 0.5;
    return textureLod(fields, at / vec3(textureSize(fields, 0)), 0.0).r;
#else
    ivec3 cell = cellAt(field, g);
    return trilinear(voxelAt(field, cell), g - vec3(cell));
#endif
}
