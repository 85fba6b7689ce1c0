// The pictures under assets/textures: their sizes, their own rules, and whether they show what they say they show.
// What is expected of the sky and the earth is computed here on its own, not with the maker's code.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { PNG } from 'pngjs';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..', '..');
const textures = path.join(root, 'assets', 'textures');
const sizes = {
  'earth-color': [2048, 1024],
  'earth-water': [2048, 1024],
  'earth-normal': [2048, 1024],
  'moon-color': [1024, 512],
  'moon-normal': [1024, 512],
  sun: [1024, 512],
  grid: [512, 512],
  'sky-px': [1024, 1024],
  'sky-nx': [1024, 1024],
  'sky-py': [1024, 1024],
  'sky-ny': [1024, 1024],
  'sky-pz': [1024, 1024],
  'sky-nz': [1024, 1024],
};
const file = (name, folder = textures) => path.join(folder, `${name}.png`);
const decoded = new Map();
function picture(name) {
  if (!decoded.has(name)) decoded.set(name, PNG.sync.read(readFileSync(file(name))));
  return decoded.get(name);
}
function texel(name, x, y) {
  const { width, data } = picture(name),
    at = (y * width + x) * 4;
  return [data[at], data[at + 1], data[at + 2]];
}

test('every texture has its stated size', () => {
  for (const [name, [width, height]] of Object.entries(sizes)) {
    const header = readFileSync(file(name)).subarray(16, 24);
    assert.deepEqual([header.readUInt32BE(0), header.readUInt32BE(4)], [width, height], name);
  }
});

test('all textures together stay within 6 MB', () => {
  const total = Object.keys(sizes).reduce((sum, name) => sum + statSync(file(name)).size, 0);
  assert.ok(total <= 6e6, `${total} bytes`);
});

test('a texel of the earth is water in the mask exactly where blue is its greatest component', () => {
  const color = picture('earth-color').data,
    water = picture('earth-water').data;
  let wrong = 0,
    wet = 0;
  for (let i = 0; i < color.length; i += 4) {
    const blueDominant = color[i + 2] > color[i] && color[i + 2] > color[i + 1];
    if (water[i] !== (blueDominant ? 255 : 0)) ++wrong;
    if (blueDominant) ++wet;
  }
  assert.equal(wrong, 0);
  // Weighted by texel, not by area: the poles, which are ice, count for too much.
  assert.ok(
    wet / (color.length / 4) > 0.5 && wet / (color.length / 4) < 0.72,
    `share of water ${wet / (color.length / 4)}`,
  );
});

const earthTexel = (lon, lat) => [
  Math.floor(((lon + 180) / 360) * 2048) % 2048,
  Math.min(1023, Math.floor(((90 - lat) / 180) * 1024)),
];

test('the continents are where an atlas has them', () => {
  const land = {
    Paris: [2.35, 48.86],
    Cairo: [31.2, 29.9],
    'Sao Paulo': [-46.6, -23.5],
    Denver: [-105, 39.7],
    Moscow: [37.6, 55.75],
    Delhi: [77.2, 28.6],
    'Alice Springs': [133.9, -23.7],
    Nairobi: [36.8, -1.3],
    Anchorage: [-149.2, 61.6],
    Yakutsk: [129.7, 62],
    'South Pole': [0, -89.9],
    'Summit of Greenland': [-38.5, 72.6],
    Madagascar: [46.5, -20],
    'South Island': [170.8, -43.9],
    Chukotka: [179, 67.5],
  };
  const water = {
    'mid Atlantic': [-35, 30],
    'mid Pacific': [-150, 10],
    'Indian Ocean': [80, -25],
    'Gulf of Mexico': [-90, 25],
    Mediterranean: [18, 35],
    'Black Sea': [34, 43.2],
    'Caspian Sea': [51, 41],
    'Hudson Bay': [-85, 60],
    'Tasman Sea': [160, -38],
    'Bay of Bengal': [88, 13],
    'Drake Passage': [-65, -58.5],
    dateline: [180, 40],
    'Gulf of Guinea': [0, 0],
    'Lake Superior': [-88, 47.7],
    'Lake Victoria': [33, -1],
  };
  for (const [name, [lon, lat]] of Object.entries(land))
    assert.equal(texel('earth-water', ...earthTexel(lon, lat))[0], 0, `${name} is land`);
  for (const [name, [lon, lat]] of Object.entries(water))
    assert.equal(texel('earth-water', ...earthTexel(lon, lat))[0], 255, `${name} is water`);
});

