// A picture drawn by shader variants, with cached loads where Chromium's GL gains by them, is in every byte the picture
// of the one full program without them: pixels that a variant discards are drawn by its fallback
// (shaders/pass/canvas.vert). Sizes that no tile divides, times at which uncommon features lie elsewhere; and on the
// page itself, where a slow picture is refined band by band.
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { readFile } from 'node:fs/promises';
import { PNG } from 'pngjs';
import { browserNames, differences, launch, openPage, picture, until } from './browsers.mjs';
import { serve } from './server.mjs';

const still = 'pause=on&depth=8';
// Where a file is not the library's own, though its text is the same, there is one program, and it caches no loads.
const encode = await readFile(new URL('../../shaders/shade/encode.glsl', import.meta.url), 'utf8');
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
          const query = `scene=${scene}&size=${size}&time=${time}&${still}&adapt=off&parts=${parts}`;
          const page = await openPage(browser, `${server.url}?${query}`);
          const { sourceBytes } = await page.evaluate(() => window.gnomon.stats());
          const seen = await picture(page);
          const cachesLoads = () => page.evaluate(() => window.gnomon.source().includes('void cacheLoads('));
          assert.equal(await cachesLoads(), name === 'chromium');
          await page.evaluate((text) => window.gnomon.shaders({ 'shade/encode.glsl': text }), encode);
          assert.equal(await cachesLoads(), false);
          const plain = await picture(page);
          page.verify();
          await page.close();
          return { seen, sourceBytes, plain };
        };
        const full = await shown('off'), variants = await shown('on');
        assert.equal(differences(variants.plain, variants.seen), 0);
        const bytes = `${variants.sourceBytes} bytes beside ${full.sourceBytes}`;
        assert.ok(variants.sourceBytes > full.sourceBytes + 10_000, `there was no base variant: ${bytes}`);
        assert.ok(new Set(full.seen.data).size > 50, 'the picture has many values');
        assert.equal(differences(variants.seen, full.seen), 0);
      });

    test('pro as the page refines it', async () => {
      const viewport = { width: 641, height: 479 };
      const url = `${server.url}?scene=pro&size=641x479&${still}`;
      const full = await openPage(browser, `${url}&time=3&adapt=off&parts=off`, { viewport });
      const wanted = await picture(full);
      const page = await openPage(browser, `${url}&time=0`, { viewport });
      await page.evaluate(() => { // all but the canvas
        for (const one of document.querySelectorAll('body *'))
          if (one.tagName !== 'CANVAS' && !one.querySelector('canvas')) one.style.display = 'none';
      });
      await page.evaluate(() => window.gnomon.set('time', 3)); // all programs are ready: it is drawn by them anew
      const shown = async () => PNG.sync.read(Buffer.from(await page.screenshot()));
      await until('the picture of the full program', async () => differences(await shown(), wanted) === 0);
      for (const each of [page, full]) {
        each.verify();
        await each.close();
      }
    });
  });
