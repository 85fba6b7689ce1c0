// Earth: real outlines (Natural Earth, through world-atlas), invented colours and heights.
//
// makeEarth(report) -> {'earth-color.png', 'earth-water.png', 'earth-normal.png'}
//
// The rule that the pictures share: a texel is water exactly where blue is the greatest of its three components
// (b > r and b > g). Land, ice on land and ice on the sea are never so. earth-water is 255 on water and 0 elsewhere.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { feature } from 'topojson-client';
import { chains, lakes, moisture, plateaus, warmth } from './earth-places.mjs';
import { clamp, fractal, gradientNoise, mix, ridged, smoothstep } from './noise.mjs';
import { fillRings, latitudeOf, longitudeOf, normalMap, texelDirection } from './sphere.mjs';

const width = 2048, height = 1024, texels = width * height;
const degree = Math.PI / 180;

function landRings() {
  const file = createRequire(import.meta.url).resolve('world-atlas/land-50m.json');
  const topology = JSON.parse(readFileSync(file, 'utf8'));
  const land = feature(topology, topology.objects.land);
  const geometries = land.type === 'FeatureCollection' ? land.features.map((f) => f.geometry) : [land.geometry];
  return geometries.flatMap((g) => (g.type === 'Polygon' ? [g.coordinates] : g.coordinates)).flat();
}

const wrapped = (longitude) => longitude - 360 * Math.round(longitude / 360);

// Calls visit(texel, degrees) for texels within `reach` degrees of the polyline, with the distance to it.
function forTexelsNearLine(line, reach, visit) {
  const nearest = new Map();
  for (let i = 0; i + 1 < line.length; ++i) {
    const [lonA, latA] = line[i], [lonB, latB] = line[i + 1];
    const squeeze = Math.cos(((latA + latB) / 2) * degree);
    const bx = wrapped(lonB - lonA) * squeeze, by = latB - latA;
    const top = Math.max(0, Math.floor(((90 - Math.max(latA, latB) - reach) / 180) * height));
    const bottom = Math.min(height - 1, Math.ceil(((90 - Math.min(latA, latB) + reach) / 180) * height));
    const westmost = Math.min(0, bx) - reach, eastmost = Math.max(0, bx) + reach;
    const from = Math.floor(((lonA + westmost / squeeze + 180) / 360) * width),
      to = Math.ceil(((lonA + eastmost / squeeze + 180) / 360) * width);
    for (let y = top; y <= bottom; ++y) {
      for (let x = from; x <= to; ++x) {
        const px = wrapped(longitudeOf(x, width) - lonA) * squeeze, py = latitudeOf(y, height) - latA;
        const t = clamp((px * bx + py * by) / (bx * bx + by * by));
        const distance = Math.hypot(px - t * bx, py - t * by);
        const texel = y * width + (((x % width) + width) % width);
        if (distance < reach && !(nearest.get(texel) <= distance)) nearest.set(texel, distance);
      }
    }
  }
  nearest.forEach((distance, texel) => visit(texel, distance));
}

// Sum of smooth elliptic bumps [longitude, latitude, half-width, half-height, amount] at a point.
function bumps(list, longitude, latitude) {
  let sum = 0;
  for (const [lon, lat, rx, ry, amount] of list) {
    const y = (latitude - lat) / ry;
    if (y * y > 6) continue;
    const x = wrapped(longitude - lon) / rx;
    if (x * x + y * y < 6) sum += amount * Math.exp(-(x * x + y * y) * 0.9);
  }
  return sum;
}

