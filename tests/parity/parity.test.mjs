// One frame from every host: OSMesa, EGL, GLX, Chromium and Firefox show the same picture.
//
// Bounds    pictures: at least `share` of the pixels within 2/255 of OSMesa's in every channel. Objects: the same one
//           at every pixel that is not on an edge between two, and there at most 0.1 % of all pixels. Light fraction:
//           the same at 99.9 % of the pixels that show the same object away from an edge; a soft one within `apart`.
// The rest  mirror images may flip where a ray grazes an edge: SwiftShader and llvmpipe round the last bit otherwise.
//           Shapes and shadows may not.
// Needs     a display (run under xvfb-run). Difference pictures of what fails lie in build/parity/.
import { after, before, test } from 'node:test';
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { join } from 'node:path';
import { fileFrom, openStill } from '../web/picture_file.mjs';
import { serve } from '../web/server.mjs';
import { sharedBrowser } from '../web/shared_browser.mjs';
import { agreement, onAnEdge, readPfm, readPng, writeDifference } from './picture.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const out = join(root, 'build/parity');
const gnomon = process.env.GNOMON_BINARY ?? join(root, 'build/native/gnomon');
mkdirSync(out, { recursive: true });

const scenes = [
  { name: 'lite', depth: 8, size: '240x180', share: 0.999 },
  { name: 'torus', depth: 8, size: '240x180', share: 0.999 },
  { name: 'pro', depth: 8, size: '240x180', share: 0.995 },
  // Soft shadows and marched solids add up roundings over many steps: a light fraction may be a little apart.
  { name: 'complex', depth: 2, size: '160x120', share: 0.99, shadows: 'silhouette', apart: 0.02 },
  { name: 'solids', depth: 2, size: '160x120', share: 0.98, shadows: 'cone-linear', apart: 0.02 },
];
const natives = ['osmesa', 'egl', 'window'];
const hosts = [...natives, 'chromium', 'firefox'];

let server;
before(async () => (server = await serve()));
after(() => server.close());

/** Draws picture, objects and light fractions with one host; a browser loads the page and compiles once for all. */
async function draw(host, { name, size, depth, shadows = 'hard' }) {
  const files = Object.fromEntries(
    ['picture', 'object', 'visibility'].map((what) => {
      const aov = what === 'picture' ? '' : what;
      return [what, { aov, file: join(out, `${name}-${what}-${host}.${aov ? 'pfm' : 'png'}`) }];
    }),
  );
  const set = [`depth=${depth}`, `shadows=${shadows}`];
  if (natives.includes(host)) {
    const settings = [...set, `size=${size}`, `context=${host}`].map((setting) => `--${setting}`);
    for (const { aov, file } of Object.values(files))
      execFileSync(gnomon, ['render', name, '-o', file, ...settings, ...(aov ? [`--aov=${aov}`] : [])]);
  } else {
    const page = await openStill(await sharedBrowser(host), server.url, { scene: name, size, set });
    for (const { aov, file } of Object.values(files)) writeFileSync(file, await fileFrom(page, aov));
    await page.close();
  }
  return {
    picture: readPng(files.picture.file),
    objects: readPfm(files.object.file),
    light: readPfm(files.visibility.file),
  };
}

function showsThePicture(scene, host, { picture: wanted }, { picture: got }) {
  const { share, apart } = agreement(wanted, got, 2);
  const worst = apart.reduce((most, pixel) => Math.max(most, pixel.off), 0);
  console.log(
    `${scene.name} ${host}: ${(100 * share).toFixed(3)} % within 2/255, ` +
      `${apart.length} pixels apart, at most by ${worst}/255`,
  );
  if (share < scene.share) writeDifference(wanted, got, join(out, `${scene.name}-${host}-difference.png`));
  assert.ok(share >= scene.share, `${(100 * share).toFixed(3)} % agree, ${100 * scene.share} % are asked for`);
}

function flipsNothing(scene, host, wanted, got) {
  const { width, height, data: objects } = wanted.objects;
  let flipped = 0,
    inside = 0,
    dark = 0;
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const i = y * width + x;
      const edge = onAnEdge(wanted.objects, x, y);
      if (objects[i] !== got.objects.data[i]) edge ? ++flipped : ++inside;
      else if (!edge && Math.abs(wanted.light.data[i] - got.light.data[i]) > (scene.apart ?? 0)) ++dark;
    }
  console.log(
    `${scene.name} ${host}: ${flipped} edge pixels and ${inside} others show another object, ${dark} another shadow`,
  );
  assert.equal(inside, 0, 'away from edges every pixel shows the same object');
  assert.ok(flipped <= (width * height) / 1000, `${flipped} edge pixels show another object`);
  assert.ok(dark <= (width * height) / 1000, `${dark} pixels are lit otherwise`);
}

for (const scene of scenes)
  test(`${scene.name}: every host shows what OSMesa shows`, { timeout: 600_000 }, async (t) => {
    const wanted = await draw('osmesa', scene);
    for (const host of hosts.slice(1))
      await t.test(host, async (t) => {
        const got = await draw(host, scene);
        await t.test('the same picture', () => showsThePicture(scene, host, wanted, got));
        await t.test('no shape or shadow flips', () => flipsNothing(scene, host, wanted, got));
      });
  });
