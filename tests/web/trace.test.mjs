// The page against the source document's way of tracing (tests/textbook/source), in the same browser and run; and
// shader files of a script's own.
//
// Bound  pro and lite show nearly the source's picture (its sky is sampled otherwise): at least 98 % of the pixels
//        within 24/255. A frame of pro takes at most half of the source's, lite at most 1/1.1: what a busy machine
//        leaves of the figures in docs/results.md
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { median, openPair, timeInTurns } from './against_source.mjs';
import { browserNames, openPage, picture } from './browsers.mjs';
import { serve } from './server.mjs';
import { sharedBrowser } from './shared_browser.mjs';

const still = 'pause=on&time=0&depth=8&adapt=off';
const compared = { lite: { size: '200x150', least: 1.1 }, pro: { size: '160x120', least: 2 } };

const apart = (a, b) => a.data.reduce((most, value, i) => Math.max(most, Math.abs(value - b.data[i])), 0);

function shareWithin(a, b, bound) {
  let good = 0;
  for (let i = 0; i < a.data.length; i += 4)
    good += [0, 1, 2].every((channel) => Math.abs(a.data[i + channel] - b.data[i + channel]) <= bound);
  return good / (a.width * a.height);
}

for (const name of browserNames)
  describe(`against the source in ${name}`, () => {
    let server, browser;

    before(async () => {
      server = await serve();
      browser = await sharedBrowser(name);
    });
    after(async () => {
      await server?.close();
    });

    for (const [scene, { size, least }] of Object.entries(compared))
      test(`${scene} is the source's picture, at least ${least} times as fast`, async () => {
        const { ours, source } = await openPair(browser, server.url, { scene, size });
        const share = shareWithin(await picture(ours), await picture(source), 24);
        const { ratios } = await timeInTurns({ ours, source }, 3);
        const all = ratios.map((ratio) => ratio.toFixed(2)).join(' ');
        const text = `${(100 * share).toFixed(2)} % alike; ${median(ratios).toFixed(2)} times as fast (${all})`;
        console.log(`# ${name} ${scene}: ${text}`);
        assert.ok(share >= 0.98, text);
        assert.ok(median(ratios) >= least, text);
        for (const page of [ours, source]) {
          page.verify();
          await page.close();
        }
      });

    test("a script's own shader files draw, wrong ones are told, and the library's come back", async () => {
      const page = await openPage(browser, `${server.url}?scene=torus&size=160x120&${still}`, {
        expectErrors: [/shade\/encode\.glsl/],
      });
      const replace = (files) =>
        page.evaluate(
          (texts) =>
            window.gnomon.shaders(texts).then(
              () => '',
              (error) => error.message,
            ),
          files,
        );
      const library = await picture(page);
      const red =
        'vec3 chooseChannels(vec3 color) { return vec3(1.0, 0.0, 0.0); }\nvec3 encode(vec3 color) { return color; }\n';
      assert.equal(await replace({ 'shade/encode.glsl': red }), '');
      const drawn = await picture(page);
      assert.deepEqual([...drawn.data.subarray(0, 4)], [255, 0, 0, 255]);
      assert.match(
        await replace({ 'shade/encode.glsl': `${red}float broken = nothing;\n` }),
        /shaders\/shade\/encode\.glsl/,
      );
      assert.equal(apart(await picture(page).catch(() => drawn), drawn), 0, 'what drew before goes on');
      assert.match(
        await replace({ 'shade/none.glsl': '' }),
        /shaders\/shade\/none\.glsl: there is no such shader file/,
      );
      assert.equal(await replace({}), '');
      assert.equal(apart(await picture(page), library), 0);
    });
  });
