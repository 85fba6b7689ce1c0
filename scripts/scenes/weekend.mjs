// The cover of Ray Tracing in One Weekend, after its last chapter: many small balls about three large ones, matte,
// metal and glass. The book's light comes from the sky all around; here from a sun, and in the shade from everywhere
// alike.
//
// Source  P. Shirley, T. D. Black, S. Hollasch, Ray Tracing in One Weekend, "Where Next?"
import { randomStream } from '../assets/noise.mjs';
import { glass, matte, metal } from './materials.mjs';
import { size, sub } from './vectors.mjs';

export function weekend() {
  const random = randomStream(7);
  const materials = {
    ground: matte([0.5, 0.5, 0.5]),
    glass,
    brown: matte([0.4, 0.2, 0.1]),
    mirror: metal([0.7, 0.6, 0.5]),
  };
  for (let i = 0; i < 60; ++i) materials[`matte${i}`] = matte([0, 1, 2].map(() => random() * random()));
  for (let i = 0; i < 20; ++i) materials[`metal${i}`] = metal([0, 1, 2].map(() => 0.4 + 0.4 * random()));
  const objects = [
    { sphere: { center: [0, -1000, 0], radius: 1000 }, material: 'ground' },
    { sphere: { center: [0, 1, 0], radius: 1 }, material: 'glass', casts_shadow: false },
    { sphere: { center: [-4, 1, 0], radius: 1 }, material: 'brown' },
    { sphere: { center: [4, 1, 0], radius: 1 }, material: 'mirror' },
  ];
  for (let a = -11; a < 11; ++a)
    for (let b = -11; b < 11; ++b) {
      const center = [a + 0.9 * random(), 0.2, b + 0.9 * random()];
      const choice = random();
      const pick = random();
      if ([0, -4, 4].some((x) => size(sub(center, [x, 0.2, 0])) < 1.15)) continue;
      const name = choice < 0.8 ? `matte${Math.floor(60 * pick)}` : `metal${Math.floor(20 * pick)}`;
      const clear = choice >= 0.95;
      objects.push({
        sphere: { center, radius: 0.2 },
        material: clear ? 'glass' : name,
        ...(clear ? { casts_shadow: false } : {}),
      });
    }
  return {
    scene: {
      title: 'Weekend: the cover of Ray Tracing in One Weekend',
      description: 'Hundreds of small balls about three large ones: matte, metal and glass.',
      camera: { eye: [13, 2, 3], target: [0, 0, 0], fov: 20 },
      background: { color: [0.62, 0.77, 1] },
      lights: [{ point: { position: [300, 700, 400] }, color: [0.95, 0.92, 0.85] }],
      materials,
      objects,
    },
  };
}
