// The report as a page of the site: files dropped and chosen, what the tracer's page left, bad files, and that nobody
// loads it who does not open it.
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { browserNames, openPage, until } from './browsers.mjs';
import { serve } from './server.mjs';
import { sharedBrowser } from './shared_browser.mjs';

const gnomon = process.env.GNOMON_BINARY ?? 'build/native/gnomon';
describe("the report's viewer", () => {
  let folder, bench, shadows, later, broken;

  before(() => {
    folder = mkdtempSync(join(tmpdir(), 'gnomon-viewer-'));
    [bench, shadows, later, broken] = ['bench.json', 'shadows.json', 'later.json', 'broken.json'].map((name) =>
      join(folder, name),
    );
    execFileSync(gnomon, [
      'bench',
      'lite',
      '--depth=1,4',
      '--shadows=off,hard',
      '--size=32x24',
      '--repeats=2',
      `--json=${bench}`,
    ]);
    execFileSync(gnomon, [
      'lab',
      'shadows',
      '--scenes=simple',
      '--models=hard,silhouette',
      '--size=32x24',
      '--reference=16',
      '--repeats=1',
      `--json=${shadows}`,
    ]);
    writeFileSync(later, readFileSync(bench, 'utf8').replace('"version": 1', '"version": 7'));
    writeFileSync(broken, '{"objects": [');
  });
  after(() => rmSync(folder, { recursive: true, force: true }));

  for (const name of browserNames)
    describe(`in ${name}`, () => {
      let server, browser, page;
      before(async () => {
        server = await serve();
        browser = await sharedBrowser(name);
        page = await openPage(browser, `${server.url}report.html`, {
          ready: false,
          viewport: { width: 1100, height: 800 },
        });
      });
      after(async () => {
        page?.verify();
        await page?.close();
        await server?.close();
      });

      const titles = () =>
        page.$$eval('article > h1, article > h2', (all) => all.map((heading) => heading.textContent));
      const problems = () => page.$$eval('#problems p', (all) => all.map((line) => line.textContent));
      /** Several files let go over the page. */
      const drop = (files) =>
        page.evaluate(
          (all) => {
            const dataTransfer = new DataTransfer();
            for (const [name, text] of all)
              dataTransfer.items.add(new File([text], name, { type: 'application/json' }));
            for (const type of ['dragenter', 'dragover', 'drop'])
              document.body.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
          },
          files.map((file) => [file.split('/').at(-1), readFileSync(file, 'utf8')]),
        );

      test('is empty at first, and says what to do', async () => {
        assert.deepEqual(await titles(), []);
        assert.match(await page.$eval('#empty', (element) => element.innerText), /Drop files here, or open them/);
      });

      test('opens several files that are dropped, and draws them', async () => {
        await drop([bench, shadows]);
        await until('two runs', async () => (await titles()).length === 2);
        assert.deepEqual(await titles(), ['Frames a second', 'Shadows: speed against error']);
        assert.ok((await page.$$('canvas')).length > 2);
        assert.equal(await page.$eval('#empty', (element) => element.hidden), true);
      });

      test('opens what the file button chose, by keyboard', async () => {
        await page.evaluate(() =>
          document.getElementById('files').addEventListener('click', (event) => {
            event.preventDefault();
            window.asked = true;
          }),
        );
        await page.focus('.bar .open');
        await page.keyboard.press('Enter');
        assert.equal(await page.evaluate(() => window.asked), true, 'the system asks for files');
        await (await page.$('#files')).uploadFile(bench);
        await until('three runs', async () => (await titles()).filter((title) => title !== 'Together').length === 3);
        assert.equal((await titles())[0], 'Together', 'two benches stand in one table');
      });

      test('refuses a bad file with its name, what is wrong and the remedy; what is shown stays', async () => {
        const shown = await titles();
        await drop([later]);
        await until('a message', async () => (await problems()).length);
        assert.deepEqual(await problems(), [
          'later.json: version: version 7 of results is unknown; this page reads version 1; ' +
            'read it with the gnomon that wrote it',
        ]);
        assert.deepEqual(await titles(), shown);
      });

      test('of several files the good ones are shown, and the message goes with the next', async () => {
        await drop([broken, shadows]);
        await until('another run', async () => (await titles()).filter((title) => /^Shadows/.test(title)).length === 2);
        const [message, ...others] = await problems();
        assert.match(message, /^broken\.json: this is no JSON \(.*\); give a file/);
        assert.deepEqual(others, []);
        await drop([shadows]);
        await until('no message', async () => (await problems()).length === 0);
      });

      test('takes runs away one by one', async () => {
        for (let left = 4; left >= 0; --left) {
          await page.focus('nav button');
          await page.keyboard.press('Enter');
          await until(`${left} left`, async () => (await page.$$('nav li')).length === left);
        }
        assert.equal(await page.$eval('#empty', (element) => element.hidden), false);
        assert.equal(await page.evaluate(() => Object.keys(Chart.instances).length), 0, 'no chart is left behind');
      });

      test('shows what the tracer’s page left, when it opens', async () => {
        await page.evaluate((text) => localStorage.setItem('gnomon.results', `[${text}]`), readFileSync(bench, 'utf8'));
        await page.reload();
        await until('the run', async () => (await titles()).length === 1);
        assert.deepEqual(await problems(), []);
      });

      test('says so where that is no results', async () => {
        for (const text of ['{', '7', '[{"format": "other"}]']) {
          await page.evaluate((value) => localStorage.setItem('gnomon.results', value), text);
          await page.reload();
          await until('a message', async () => (await problems()).length === 1);
          assert.match(
            (await problems())[0],
            /^What the tracer's page left is no results \(.+\); measure there once more, or open a file\.$/,
          );
          assert.equal(await page.$eval('#empty', (element) => element.hidden), false);
        }
        await page.evaluate(() => localStorage.clear());
      });
    });

  test('the tracer’s page loads nothing of it, and links to it', async () => {
    const server = await serve();
    const browser = await sharedBrowser('chromium');
    const requests = [];
    const page = await openPage(browser, `${server.url}?size=32x24`, {
      before: (page) => page.on('request', (request) => requests.push(request.url())),
    });
    assert.deepEqual(
      requests.filter((url) => /report|chart/.test(url)),
      [],
    );
    await page.click('#keys');
    assert.equal(await page.$eval('#help footer a', (link) => link.href), `${server.url}report.html`);
    page.verify();
    await page.close();
    await server.close();
  });
});
