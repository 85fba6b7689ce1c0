// Scenes after the Standard Procedural Databases.
//
// Source  E. Haines, A Proposal for Standard Graphics Environments, IEEE CG&A 7(11), 1987: balls, rings, lattice (then
//         "jacks" and later), mount. Built here from groups and instances; sizes, colours and views are ours
import { randomStream } from '../assets/noise.mjs';
import { glass, glossy, matte, metal } from './materials.mjs';
import { add, direction, rotationTo, scale, size, sub } from './vectors.mjs';

/** The sphereflake: each ball has nine a third as large around it, six about its waist and three on its crown. */
export function balls() {
  const around = [0, 60, 120, 180, 240, 300].map((angle) => direction(90, angle));
  const crown = [30, 150, 270].map((angle) => direction(30, angle));
  const definitions = { flake0: { sphere: { center: [0, 0, 0], radius: 1 } } };
  for (let level = 1; level <= 4; ++level) {
    const children = [...around, ...crown].map((way) => ({
      instance: { of: `flake${level - 1}`, scale: 1 / 3, rotate: rotationTo(way), translate: scale(4 / 3, way) },
    }));
    definitions[`flake${level}`] = { group: { of: [{ instance: { of: 'flake0' } }, ...children] } };
  }
  return {
    scene: {
      title: 'Balls: a sphereflake of 7381 spheres',
      description:
        'The sphereflake of the Standard Procedural Databases: a ball with nine a third as large on it, and so on, ' +
        'four times.',
      camera: { eye: [3.1, 3.3, 3.4], target: [0, 0.05, 0], fov: 38 },
      background: { color: [0.078, 0.161, 0.325] },
      lights: [
        { point: { position: [6, 8, 2] }, color: [1, 0.95, 0.88] },
        { point: { position: [-4, 5, 6] }, color: [0.32, 0.38, 0.5] },
      ],
      materials: {
        ball: { ...metal([0.3, 0.28, 0.24]), ...matte([0.7, 0.42, 0.12]) },
        floor: matte([0.5, 0.5, 0.52]),
      },
      definitions,
      objects: [
        { plane: { point: [0, -1.55, 0], normal: [0, 1, 0] }, material: 'floor' },
        { instance: { of: 'flake4' }, material: 'ball' },
      ],
    },
  };
}

/** A pyramid of dodecahedra made of rods and joints. */
export function rings() {
  const golden = (1 + Math.sqrt(5)) / 2;
  const corners = [];
  for (const a of [-1, 1])
    for (const b of [-1, 1]) {
      for (const c of [-1, 1]) corners.push([a, b, c]);
      for (let turn = 0; turn < 3; ++turn) {
        const corner = [0, a / golden, b * golden];
        corners.push([0, 1, 2].map((i) => corner[(i + turn) % 3]));
      }
    }
  const edge = 2 / golden;
  const rods = [];
  corners.forEach((from, i) =>
    corners.slice(i + 1).forEach((to) => {
      if (Math.abs(size(sub(to, from)) - edge) < 1e-9) rods.push({ cylinder: { from, to, radius: 0.085 } });
    }),
  );
  const joints = corners.map((center) => ({ sphere: { center, radius: 0.17 } }));
  const cages = [];
  const levels = 5;
  for (let level = 0; level < levels; ++level)
    for (let x = 0; x <= level; ++x)
      for (let z = 0; z <= level; ++z)
        cages.push({
          instance: {
            of: 'cage',
            scale: 0.62,
            rotate: [0, 31.72 * ((x + z + level) % 3), 0],
            translate: [2.3 * (x - level / 2), 2.15 * (levels - 1 - level), 2.3 * (z - level / 2)],
          },
          material: ['red', 'blue', 'yellow'][(x + 2 * z + level) % 3],
        });
  return {
    scene: {
      title: 'Rings: a pyramid of cages',
      description:
        `${cages.length} dodecahedra of 30 rods and 20 joints each, after the rings of the Standard Procedural ` +
        'Databases.',
      camera: { eye: [11.5, 10.5, 15], target: [0, 3.4, 0], fov: 40 },
      background: { color: [0.5, 0.62, 0.75] },
      lights: [
        { point: { position: [14, 22, 9] }, color: [0.95, 0.9, 0.82] },
        { point: { position: [-15, 12, 12] }, color: [0.22, 0.26, 0.34] },
      ],
      materials: {
        floor: matte([0.42, 0.44, 0.47]),
        red: glossy([0.62, 0.2, 0.1]),
        blue: glossy([0.12, 0.3, 0.55]),
        yellow: glossy([0.7, 0.5, 0.1]),
      },
      definitions: { cage: { group: { of: [...rods, ...joints] } } },
      objects: [{ plane: { point: [0, -1.17, 0], normal: [0, 1, 0] }, material: 'floor' }, ...cages],
    },
  };
}

