// Frame rates compared in the page: window.gnomon.compare() and its dialog, in real browsers.
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { browserNames, differences, openPage, picture, until } from './browsers.mjs';
import { serve } from './server.mjs';
import { sharedBrowser } from './shared_browser.mjs';

const gnomon = process.env.GNOMON_BINARY ?? 'build/native/gnomon';
const tiny = { scenes: ['lite'], size: '32x24', depth: [1, 4], shadows: 'off,hard' };

for (const name of browserNames)
  describe(`compare in ${name}`, () => {
    let folder, server, browser, page, results;

    before(async () => {
      folder = mkdtempSync(join(tmpdir(), 'gnomon-compare-'));
      server = await serve({ isolated: true });
      browser = await sharedBrowser(name);
      page = await openPage(browser, `${server.url}?size=64x48&pause=on&time=1&eye=0,1,30`);
    });
    after(async () => {
      await page?.close();
      await server?.close();
      rmSync(folder, { recursive: true, force: true });
    });

    const compare = (options) => page.evaluate((asked) => window.gnomon.compare(asked), options);
    const refusal = (options) =>
      page.evaluate(
        (asked) =>
          window.gnomon.compare(asked).then(
            () => 'taken',
            ({ message }) => message,
          ),
        options,
      );
    const at = (key) => results.tables[0].columns.findIndex((column) => column.key === key);

    test('measures a row for every combination, tells how far it is, and leaves the view as it was', async () => {
      const shown = await picture(page);
      const settings = await page.evaluate(() => window.gnomon.settings());
      const told = await page.evaluate(async (asked) => {
        const told = [];
        const results = await window.gnomon.compare({
          ...asked,
          repeats: 3,
          onprogress: (progress) => told.push(progress),
        });
        return { told, results };
      }, tiny);
      results = told.results;
      const { rows, keys } = results.tables[0];
      const context = `webgl2-${name}`;
      assert.deepEqual(
        rows.map((row) => row.slice(0, keys)),
        [
          ['lite', context, '32x24', 1, 'off'],
          ['lite', context, '32x24', 1, 'hard'],
          ['lite', context, '32x24', 4, 'off'],
          ['lite', context, '32x24', 4, 'hard'],
        ],
      );
      assert.equal(
        results.command,
        "gnomon.compare({ scenes: 'lite', depth: '1,4', shadows: 'off,hard', size: '32x24', repeats: 3 })",
      );
      assert.equal(results.environment.rounds, `${context} 3 of 3`);

      const [planned, ...steps] = told.told;
      assert.deepEqual(planned.rows.at(-1), 'lite, size 32x24, depth 4, shadows hard');
      const last = (stage) => steps.filter((step) => step.stage === stage).at(-1);
      assert.deepEqual([last('compiling').done, last('compiling').all], [4, 4]);
      assert.deepEqual([last('drawing').done, last('drawing').all], [16, 16], 'one round is not measured');
      assert.ok(steps.every(({ secondsLeft }) => secondsLeft >= 0) && last('drawing').secondsLeft === 0);

      assert.deepEqual(await page.evaluate(() => window.gnomon.settings()), settings);
      assert.equal(differences(shown, await picture(page)), 0);
    });

    test('medians lie between their quartiles, and the first row has the ratio 1', () => {
      for (const row of results.tables[0].rows)
        for (const key of ['frame', 'frame_calibrated', 'ratio']) {
          const [low, median, high] = [`${key}_low`, key, `${key}_high`].map((column) => row[at(column)]);
          assert.ok(low > 0 && low <= median && median <= high, `${key}: ${low} ${median} ${high}`);
        }
      const [first] = results.tables[0].rows;
      assert.equal(first[at('ratio')], 1);
      assert.ok(Math.abs(first[at('fps')] - 1000 / first[at('frame')]) < 1e-6);
      assert.ok(
        results.tables[0].rows.every((row) => row[at('cpu')] === null),
        'no page can tell',
      );
    });

    test('is a file of results that the desktop reports beside its own, column by column', () => {
      const [web, native, html] = ['web.json', 'native.json', 'both.html'].map((file) => join(folder, file));
      writeFileSync(web, JSON.stringify(results));
      const options = ['--depth=1,4', '--shadows=off,hard', '--size=32x24', '--repeats=1'];
      execFileSync(gnomon, ['bench', 'lite', ...options, `--json=${native}`]);
      execFileSync(gnomon, ['report', native, web, '-o', html]);
      const against = execFileSync(gnomon, ['report', '--against', web, web], { encoding: 'utf8' });
      assert.match(against, /the same within noise/);
      const ours = JSON.parse(execFileSync('cat', [native], { encoding: 'utf8' }));
      const { columns, name: table, keys } = ours.tables[0];
      assert.deepEqual(
        {
          columns: results.tables[0].columns.filter(({ key }) => key !== 'gpu'),
          table: results.tables[0].name,
          keys: results.tables[0].keys,
        },
        { columns, table, keys },
      );
      assert.deepEqual(results.charts, ours.charts);
    });

    test('refuses what it does not know, and says what to do', async () => {
      for (const [options, words] of [
        [{ depth: [1, 9] }, 'compare: depth: 9 is out of range; use 1…8'],
        [{ shadows: 'haard' }, "did you mean 'hard'?"],
        [{ shadow: 'off' }, "there is no setting 'shadow'; did you mean 'shadows'?"],
        [{ pause: 'on' }, 'compare: pause: no frame that is drawn for measuring depends on it'],
        [{ scenes: 'lit' }, "compare: scenes: there is no scene 'lit'; there are "],
        [{ scenes: [] }, 'compare: scenes: there is none; name at least one'],
        [{ baseline: 'depth=3' }, "depth is never '3' here; add it to depth"],
        [{ repeats: 0 }, 'compare: repeats: 0 is out of range; use 1…10000'],
        [
          { ...tiny, eye: [1, 2, 3], target: '1,2,3' },
          'the camera looks at its own position; let eye and target differ',
        ],
        [{ ...tiny, scenes: { objects: [{ sphere: { center: [0, 0, 0], radius: -1 } }] } }, 'objects[0]'],
      ]) {
        const said = await refusal(options);
        assert.ok(said.includes(words), `${JSON.stringify(options)}: ${said}`);
      }
    });

    test('ends after the row under way when it is stopped, and keeps the rounds that are done', async () => {
      const stopped = await page.evaluate(async (asked) => {
        const stop = new AbortController();
        const rounds = [];
        const results = await window.gnomon.compare({
          ...asked,
          depth: 1,
          repeats: 1000,
          signal: stop.signal,
          onround: (round) => (rounds.push(round), rounds.length === 2 && stop.abort()),
        });
        return { results, rounds };
      }, tiny);
      assert.match(stopped.results.environment.rounds, /of 1000; interrupted$/);
      assert.equal(stopped.rounds.length, 3, 'two that were whole, and what there was at the end');
      const columns = stopped.results.tables[0].columns.map(({ key }) => key);
      for (const row of stopped.results.tables[0].rows) assert.ok(row[columns.indexOf('rounds')] >= 2);
      assert.ok(!(await page.evaluate(() => document.body.classList.contains('lost'))));
    });

    test('continues in another load of the page with what it measured in this one', async () => {
      const inSession = (options) =>
        page.evaluate(
          async (asked) => {
            let series;
            const results = await window.gnomon.compare({ ...asked, onround: (_, all) => (series = all) });
            return { series, results };
          },
          { ...tiny, repeats: 3, browserSessions: 2, ...options },
        );
      const first = await inSession({ browserSession: 1 });
      assert.equal(first.results.environment.rounds, `webgl2-${name} 2 of 3`);
      await page.reload();
      await page.evaluate(() => window.gnomon.ready);
      const second = await inSession({ browserSession: 2, earlier: first.series });
      assert.equal(second.results.environment.rounds, `webgl2-${name} 3 of 3`);
      for (const row of second.results.tables[0].rows) assert.deepEqual([row[at('rounds')], row[at('passes')]], [3, 2]);
      const numbers = (series) =>
        series
          .trim()
          .split('\n')
          .map((line) => line.trim().split(' '));
      const [before, both] = [numbers(first.series), numbers(second.series)];
      assert.deepEqual(
        both.map((line) => line.slice(0, 1).concat(line.slice(2, 6), line.slice(7, 9))),
        before.map((line) => line.slice(0, 1).concat(line.slice(2, 6), line.slice(7, 9))),
        'the earlier frames stand first',
      );
      // `go` and `goes` are earlier names of `browserSession` and `browserSessions`.
      assert.match(
        await refusal({ ...tiny, repeats: 3, goes: 2, go: 2, earlier: '1 2 three' }),
        /earlier: these are not the rows that are measured here/,
      );
    });

    test('continues without the row that takes the context with it', async () => {
      const after = await page.evaluate(async (asked) => {
        const told = [];
        let lost = false;
        const onprogress = (progress) => {
          if (progress.stage === 'problem') told.push(progress.text);
          if (lost || progress.stage !== 'drawing' || progress.row !== 'lite, size 32x24, depth 1, shadows hard')
            return;
          lost = true;
          const canvas = document.getElementById('lab');
          const loser = canvas.getContext('webgl2').getExtension('WEBGL_lose_context');
          loser.loseContext();
          setTimeout(() => loser.restoreContext(), 100);
        };
        const results = await window.gnomon.compare({ ...asked, repeats: 3, onprogress });
        return { results, told };
      }, tiny);
      assert.deepEqual(after.told, [
        'lite, size 32x24, depth 1, shadows hard: the graphics context was lost while this was drawn',
      ]);
      assert.equal(after.results.environment['left out'], after.told[0]);
      const { rows, columns } = after.results.tables[0];
      assert.deepEqual(
        rows.map((row) => row.slice(3, 5)),
        [
          [1, 'off'],
          [4, 'off'],
          [4, 'hard'],
        ],
      );
      for (const row of rows) assert.equal(row[columns.findIndex(({ key }) => key === 'rounds')], 3);
      assert.ok(!(await page.evaluate(() => document.body.classList.contains('lost'))), 'the view keeps its context');
    });

    test('the view loses its context and gets it back while another measures', async () => {
      const shown = await picture(page);
      const { results, events } = await page.evaluate(async (asked) => {
        const loser = document.getElementById('view').getContext('webgl2').getExtension('WEBGL_lose_context');
        const events = [];
        const off = ['lost', 'restored'].map((event) => window.gnomon.on(event, () => events.push(event)));
        const onround = () => {
          if (events.length) return;
          loser.loseContext();
          setTimeout(() => loser.restoreContext(), 100);
        };
        const results = await window.gnomon.compare({ ...asked, repeats: 6, onround });
        await new Promise((resolve) => setTimeout(resolve, 200));
        off.forEach((end) => end());
        return { results, events };
      }, tiny);
      assert.deepEqual(events, ['lost', 'restored']);
      assert.equal(results.environment.rounds, `webgl2-${name} 6 of 6`);
      assert.equal(results.environment['left out'], undefined);
      assert.equal(differences(shown, await picture(page)), 0);
    });

    test('nothing of the laboratory is left on the page, however often it was used', async () => {
      const ball = { objects: [{ sphere: { center: [0, 0, 0], radius: 1 } }] };
      const shown = await picture(page);
      const answers = await page.evaluate(
        // More than browsers have contexts for at a time.
        async (scene) => {
          const distance = async (far) => (await window.gnomon.traceRays(scene, [0, 0, far, 0, 0, 0, -1, 0]))[1];
          return Promise.all(Array.from({ length: 20 }, (_, i) => distance(i + 2)));
        },
        ball,
      );
      assert.deepEqual(
        answers,
        Array.from({ length: 20 }, (_, i) => i + 1),
      );
      assert.equal(await page.$('#lab'), null);
      assert.equal(differences(shown, await picture(page)), 0);
      assert.ok(!(await page.evaluate(() => document.body.classList.contains('lost'))));
    });

    test('the button opens a dialog that measures, shows a table and gives it away', async () => {
      await page.click('#compare');
      await page.waitForSelector('#compare-dialog[open]');
      await page.evaluate(() => {
        for (const box of document.querySelectorAll('#compare-dialog input'))
          box.checked = { scenes: ['lite'], depth: ['1', '2'], shadows: ['off'], size: ['400x300'] }[box.name].includes(
            box.value,
          );
        document.querySelector('#compare-dialog form').dispatchEvent(new Event('change'));
      });
      const textOf = (selector) => page.$eval(selector, (element) => element.textContent);
      assert.equal(await textOf('#compare-dialog .count'), '2 rows');
      await page.click('#compare-dialog footer .main');
      await until('the second round', async () =>
        /Drawing ([6-9]|\d\d) of 32, about/.test(await textOf('#compare-dialog')),
      );
      await page.keyboard.press('Escape'); // stops it, and what is done stands there
      await page.waitForSelector('#compare-dialog tbody tr');
      assert.ok(await page.$eval('#compare-dialog', (dialog) => dialog.open));
      const cells = await page.$$eval('#compare-dialog tbody tr', (rows) =>
        rows.map((row) => [...row.cells].map((cell) => cell.textContent)),
      );
      assert.deepEqual(
        cells.map(([scene, depth]) => [scene, depth]),
        [
          ['lite', '1'],
          ['lite', '2'],
        ],
      );
      for (const [, , fps, frame, ratio] of cells)
        assert.ok(Number(fps) > 0 && /^[\d.]+…[\d.]+$/.test(frame.slice(frame.length / 3)) && ratio);
      const [opened, kept] = await page.evaluate(() => {
        let opened;
        window.open = (address) => (opened = String(address));
        document.querySelector('#compare-dialog footer .main').click();
        return [opened, JSON.parse(localStorage.getItem('gnomon.results'))];
      });
      assert.equal(opened, `${server.url}report.html`);
      assert.equal(kept[0].format, 'gnomon-results');
      await page.keyboard.press('Escape');
      await until('the dialog closed', () => page.$eval('#compare-dialog', (dialog) => !dialog.open));
    });

    test('complained of nothing', () => page.verify());
  });
