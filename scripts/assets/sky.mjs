// Sky: the stars to magnitude 7.2 where a catalogue has them, and the Milky Way within its observed outlines.
//
// makeSky(report) -> {'sky-px.png' … 'sky-nz.png'}: six faces as standard cube maps have them. Their axes are
//                        left-handed and the scene's are not, so that one is mirrored (docs/scenes.md): the file sky-px
//                        shows what lies towards -x
// skyDirection(ra, dec)  the world direction of a place of the sky (degrees): +y is the celestial north pole, +x the
//                        point of spring, right-handed; right ascension grows to the left as seen from inside with
//                        north up
//
// Light is added in linear units and stored as sRGB. A star is a Gaussian spot of fixed angle on the sphere, so that it
// is round wherever on a face it falls, and it is drawn on every face it touches, so that no edge cuts it.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { blackbodyColor, temperatureOf } from './star-color.mjs';
import { clamp, fractal, gradientNoise, hash, mix, ridged, smoothstep } from './noise.mjs';
import { direction, fillRings } from './sphere.mjs';

const size = 1024;
const degree = Math.PI / 180;
const pathOf = (name) => createRequire(import.meta.url).resolve(`d3-celestial/data/${name}`);
const read = (name) => JSON.parse(readFileSync(pathOf(name), 'utf8'));

export function skyDirection(ra, dec) {
  const a = ra * degree, d = dec * degree;
  return [Math.cos(d) * Math.cos(a), Math.sin(d), -Math.cos(d) * Math.sin(a)];
}

// Faces as the GPU gets them, by world axis: the inverse of GL's table, the direction seen at (sc, tc) of a face at
// distance 1; and (sc, tc, ma) of a direction.
const faces = {
  px: { at: (s, t) => [1, -t, -s], project: ([x, y, z]) => [-z, -y, x] },
  nx: { at: (s, t) => [-1, -t, s], project: ([x, y, z]) => [z, -y, -x] },
  py: { at: (s, t) => [s, 1, t], project: ([x, y, z]) => [x, z, y] },
  ny: { at: (s, t) => [s, -1, -t], project: ([x, y, z]) => [x, -z, -y] },
  pz: { at: (s, t) => [s, -t, 1], project: ([x, y, z]) => [x, -y, z] },
  nz: { at: (s, t) => [-s, -t, -1], project: ([x, y, z]) => [-x, -y, -z] },
};

// Seen from within they are mirrored: each is written the other way round, under the name that it has with x mirrored.
const nameInFile = { px: 'nx', nx: 'px', py: 'py', ny: 'ny', pz: 'pz', nz: 'nz' };

// Equatorial J2000 to galactic axes: rows point to the centre, to longitude 90 and to the north pole of the galaxy.
const galactic = [
  [-0.0548755604, -0.8734370902, -0.4838350155],
  [0.4941094279, -0.44482963, 0.7469822445],
  [-0.867666149, -0.1980763734, 0.4559837762],
];
const apply = (m, v) => m.map((row) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);

const mapWidth = 2048, mapHeight = 1024;

// A Gaussian blur on the sphere: rows widen towards the poles, the map wraps round. Three boxes in place of the bell.
function blurred(map, sigma) {
  const radiusOf = (texelAngle) => Math.max(0, Math.round((Math.sqrt(4 * (sigma / texelAngle) ** 2 + 1) - 1) / 2));
  let from = map;
  for (let pass = 0; pass < 3; ++pass) {
    const across = new Float32Array(map.length), down = new Float32Array(map.length);
    for (let y = 0; y < mapHeight; ++y) {
      const cosine = Math.cos((90 - ((y + 0.5) / mapHeight) * 180) * degree), row = y * mapWidth;
      const r = Math.min(mapWidth / 2 - 1, radiusOf((360 / mapWidth) * cosine));
      let sum = 0;
      for (let x = -r; x <= r; ++x) sum += from[row + ((x + mapWidth) % mapWidth)];
      for (let x = 0; x < mapWidth; ++x) {
        across[row + x] = sum / (2 * r + 1);
        sum += from[row + ((x + r + 1) % mapWidth)] - from[row + ((x - r + mapWidth) % mapWidth)];
      }
    }
    const r = radiusOf(180 / mapHeight);
    for (let x = 0; x < mapWidth; ++x) {
      const at = (y) => across[clamp(y, 0, mapHeight - 1) * mapWidth + x];
      let sum = 0;
      for (let y = -r; y <= r; ++y) sum += at(y);
      for (let y = 0; y < mapHeight; ++y) {
        down[y * mapWidth + x] = sum / (2 * r + 1);
        sum += at(y + r + 1) - at(y - r);
      }
    }
    from = down;
  }
  return from;
}

