// Renders one frame of the page in a real browser and writes the canvas' pixels, or an output as floats.
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { writeFile } from 'node:fs/promises';
import { PNG } from 'pngjs';
import { launch, openPage, picture } from './browsers.mjs';
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

/** The bytes of a PFM file: rows from the bottom up, little endian. */
function pfm({ width, height, channels, data }) {
  const header = Buffer.from(`${channels === 3 ? 'PF' : 'Pf'}\n${width} ${height}\n-1.0\n`);
  const rows = Buffer.alloc(data.length * 4);
  const row = width * channels;
  for (let y = 0; y < height; ++y)
    for (let i = 0; i < row; ++i) rows.writeFloatLE(data[(height - 1 - y) * row + i], (y * row + i) * 4);
  return Buffer.concat([header, rows]);
}

function png({ width, height, data }) {
  const image = new PNG({ width, height });
  data.copy(image.data);
  return PNG.sync.write(image, { colorType: 2 });
}

/** The output as floats; base64 keeps infinities, which JSON does not. */
async function output(page, aov) {
  const { text, ...shape } = await page.evaluate(async (name) => {
    const { width, height, channels, data } = await window.gnomon.readOutput(name);
    const bytes = new Uint8Array(data.buffer);
    let string = '';
    for (let i = 0; i < bytes.length; i += 8192) string += String.fromCharCode(...bytes.subarray(i, i + 8192));
    return { width, height, channels, text: btoa(string) };
  }, aov);
  const bytes = Buffer.from(text, 'base64');
  return { ...shape, data: new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length)) };
}

/**
 * Writes one frame of the page in an open browser to `file`; throws what the page complains of.
 * @param options.set texts KEY=VALUE
 */
export async function render(browser, url, { scene, size, set = [], aov = 'color', file }) {
  const query = new URLSearchParams({ scene, size, time: '0', pause: 'on' });
  for (const pair of set) query.set(pair.slice(0, pair.indexOf('=')), pair.slice(pair.indexOf('=') + 1));
  const page = await openPage(browser, `${url}?${query}`);
  const told = await page.$eval('.problems', (element) => element.textContent);
  if (told) throw new Error(told); // a picture of something else than asked for helps nobody
  const bytes = file.endsWith('.png') ? png(await picture(page)) : pfm(await output(page, aov));
  page.verify();
  await page.close();
  await writeFile(file, bytes);
}

async function main() {
  const chosen = options();
  if (chosen.help) return console.log(usage);
  if (!/\.(png|pfm)$/.test(chosen.output ?? '')) fail('-o needs a file that ends in .png or .pfm');
  if (chosen.set.some((pair) => !pair.includes('='))) fail('--set needs KEY=VALUE');
  if (!['chromium', 'firefox'].includes(chosen.browser)) fail(`there is no browser '${chosen.browser}'`);

  const server = await serve();
  const browser = await launch(chosen.browser);
  try {
    await render(browser, server.url, { ...chosen, file: chosen.output });
  } catch (error) {
    console.error(`render: error: ${error.message}`);
    process.exitCode = 1;
  } finally {
    await browser.close();
    await server.close();
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await main();
