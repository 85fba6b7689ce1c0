// Renders one frame of the page in a real browser and writes the canvas' pixels, or an output as floats.
import { parseArgs } from 'node:util';
import { writeFile } from 'node:fs/promises';
import { fileFrom, openStill } from './picture_file.mjs';
import { launch } from './browsers.mjs';
import { serve } from './server.mjs';

const usage = `usage: node tests/web/render.mjs --browser=chromium|firefox [--scene=lite] [--size=200x150]
                                [--set=KEY=VALUE …] [--aov=NAME] -o FILE.png|FILE.pfm
  FILE.png  the canvas as it is read back, 8 bits a channel
  FILE.pfm  the output --aov names (default color), float32
Time is 0 and paused unless --set says otherwise. --set takes the page's settings, as --set=depth=8.`;

function fail(text) {
  console.error(`render: error: ${text}\n${usage}`);
  process.exit(2);
}

function options() {
  try {
    return parseArgs({
      options: {
        browser: { type: 'string', default: 'chromium' },
        scene: { type: 'string', default: 'lite' },
        size: { type: 'string', default: '200x150' },
        set: { type: 'string', multiple: true, default: [] },
        aov: { type: 'string', default: 'color' },
        output: { type: 'string', short: 'o' },
        help: { type: 'boolean', default: false },
      },
    }).values;
  } catch (error) {
    return fail(error.message);
  }
}

const chosen = options();
if (chosen.help) {
  console.log(usage);
  process.exit(0);
}
if (!/\.(png|pfm)$/.test(chosen.output ?? '')) fail('-o needs a file that ends in .png or .pfm');
if (chosen.set.some((pair) => !pair.includes('='))) fail('--set needs KEY=VALUE');
if (!['chromium', 'firefox'].includes(chosen.browser)) fail(`there is no browser '${chosen.browser}'`);

const server = await serve();
const browser = await launch(chosen.browser);
try {
  const page = await openStill(browser, server.url, chosen);
  await writeFile(chosen.output, await fileFrom(page, chosen.output.endsWith('.pfm') ? chosen.aov : ''));
} catch (error) {
  console.error(`render: error: ${error.message}`);
  process.exitCode = 1;
} finally {
  await browser.close();
  await server.close();
}