test('the ice is white, the rain forest green and the Sahara pale', () => {
  const [ir, ig, ib] = texel('earth-color', ...earthTexel(-40, 75));
  assert.ok(Math.min(ir, ig, ib) > 200, `Greenland ${[ir, ig, ib]}`);
  const [fr, fg, fb] = texel('earth-color', ...earthTexel(-62, -4));
  assert.ok(fg > fr && fg > fb, `Amazon ${[fr, fg, fb]}`);
  const [sr, sg, sb] = texel('earth-color', ...earthTexel(15, 25));
  assert.ok(sr > 140 && sr > sg && sg > sb, `Sahara ${[sr, sg, sb]}`);
});

for (const name of ['earth-normal', 'moon-normal']) {
  test(`${name} decodes to unit vectors that point outward`, () => {
    const { data } = picture(name);
    let worst = 0,
      least = 1;
    for (let i = 0; i < data.length; i += 4) {
      const [x, y, z] = [data[i], data[i + 1], data[i + 2]].map((c) => (c - 128) / 127);
      worst = Math.max(worst, Math.abs(Math.hypot(x, y, z) - 1));
      least = Math.min(least, z);
    }
    assert.ok(worst <= 0.02, `length off by ${worst}`);
    assert.ok(least > 0, `least z ${least}`);
  });
}

test('the normals of water are flat', () => {
  const water = picture('earth-water').data,
    normal = picture('earth-normal').data;
  let bumpy = 0;
  for (let i = 0; i < water.length; i += 4) {
    if (water[i] === 255 && (normal[i] !== 128 || normal[i + 1] !== 128 || normal[i + 2] !== 255)) ++bumpy;
  }
  assert.equal(bumpy, 0);
});

test('the south slope of the Himalaya faces south, its green below the middle', () => {
  let sum = 0,
    count = 0;
  for (let lon = 79; lon < 90; lon += 0.1) {
    const crest = 30.5 - (Math.min(lon, 85) - 80) * 0.44 - Math.max(0, lon - 85) * 0.05;
    for (let south = 0.8; south < 2; south += 0.1) {
      sum += texel('earth-normal', ...earthTexel(lon, crest - south))[1];
      ++count;
    }
  }
  assert.ok(sum / count < 122, `mean green ${sum / count}`);
});

// How much the first and last columns differ, against how much neighbours differ elsewhere.
function seamRatio(name, along) {
  const { width, height } = picture(name);
  const [across, length] = along === 'u' ? [width, height] : [height, width];
  const at = (i, j) => (along === 'u' ? texel(name, i, j) : texel(name, j, i));
  const step = (a, b) => {
    let sum = 0;
    for (let j = 0; j < length; ++j) {
      const p = at(a, j),
        q = at(b, j);
      sum += Math.abs(p[0] - q[0]) + Math.abs(p[1] - q[1]) + Math.abs(p[2] - q[2]);
    }
    return sum / length;
  };
  let inside = 0;
  for (let k = 1; k <= 16; ++k) {
    const i = Math.floor((across * k) / 17);
    inside += step(i - 1, i) / 16;
  }
  return step(across - 1, 0) / inside;
}

for (const [name, along] of [
  ['earth-color', 'u'],
  ['moon-color', 'u'],
  ['moon-normal', 'u'],
  ['sun', 'u'],
  ['sun', 'v'],
  ['grid', 'u'],
  ['grid', 'v'],
]) {
  test(`${name} has no seam along ${along}`, () => {
    // Its border is a line, cut in halves by the edge: the halves must match.
    if (name === 'grid') {
      const { width } = picture(name);
      for (let i = 0; i < width; ++i) {
        const [a, b] =
          along === 'u'
            ? [texel(name, 0, i), texel(name, width - 1, i)]
            : [texel(name, i, 0), texel(name, i, width - 1)];
        assert.deepEqual(a, b);
      }
      return;
    }
    // An earth of land and sea varies from column to column: twice the usual is still no seam.
    const ratio = seamRatio(name, along),
      bound = name === 'earth-color' ? 2 : 1.5;
    assert.ok(ratio < bound, `the seam differs ${ratio} times as much as neighbours do`);
  });
}

