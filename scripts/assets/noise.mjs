// Noise: numbers that look random and are the same on every run.
//
// hash(seed, x, y, z)          uniform in [0, 1) from integers; the source of everything else here
// randomStream(seed)           function that yields the next uniform number in [0, 1)
// gradientNoise(seed)          (x, y, z) -> about -1 … 1, smooth; sampled on a sphere it has neither seam nor pole
// fractal, ridged              sums of octaves of a noise: rolling (-1 … 1), and crested like mountain chains (0 … 1)
// periodicNoise(seed, nx, ny)  (u, v) -> about -1 … 1, with period 1 in both and a lattice of nx by ny
// smoothstep, mix, clamp       as in GLSL

export const clamp = (x, low = 0, high = 1) => (x < low ? low : x > high ? high : x);
export const mix = (a, b, t) => a + (b - a) * t;
export const smoothstep = (from, to, x) => {
  const t = clamp((x - from) / (to - from));
  return t * t * (3 - 2 * t);
};

const hashBits = (seed, x, y, z) => {
  let h = Math.imul(seed, 0x9e3779b1) ^ Math.imul(x, 0x85ebca6b) ^ Math.imul(y, 0xc2b2ae35) ^ Math.imul(z, 0x27d4eb2f);
  h = Math.imul(h ^ (h >>> 15), 0x2c1b3c6d);
  h = Math.imul(h ^ (h >>> 12), 0x297a2d39);
  return (h ^ (h >>> 15)) >>> 0;
};

export const hash = (seed, x = 0, y = 0, z = 0) => hashBits(seed, x, y, z) / 4294967296;

export function randomStream(seed) {
  let count = 0;
  return () => hash(seed, ++count, 7, 13);
}

const fade = (t) => t * t * t * (t * (t * 6 - 15) + 10);

// The twelve edge midpoints of a cube, four of them twice: no gradient points along an axis, so no axis shows.
const gradients = [
  1, 1, 0, -1, 1, 0, 1, -1, 0, -1, -1, 0, 1, 0, 1, -1, 0, 1, 1, 0, -1, -1, 0, -1,
  0, 1, 1, 0, -1, 1, 0, 1, -1, 0, -1, -1, 1, 1, 0, -1, 1, 0, 0, -1, 1, 0, -1, -1,
];

export function gradientNoise(seed) {
  const corner = (ix, iy, iz, x, y, z) => {
    const g = (hashBits(seed, ix, iy, iz) & 15) * 3;
    return gradients[g] * x + gradients[g + 1] * y + gradients[g + 2] * z;
  };
  return (x, y, z) => {
    const ix = Math.floor(x), iy = Math.floor(y), iz = Math.floor(z);
    const fx = x - ix, fy = y - iy, fz = z - iz;
    const u = fade(fx), v = fade(fy), w = fade(fz);
    const row = (dy, dz) => mix(
      corner(ix, iy + dy, iz + dz, fx, fy - dy, fz - dz),
      corner(ix + 1, iy + dy, iz + dz, fx - 1, fy - dy, fz - dz), u);
    return mix(mix(row(0, 0), row(1, 0), v), mix(row(0, 1), row(1, 1), v), w);
  };
}

export function fractal(noise, octaves, x, y, z, gain = 0.5) {
  let sum = 0, amplitude = 1, total = 0;
  for (let octave = 0; octave < octaves; ++octave) {
    sum += amplitude * noise(x, y, z);
    total += amplitude;
    amplitude *= gain;
    // The offset keeps the octaves' lattices from sharing a point, where all of them would be zero at once.
    x = 2.03 * x + 17.3; y = 2.03 * y + 5.7; z = 2.03 * z + 31.1;
  }
  return sum / total;
}

export function ridged(noise, octaves, x, y, z, gain = 0.5) {
  let sum = 0, amplitude = 1, total = 0, weight = 1;
  for (let octave = 0; octave < octaves; ++octave) {
    let crest = 1 - Math.abs(noise(x, y, z));
    crest *= crest;
    sum += amplitude * crest * weight;
    total += amplitude;
    weight = clamp(crest * 1.4);            // detail gathers on the crests and leaves the valleys smooth
    amplitude *= gain;
    x = 2.03 * x + 17.3; y = 2.03 * y + 5.7; z = 2.03 * z + 31.1;
  }
  return sum / total;
}

export function periodicNoise(seed, nx, ny) {
  const corner = (ix, iy, x, y) => {
    const angle = 2 * Math.PI * hash(seed, ((ix % nx) + nx) % nx, ((iy % ny) + ny) % ny);
    return Math.cos(angle) * x + Math.sin(angle) * y;
  };
  return (u, v) => {
    const x = u * nx, y = v * ny;
    const ix = Math.floor(x), iy = Math.floor(y);
    const fx = x - ix, fy = y - iy;
    const s = fade(fx);
    return 1.4 * mix(
      mix(corner(ix, iy, fx, fy), corner(ix + 1, iy, fx - 1, fy), s),
      mix(corner(ix, iy + 1, fx, fy - 1), corner(ix + 1, iy + 1, fx - 1, fy - 1), s), fade(fy));
  };
}
