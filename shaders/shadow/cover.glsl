// What a solid covers of a light's disc, as seen from a surface point, and how the covers of several solids are united.
//
// The disc is the unit disc of points q, q being the direction axes * vec3(slope * q, 1) from the apex.
//
// LightCone    of all rays from the surface point, its apex, to the disc
// across       a vector from the apex as a point of the cone's own space, where the light's disc lies at z = 1 and (x,
//              y) / z is q
// passesBy     whether the cone passes a ball by
// Cover        how much of the disc is covered, and between which q.x in each of 16 rows; a convex solid covers an
//              interval
// halfDisc     the cover of all q with dot(normal, q) > level
// Shade        the union of covers: its area, and a mask of 256 points of the disc, 16 in each row
// unite        adds a cover. What it has in common with those before follows from both areas and the points' odds:
//              covers that do not overlap add up to their exact areas, as do those of which one holds the other or
//              which leave nothing bare
// Error        areas: roundings. Union of covers that overlap: the mask's, about .01 of the disc at worst (RMSE .002)
// Source       R. L. Plackett, A Class of Bivariate Distributions, 1965, for a table of given sums and odds
// Limits       rows cut the disc into slices of equal area, at the middle of each slice's mass
const float kPi = 3.14159265358979;
const mat4 kRows = mat4(-0.864976, -0.701790, -0.573609, -0.458684, -0.351139, -0.248116, -0.147864, -0.049127,
                        0.049127, 0.147864, 0.248116, 0.351139, 0.458684, 0.573609, 0.701790, 0.864976);
const mat4 kHalfWidths = mat4(0.501813, 0.712384, 0.819129, 0.888599, 0.936323, 0.968730, 0.989008, 0.998793,
                        0.998793, 0.989008, 0.968730, 0.936323, 0.888599, 0.819129, 0.712384, 0.501813);
// Where in its row's cells a point lies, so that no two rows have theirs below each other.
const mat4 kShifts = mat4(-0.3750, 0.0885, -0.1979, 0.2656, -0.0209, -0.3074, 0.1562, -0.1303,
                        0.3332, 0.0467, -0.2397, 0.2238, -0.0627, -0.3492, 0.1144, -0.1721);

struct LightCone {
    vec3 apex;
    mat3 axes;      // unit columns: two across, and towards the light
    float slope;    // radius of the disc over its distance
    float distance; // to the disc
};

struct Cover {
    float area;  // of the unit disc's pi; negative: the apex lies inside of the solid
    mat4 low;  // a row is bare where low > high
    mat4 high;
};

// Of the mask: rows 0 to 7 in `lower`, 8 to 15 in `upper`, of each first four in the lower halves.
struct Points {
    uvec4 lower;
    uvec4 upper;
};

struct Shade {
    float area;
    float largest; // cover so far: the union is no less
    Points hidden;
    float count; // of those
};

const mat4 kBeyond = mat4(2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0);

Cover coverNothing() { return Cover(0.0, kBeyond, -kBeyond); }
Cover coverAll() { return Cover(kPi, -kBeyond, kBeyond); }
Cover coverFromInside() { return Cover(-1.0, kBeyond, -kBeyond); }

vec3 across(LightCone cone, vec3 fromApex) {
    vec3 local = fromApex * cone.axes;
    return vec3(local.xy / cone.slope, local.z) / cone.distance;
}

bool passesBy(LightCone cone, vec4 ball) {
    vec3 local = (ball.xyz - cone.apex) * cone.axes;
    float reach = ball.w * 1.00001;
    float beside = length(local.xy) - cone.slope * local.z;
    return local.z < -reach || local.z - reach > cone.distance || beside > reach * sqrt(1.0 + cone.slope * cone.slope);
}

// Of the unit disc beyond the chord at x; atan() is the arc cosine, whose own error is much larger on some GPUs.
float segmentArea(float x) {
    x = clamp(x, -1.0, 1.0);
    float y = sqrt((1.0 - x) * (1.0 + x));
    return (y == 0.0 ? (x < 0.0 ? kPi : 0.0) : atan(y, x)) - x * y;
}

