// A picture in parts is the picture of the whole program, in every byte: what a browser's GL leaves out is drawn behind
// (shaders/pass/canvas.vert). Sizes that no tile divides, times at which what is rare lies elsewhere, a canvas smaller than
// what is rare in it.
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { browserNames, differences, launch, openPage, picture } from './browsers.mjs';
import { serve } from './server.mjs';

const cases = [
  { scene: 'pro', size: '163x121', time: 0 },
  { scene: 'pro', size: '90x67', time: 7.3 },
  { scene: 'lite', size: '161x122', time: 2.5 },
  { scene: 'shapes', size: '121x91', time: 1 },
];

for (const name of browserNames)
  describe(name, () => {
    let server, browser;

    before(async () => {
      server = await serve();
      browser = await launch(name);
    });
    after(async () => {
      await browser?.close();
      await server?.close();
    });

    for (const { scene, size, time } of cases)
      test(`${scene} at ${size}`, async () => {
        const shown = async (parts) => {
          const page = await openPage(browser, `${server.url}?scene=${scene}&size=${size}&time=${time}&pause=on&depth=8&adapt=off&parts=${parts}`);
          const { sourceBytes } = await page.evaluate(() => window.gnomon.stats());
          const seen = await picture(page);
          page.verify();
          await page.close();
          return { seen, sourceBytes };
        };
        const whole = await shown('off'), parts = await shown('on');
        assert.ok(parts.sourceBytes > whole.sourceBytes + 10_000, `there was no usual program: ${parts.sourceBytes} bytes beside ${whole.sourceBytes}`);
        assert.ok(new Set(whole.seen.data).size > 50, 'the picture shows nothing');
        assert.equal(differences(parts.seen, whole.seen), 0);
      });
  });
