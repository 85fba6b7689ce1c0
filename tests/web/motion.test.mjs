// How the page moves in time, in real browsers: it walks as fast with few frames as with many, and what is measured in
// milliseconds. The machine has to be free.
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { browserNames, openPage, until } from './browsers.mjs';
import { eyeOf, goHome, set } from './page_values.mjs';
import { serve } from './server.mjs';
import { sharedBrowser } from './shared_browser.mjs';

const small = 'size=160x120'; // a software renderer traces it

for (const name of browserNames)
  describe(`the page's motion in ${name}`, () => {
    let server, browser, page;

    before(async () => {
      server = await serve();
      browser = await sharedBrowser(name);
      page = await openPage(browser, `${server.url}?${small}`);
    });
    after(async () => {
      await page?.close();
      await server?.close();
    });

    /** How fast the camera goes with the key held, in units a second. */
    const walk = async (key, ms = 500) => {
      await goHome(page);
      await page.evaluate(() => window.gnomon.settled()); // no compiling between the frames
      const drawn = await page.evaluate(() => window.gnomon.frames);
      await until('frames that flow again', () => page.evaluate((from) => window.gnomon.frames > from + 4, drawn));
      const start = performance.now();
      await page.keyboard.down(key);
      await new Promise((resolve) => setTimeout(resolve, ms));
      await page.keyboard.up(key);
      const seconds = (performance.now() - start) / 1000;
      return (await eyeOf(page)).map((value, axis) => (value - [0, 0, 35][axis]) / seconds);
    };

    test('W A S D move along the view', async () => {
      await set(page, 'depth', '1');
      for (const [key, axis, sign] of [
        ['w', 2, -1],
        ['s', 2, 1],
        ['a', 0, -1],
        ['d', 0, 1],
      ]) {
        const way = await walk(key);
        assert.ok(way[axis] * sign > 0.5, `${key}: ${way}`);
        assert.ok(Math.abs(way[2 - axis]) < 1e-3, `${key} goes straight: ${way}`);
      }
    });

    test('Shift halves the speed', async () => {
      const full = -(await walk('w', 900))[2];
      await page.keyboard.down('Shift');
      const half = -(await walk('w', 900))[2];
      await page.keyboard.up('Shift');
      assert.ok(half > 0.25 * full && half < 0.8 * full, `${full} and ${half}`);
    });

    test('without adapting every picture has its full resolution', async () => {
      const own = await openPage(browser, `${server.url}?${small}&adapt=off`);
      const [first, sharp] = await own.evaluate(async () => {
        while (!window.gnomon.sharpFrameMs) await new Promise((resolve) => setTimeout(resolve, 20));
        return [window.gnomon.firstFrameMs, window.gnomon.sharpFrameMs];
      });
      assert.ok(Math.abs(first - sharp) < 500, `first ${first}, sharp ${sharp}`);
      own.verify();
      await own.close();
    });

    test('complained of nothing all along', () => page.verify());
  });
