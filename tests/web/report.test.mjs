// A report is one file: it draws, sorts and loads nothing, in both browsers.
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { browserNames, launch } from './browsers.mjs';

const gnomon = process.env.GNOMON_BINARY ?? 'build/native/gnomon';

for (const name of browserNames)
  describe(name, () => {
    let folder, browser, page;
    const complaints = [], requests = [];

    before(async () => {
      folder = mkdtempSync(join(tmpdir(), 'gnomon-report-'));
      const file = join(folder, 'report.html');
      execFileSync(gnomon, ['lab', 'intersect', '--shapes=sphere,torus', '--distances=3,100', '--rays=200', `--html=${file}`]);
      browser = await launch(name);
      page = await browser.newPage();
      page.on('console', (message) => complaints.push(message.text()));
      page.on('pageerror', (error) => complaints.push(error.message));
      page.on('request', (request) => requests.push(request.url()));
      await page.goto(pathToFileURL(file).href);
      await page.waitForSelector('tbody tr');
    });
    after(async () => {
      await browser?.close();
      rmSync(folder, { recursive: true, force: true });
    });

    const column = (index) =>
      page.$$eval('tbody tr', (rows, at) => rows.map((row) => row.cells[at].textContent), index);

    test('shows environment, command and every row', async () => {
      assert.match(await page.$eval('.command', (element) => element.textContent), /^gnomon lab intersect --rays=200/);
      assert.match(await page.$eval('dl', (element) => element.textContent), /renderer.*llvmpipe/s);
      // A sphere has five classes of rays, three tori have six, at two distances.
      assert.equal((await column(0)).length, 2 * (5 + 3 * 6));
    });

    test('a click on a heading sorts, a second one the other way', async () => {
      const heading = await page.evaluateHandle(() => [...document.querySelectorAll('th button')].find((button) => button.textContent.startsWith('distance')));
      const index = await heading.evaluate((button) => button.parentElement.cellIndex);
      await heading.click();
      const falling = (await column(index)).map(Number);
      assert.deepEqual(falling, [...falling].sort((a, b) => b - a));
      assert.equal(falling[0], 100);
      await heading.click();
      assert.equal(Number((await column(index))[0]), 3);
    });

    test('every chart has lines', async () => {
      const drawn = await page.$$eval('canvas', (canvases) => canvases.map((canvas) => {
        const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        let blue = 0;
        for (let i = 0; i < data.length; i += 4) blue += data[i] < 60 && data[i + 2] > 120 && data[i + 3] > 200;
        return blue;
      }));
      assert.equal(drawn.length, 10, 'five charts for each of two shapes');
      for (const blue of drawn) assert.ok(blue > 100, `${drawn}`);
    });

    test('says nothing on the console and loads nothing', () => {
      assert.deepEqual(complaints, []);
      assert.deepEqual(requests.filter((url) => !url.startsWith('file:')), []);
    });
  });
