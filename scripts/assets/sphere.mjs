// Sphere: pictures of a whole sphere, u = 0 at longitude -180 and u = 1 at +180, row 0 at the north pole.
//
// texelDirection(x, y, width, height)  unit vector of a texel's centre; longitude 0 is +x, 90 east is +y, north is +z
// fillRings(rings, width, height)      coverage 0 … 1 of every texel by rings of [longitude, latitude] in degrees,
//                                      even-odd
// normalMap(heights, width, height)    tangent-space normals of a height field in radii: x east, y north, z out

const degree = Math.PI / 180;

export function direction(longitude, latitude) {
  const lon = longitude * degree, lat = latitude * degree;
  return [Math.cos(lat) * Math.cos(lon), Math.cos(lat) * Math.sin(lon), Math.sin(lat)];
}

export const longitudeOf = (x, width) => ((x + 0.5) / width) * 360 - 180;
export const latitudeOf = (y, height) => 90 - ((y + 0.5) / height) * 180;
export const texelDirection = (x, y, width, height) => direction(longitudeOf(x, width), latitudeOf(y, height));

// The ring with longitudes that never jump. A ring that goes round a pole is closed over the south pole: for the
// even-odd rule it then covers all that lies south of it.
function unrolled(ring) {
  const points = [];
  let turn = 0;
  for (let i = 0; i < ring.length; ++i) {
    if (i > 0) turn -= 360 * Math.round((ring[i][0] - ring[i - 1][0]) / 360);
    points.push([ring[i][0] + turn, ring[i][1]]);
  }
  const first = points[0], last = points[points.length - 1];
  if (Math.abs(last[0] - first[0]) > 180) points.push([last[0], -90], [first[0], -90], first);
  return points;
}

const scanlinesPerRow = 4;

export function fillRings(rings, width, height) {
  const lines = height * scanlinesPerRow;
  const crossings = Array.from({ length: lines }, () => new Map());
  rings.forEach((ring, index) => {
    const points = unrolled(ring);
    for (let i = 0; i < points.length; ++i) {
      const [lonA, latA] = points[i], [lonB, latB] = points[(i + 1) % points.length];
      const a = ((90 - latA) / 180) * lines - 0.5, b = ((90 - latB) / 180) * lines - 0.5;
      const from = Math.max(0, Math.ceil(Math.min(a, b))), to = Math.min(lines - 1, Math.ceil(Math.max(a, b)) - 1);
      for (let line = from; line <= to; ++line) {
        const lon = lonA + ((lonB - lonA) * (line - a)) / (b - a);
        if (!crossings[line].has(index)) crossings[line].set(index, []);
        crossings[line].get(index).push(((lon + 180) / 360) * width);
      }
    }
  });
  const coverage = new Float32Array(width * height);
  const inside = new Float32Array(width);
  for (let line = 0; line < lines; ++line) {
    inside.fill(0);
    for (const xs of crossings[line].values()) {
      xs.sort((p, q) => p - q);
      for (let i = 0; i + 1 < xs.length; i += 2) {
        for (let x = Math.floor(xs[i]); x < xs[i + 1]; ++x) {
          const part = Math.min(x + 1, xs[i + 1]) - Math.max(x, xs[i]);
          const column = ((x % width) + width) % width;
          // Even-odd for fractions: a hole in a filled texel takes away what the hole covers.
          inside[column] = inside[column] + part - 2 * inside[column] * part;
        }
      }
    }
    const row = Math.floor(line / scanlinesPerRow) * width;
    for (let x = 0; x < width; ++x) coverage[row + x] += inside[x] / scanlinesPerRow;
  }
  return coverage;
}

// Within this angle of a pole (degrees) a texel is much narrower than high, and its east differs from its neighbour's:
// the bumps fade there, so that no star of creases meets in the pole.
const poleFade = 4;

// Stored slopes are multiples of this: half a degree of tilt, unseen in the light, a quarter less to load.
const coarse = 2;

export function normalMap(heights, width, height) {
  const data = new Uint8Array(width * height * 3);
  const northStep = Math.PI / height, eastStep = (2 * Math.PI) / width;
  for (let y = 0; y < height; ++y) {
    const latitude = latitudeOf(y, height);
    const fade = Math.min(1, (90 - Math.abs(latitude)) / poleFade);
    const above = Math.max(0, y - 1), below = Math.min(height - 1, y + 1);
    // Near a pole the east difference is taken over a wider interval, so that it spans about as much ground as the
    // north one.
    const reach = Math.max(1, Math.round(1 / Math.max(0.02, Math.cos(latitude * degree))));
    const east = 2 * reach * eastStep * Math.cos(latitude * degree), north = (below - above) * northStep;
    for (let x = 0; x < width; ++x) {
      const west = (x - reach + width) % width, eastward = (x + reach) % width;
      const slopeEast = (fade * (heights[y * width + eastward] - heights[y * width + west])) / east;
      const slopeNorth = (fade * (heights[above * width + x] - heights[below * width + x])) / north;
      const length = Math.hypot(slopeEast, slopeNorth, 1);
      const stored = [slopeEast, slopeNorth].map((slope) => coarse * Math.round((-127 * slope) / (length * coarse)));
      // The third component follows from the two as they are stored, so that the vector stays of unit length.
      const out = Math.sqrt(127 * 127 - stored[0] ** 2 - stored[1] ** 2);
      data.set([128 + stored[0], 128 + stored[1], Math.round(128 + out)], (y * width + x) * 3);
    }
  }
  return { width, height, channels: 3, data };
}