Cover halfDisc(vec2 normal, float level) {
    float size = max(length(normal), 1e-20);
    float slant = abs(normal.x) < 1e-10 * size ? 1e-10 * size : normal.x;
    mat4 edge;
    for (int i = 0; i < 4; ++i) edge[i] = (level - normal.y * kRows[i]) / slant;
    return Cover(segmentArea(level / size), slant > 0.0 ? edge : -kBeyond, slant > 0.0 ? kBeyond : edge);
}

// The points of four rows in the lower bits.
uvec4 pointsBetween(vec4 low, vec4 high, vec4 halfWidth, vec4 shift) {
    vec4 from = clamp(ceil(8.0 * low / halfWidth + 7.5 - shift), 0.0, 16.0);
    vec4 to = clamp(floor(8.0 * high / halfWidth + 8.5 - shift), 0.0, 16.0);
    return (uvec4(1u) << uvec4(max(from, to))) - (uvec4(1u) << uvec4(from));
}

Points pointsOf(Cover cover) {
    uvec4 rows[4];
    for (int i = 0; i < 4; ++i) rows[i] = pointsBetween(cover.low[i], cover.high[i], kHalfWidths[i], kShifts[i]);
    return Points(rows[0] | (rows[1] << 16u), rows[2] | (rows[3] << 16u));
}

Points inBoth(Points a, Points b) { return Points(a.lower & b.lower, a.upper & b.upper); }
Points without(Points a, Points b) { return Points(a.lower & ~b.lower, a.upper & ~b.upper); }
Points together(Points a, Points b) { return Points(a.lower | b.lower, a.upper | b.upper); }

float countOf(Points points) {
    uvec4 a = points.lower - ((points.lower >> 1u) & 0x55555555u);
    uvec4 b = points.upper - ((points.upper >> 1u) & 0x55555555u);
    a = (a & 0x33333333u) + ((a >> 2u) & 0x33333333u);
    b = (b & 0x33333333u) + ((b >> 2u) & 0x33333333u);
    a += b; // four bits each: at most 8
    a = (a & 0x0F0F0F0Fu) + ((a >> 4u) & 0x0F0F0F0Fu);
    uvec4 pairs = (a & 0x00FF00FFu) + ((a >> 8u) & 0x00FF00FFu);
    uint sum = pairs.x + pairs.y + pairs.z + pairs.w;
    return float((sum & 0xFFFFu) + (sum >> 16u));
}

// What two parts of the disc of known areas have in common, all as fractions of it, whose odds of lying in both are
// those of the mask's points: of all in both or in neither against those in one only.
float sharedPart(float a, float b, float both, float neither, float one, float other) {
    float most = min(a, b);
    float least = max(a + b - 1.0, 0.0);
    if (both + one == 0.0 || both + other == 0.0) return a * b; // one has no points
    if (one * other == 0.0) return most;
    if (both * neither == 0.0) return least;
    float odds = both * neither / (one * other);
    float s = 1.0 + (a + b) * (odds - 1.0);
    return clamp(2.0 * odds * a * b / (s + sqrt(max(s * s - 4.0 * odds * (odds - 1.0) * a * b, 0.0))), least, most);
}

void unite(inout Shade shade, float area, Points points) {
    float both = countOf(inBoth(points, shade.hidden));
    float added = countOf(points) - both;
    float left = shade.count - both;
    float twice = sharedPart(min(area / kPi, 1.0), min(shade.area / kPi, 1.0), both, 256.0 - both - added - left, added,
        left);
    shade.area += area - kPi * twice;
    shade.largest = max(shade.largest, area);
    shade.hidden = together(shade.hidden, points);
    shade.count += added;
}

void unite(inout Shade shade, Cover cover) { unite(shade, cover.area, pointsOf(cover)); }

float bareFraction(Shade shade) { return clamp(1.0 - max(shade.area, shade.largest) / kPi, 0.0, 1.0); }
