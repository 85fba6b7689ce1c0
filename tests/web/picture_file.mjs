// One frame of the page as a file: the canvas' bytes as PNG, an output's floats as PFM.
import { PNG } from 'pngjs';
import { openPage, picture } from './browsers.mjs';

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

/** A page of its own at time 0 that stands still. @param set texts KEY=VALUE, beside time and pause */
export async function openStill(browser, url, { scene, size, set }) {
  const query = new URLSearchParams({ scene, size, time: '0', pause: 'on' });
  for (const pair of set) query.set(pair.slice(0, pair.indexOf('=')), pair.slice(pair.indexOf('=') + 1));
  const page = await openPage(browser, `${url}?${query}`);
  const told = await page.$eval('.problems', (element) => element.textContent);
  if (told) throw new Error(told); // a picture of something else than asked for helps nobody
  return page;
}

/** The page's picture as the bytes of a PNG file, or one of its outputs as those of a PFM file. */
export async function fileFrom(page, aov = '') {
  const file = aov ? pfm(await output(page, aov)) : png(await picture(page));
  page.verify();
  return file;
}
