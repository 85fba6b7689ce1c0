// A report is one file: it draws, sorts and loads nothing, in both browsers.
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { browserNames, until } from './browsers.mjs';
import { sharedBrowser } from './shared_browser.mjs';

const gnomon = process.env.GNOMON_BINARY ?? 'build/native/gnomon';

for (const name of browserNames)
  describe(`a report in ${name}`, () => {
    let folder, browser, page;
    const complaints = [],
      requests = [];

    before(async () => {
      folder = mkdtempSync(join(tmpdir(), 'gnomon-report-'));
      const file = join(folder, 'report.html');
      execFileSync(gnomon, [
        'lab',
        'intersect',
        '--shapes=sphere,torus',
        '--distances=3,100',
        '--rays=200',
        `--html=${file}`,
      ]);
      browser = await sharedBrowser(name);
      page = await browser.newPage();
      page.on('console', (message) => complaints.push(message.text()));
      page.on('pageerror', (error) => complaints.push(error.message));
      page.on('request', (request) => requests.push(request.url()));
      await page.goto(pathToFileURL(file).href);
      await page.waitForSelector('tbody tr');
    });
    after(async () => {
      await page?.close();
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
      const heading = await page.evaluateHandle(() =>
        [...document.querySelectorAll('section:last-of-type th button')].find((button) =>
          button.textContent.startsWith('distance'),
        ),
      );
      const index = await heading.evaluate((button) => button.parentElement.cellIndex);
      await heading.click();
      const falling = (await column(index)).map(Number);
      assert.deepEqual(
        falling,
        [...falling].sort((a, b) => b - a),
      );
      assert.equal(falling[0], 100);
      await heading.click();
      assert.equal(Number((await column(index))[0]), 3);
    });

    test('every chart has lines', async () => {
      const drawn = await page.$$eval('canvas', (canvases) =>
        canvases.map((canvas) => {
          const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
          let blue = 0;
          for (let i = 0; i < data.length; i += 4) blue += data[i] < 60 && data[i + 2] > 120 && data[i + 3] > 200;
          return blue;
        }),
      );
      assert.equal(drawn.length, 10, 'five charts for each of two shapes');
      for (const blue of drawn) assert.ok(blue > 100, `${drawn}`);
    });

    test('says nothing on the console and loads nothing', () => {
      assert.deepEqual(complaints, []);
      assert.deepEqual(
        requests.filter((url) => !/^(file|data):/.test(url)),
        [],
      );
    });
  });

