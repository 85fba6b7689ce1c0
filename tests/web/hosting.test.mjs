// The page where browser or server lack something, each time in a page of its own.
import { before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { browserNames, openPage, picture, until } from './browsers.mjs';
import { serve } from './server.mjs';
import { sharedBrowser } from './shared_browser.mjs';

const query = 'size=160x120&pause=on';

for (const name of browserNames)
  describe(`hosting, ${name}`, () => {
    let browser;
    before(async () => (browser = await sharedBrowser(name)));

    /** Serves the page as `hosting` says and opens it. */
    const withPage = async (hosting, options, use) => {
      const server = await serve(hosting);
      const page = await openPage(browser, `${server.url}?${query}`, options);
      try {
        await use(page);
        page.verify();
      } finally {
        await page.close();
        await server.close();
      }
    };
    const said = (page) => page.$eval('#splash', (element) => element.textContent);

    test('a browser without WebGL 2 is told so', async () => {
      const before = (page) =>
        page.evaluateOnNewDocument(() => {
          HTMLCanvasElement.prototype.getContext = () => null;
        });
      await withPage({}, { before, ready: false }, async (page) => {
        await until('the message', async () => (await said(page)).includes('WebGL 2'));
      });
    });

    test('a missing program is told, not a white page', async () => {
      const options = { ready: false, expectErrors: [/404/, /wasm/] };
      await withPage({ missing: /gnomon\.wasm$/ }, options, async (page) => {
        await until('the message', async () => (await said(page)).includes('gnomon.wasm'));
      });
    });

    test('who saves data downloads the laboratory on asking only', async () => {
      const requests = [];
      const before = async (page) => {
        page.on('request', (request) => requests.push(new URL(request.url()).pathname));
        await page.evaluateOnNewDocument(() => {
          Object.defineProperty(navigator, 'connection', { value: { saveData: true } });
        });
      };
      const asked = () => requests.filter((path) => /lab[._]|compare/.test(path)).sort();
      await withPage({}, { before }, async (page) => {
        await new Promise((resolve) => setTimeout(resolve, 4000)); // else two seconds would do
        assert.deepEqual(asked(), []);
        assert.equal(await page.$eval('#numerics', ({ textContent }) => textContent), '');
        assert.equal((await page.evaluate(() => window.gnomon.numerics())).holds, true);
        assert.deepEqual(asked(), ['/gnomon-lab.js', '/gnomon-lab.wasm', '/page/lab.js', '/page/lab_calls.js']);
      });
    });

    test('a missing laboratory is told where it is asked for, and the view lives', async () => {
      const words = /gnomon-lab\.wasm: the server does not have it \(404\)/;
      await withPage({ missing: /gnomon-lab\.wasm$/ }, { expectErrors: [/404/] }, async (page) => {
        const numerics = () => page.$eval('#numerics', ({ textContent, title }) => textContent && [textContent, title]);
        const [text, why] = await until('the read-out', numerics);
        assert.equal(text, ' · numerics not measured');
        assert.match(why, words);
        const refusals = await page.evaluate(() => {
          const { compare, numerics, traceRays } = window.gnomon;
          const asked = [compare({ scenes: 'lite' }), numerics(), traceRays({ objects: [] }, [])];
          return Promise.all(asked.map((one) => one.catch(({ message }) => message)));
        });
        assert.equal(refusals.length, 3);
        for (const refusal of refusals) assert.match(refusal, words);
        await page.click('#compare');
        await page.waitForSelector('#compare-dialog[open]');
        await page.click('#compare-dialog footer .main');
        const said = await page.waitForSelector('#compare-dialog .wrong');
        assert.match(await said.evaluate((element) => element.textContent), words);
        assert.equal(await page.$('#messages .problem'), null, 'no second message');
        assert.equal(await page.$('#lab'), null);
        assert.ok(new Set((await picture(page)).data).size > 50);
      });
    });

    test('lies under any path of a server that knows few types', async () => {
      await withPage({ path: '/some/where/', plainTypes: true }, {}, async (page) => {
        assert.ok(new Set((await picture(page)).data).size > 50);
        assert.equal((await page.evaluate(() => window.gnomon.numerics())).rays, 2048);
      });
    });
  });