// Angle in degrees from every texel to the nearest texel of the other kind, positive on land: sweeps that hand on the
// nearest shore texel to the neighbours, with true distances on the sphere.
function coastDistance(isLand, directions) {
  const source = new Int32Array(texels).fill(-1), chord = new Float32Array(texels).fill(Infinity);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const i = y * width + x, east = y * width + ((x + 1) % width), south = i + width;
      if (isLand[i] !== isLand[east]) { source[i] = i; source[east] = east; chord[i] = chord[east] = 0; }
      if (y + 1 < height && isLand[i] !== isLand[south]) {
        source[i] = i;
        source[south] = south;
        chord[i] = chord[south] = 0;
      }
    }
  }
  const offer = (i, from) => {
    const s = source[from];
    if (s < 0 || s === source[i]) return;
    const dx = directions[3 * i] - directions[3 * s], dy = directions[3 * i + 1] - directions[3 * s + 1],
      dz = directions[3 * i + 2] - directions[3 * s + 2];
    const squared = dx * dx + dy * dy + dz * dz;
    if (squared < chord[i]) { chord[i] = squared; source[i] = s; }
  };
  for (let round = 0; round < 2; ++round) {
    for (const [start, end, step] of [[0, height, 1], [height - 1, -1, -1]]) {
      for (let y = start; y !== end; y += step) {
        const row = y * width, before = (y - step) * width, hasBefore = y !== start;
        for (let pass = 0; pass < 2 * width; ++pass) {
          const x = pass % width, i = row + x, west = (x + width - 1) % width, east = (x + 1) % width;
          if (hasBefore && pass < width) { offer(i, before + x); offer(i, before + west); offer(i, before + east); }
          offer(i, row + west);
        }
        for (let pass = 2 * width - 1; pass >= 0; --pass) offer(row + (pass % width), row + ((pass + 1) % width));
      }
    }
  }
  return chord.map((squared, i) => {
    const angle = squared === Infinity ? 90 : (2 * Math.asin(Math.min(1, Math.sqrt(squared) / 2))) / degree;
    return isLand[i] ? angle : -angle;
  });
}

const palette = {
  rainforest: [38, 72, 26], savanna: [128, 122, 62], steppe: [142, 132, 84], broadleaf: [66, 94, 42],
  taiga: [52, 72, 42],
  tundra: [124, 118, 96], sand: [208, 178, 126], redSand: [184, 112, 68], greySand: [168, 146, 108],
  rock: [112, 98, 82],
  ice: [243, 246, 246], seaIce: [222, 231, 231],
  abyss: [7, 22, 62], ocean: [12, 38, 92], shelf: [28, 84, 128], lagoon: [52, 132, 150], polar: [20, 48, 84],
};
const blend = (a, b, t) => [mix(a[0], b[0], t), mix(a[1], b[1], t), mix(a[2], b[2], t)];

const redGround = [[133, -25, 16, 10, 1], [18, -24, 8, 8, 0.5], [48, 20, 5, 4, 0.5], [-8, 20, 8, 5, 0.25]];
const greyGround = [
  [104, 42, 14, 6, 1], [62, 42, 12, 6, 0.9], [88, 34, 12, 5, 1], [57, 32, 9, 5, 0.7], [-69, -44, 5, 8, 0.9],
  [-117, 40, 7, 5, 0.8],
];

function landColor(place) {
  const { longitude, latitude, temperature, wet, kilometres, grain, region } = place;
  let desert = blend(palette.sand, palette.redSand, clamp(bumps(redGround, longitude, latitude)));
  desert = blend(desert, palette.greySand, clamp(bumps(greyGround, longitude, latitude)));
  const hot = smoothstep(15, 23, temperature), cold = smoothstep(7, 1, temperature);
  const grass = blend(palette.steppe, palette.savanna, hot);
  const forest = blend(blend(palette.broadleaf, palette.rainforest, hot), palette.taiga, cold);
  let color =
    wet < 0.44 ? blend(desert, grass, smoothstep(0.06, 0.42, wet)) : blend(grass, forest, smoothstep(0.46, 0.88, wet));
  color = blend(color, palette.rock, clamp(0.8 * smoothstep(0.9, 3, kilometres) * (0.8 + 0.4 * grain)));
  color = blend(color, palette.tundra, smoothstep(-4, -9, temperature + 2 * grain));
  color = color.map((c) => c * (1 + 0.13 * grain + 0.22 * region));
  const snowLine = 5.4 * Math.max(0, 1 - (latitude / 75) ** 2);
  const snow = smoothstep(snowLine, snowLine + 1.1, kilometres + 0.7 * grain - 0.1) * smoothstep(1, 1.6, kilometres);
  return blend(color, palette.ice, Math.max(0.92 * snow, smoothstep(-14.5, -19, temperature + 3 * grain)));
}

