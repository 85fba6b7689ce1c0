// The Cornell box by its measured geometry and nearly its colours, in units of 100 mm: five walls, two blocks, and a
// ball of light under the ceiling for its lamp. Light that walls give each other is ambient here.
//
// Source  https://www.graphics.cornell.edu/online/box/data.html
import { matte } from './materials.mjs';

const wall = (a, b, c, d, material) => [
  { triangle: { vertices: [a, b, c] }, material },
  { triangle: { vertices: [a, c, d] }, material },
];

/** A block upright on the floor, from the corners of its base. */
function block(corners, height) {
  const center = [0, 1].map((i) => corners.reduce((sum, corner) => sum + corner[i], 0) / 4);
  const [along, beside] = [1, 3].map((i) => [0, 1].map((k) => corners[i][k] - corners[0][k]));
  return {
    box: {
      center: [center[0], height / 2, center[1]],
      half_size: [Math.hypot(...along) / 2, height / 2, Math.hypot(...beside) / 2],
      rotate: [0, (Math.atan2(-along[1], along[0]) * 180) / Math.PI, 0],
    },
    material: 'white',
  };
}

export function cornell() {
  const [x, y, z] = [5.528, 5.488, 5.592];
  return {
    scene: {
      title: 'Cornell box',
      description: 'Two white blocks between a red and a green wall, under a ball of light.',
      camera: { eye: [2.78, 2.73, -8], target: [2.78, 2.73, 0], fov: 39.3 },
      background: { color: 0 },
      lights: [
        { sphere: { center: [2.78, 5.05, 2.795], radius: 0.55 }, color: [1, 0.86, 0.66] },
        { point: { position: [2.78, 4.4, -4] }, color: [0.16, 0.15, 0.14] }, // for the light of the walls
      ],
      materials: {
        white: matte([0.75, 0.74, 0.7], 0.22),
        red: matte([0.63, 0.06, 0.05], 0.22),
        green: matte([0.14, 0.45, 0.09], 0.22),
        lamp: { emission: [1, 0.95, 0.8] },
      },
      objects: [
        ...wall([0, 0, 0], [0, 0, z], [x, 0, z], [x, 0, 0], 'white'),
        ...wall([0, y, 0], [x, y, 0], [x, y, z], [0, y, z], 'white'),
        ...wall([0, 0, z], [0, y, z], [x, y, z], [x, 0, z], 'white'),
        ...wall([0, 0, 0], [0, y, 0], [0, y, z], [0, 0, z], 'green'),
        ...wall([x, 0, 0], [x, 0, z], [x, y, z], [x, y, 0], 'red'),
        block([[1.3, 0.65], [0.82, 2.25], [2.4, 2.72], [2.9, 1.14]], 1.65), // prettier-ignore
        block([[4.23, 2.47], [2.65, 2.96], [3.14, 4.56], [4.72, 4.06]], 3.3), // prettier-ignore
        {
          box: { center: [2.78, 5.47, 2.795], half_size: [0.65, 0.015, 0.525] },
          material: 'lamp',
          casts_shadow: false,
        },
      ],
    },
  };
}
