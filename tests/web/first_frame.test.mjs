// How soon the page shows something, from navigation to the first frame that the GPU has finished, at the size of a
// window.
//
// Bound  on a software renderer with two cores: lite within 3 s, pro at depth 8 within 6 s
import { test } from 'node:test';
import { strict as assert } from 'node:assert';
import { browserNames, launch, openPage, until } from './browsers.mjs';
import { serve } from './server.mjs';

const bounds = [
  { query: 'scene=lite', ms: 3000 },
  { query: 'scene=pro&depth=8', ms: 6000 },
];

for (const name of browserNames)
  for (const { query, ms } of bounds)
    test(`${name}: ${query} is on the page within ${ms / 1000} s of navigation`, async () => {
      const server = await serve();
      const browser = await launch(name); // new each time: nothing is cached, shaders compile cold
      try {
        const page = await openPage(browser, `${server.url}?${query}`, { viewport: { width: 800, height: 600 } });
        const first = await until('the first frame', () => page.evaluate(() => window.gnomon.firstFrameMs));
        const { compileMs, sourceBytes } = await page.evaluate(() => window.gnomon.stats());
        console.log(
          `# ${name} ${query}: ${Math.round(first)} ms; all programs, from source (${sourceBytes} bytes) ` +
            `to the first pixel of each: ${Math.round(compileMs)} ms`,
        );
        assert.ok(first <= ms, `it took ${Math.round(first)} ms`);
        page.verify();
      } finally {
        await browser.close();
        await server.close();
      }
    });