function waterColor({ latitude, offshore, tone }) {
  const depth = offshore * (1 + 1.4 * tone) + 0.6 * tone;
  const polar = smoothstep(45, 68, Math.abs(latitude));
  const tropical = smoothstep(34, 20, Math.abs(latitude));
  let color = blend(palette.ocean, palette.abyss, smoothstep(2, 13, depth + 5 * tone));
  color = blend(color, palette.polar, 0.6 * polar);
  color = blend(color, palette.shelf, 0.75 * (1 - smoothstep(0, 1.9, depth)));
  return blend(color, palette.lagoon, (0.25 + 0.35 * tropical) * (1 - smoothstep(0, 0.7, depth)));
}

// Rounded to bytes so that the rule of this file holds. Colours are a multiple of two: no eye sees the lost bit, and
// the file is a quarter smaller.
function storeColor(data, i, color, isWater) {
  let [r, g, b] = color.map((c) => 2 * Math.round(clamp(c, 0, 254) / 2));
  if (isWater) b = Math.max(b, r + 2, g + 2);
  else b = Math.min(b, Math.max(r, g));
  data[3 * i] = r; data[3 * i + 1] = g; data[3 * i + 2] = b;
}

export function makeEarth(report = () => {}) {
  report('outlines');
  const coverage = fillRings(landRings(), width, height);
  for (const { width: half, spine } of lakes) {
    const shore = gradientNoise(23);
    forTexelsNearLine(spine, half * 1.5, (i, distance) => {
      const lon = longitudeOf(i % width, width), lat = latitudeOf(Math.floor(i / width), height);
      const ragged = half * (1 + 0.55 * fractal(shore, 3, lon * 0.9, lat * 0.9, half * 10));
      coverage[i] = Math.min(coverage[i], smoothstep(ragged - 0.09, ragged + 0.09, distance));
    });
  }
  const isLand = Uint8Array.from(coverage, (c) => (c >= 0.5 ? 1 : 0));
  const directions = new Float64Array(texels * 3);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) directions.set(texelDirection(x, y, width, height), (y * width + x) * 3);

  report('distance to the coast');
  const coast = coastDistance(isLand, directions);

  report('heights');
  const mountain = new Float32Array(texels);
  for (const { height: top, width: half, crest } of chains) {
    forTexelsNearLine(crest, half * 2.4, (i, distance) => {
      const r = distance / half;
      mountain[i] = Math.max(mountain[i], top * Math.exp(-r * r) - top * Math.exp(-2.4 * 2.4));
    });
  }
  const hills = gradientNoise(21), folds = gradientNoise(22), climate = gradientNoise(24), floes = gradientNoise(25);
  const heights = new Float32Array(texels), plains = new Float32Array(texels);
  const relief = new Float32Array(texels);
  for (let i = 0; i < texels; ++i) {
    if (!isLand[i]) continue;
    const [x, y, z] = directions.subarray(3 * i, 3 * i + 3);
    const longitude = longitudeOf(i % width, width), latitude = latitudeOf(Math.floor(i / width), height);
    const shore = smoothstep(0, 1.2, coast[i]);
    const crest = ridged(folds, 6, 26 * x, 26 * y, 26 * z, 0.55), roll = fractal(hills, 6, 9 * x, 9 * y, 9 * z, 0.55);
    const broad = bumps(plateaus, longitude, latitude);
    plains[i] = shore * Math.max(0, 0.25 + 0.7 * roll + broad) + mountain[i] * 0.5;
    const icy = Math.max(smoothstep(-62, -66, latitude), iceSheet(longitude, latitude, coast[i], 0));
    relief[i] =
      shore * (1 - 0.75 * icy) * (0.35 * roll + 0.5 * crest * (0.35 + 0.5 * broad))
      + mountain[i] * (0.25 + 0.95 * crest) + shore * broad * 0.7;
    heights[i] = Math.max(0, relief[i] + 0.12 * shore);
  }

  report('climate and colours');
  const color = { width, height, channels: 3, data: new Uint8Array(texels * 3) };
  const water = { width, height, channels: 1, data: new Uint8Array(texels) };
  for (let i = 0; i < texels; ++i) {
    const [x, y, z] = directions.subarray(3 * i, 3 * i + 3);
    const longitude = longitudeOf(i % width, width), latitude = latitudeOf(Math.floor(i / width), height);
    if (isLand[i]) {
      const kilometres = plains[i], grain = 1.6 * fractal(climate, 5, 30 * x, 30 * y, 30 * z, 0.65),
        region = fractal(climate, 4, 6 * x, 6 * y, 6 * z);
      const temperature =
        28 - 0.0073 * latitude * latitude - 5.5 * Math.max(0, heights[i] * 0.55 + kilometres * 0.45 - 0.3)
        + bumps(warmth, longitude, latitude) + 3 * region;
      const away = Math.abs(latitude);
      // The borders of dry and wet wander by a few degrees, or the ellipses they are made of would show.
      const bentLongitude = longitude + 7 * fractal(climate, 5, 7 * x + 9, 7 * y, 7 * z, 0.6),
        bentLatitude = latitude + 5 * fractal(climate, 5, 7 * x, 7 * y + 9, 7 * z, 0.6);
      const rain =
        0.62 * Math.exp(-Math.pow(bentLatitude / 13, 2)) + 0.62 * Math.exp(-Math.pow((away - 52) / 17, 2)) + 0.22;
      const wet = rain + bumps(moisture, bentLongitude, bentLatitude) + 0.4 * region + 0.14 * grain;
      let texel = landColor({ longitude, latitude, temperature, wet, kilometres: heights[i], grain, region });
      const ice = Math.max(iceSheet(longitude, latitude, coast[i], grain), smoothstep(-60, -61, latitude));
      texel = blend(texel, palette.ice, ice);
      if (texel[0] > 225) texel = texel.map((c) => c * (1 - 0.025 * Math.abs(grain)));
      storeColor(color.data, i, texel, false);
      continue;
    }
    const tone = fractal(hills, 5, 8 * x, 8 * y, 8 * z);
    const pack = seaIce(longitude, latitude, -coast[i], fractal(floes, 6, 20 * x, 20 * y, 20 * z, 0.62));
    if (pack > 0) {
      storeColor(color.data, i, blend(palette.seaIce, palette.ice, pack), false);
    } else {
      const texel = waterColor({ latitude, offshore: -coast[i], tone });
      // A texel of water that the coast crosses takes a little of the shore's tone, which softens the coast.
      storeColor(color.data, i, blend(texel, palette.shelf, 0.5 * coverage[i]), true);
      water.data[i] = 255;
    }
  }

  report('normals');
  // Heights in planetary radii times an exaggeration: true relief would be flat to the eye at this size.
  const exaggeration = 34, radius = 6371;
  const bumpy = heights.map((h) => (h * exaggeration) / radius);
  const normal = normalMap(bumpy, width, height);
  for (let i = 0; i < texels; ++i) if (!isLand[i]) normal.data.set([128, 128, 255], 3 * i);
  return { 'earth-color.png': color, 'earth-water.png': water, 'earth-normal.png': normal };
}