// The five nested outlines, from the faint edge to the bright clouds: how much light each adds, and how soft its edge
// is in degrees.
const outlines = { ol1: [0.2, 2.6], ol2: [0.24, 1.7], ol3: [0.24, 1.3], ol4: [0.22, 1], ol5: [0.2, 0.8] };

// Light of the Milky Way before its fine structure, as a map in galactic longitude and latitude.
function milkyWayMap() {
  const light = new Float32Array(mapWidth * mapHeight);
  for (const { id, geometry } of read('mw.json').features) {
    const [weight, softness] = outlines[id];
    const rings = geometry.coordinates.flat().map((ring) => ring.map(([lon, lat]) => {
      const [x, y, z] = apply(galactic, direction(lon, lat));
      return [Math.atan2(y, x) / degree, Math.asin(clamp(z, -1, 1)) / degree];
    }));
    const filled = fillRings(rings, mapWidth, mapHeight);
    // A band that rings the whole sky leaves both poles dark: if the even-odd rule lit one, the map is the complement.
    if (filled[0] > 0.5) filled.forEach((value, i) => { filled[i] = 1 - value; });
    blurred(filled, softness).forEach((value, i) => { light[i] += weight * value; });
  }
  return light;
}

function bilinear(map, u, v) {
  const x = u * mapWidth - 0.5, y = clamp(v * mapHeight - 0.5, 0, mapHeight - 1.001);
  const ix = Math.floor(x), iy = Math.floor(y), west = (ix + mapWidth) % mapWidth, east = (ix + 1) % mapWidth;
  const row = (line) => mix(map[line * mapWidth + west], map[line * mapWidth + east], x - ix);
  return mix(row(iy), row(iy + 1), y - iy);
}

const clouds = gradientNoise(41), dust = gradientNoise(42), veil = gradientNoise(43);

// Linear RGB of the Milky Way in a direction given in galactic axes.
function milkyWay(map, [x, y, z]) {
  const longitude = Math.atan2(y, x), latitude = Math.asin(clamp(z, -1, 1));
  const base = bilinear(map, (longitude / degree + 180) / 360, (90 - latitude / degree) / 180);
  if (base < 0.0005) return null;
  const b = latitude / degree;
  const centre = Math.exp(-((longitude / degree / 24) ** 2) - (b / 9) ** 2);
  const structure = 1 + 1.1 * fractal(clouds, 6, 7 * x, 7 * y, 9 * z, 0.6);
  // Dust lies in a sheet much thinner than the stars: it darkens near the galactic equator only.
  const ridge = ridged(dust, 5, 3.2 * x, 3.2 * y, 7 * z, 0.55);
  const lane = smoothstep(0.42, 0.72, ridge + 0.22 * fractal(veil, 5, 16 * x, 16 * y, 16 * z, 0.6));
  const shade = 1 - 0.72 * lane * Math.exp(-(((b + 1.2 * veil(2 * x, 2 * y, 2 * z)) / 5) ** 2));
  const level = base * Math.max(0.12, structure) * shade * (1 + 1.3 * centre);
  const light = 0.046 * Math.pow(level, 1.2);
  const warm = clamp(0.25 + 0.9 * centre + 0.5 * lane * (1 - shade));
  return [light * mix(0.8, 1.15, warm), light * mix(0.97, 0.99, warm), light * mix(1.36, 0.78, warm)];
}

const toStored = (linear) => 255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1 / 2.4) - 0.055);
const toLinear = (stored) =>
  (stored / 255 <= 0.04045 ? stored / 255 / 12.92 : Math.pow((stored / 255 + 0.055) / 1.055, 2.4));

// What is too bright to store: a soft shoulder that keeps the hue, so that a red star is not yellow, and whitens the
// middle of the very brightest as an eye or a film does.
function shouldered(light) {
  const most = Math.max(...light);
  if (most < 0.2) return light;
  const shown = 0.2 + 0.8 * (1 - Math.exp((0.2 - most) / 0.8)), white = 0.55 * (1 - Math.exp(-most / 5));
  return light.map((c) => mix((c * shown) / most, shown, white));
}

const background = [3, 4, 7];
const backgroundLight = background.map(toLinear);