// Several runs, as `gnomon report` puts them on one page.
describe('a report of several runs', () => {
  let folder, browser, page;
  const complaints = [],
    requests = [];

  before(async () => {
    folder = mkdtempSync(join(tmpdir(), 'gnomon-report-'));
    const [old, now, file] = ['old.json', 'new.json', 'report.html'].map((name) => join(folder, name));
    for (const json of [old, now])
      execFileSync(gnomon, [
        'bench',
        'lite',
        'shapes',
        '--depth=1,4',
        '--shadows=off,hard',
        '--size=32x24',
        '--repeats=3',
        `--json=${json}`,
      ]);
    execFileSync(gnomon, ['report', '--against', old, now, '-o', file]);
    browser = await sharedBrowser('chromium');
    page = await browser.newPage();
    page.on('console', (message) => complaints.push(message.text()));
    page.on('pageerror', (error) => complaints.push(error.message));
    page.on('request', (request) => requests.push(request.url()));
    await page.goto(pathToFileURL(file).href);
    await page.waitForSelector('article:last-of-type tbody tr');
  });
  after(async () => {
    await page?.close();
    rmSync(folder, { recursive: true, force: true });
  });

  const headed = (text) =>
    page.evaluateHandle(
      (wanted) =>
        [...document.querySelectorAll('#run-1 section')].find(
          (section) => section.querySelector('h3').textContent === wanted,
        ),
      text,
    );
  const cellsOf = (section) =>
    section.$$eval('tbody tr', (all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));

  test('lists the comparison and both runs, and each link leads to its own', async () => {
    const links = await page.$$eval('nav a', (all) =>
      all.map(
        (link) =>
          document.querySelector(link.getAttribute('href')).querySelector('h2').textContent === link.textContent,
      ),
    );
    assert.deepEqual(links, [true, true, true]);
    const commands = await page.$$eval('.command', (all) => all.map((element) => element.textContent));
    assert.match(commands[0], /^gnomon report --against /);
    assert.match(commands[1], /^gnomon bench lite shapes --context=osmesa --depth=1,4 --shadows=off,hard/);
  });

  test('tells every row a verdict, and shows quartiles in the cell of their median', async () => {
    const rows = await cellsOf(await headed('Frames a second: frame'));
    assert.equal(rows.length, 8);
    for (const cells of rows) {
      assert.equal(cells.length, 9, 'scene, context, size, depth, shadows, old, new, ratio, verdict');
      assert.match(cells[7], /^\d+\.\d+ ?\d+\.\d+ … (\d+\.\d+|inf)$/);
      assert.match(cells[8], /^(faster|slower|the same within noise)$/);
    }
  });

  test('says first how many rows became what, of every kind of number', async () => {
    const rows = await cellsOf(await headed('What changed'));
    assert.deepEqual(
      rows.map((cells) => cells.slice(0, 4)),
      [
        ['Frames a second', 'frame', 'time', '8'],
        ['Frames a second', 'ratio', 'ratio', '8'],
        ['Frames a second', 'source', 'count', '8'],
      ],
    );
    for (const cells of rows)
      assert.equal(
        cells
          .slice(4, 7)
          .map(Number)
          .reduce((a, b) => a + b),
        8,
      );
    assert.deepEqual(rows[2].slice(4, 7), ['0', '0', '8'], 'the same program has the same shaders');
  });

  test('puts all runs into one table, a column each, and their FPS and compile times into charts', async () => {
    const heads = await page.$$eval('#together th button', (all) => all.map((button) => button.firstChild.textContent));
    assert.deepEqual(heads, ['scene', 'shadows', 'depth', 'run 2: osmesa, 32x24', 'run 3: osmesa, 32x24']);
    const together = await page.$$eval('#together tbody tr', (all) =>
      all.map((row) => [...row.cells].map((cell) => cell.textContent)),
    );
    const own = async (run) =>
      page.$$eval(`#run-${run} section:nth-of-type(2) tbody tr`, (all) =>
        all.map((row) => Number(row.cells[5].textContent.replace(',', ''))),
      );
    for (const [column, run] of [
      [3, 2],
      [4, 3],
    ]) {
      const fps = together.map((cells) => Number(cells[column].replace(',', ''))),
        sorted = (list) => [...list].sort((a, b) => a - b);
      assert.equal(fps.length, 8);
      sorted(await own(run)).forEach((value, i) =>
        assert.ok(Math.abs(sorted(fps)[i] / value - 1) < 0.01, `run ${run}: ${fps}`),
      );
    }
    const charts = await page.$$eval('#together canvas', (all) =>
      all
        .map((canvas) => Chart.getChart(canvas))
        .map(
          ({ config, data }) => `${config.type} ${data.datasets.map(({ label, data }) => `${label} ${data.length}`)}`,
        ),
    );
    const lines = 'line run 2: osmesa, 32x24 2,run 3: osmesa, 32x24 2',
      bars = 'bar run 2: osmesa, 32x24 4,run 3: osmesa, 32x24 4';
    assert.deepEqual(charts, [lines, lines, lines, lines, bars, bars]);
  });

  test('lines up the numbers of a column: all have as many decimals', async () => {
    const fps = await page.$$eval('#run-2 tbody tr', (all) => all.map((row) => row.cells[5].textContent));
    assert.equal(new Set(fps.map((text) => text.split('.')[1]?.length ?? 0)).size, 1, `${fps}`);
  });

  test('sorts by the median, not by the text of the cell', async () => {
    const heading = await page.evaluateHandle(() => document.querySelectorAll('#run-2 th button')[6]);
    const frames = () =>
      page.$$eval('#run-2 tbody tr', (all) =>
        all.map((row) => Number(row.cells[6].firstChild.textContent.replace(',', ''))),
      );
    await heading.click();
    const falling = await frames();
    assert.deepEqual(
      falling,
      [...falling].sort((a, b) => b - a),
    );
    await heading.click();
    assert.deepEqual(await frames(), [...falling].reverse());
  });

  test('draws FPS over depth for each scene of each run, a line for each kind of shadows', async () => {
    const charts = await page.$$eval('article:not(#together) .canvas canvas', (all) =>
      all
        .map((canvas) => Chart.getChart(canvas))
        .map((chart) => ({
          lines: chart.data.datasets.map(({ label, data }) => `${label} ${data.map(({ x }) => x)}`),
          x: chart.options.scales.x.title.text,
          y: chart.options.scales.y.title.text,
        })),
    );
    assert.equal(charts.length, 4);
    for (const chart of charts)
      assert.deepEqual(chart, { lines: ['off 1,4', 'hard 1,4'], x: 'depth', y: ['FPS, 1/s', '(higher is better)'] });
  });

  test('says nothing on the console and loads nothing', () => {
    assert.deepEqual(complaints, []);
    assert.deepEqual(
      requests.filter((url) => !/^(file|data):/.test(url)),
      [],
    );
  });
});

