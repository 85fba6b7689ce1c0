// A context that the browser takes and gives back again and again: the page draws the same picture after each loss, and
// no GL object outlives the context that it was made in.
//
// Scope  50 losses of one page, counted from one loss to the next: the first picture of all may have had more objects,
//        such as the programs that drew before its images came.
// Bound  the fewest and the most objects after a loss are at most two apart: the fences of a program's first draw and
//        of a frame may or may not have passed. What each loss left behind would add up to 50 and more.
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { browserNames, differences, openPage, picture } from './browsers.mjs';
import { serve } from './server.mjs';
import { sharedBrowser } from './shared_browser.mjs';

const losses = 50;
const fences = 2;
// Each restored context compiles everything anew: the cheapest picture proves as much as any other.
const cheapest = 'scene=torus&size=64x48&depth=1&shadows=off&parts=off&pause=on&time=1';

/**
 * Runs in the page: loses and restores the context; answers for each time how many objects were alive once the picture
 * stood again, and how many of its bytes differed.
 */
async function loseAndRestore(times) {
  const { gnomon } = window;
  const extension = document.getElementById('view').getContext('webgl2').getExtension('WEBGL_lose_context');
  const next = (event) =>
    new Promise((resolve) => {
      const off = gnomon.on(event, () => resolve(off()));
    });
  const wanted = (await gnomon.image()).data;
  const alive = [],
    wrong = [];
  for (let i = 0; i < times; ++i) {
    const lost = next('lost');
    extension.loseContext();
    await lost;
    await new Promise((resolve) => setTimeout(resolve)); // the browser refuses while listeners still hear of the loss
    const restored = next('restored');
    extension.restoreContext();
    await restored;
    const { data } = await gnomon.image();
    wrong.push(wanted.reduce((count, value, at) => count + (value !== data[at]), 0));
    await next('frame');
    alive.push(gnomon.stats().glObjects);
  }
  return { alive, wrong };
}

for (const name of browserNames)
  describe(`context loss in ${name}`, () => {
    let server, browser;

    before(async () => {
      server = await serve();
      browser = await sharedBrowser(name);
    });
    after(async () => {
      await server?.close();
    });

    test(`${losses} lost contexts leave the picture as it is and no GL object behind`, async () => {
      const page = await openPage(browser, `${server.url}?${cheapest}`);
      const shown = await picture(page);
      assert.ok(new Set(shown.data).size > 50, 'the picture has many values');
      const start = performance.now();
      const { alive, wrong } = await page.evaluate(loseAndRestore, losses);
      const seconds = (performance.now() - start) / 1000;
      const [fewest, most] = [Math.min(...alive), Math.max(...alive)];
      console.log(
        `# ${name}: ${losses} losses in ${seconds.toFixed(1)} s, ${fewest} to ${most} objects alive after each`,
      );
      assert.equal(alive.length, losses);
      assert.ok(fewest > 0 && most - fewest <= fences, `objects alive after each loss: ${alive}`);
      assert.deepEqual(wrong, Array(losses).fill(0), 'bytes that differ after each loss');
      assert.equal(differences(shown, await picture(page)), 0);
      page.verify();
      await page.close();
    });
  });