const spotSigma = 0.0013;                 // radians: about two thirds of a texel in a face's middle
const faintest = 7.2, whiteMagnitude = 2;  // the star whose middle has unit light
const least = 0.00012;                    // light that no longer changes a stored value

function starSpots() {
  return read('stars.8.json').features
    .filter(({ properties }) => properties.mag <= faintest)
    .map(({ properties, geometry }) => {
      const light = Math.pow(10, -0.4 * (properties.mag - whiteMagnitude));
      const colorIndex = Number.parseFloat(properties.bv);
      return {
        toward: skyDirection(...geometry.coordinates),
        light,
        color: blackbodyColor(temperatureOf(Number.isFinite(colorIndex) ? colorIndex : 0.5)),
        halo: light > 0.12 ? 0.006 * light : 0,
      };
    });
}

const haloWidth = 3.2 * spotSigma;
const haloAt = (halo, squared) => halo / (1 + squared / (haloWidth * haloWidth)) ** 1.6;

function addStar(frame, face, star) {
  const [sc, tc, ma] = face.project(star.toward);
  if (ma < 0.3) return;
  const spotReach = spotSigma * Math.sqrt(2 * Math.log(Math.max(star.light / least, 1.01)));
  const haloReach = star.halo > 0 ? haloWidth * Math.sqrt(Math.pow(star.halo / least, 1 / 1.6)) : 0;
  const reach = Math.max(spotReach, haloReach);
  const s = sc / ma, t = tc / ma, stretch = reach * (1 + s * s + t * t) * 1.1;
  const texel = (x) => ((x + 1) / 2) * size - 0.5;
  const left = Math.max(0, Math.ceil(texel(s - stretch))), right = Math.min(size - 1, Math.floor(texel(s + stretch)));
  const top = Math.max(0, Math.ceil(texel(t - stretch))), bottom = Math.min(size - 1, Math.floor(texel(t + stretch)));
  for (let y = top; y <= bottom; ++y) {
    for (let x = left; x <= right; ++x) {
      const d = face.at((2 * (x + 0.5)) / size - 1, (2 * (y + 0.5)) / size - 1), scale = 1 / Math.hypot(...d);
      const squared =
        (d[0] * scale - star.toward[0]) ** 2 + (d[1] * scale - star.toward[1]) ** 2
        + (d[2] * scale - star.toward[2]) ** 2;
      if (squared > reach * reach) continue;
      const light =
        star.light * Math.exp(-squared / (2 * spotSigma * spotSigma))
        + (star.halo > 0 ? haloAt(star.halo, squared) - least : 0);
      if (light <= 0) continue;
      const at = (y * size + x) * 3;
      for (let c = 0; c < 3; ++c) frame[at + c] += light * star.color[c];
    }
  }
}

export function makeSky(report = () => {}) {
  report('outlines of the Milky Way');
  const map = milkyWayMap();
  report('stars');
  const stars = starSpots();
  const pictures = {};
  Object.entries(faces).forEach(([name, face], faceNumber) => {
    report(`face ${name}`);
    const glow = new Float32Array(size * size * 3), points = new Float32Array(size * size * 3);
    for (const star of stars) addStar(points, face, star);
    const data = new Uint8Array(size * size * 3);
    for (let y = 0; y < size; ++y) {
      for (let x = 0; x < size; ++x) {
        const [dx, dy, dz] = face.at((2 * (x + 0.5)) / size - 1, (2 * (y + 0.5)) / size - 1),
          scale = 1 / Math.hypot(dx, dy, dz);
        // World axes to the equatorial axes of astronomy (x to spring, z to the north pole).
        const cloud = milkyWay(map, apply(galactic, [dx * scale, -dz * scale, dy * scale]));
        const at = (y * size + x) * 3;
        if (cloud) glow.set(cloud, at);
        const lit = cloud !== null || points[at + 1] > 0;
        // One random offset for the three components: it breaks up bands as well as three would, and packs smaller.
        const dither = hash(faceNumber, x, y, 3);
        const light = shouldered([0, 1, 2].map((c) => glow[at + c] + points[at + c]));
        const mirrored = at + (size - 1 - 2 * x) * 3;
        for (let c = 0; c < 3; ++c) {
          data[mirrored + c] =
            lit ? Math.min(255, Math.floor(toStored(backgroundLight[c] + light[c]) + dither)) : background[c];
        }
      }
    }
    pictures[`sky-${nameInFile[name]}.png`] = { width: size, height: size, channels: 3, data };
  });
  return pictures;
}
