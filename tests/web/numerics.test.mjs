// What the browsers' GL makes of the intersectors' arithmetic: ray by ray against doubles, and as the page itself
// tells.
//
// Bound  docs/numerics.md: no wrong decision further than 2^-22 of the size from tangency, surface point within
//        4 · 2^-23 of the size, o + t d within 1.5 ulp of t
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { compareHits, grazingRay, packed, randomNumbers, solid, solve, traceRays, uniformRay } from './rays.mjs';
import { browserNames, differences, openPage, picture, until } from './browsers.mjs';
import { serve } from './server.mjs';
import { sharedBrowser } from './shared_browser.mjs';

const far = 10_000;
const still = 'size=160x120&pause=on&time=1';
const solids = {
  sphere: solid({ center: [0.2718281, -0.5772156, 0.6931471], radius: 1 }),
  torus: solid({ center: [-0.3141592, 0.1618033, 0.4142135], axis: [0.6, 0.3, -0.74], major: 1, radius: 0.25 }),
};

const raysAt = (shape, count) => {
  const number = randomNumbers(count);
  return Array.from({ length: count }, (_, i) => (i % 2 ? grazingRay : uniformRay)(shape, far, number));
};

// What takes the rays for others by half an ulp of their far origin, as textbook arithmetic does, must not pass.
test('the comparison sees a textbook re-centring', () => {
  for (const shape of Object.values(solids)) {
    const rays = raysAt(shape, 1000);
    const answers = rays.flatMap(({ origin, direction }) => {
      const moved = origin.map((value, axis) => value + 4.9e-4 * (axis - 1));
      const { hit, t } = solve(shape, { origin: moved, direction });
      const point = origin.map((value, axis) => value + t * direction[axis]);
      return hit ? [0, t, ...point, 0, 0, 0] : [-1, 0, 0, 0, 0, 0, 0, 0];
    });
    const found = compareHits(shape, rays, Float64Array.from(answers));
    assert.ok(found.wrong > 100 && found.worstPoint > 1000, JSON.stringify(found));
  }
});