test('the sun is bright: its mean is near 0.8', () => {
  const { data } = picture('sun');
  let sum = 0;
  for (let i = 0; i < data.length; i += 4) sum += data[i] + data[i + 1] + data[i + 2];
  const mean = sum / (data.length / 4) / 3 / 255;
  assert.ok(mean > 0.72 && mean < 0.9, `mean ${mean}`);
});

// The sky. World axes: +y to the celestial north pole, +x to right ascension 0, right-handed, +z to right ascension
// 270.
function skyTexel(raHours, dec) {
  const a = (raHours * Math.PI) / 12,
    d = (dec * Math.PI) / 180;
  return faceTexel([Math.cos(d) * Math.cos(a), Math.sin(d), -Math.cos(d) * Math.sin(a)]);
}

// Table 8.19 of the OpenGL 4.6 specification, row by row, for the direction with x mirrored (docs/scenes.md): a
// constellation is then not.
function faceTexel([x, ry, rz]) {
  const rx = -x;
  const major = [Math.abs(rx), Math.abs(ry), Math.abs(rz)];
  const axis = major.indexOf(Math.max(...major));
  const [name, sc, tc] = [
    rx > 0 ? ['sky-px', -rz, -ry] : ['sky-nx', rz, -ry],
    ry > 0 ? ['sky-py', rx, rz] : ['sky-ny', rx, -rz],
    rz > 0 ? ['sky-pz', rx, -ry] : ['sky-nz', -rx, -ry],
  ][axis];
  const texels = (c) => ((c / major[axis] + 1) / 2) * 1024;
  return { name, x: texels(sc), y: texels(tc) };
}

const catalogue = JSON.parse(
  readFileSync(createRequire(import.meta.url).resolve('d3-celestial/data/stars.6.json'), 'utf8'),
);
const byHipparcos = new Map(catalogue.features.map((star) => [star.id, star]));
const brightStars = {
  Sirius: 32349,
  Canopus: 30438,
  Arcturus: 69673,
  Vega: 91262,
  Capella: 24608,
  Rigel: 24436,
  Procyon: 37279,
  Betelgeuse: 27989,
  Achernar: 7588,
  Altair: 97649,
  Aldebaran: 21421,
  Antares: 80763,
  Spica: 65474,
  Pollux: 37826,
  Fomalhaut: 113368,
  Deneb: 102098,
  Polaris: 11767,
  Regulus: 49669,
};
const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

for (const [starName, id] of Object.entries(brightStars)) {
  test(`${starName} is a brightest spot within 1.5 texels of its catalogue place`, () => {
    const [longitude, dec] = byHipparcos.get(id).geometry.coordinates;
    const { name, x, y } = skyTexel(((longitude + 360) % 360) / 15, dec);
    let near = 0,
      around = 0,
      sumX = 0,
      sumY = 0,
      sum = 0;
    for (let ty = Math.max(0, Math.floor(y) - 6); ty <= Math.min(1023, Math.floor(y) + 6); ++ty) {
      for (let tx = Math.max(0, Math.floor(x) - 6); tx <= Math.min(1023, Math.floor(x) + 6); ++tx) {
        const light = luminance(texel(name, tx, ty)),
          distance = Math.hypot(tx + 0.5 - x, ty + 0.5 - y);
        if (distance <= 1.5) near = Math.max(near, light);
        else around = Math.max(around, light);
        // The centre of light of the core alone: a neighbour star or a face's edge must not pull it.
        if (distance <= 3) {
          const weight = (light / 255) ** 2;
          sumX += weight * (tx + 0.5);
          sumY += weight * (ty + 0.5);
          sum += weight;
        }
      }
    }
    assert.ok(near > 120, `brightness ${near}`);
    assert.ok(near >= around, `${around} nearby against ${near}`);
    assert.ok(
      Math.hypot(sumX / sum - x, sumY / sum - y) <= 1.5,
      `centre at ${sumX / sum}, ${sumY / sum} and not ${x}, ${y}`,
    );
  });
}

