// Sun: granules, the dark lanes between them, filaments and a few spots. Repeats without a seam in u and in v.
//
// makeSun() -> {'sun.png': picture}
//
// The picture multiplies the colour of the sun's emission: it is bright (mean about 0.8) and only slightly warm.
import { clamp, hash, mix, periodicNoise, smoothstep } from './noise.mjs';

const width = 1024, height = 512;

// Nearest and second nearest of one jittered point per lattice cell, and a number of the nearest point's own.
function cells(seed, nx, ny, u, v) {
  const x = u * nx, y = v * ny, ix = Math.floor(x), iy = Math.floor(y);
  let first = Infinity, second = Infinity, own = 0;
  for (let dy = -1; dy <= 1; ++dy) {
    for (let dx = -1; dx <= 1; ++dx) {
      const cx = (((ix + dx) % nx) + nx) % nx, cy = (((iy + dy) % ny) + ny) % ny;
      const px = ix + dx + 0.1 + 0.8 * hash(seed, cx, cy, 0), py = iy + dy + 0.1 + 0.8 * hash(seed, cx, cy, 1);
      const distance = Math.hypot(x - px, y - py);
      if (distance < first) { second = first; first = distance; own = hash(seed, cx, cy, 2); }
      else if (distance < second) second = distance;
    }
  }
  return { first, second, own };
}

// Centre in u and v, radius of the penumbra in v: in pairs and groups within the two belts where the real sun has them.
const spots = [
  [0.172, 0.338, 0.021], [0.193, 0.345, 0.012], [0.186, 0.322, 0.006],
  [0.44, 0.63, 0.017], [0.463, 0.64, 0.009],
  [0.705, 0.37, 0.011], [0.722, 0.377, 0.015], [0.738, 0.36, 0.006],
  [0.885, 0.655, 0.012], [0.9, 0.648, 0.006],
];

const periodicDistance = (a, b) => Math.abs(a - b - Math.round(a - b));

export function makeSun() {
  const octaves = [4, 8, 16, 32, 64].map((n, i) => periodicNoise(31 + i, n * 2, n));
  const rolling = (u, v, from, count, gain = 0.55) => {
    let sum = 0, amplitude = 1, total = 0;
    for (let i = from; i < from + count; ++i) {
      sum += amplitude * octaves[i](u, v);
      total += amplitude;
      amplitude *= gain;
    }
    return sum / total;
  };
  const crests = periodicNoise(57, 6, 3), finerCrests = periodicNoise(58, 14, 7);
  const levels = new Float32Array(width * height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const u = (x + 0.5) / width, v = (y + 0.5) / height;
      const bendU = 0.006 * rolling(u, v, 2, 3), bendV = 0.012 * rolling(u + 0.37, v + 0.61, 2, 3);
      const granule = cells(3, 176, 88, u + bendU, v + bendV);
      const lane = smoothstep(-0.12, 0.62, granule.second - granule.first);
      const supergranule = cells(5, 22, 11, u + 3 * bendU, v + 3 * bendV);
      const network = 1 - smoothstep(0, 0.24, supergranule.second - supergranule.first);
      let level = 0.715 + 0.17 * lane + 0.06 * (granule.own - 0.5) + 0.09 * rolling(u, v, 0, 5);
      level += 0.05 * network * (0.5 + rolling(u + 0.2, v, 1, 3));

      // Filaments: thin crests of a slow noise, broken into arcs by another.
      const warpedU = u + 4 * bendU, warpedV = v + 4 * bendV;
      const crest = 1 - Math.abs(crests(warpedU, warpedV) + 0.45 * finerCrests(warpedU, warpedV));
      const arcs = smoothstep(0.05, 0.4, octaves[0](u + 0.53, v + 0.27));
      level -= 0.15 * smoothstep(0.9, 0.995, crest) * arcs;

      for (const [spotU, spotV, radius] of spots) {
        const du = 2 * periodicDistance(u, spotU), dv = periodicDistance(v, spotV);
        if (du > 3 * radius || dv > 3 * radius) continue;
        const ragged = 1 + 0.35 * rolling(u + 0.1, v + 0.1, 3, 2);
        const r = Math.hypot(du, dv) / (radius * ragged);
        level += 0.1 * smoothstep(2.6, 1.1, r) * (0.6 + lane * 0.4);        // the bright faculae about a group
        const penumbra = smoothstep(1.08, 0.85, r), umbra = smoothstep(0.58, 0.4, r);
        level = mix(level, 0.56 + 0.1 * (lane - 0.5), penumbra);
        level = mix(level, 0.2, umbra);
      }
      levels[y * width + x] = clamp(level);
    }
  }
  const data = new Uint8Array(width * height * 3);
  for (let i = 0; i < levels.length; ++i) {
    // Colour is a function of the grey level alone, so that the file needs no more than a palette; cooler gas is
    // redder.
    const level = Math.round(levels[i] * 160) / 160;
    data[3 * i] = Math.round(255 * clamp(Math.pow(level, 0.75)));
    data[3 * i + 1] = Math.round(255 * level);
    data[3 * i + 2] = Math.round(255 * Math.pow(level, 1.4));
  }
  return { 'sun.png': { width, height, channels: 3, data } };
}