/** A cubic lattice of joints and rods, seen from within its edge. */
export function lattice() {
  const count = 7;
  const cell = {
    group: {
      of: [
        { sphere: { center: [0, 0, 0], radius: 0.2 }, material: 'joint' },
        { cylinder: { from: [0.15, 0, 0], to: [0.85, 0, 0], radius: 0.07 }, material: 'rod' },
        { cylinder: { from: [0, 0.15, 0], to: [0, 0.85, 0], radius: 0.07 }, material: 'rod' },
        { cylinder: { from: [0, 0, 0.15], to: [0, 0, 0.85], radius: 0.07 }, material: 'rod' },
      ],
    },
  };
  const row = (of, axis) => ({
    group: {
      of: Array.from({ length: count }, (_, i) => ({
        instance: { of, translate: [0, 1, 2].map((k) => (k === axis ? i : 0)) },
      })),
    },
  });
  return {
    scene: {
      title: 'Lattice: 343 joints and 1029 rods',
      description: 'A cube of cubes after the lattice of the Standard Procedural Databases: red joints, blue rods.',
      camera: { eye: [12.5, 10.5, 14.5], target: [3.3, 3.1, 3.3], fov: 36 },
      background: { color: [0.06, 0.08, 0.12] },
      lights: [
        { point: { position: [12, 15, 9] }, color: [1, 0.96, 0.9] },
        { point: { position: [-6, 8, 14] }, color: [0.35, 0.4, 0.55] },
      ],
      materials: { joint: glossy([0.75, 0.16, 0.07]), rod: glossy([0.16, 0.34, 0.6]) },
      definitions: { cell, row: row('cell', 0), sheet: row('row', 1), cube: row('sheet', 2) },
      objects: [{ instance: { of: 'cube' } }],
    },
  };
}

/** Heights of a square of 2^steps cells, each step's middles off their neighbours' mean by half as much. */
function fractalHeights(steps, random) {
  const n = 2 ** steps;
  const heights = Array.from({ length: n + 1 }, () => new Float64Array(n + 1));
  heights[n / 2][n / 2] = 1.5; // the peak; corners stay at 0
  for (let cell = n, rough = 0.9; cell > 1; cell /= 2, rough *= 0.5) {
    const half = cell / 2;
    const offset = () => rough * (random() - 0.5);
    for (let y = half; y < n; y += cell)
      for (let x = half; x < n; x += cell) {
        if (x === n / 2 && y === n / 2) continue;
        const sum = heights[y - half][x - half] + heights[y - half][x + half] + heights[y + half][x - half];
        heights[y][x] = (sum + heights[y + half][x + half]) / 4 + offset();
      }
    for (let y = 0; y <= n; y += half)
      for (let x = y % cell === 0 ? half : 0; x <= n; x += cell) {
        const near = [[y - half, x], [y + half, x], [y, x - half], [y, x + half]]; // prettier-ignore
        const inside = near.filter(([v, u]) => v >= 0 && v <= n && u >= 0 && u <= n);
        heights[y][x] = inside.reduce((sum, [v, u]) => sum + heights[v][u], 0) / inside.length + offset();
      }
  }
  // The mountain ends below the water.
  for (let y = 0; y <= n; ++y)
    for (let x = 0; x <= n; ++x) {
      const inside = Math.min(1, 1.5 * (1 - Math.max(Math.abs(2 * x - n), Math.abs(2 * y - n)) / n) + 0.02);
      heights[y][x] = (heights[y][x] + 0.35) * inside - 0.35;
    }
  return heights;
}

/** A fractal mountain, a mesh, and four balls of glass above it. */
export function mount() {
  const steps = 5;
  const n = 2 ** steps;
  const heights = fractalHeights(steps, randomStream(23));
  const lines = ['# A fractal mountain: scripts/make-scenes mount'];
  for (let y = 0; y <= n; ++y)
    for (let x = 0; x <= n; ++x)
      lines.push(`v ${[(4 * x) / n - 2, heights[y][x], (4 * y) / n - 2].map((c) => Number(c.toFixed(4))).join(' ')}`);
  const at = (x, y) => y * (n + 1) + x + 1;
  for (let y = 0; y < n; ++y)
    for (let x = 0; x < n; ++x) {
      lines.push(`f ${at(x, y)} ${at(x, y + 1)} ${at(x + 1, y + 1)}`);
      lines.push(`f ${at(x, y)} ${at(x + 1, y + 1)} ${at(x + 1, y)}`);
    }
  const balls = [45, 135, 225, 315].map((angle) => ({
    sphere: { center: add([0, 1.35, 0], scale(1.35, direction(90, angle))), radius: 0.42 },
    material: 'glass',
    casts_shadow: false,
  }));
  return {
    files: { 'mount.obj': `${lines.join('\n')}\n` },
    scene: {
      title: 'Mount: a fractal mountain and four balls of glass',
      description: `A mesh of ${2 * n * n} triangles after the mount of the Standard Procedural Databases.`,
      camera: { eye: [-2.6, 2.9, -5.4], target: [0, 0.55, 0], fov: 38 },
      background: { color: [0.42, 0.6, 0.85] },
      lights: [
        { point: { position: [-9, 9, -3] }, color: [1, 0.94, 0.84] },
        { point: { position: [8, 6, -8] }, color: [0.2, 0.26, 0.36] },
      ],
      materials: { rock: matte([0.55, 0.48, 0.38]), glass, water: glossy([0.05, 0.16, 0.22], 1.33) },
      objects: [
        { mesh: { file: 'mount.obj', smooth: false }, material: 'rock' },
        { plane: { point: [0, -0.1, 0], normal: [0, 1, 0] }, material: 'water' },
        ...balls,
      ],
    },
  };
}