test('places known without the catalogue agree: Sirius 6h45.1m -16.72, Vega 18h36.9m +38.78', () => {
  for (const [hours, dec] of [
    [6 + 45.15 / 60, -16.716],
    [18 + 36.94 / 60, 38.784],
  ]) {
    const { name, x, y } = skyTexel(hours, dec);
    assert.ok(luminance(texel(name, Math.floor(x), Math.floor(y))) > 180);
  }
});

test('Orion is not mirrored: seen from inside with north up, Betelgeuse is upper left, Rigel lower right', () => {
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  // The belt: 5h36m, on the equator.
  const toward = [Math.cos((5.6 * Math.PI) / 12), 0, -Math.sin((5.6 * Math.PI) / 12)];
  const right = cross(toward, [0, 1, 0]),
    up = cross(right, toward);
  // Look at every direction of the constellation's frame, and note where the picture has red and blue light of a bright
  // star.
  let red = null,
    blue = null,
    redMost = 0,
    blueMost = 0;
  for (let b = -0.22; b <= 0.22; b += 0.0008) {
    for (let a = -0.13; a <= 0.13; a += 0.0008) {
      const d = [0, 1, 2].map((i) => toward[i] + a * right[i] + b * up[i]);
      const { name, x, y } = faceTexel(d);
      const color = texel(name, Math.min(1023, Math.floor(x)), Math.min(1023, Math.floor(y))),
        light = luminance(color);
      if (color[0] > color[2] + 20 && light > redMost) {
        redMost = light;
        red = d;
      }
      if (color[2] > color[0] && light > blueMost) {
        blueMost = light;
        blue = d;
      }
    }
  }
  assert.ok(dot(red, right) < 0 && dot(red, up) > 0, 'Betelgeuse, the red one, is upper left');
  assert.ok(dot(blue, right) > 0 && dot(blue, up) < 0, 'Rigel, the blue one, is lower right');
});

test('faces of the sky meet: texels on both sides of every edge hold nearly the same light', () => {
  // A step of half a texel to either side of an edge, on all twelve; the bound allows for stars cut by sampling.
  const axes = [
    [1, 0, 0],
    [-1, 0, 0],
    [0, 1, 0],
    [0, -1, 0],
    [0, 0, 1],
    [0, 0, -1],
  ];
  const step = 0.5 / 512;
  for (const a of axes) {
    for (const b of axes) {
      if (Math.abs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) === 1) continue;
      const c = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
      let sum = 0;
      for (let k = 0; k < 1024; ++k) {
        const along = (k + 0.5) / 512 - 1;
        const sides = [
          [1, 1 - step],
          [1 - step, 1],
        ].map(([p, q]) => {
          const { name, x, y } = faceTexel([0, 1, 2].map((i) => p * a[i] + q * b[i] + along * c[i]));
          return luminance(texel(name, Math.min(1023, Math.floor(x)), Math.min(1023, Math.floor(y))));
        });
        sum += Math.abs(sides[0] - sides[1]);
      }
      assert.ok(sum / 1024 < 1, `mean step ${sum / 1024} between ${a} and ${b}`);
    }
  }
});

test('making an asset again, from any folder, gives the same bytes, and the texels that are committed', () => {
  const folder = mkdtempSync(path.join(os.tmpdir(), 'assets-'));
  try {
    const make = (out) => {
      execFileSync(process.execPath, [path.join(root, 'scripts', 'make-assets'), '--out', out, 'grid', 'sun'], {
        cwd: os.tmpdir(),
      });
      return ['grid', 'sun'].map((name) => readFileSync(file(name, out)));
    };
    const once = make(path.join(folder, 'once')),
      again = make(path.join(folder, 'again'));
    ['grid', 'sun'].forEach((name, i) => {
      assert.ok(once[i].equals(again[i]), `${name} twice`);
      // Another version of zlib may pack the same texels otherwise: the committed file is held to its texels.
      assert.ok(PNG.sync.read(once[i]).data.equals(picture(name).data), `${name} as committed`);
    });
  } finally {
    rmSync(folder, { recursive: true });
  }
});
