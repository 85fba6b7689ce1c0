// A picture of base and full shader variants is in every byte the picture of the full variant alone: what the base
// variant discards is drawn behind it (shaders/pass/canvas.vert). Sizes that no tile divides, times at which uncommon
// features lie elsewhere; and on the page itself, where a slow picture is refined band by band.
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { readFile } from 'node:fs/promises';
import { PNG } from 'pngjs';
import { browserNames, differences, openPage, picture, until } from './browsers.mjs';
import { serve } from './server.mjs';
import { sharedBrowser } from './shared_browser.mjs';

const still = 'pause=on&depth=8';
// Where a file is not the library's own, though its text be the same, there is one program.
const encode = await readFile(new URL('../../shaders/shade/encode.glsl', import.meta.url), 'utf8');
const cases = [
  { scene: 'pro', size: '163x121', time: 0 },
  { scene: 'pro', size: '90x67', time: 7.3 },
  { scene: 'lite', size: '161x122', time: 2.5 },
  { scene: 'shapes', size: '121x91', time: 1 },
];

for (const name of browserNames)
  describe(`shader variants in ${name}`, () => {
    let server, browser;

    before(async () => {
      server = await serve();
      browser = await sharedBrowser(name);
    });
    after(async () => {
      await server?.close();
    });

    for (const { scene, size, time } of cases)
      test(`${scene} at ${size}`, async () => {
        const shown = async (variants) => {
          const page = await openPage(
            browser,
            `${server.url}?scene=${scene}&size=${size}&time=${time}&${still}&adapt=off&parts=${variants}`,
          );
          const { sourceBytes } = await page.evaluate(() => window.gnomon.stats());
          const seen = await picture(page);
          await page.evaluate((text) => window.gnomon.shaders({ 'shade/encode.glsl': text }), encode);
          const plain = await picture(page);
          page.verify();
          await page.close();
          return { seen, sourceBytes, plain };
        };
        const full = await shown('off'),
          both = await shown('on');
        assert.equal(differences(both.plain, both.seen), 0);
        assert.ok(
          both.sourceBytes > full.sourceBytes + 10_000,
          `there was no base variant: ${both.sourceBytes} bytes beside ${full.sourceBytes}`,
        );
        assert.ok(new Set(full.seen.data).size > 50, 'the picture shows nothing');
        assert.equal(differences(both.seen, full.seen), 0);
      });

    test('pro as the page refines it', async () => {
      const viewport = { width: 641, height: 479 };
      const url = `${server.url}?scene=pro&size=641x479&${still}`;
      const full = await openPage(browser, `${url}&time=3&adapt=off&parts=off`, { viewport });
      const wanted = await picture(full);
      const page = await openPage(browser, `${url}&time=0`, { viewport });
      await page.evaluate(() => {
        // all but the canvas
        for (const one of document.querySelectorAll('body *'))
          if (one.tagName !== 'CANVAS' && !one.querySelector('canvas')) one.style.display = 'none';
      });
      await page.evaluate(() => window.gnomon.set('time', 3)); // all programs are ready: it is drawn by them anew
      const shown = async () => PNG.sync.read(Buffer.from(await page.screenshot()));
      await until('the picture of the full variant', async () => differences(await shown(), wanted) === 0);
      for (const each of [page, full]) {
        each.verify();
        await each.close();
      }
    });
  });
