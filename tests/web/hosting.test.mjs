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

    test('lies under any path of a server that knows few types', async () => {
      await withPage({ path: '/some/where/', plainTypes: true }, {}, async (page) => {
        assert.ok(new Set((await picture(page)).data).size > 50);
      });
    });
  });
