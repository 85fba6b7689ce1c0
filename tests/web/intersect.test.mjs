// Every shape's intersector in both browsers, ray by ray: tests/web/ray_corpus.cpp asks and judges, the page answers.
//
// Bound  that of the shapes' files, as in tests/shader/intersect_test.cpp
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { browserNames, openPage } from './browsers.mjs';
import { traceRays } from './rays.mjs';
import { serve } from './server.mjs';
import { sharedBrowser } from './shared_browser.mjs';

const corpus = process.env.GNOMON_RAY_CORPUS ?? 'build/native/tests/ray_corpus';
const raysEach = 1000; // of a class at a distance

for (const name of browserNames)
  describe(`shapes' rays in ${name}`, () => {
    let server, browser, page, folder;

    before(async () => {
      folder = mkdtempSync(join(tmpdir(), 'gnomon-rays-'));
      server = await serve();
      browser = await sharedBrowser(name);
      page = await openPage(browser, `${server.url}?scene=lite&size=64x48&pause=on`);
    });
    after(async () => {
      await page?.close();
      await server?.close();
      rmSync(folder, { recursive: true, force: true });
    });

    test('every shape answers within its bounds', async () => {
      const sets = Number(execFileSync(corpus, ['ask', folder, String(raysEach)], { encoding: 'utf8' }));
      assert.ok(sets > 40, `${sets} sets of rays`);
      for (let set = 0; set < sets; ++set) {
        const bytes = readFileSync(join(folder, `${set}.rays`));
        const rays = new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
        const answers = await traceRays(page, readFileSync(join(folder, `${set}.json`), 'utf8'), rays);
        writeFileSync(
          join(folder, `${set}.answers`),
          new Uint8Array(answers.buffer, answers.byteOffset, answers.byteLength),
        );
      }
      const { status, stdout } = spawnSync(corpus, ['compare', folder], { encoding: 'utf8' });
      console.log(stdout.replace(/^/gm, `# ${name}: `));
      assert.equal(status, 0, stdout);
    });
  });