for (const name of browserNames)
  describe(`numerics in ${name}`, () => {
    let server, browser, page;

    before(async () => {
      server = await serve();
      browser = await sharedBrowser(name);
      page = await openPage(browser, `${server.url}?scene=pro&${still}`);
    });
    after(async () => {
      await page?.close();
      await server?.close();
    });

    const rejected = (scene, rays) =>
      page.evaluate(
        (...asked) =>
          window.gnomon.traceRays(...asked).then(
            () => '',
            (error) => error.message,
          ),
        scene,
        rays,
      );

    test('the read-out says that the numerics are exact, by itself, and the picture stays', async () => {
      const shown = await picture(page);
      const ask = () => page.$eval('#numerics', ({ textContent, title }) => textContent && { textContent, title });
      const told = await until('the numerics', ask);
      console.log(`# ${name}: ${told.title}`);
      assert.equal(told.textContent, ' · numerics exact');
      assert.match(told.title, /^numerics exact: 0 of 2048 decisions wrong, surface point within \d\.\d · 2\^-23/);
      assert.equal(differences(shown, await picture(page)), 0);
      const drawn = await page.evaluate(() => window.gnomon.frames);
      await until('frames that flow on', () => page.evaluate((from) => window.gnomon.frames > from + 4, drawn));
      page.verify();
    });

    test('the help has the figures, for those without a pointer', async () => {
      await page.keyboard.press('h');
      await page.waitForSelector('#help[open]');
      const footer = await page.$eval('#help footer', (element) => element.textContent);
      assert.match(footer, /Drawn by .+; numerics exact: 0 of 2048/);
      await page.keyboard.press('Escape');
    });

    test('numerics() answers what was measured, once a page', async () => {
      const ask = () => page.evaluate(() => window.gnomon.numerics());
      const first = await ask();
      console.log(`# ${name}: measured in ${Math.round(first.milliseconds)} ms`);
      assert.deepEqual(await ask(), first);
      assert.equal(first.measured && first.holds, true, first.summary);
      assert.deepEqual([first.rays, first.wrong], [2048, 0]);
      assert.ok(first.worstPoint > 0 && first.worstPoint <= 4 && first.worstAlong > 0 && first.worstAlong <= 1.5);
    });

    for (const [kind, shape] of Object.entries(solids))
      test(`rays at a ${kind} ${far} units away decide like doubles`, async () => {
        const rays = raysAt(shape, 4000);
        const found = compareHits(shape, rays, await traceRays(page, shape.scene, packed(rays)));
        console.log(`# ${name} ${kind}:`, JSON.stringify(found));
        assert.ok(found.compared > 0.99 * rays.length, 'rays that are not too near to tangency');
        assert.equal(found.wrong, 0);
        assert.ok(found.worstPoint <= 4 && found.worstAlong <= 1.5);
        page.verify();
      });

    test('a large batch comes back complete and in order', async () => {
      const shown = await picture(page);
      const rays = packed(raysAt(solids.sphere, 20_000));
      const start = performance.now();
      const answers = await traceRays(page, solids.sphere.scene, rays);
      console.log(`# ${name}: 20 000 rays there and back in ${Math.round(performance.now() - start)} ms`);
      assert.equal(answers.length, rays.length);
      const last = await traceRays(page, solids.sphere.scene, rays.slice(-8 * 100));
      assert.deepEqual(answers.slice(-8 * 100), last);
      assert.equal(differences(shown, await picture(page)), 0, 'the picture stays as it is');
    });

    test('a ray carries side and tMin, an answer object, t, point and normal', async () => {
      const ball = (z) => ({ sphere: { center: [0, 0, z], radius: 1 } });
      const scene = { objects: [ball(0), ball(-9)] };
      const down = [0, 0, -1];
      const rays = Float32Array.of(
        ...[0, 0, 5, 0, ...down, 0], // from above onto the first
        ...[0, 0, 5, 0, ...down, 6.5], // all of the first lies nearer than tMin
        ...[0, 0, 1, -1, ...down, 0], // from its top through it
        ...[0, 0, 1, 1, ...down, 0], // leaves it outside: the second only
        ...[0, 3, 5, 0, ...down, 0], // passes by
      );
      const answers = await traceRays(page, scene, rays);
      const answer = (i) => [...answers.slice(8 * i, 8 * i + 8)];
      assert.deepEqual(answer(0), [0, 4, 0, 0, 1, 0, 0, 1]);
      assert.deepEqual(answer(1), [1, 13, 0, 0, -8, 0, 0, 1]);
      assert.deepEqual(answer(2), [0, 2, 0, 0, -1, 0, 0, -1]);
      assert.deepEqual(answer(3), [1, 9, 0, 0, -8, 0, 0, 1]);
      assert.equal(answer(4)[0], -1);
    });

    test('what traceRays cannot do it says', async () => {
      const inverted = { objects: [{ sphere: { center: [0, 0, 0], radius: -1 } }] };
      assert.match(await rejected(inverted, []), /traceRays:1: objects\[0\].*radius/);
      assert.match(await rejected('{', []), /traceRays:1/);
      assert.match(await rejected('{"objects": []}', [1, 2, 3]), /3 numbers are no rays/);
    });

    test('nothing is measured while the view moves', async () => {
      const own = await openPage(browser, `${server.url}?size=160x120&depth=1`);
      try {
        const told = () => own.$eval('#numerics', (element) => element.textContent);
        await own.keyboard.down('w');
        await new Promise((resolve) => setTimeout(resolve, 4000)); // at rest two seconds would do
        assert.equal(await told(), '');
        await own.keyboard.up('w');
        await until('the numerics', async () => (await told()) === ' · numerics exact');
        own.verify();
      } finally {
        await own.close();
        await page.bringToFront(); // only the page in front gets frames
      }
    });

    test('without float32 pictures both say so, and the page lives', async () => {
      const without = (own) =>
        own.evaluateOnNewDocument(() => {
          const get = WebGL2RenderingContext.prototype.getExtension;
          WebGL2RenderingContext.prototype.getExtension = function (extension) {
            return /float/.test(extension) ? null : get.call(this, extension);
          };
        });
      const own = await openPage(browser, `${server.url}?${still}`, { before: without });
      try {
        const { numerics, refused } = await own.evaluate(
          async (scene) => ({
            numerics: await window.gnomon.numerics(),
            refused: await window.gnomon.traceRays(scene, []).catch((error) => error.message),
          }),
          solids.sphere.scene,
        );
        assert.deepEqual([numerics.measured, numerics.holds], [false, false]);
        for (const text of [numerics.summary, refused]) assert.match(text, /cannot draw float32 pictures/);
        assert.equal(await own.$eval('#numerics', (element) => element.textContent), ' · numerics not measured');
        assert.ok(new Set((await picture(own)).data).size > 50);
        own.verify();
      } finally {
        await own.close();
        await page.bringToFront();
      }
    });

    test('complained of nothing all along', () => page.verify());
  });