// 1 on the great ice sheets and caps of the north, 0 off them; the rim of Greenland is bare ground.
function iceSheet(longitude, latitude, inland, grain) {
  const inland = bumps([[-42, 76, 22, 8, 1.6], [-44, 66, 6, 7, 1.6]], longitude, latitude);
  const greenland = inland > 0.32 && longitude > -73 && latitude > 59.5;
  const rim = greenland ? smoothstep(0.35, 1.0, inland + 0.35 * grain) : 0;
  const islands = [
    [-78, 80, 9, 2.5, 1], [-72, 70, 3, 1.5, 0.6], [18, 79, 6, 1.2, 1], [58, 80.8, 8, 1, 1.2],
    [62, 76, 4, 1.4, 0.9], [97, 80, 6, 1.4, 1], [-17.5, 64.5, 1.3, 0.4, 1.2],
  ];
  const caps = bumps(islands, longitude, latitude);
  return Math.max(rim, smoothstep(0.42, 0.72, caps + 0.25 * grain));
}

// 0 on open water; on the pack, how solid it is. The Arctic's edge reaches further south off Canada than off Norway.
function seaIce(longitude, latitude, offshore, noise) {
  const north = latitude - (80.5 - 5 * Math.cos((longitude + 120) * degree)) + 6 * noise;
  const south = -latitude - 71.5 + 5 * noise + 2.5 * Math.cos((longitude + 45) * degree) - 0.4 * offshore + 1.5;
  const solid = Math.max(north, south);
  return solid > 0 ? smoothstep(0, 5, solid + 2 * noise + 0.01) + 1e-6 : 0;
}