// What a laboratory of errors shows: fronts and pictures.
for (const name of browserNames)
  describe(`a report with pictures and fronts in ${name}`, () => {
    let folder, browser, page;
    const complaints = [],
      requests = [];

    before(async () => {
      folder = mkdtempSync(join(tmpdir(), 'gnomon-report-'));
      const file = join(folder, 'shadows.html');
      execFileSync(gnomon, [
        'lab',
        'shadows',
        '--scenes=simple',
        '--models=hard,quilez,silhouette,montecarlo',
        '--samples=1,16',
        '--size=64x48',
        '--reference=64',
        '--repeats=2',
        `--html=${file}`,
      ]);
      browser = await sharedBrowser(name);
      page = await browser.newPage();
      await page.setViewport({ width: 1200, height: 900 });
      page.on('console', (message) => complaints.push(message.text()));
      page.on('pageerror', (error) => complaints.push(error.message));
      page.on('request', (request) => requests.push(request.url()));
      await page.goto(pathToFileURL(file).href);
      await until('differences', () =>
        page.$$eval('.gallery li figcaption', (all) => all.every((caption) => caption.textContent !== 'difference')),
      );
    });
    after(async () => {
      await page?.close();
      rmSync(folder, { recursive: true, force: true });
    });

    test('marks the points of the front, from the fastest to the nearest, and says which way is better', async () => {
      const { front, points, x, y } = await page.$eval('.canvas canvas', (canvas) => {
        const { data, options } = Chart.getChart(canvas);
        const of = ({ data }) => data.map(({ x, y }) => [x, y]);
        const [first, ...others] = data.datasets;
        return {
          front: first.label === 'front' && of(first),
          points: others.flatMap(of),
          x: options.scales.x.title.text,
          y: options.scales.y.title.text,
        };
      });
      assert.equal(points.length, 5);
      const best = points
        .filter(([x, y]) => !points.some(([otherX, otherY]) => otherX < x && otherY <= y))
        .sort((a, b) => a[0] - b[0]);
      assert.ok(front.length >= 1 && front.length < points.length);
      for (const point of front)
        assert.ok(
          best.some(([x, y]) => x === point[0] && y === point[1]),
          `${point} of ${best}`,
        );
      assert.match(x[1], /lower is better/);
      assert.match(y[1], /lower is better/);
    });

    test('shows the picture of every row beside its reference, and a difference that can be seen', async () => {
      assert.equal((await page.$$('.gallery li')).length, 6, 'the reference and five ways');
      const seen = await page.$$eval('.gallery li canvas', (all) =>
        all.map((canvas) => ({
          most: Math.max(
            ...canvas
              .getContext('2d')
              .getImageData(0, 0, canvas.width, canvas.height)
              .data.filter((value, i) => i % 4 < 3),
          ),
          words: canvas.nextSibling.textContent,
          size: `${canvas.width}x${canvas.height}`,
        })),
      );
      assert.equal(seen.length, 5);
      for (const { most, words, size } of seen) {
        assert.equal(size, '64x48');
        const [, factor, greatest] = words.match(/^difference × (\d+), at most (\d+) of 255$/);
        assert.equal(most, Math.min(255, factor * greatest), words);
        assert.ok(most > 100 || Number(factor) === 128, words);
      }
    });

    test('a click on a row, or Enter on its mark, opens its picture; Escape closes it', async () => {
      const titles = () => page.$$eval('dialog[open] figcaption', (all) => all.map((caption) => caption.textContent));
      await page.click('#run-1 tbody tr:nth-child(2) td:nth-child(4)');
      const opened = await titles();
      assert.deepEqual(opened.slice(0, 2), ['simple, quilez', 'Monte Carlo, 64 samples']);
      await page.keyboard.press('Escape');
      await until('closed', async () => (await titles()).length === 0);
      await page.focus('#run-1 tbody tr:nth-child(3) .look');
      await page.keyboard.press('Enter');
      assert.equal((await titles())[0], 'simple, silhouette');
      await page.click('dialog .close');
      await until('closed', async () => (await titles()).length === 0);
    });

    test('a pointer over a point shows its picture, a click opens it', async () => {
      const place = await page.$eval('.canvas canvas', (canvas) => {
        canvas.scrollIntoView({ block: 'center' });
        const { x, y } = Chart.getChart(canvas).getDatasetMeta(2).data[0].getProps(['x', 'y'], true);
        const box = canvas.getBoundingClientRect();
        return { x: box.x + x, y: box.y + y };
      });
      await page.mouse.move(place.x - 3, place.y);
      await page.mouse.move(place.x, place.y);
      await until('a peek', () => page.$('.peek img'));
      assert.match(await page.$eval('.peek figcaption', (caption) => caption.textContent), /^simple, /);
      await page.mouse.click(place.x, place.y);
      await until('the picture', () => page.$('dialog[open] img'));
      assert.equal(await page.$('.peek'), null);
      await page.keyboard.press('Escape');
    });

    test('says nothing on the console and loads nothing', () => {
      assert.deepEqual(complaints, []);
      assert.deepEqual(
        requests.filter((url) => !/^(file|data):/.test(url)),
        [],
      );
    });
  });
