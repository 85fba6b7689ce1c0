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
      page.$$eval('section:last-of-type tbody tr', (rows, at) => rows.map((row) => row.cells[at].textContent), index);

    test('shows environment, command and every row', async () => {
      assert.match(await page.$eval('.command', (element) => element.textContent), /^gnomon lab intersect --rays=200/);
      assert.match(await page.$eval('dl', (element) => element.textContent), /renderer.*llvmpipe/s);
      // A sphere has five classes of rays, three tori have six, at two distances.
      assert.equal((await column(0)).length, 2 * (5 + 3 * 6));
    });

    test('a click on a heading sorts, a second one the other way', async () => {
      const heading = await page.evaluateHandle(() => [...document.querySelectorAll('section:last-of-type th button')].find((button) => button.textContent.startsWith('distance')));
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

// Several runs, as `gnomon report` puts them on one page.
describe('a page of several runs', () => {
  let folder, browser, page;
  const complaints = [], requests = [];

  before(async () => {
    folder = mkdtempSync(join(tmpdir(), 'gnomon-report-'));
    const [old, now, file] = ['old.json', 'new.json', 'report.html'].map((name) => join(folder, name));
    for (const json of [old, now])
      execFileSync(gnomon, ['bench', 'lite', 'shapes', '--depth=1,4', '--shadows=off,hard', '--size=32x24', '--repeats=3', `--json=${json}`]);
    execFileSync(gnomon, ['report', '--against', old, now, '-o', file]);
    browser = await launch('chromium');
    page = await browser.newPage();
    page.on('console', (message) => complaints.push(message.text()));
    page.on('pageerror', (error) => complaints.push(error.message));
    page.on('request', (request) => requests.push(request.url()));
    await page.goto(pathToFileURL(file).href);
    await page.waitForSelector('article:last-of-type tbody tr');
  });
  after(async () => {
    await browser?.close();
    rmSync(folder, { recursive: true, force: true });
  });

  test('lists the comparison and both runs, and each link leads to its own', async () => {
    const links = await page.$$eval('nav a', (all) => all.map((link) => document.querySelector(link.getAttribute('href')).querySelector('h2').textContent === link.textContent));
    assert.deepEqual(links, [true, true, true]);
    const commands = await page.$$eval('.command', (all) => all.map((element) => element.textContent));
    assert.match(commands[0], /^gnomon report --against /);
    assert.match(commands[1], /^gnomon bench lite shapes --context=osmesa --depth=1,4 --shadows=off,hard/);
  });

  test('tells every row a verdict, and shows quartiles in the cell of their median', async () => {
    const rows = await page.$$eval('#run-1 tbody tr', (all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
    assert.equal(rows.length, 8);
    for (const cells of rows) {
      assert.equal(cells.length, 9, 'scene, context, size, depth, shadows, old, new, ratio, verdict');
      assert.match(cells[7], /^\d+\.\d+ ?\d+\.\d+ … \d+\.\d+$/);
      assert.match(cells[8], /^(faster|slower|the same within noise)$/);
    }
  });

  test('lines up the numbers of a column: all have as many decimals', async () => {
    const fps = await page.$$eval('#run-2 tbody tr', (all) => all.map((row) => row.cells[5].textContent));
    assert.equal(new Set(fps.map((text) => text.split('.')[1]?.length ?? 0)).size, 1, `${fps}`);
  });

  test('sorts by the median, not by the text of the cell', async () => {
    const heading = await page.evaluateHandle(() => document.querySelectorAll('#run-2 th button')[6]);
    const frames = () => page.$$eval('#run-2 tbody tr', (all) => all.map((row) => Number(row.cells[6].firstChild.textContent.replace(',', ''))));
    await heading.click();
    const falling = await frames();
    assert.deepEqual(falling, [...falling].sort((a, b) => b - a));
    await heading.click();
    assert.deepEqual(await frames(), [...falling].reverse());
  });

  test('draws FPS over depth for each scene of each run, a line for each kind of shadows', async () => {
    const charts = await page.$$eval('canvas', (all) => all.map((canvas) => Chart.getChart(canvas)).map((chart) => ({
      lines: chart.data.datasets.map(({ label, data }) => `${label} ${data.map(({ x }) => x)}`), x: chart.options.scales.x.title.text, y: chart.options.scales.y.title.text,
    })));
    assert.equal(charts.length, 4);
    for (const chart of charts) assert.deepEqual(chart, { lines: ['off 1,4', 'hard 1,4'], x: 'depth', y: 'FPS, 1/s' });
  });

  test('says nothing on the console and loads nothing', () => {
    assert.deepEqual(complaints, []);
    assert.deepEqual(requests.filter((url) => !url.startsWith('file:')), []);
  });
});
