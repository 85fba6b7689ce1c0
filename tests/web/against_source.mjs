// The page against the source document's way of tracing (tests/textbook/source), in one browser and run. By itself it
// prints how many times as fast the page draws:
//
//   node tests/web/against_source.mjs [--browser=chromium] [--scene=pro] [--size=800x600] [--data=block] [--rounds=3]
//                                     [--eye=0,6,24 --target=0,-7,12]
//
// data  where the source has its numbers: in a block, as it had them itself, or in a texture
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { launch, openPage } from './browsers.mjs';
import { serve } from './server.mjs';
import { sourceScene, sourceShaders } from './source.mjs';

const still = 'pause=on&time=0&depth=8&adapt=off';

export const median = (values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];

/**
 * Two pages that show the same, { ours, source }. @param options.camera as in a scene file, in place of the scene's own
 */
export async function openPair(browser, url, { scene, size, data = 'auto', camera = {} }) {
  const view = Object.entries(camera)
    .map(([key, place]) => `&${key}=${place}`)
    .join('');
  const ours = await openPage(browser, `${url}?scene=${scene}&size=${size}&${still}${view}`);
  // It opens with what compiles soon, and takes its scene and shaders between two frames: of the library's own program
  // for that scene nothing is ever drawn.
  const source = await openPage(
    browser,
    `${url}?scene=torus&shadows=off&size=${size}&${still}&accel=none&data=${data}`,
  );
  const told = await sourceScene(scene);
  Object.assign(told.camera, camera);
  await source.evaluate(
    async (to, texts) => {
      window.gnomon.set('shadows', 'hard');
      await window.gnomon.load(to);
      await window.gnomon.shaders(texts);
    },
    told,
    await sourceShaders(),
  );
  return { ours, source };
}

/** Frame times in ms, a round each, in turn: { ours, source, ratios }. */
export async function timeInTurns({ ours, source }, rounds) {
  const frame = async (page) => {
    await page.bringToFront();
    return page.evaluate(() => window.gnomon.bench({ frames: 3 }).then(({ medianMs }) => medianMs));
  };
  const times = { ours: [], source: [], ratios: [] };
  for (let round = 0; round < rounds; ++round) {
    times.source.push(await frame(source));
    times.ours.push(await frame(ours));
    times.ratios.push(times.source.at(-1) / times.ours.at(-1));
  }
  return times;
}

async function main() {
  const string = (value) => ({ type: 'string', default: value });
  const { values } = parseArgs({
    options: {
      browser: string('chromium'),
      scene: string('pro'),
      size: string('800x600'),
      data: string('block'),
      rounds: string('3'),
      eye: { type: 'string' },
      target: { type: 'string' },
    },
  });
  const place = (text) => text.split(',').map(Number);
  const camera = Object.fromEntries(
    ['eye', 'target'].filter((key) => values[key]).map((key) => [key, place(values[key])]),
  );
  const server = await serve();
  const browser = await launch(values.browser);
  try {
    const { ours, source, ratios } = await timeInTurns(
      await openPair(browser, server.url, { ...values, camera }),
      Number(values.rounds),
    );
    const all = ratios.map((ratio) => ratio.toFixed(2)).join(' ');
    console.log(
      `${median(ratios).toFixed(2)} times as fast (${all}): ` +
        `${median(source).toFixed(0)} ms, ${median(ours).toFixed(0)} ms`,
    );
  } finally {
    await browser.close();
    await server.close();
  }
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await main();
