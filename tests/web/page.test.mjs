// The page in real browsers: keys, mouse, fingers, address, lost contexts, and what it says when something is wrong.
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { browserNames, differences, launch, openPage, picture, until } from './browsers.mjs';
import { eyeOf, far, get, goHome, numbers, set, targetOf } from './page_values.mjs';
import { serve } from './server.mjs';
import { sharedBrowser } from './shared_browser.mjs';

const small = 'size=160x120'; // a software renderer traces it
const still = `${small}&pause=on`;

const textOf = (page, selector) => page.$eval(selector, (element) => element.textContent);
/** A spot of the picture that nothing lies over. */
const spot = { x: 300, y: 240 };

for (const name of browserNames)
  describe(`the page in ${name}`, () => {
    let server, browser, page;

    before(async () => {
      server = await serve();
      browser = await sharedBrowser(name);
      page = await openPage(browser, `${server.url}?${small}`);
    });
    after(async () => {
      await page?.close();
      await server?.close();
    });

    /** Opens a page of its own, and closes it. */
    const withPage = async (query, options, use) => {
      const own = await openPage(browser, `${server.url}?${query}`, options);
      try {
        await use(own);
        own.verify();
      } finally {
        await own.close();
        await page.bringToFront(); // only the page in front gets frames
      }
    };

    test('draws, and complains of nothing', async () => {
      await until('the first frame', () => page.evaluate(() => window.gnomon.firstFrameMs));
      const { ms, stats } = await page.evaluate(() => ({
        ms: window.gnomon.firstFrameMs,
        stats: window.gnomon.stats(),
      }));
      console.log(
        `# ${name}: first frame after ${Math.round(ms)} ms, shader ${Math.round(stats.compileMs)} ms, ` +
          stats.renderer,
      );
      const { data, width, height } = await picture(page);
      assert.deepEqual([width, height], [160, 120]);
      assert.ok(new Set(data).size > 50, 'the picture has many values');
      page.verify();
    });

    test('counts frames on the page and in the title', async () => {
      await until('a frame rate', () => page.evaluate(() => window.gnomon.fps > 0));
      await until('the read-out', async () => /^\d/.test(await textOf(page, '#fps')));
      await until('the title', async () => /Gnomon – lite – \d+ FPS/.test(await page.title()));
    });

    for (const { key, setting, from, to } of [
      { key: 'ArrowRight', setting: 'depth', from: '4', to: '5' },
      { key: 'ArrowLeft', setting: 'depth', from: '5', to: '4' },
      { key: '1', setting: 'shadows', from: 'hard', to: 'off' },
      { key: 'g', setting: 'glow', from: 'on', to: 'off' },
      { key: 'n', setting: 'normal-maps', from: 'on', to: 'off' },
      { key: 'p', setting: 'pause', from: 'off', to: 'on' },
      { key: 'ArrowUp', setting: 'color-mode', from: 'rgb', to: 'rbr' },
      { key: 'ArrowDown', setting: 'color-mode', from: 'rbr', to: 'rgb' },
    ])
      test(`${key} changes ${setting} from ${from} to ${to} and the page says so`, async () => {
        await set(page, setting, from);
        await page.keyboard.press(key);
        await until('the change', async () => (await get(page, setting)) === to);
        await until('the note', async () => (await textOf(page, '.notes')).includes(`${setting} ${to}`));
      });

    test('depth stops at 1 and 8, and the read-out shows it', async () => {
      for (let i = 0; i < 10; ++i) await page.keyboard.press('ArrowRight');
      assert.equal(await get(page, 'depth'), '8');
      await until('the read-out', async () => (await textOf(page, '#state')).includes('depth 8'));
      for (let i = 0; i < 10; ++i) await page.keyboard.press('ArrowLeft');
      assert.equal(await get(page, 'depth'), '1');
      await set(page, 'depth', '4');
    });

    test('v says that v-sync is not ours here', async () => {
      await page.keyboard.press('v');
      await until('the note', async () => (await textOf(page, '.notes')).includes('v-sync'));
      assert.equal(await get(page, 'vsync'), 'on');
    });

    test('keys with Ctrl, and keys typed into a field, are not ours', async () => {
      await set(page, 'glow', 'on');
      await page.keyboard.down('Control');
      await page.keyboard.press('g');
      await page.keyboard.up('Control');
      await page.focus('#scene');
      await page.keyboard.press('g');
      await page.evaluate(() => document.activeElement.blur());
      assert.equal(await get(page, 'glow'), 'on');
    });

    test('a mouse drag looks around without moving', async () => {
      await goHome(page);
      await page.mouse.move(spot.x, spot.y);
      await page.mouse.down();
      await page.mouse.move(spot.x + 60, spot.y + 20, { steps: 3 });
      await page.mouse.up();
      assert.deepEqual(await eyeOf(page), [0, 0, 35]);
      assert.ok(far(await targetOf(page), [0, 0, 0]) > 1);
      const turned = await targetOf(page);
      await page.mouse.move(spot.x, spot.y);
      assert.deepEqual(await targetOf(page), turned, 'the button is up');
    });

    test('the wheel moves along the view', async () => {
      await goHome(page);
      await page.mouse.move(spot.x, spot.y);
      await page.mouse.wheel({ deltaY: -100 });
      await until('the move', async () => (await eyeOf(page))[2] < 34.5);
    });

    test('one finger looks around, two fingers move', async () => {
      await goHome(page);
      const finger = await page.touchscreen.touchStart(spot.x, spot.y);
      await finger.move(spot.x + 50, spot.y);
      await finger.end();
      assert.ok(far(await targetOf(page), [0, 0, 0]) > 1);
      assert.deepEqual(await eyeOf(page), [0, 0, 35]);

      await goHome(page);
      // Two real touch points at once are not possible in every driver: made-up pointers take the same way through the
      // page.
      await page.evaluate(({ x, y }) => {
        const canvas = document.getElementById('view');
        const point = (type, pointerId, dx) =>
          canvas.dispatchEvent(
            new PointerEvent(type, {
              pointerId,
              pointerType: 'touch',
              clientX: x + dx,
              clientY: y,
              bubbles: true,
              cancelable: true,
              isPrimary: pointerId === 71,
            }),
          );
        point('pointerdown', 71, -30);
        point('pointerdown', 72, 30);
        point('pointermove', 71, -60);
        point('pointermove', 72, 60);
        point('pointerup', 71, -60);
        point('pointerup', 72, 60);
      }, spot);
      assert.ok((await eyeOf(page))[2] < 34, 'spreading the fingers moves forward');
    });

    test('a touch brings the stick, and the stick walks', async () => {
      await goHome(page);
      const box = await (await page.waitForSelector('#stick', { visible: true })).boundingBox();
      const finger = await page.touchscreen.touchStart(box.x + box.width / 2, box.y + box.height / 2);
      await finger.move(box.x + box.width / 2, box.y + 4);
      await until('the walk', async () => (await eyeOf(page))[2] < 34.5);
      await finger.end();
      const stopped = await eyeOf(page);
      await new Promise((resolve) => setTimeout(resolve, 300));
      assert.deepEqual(await eyeOf(page), stopped);
    });

    test('the panel has a control for every setting, and it works', async () => {
      await page.waitForSelector('#panel .lil-gui');
      const { rows, controls } = await page.evaluate(() => ({
        rows: window.gnomon.table().length,
        controls: document.querySelectorAll('#panel .lil-controller').length,
      }));
      assert.equal(controls, rows - 2); // size and vsync belong to the window
      await set(page, 'glow', 'on');
      await page.evaluate(() => {
        const control = [...document.querySelectorAll('#panel .lil-boolean')].find((row) =>
          row.textContent.includes('Glow'),
        );
        control.querySelector('input').click();
      });
      assert.equal(await get(page, 'glow'), 'off');
      await set(page, 'glow', 'on');
    });

    test('the help lists the keys of the table', async () => {
      await page.keyboard.press('h');
      await page.waitForSelector('#help[open]');
      const help = await textOf(page, '#help');
      for (const cap of ['→', '←', '↑', '↓', 'G', 'N', 'P', '1', 'W']) assert.ok(help.includes(cap), cap);
      await page.keyboard.press('Escape');
      await until('the help closed', () => page.$eval('#help', (dialog) => !dialog.open));
    });

    test('the address restores scene, camera and settings', async () => {
      for (const [key, value] of [
        ['pause', 'on'],
        ['time', '1.5'],
        ['depth', '3'],
        ['shadows', 'off'],
        ['glow', 'off'],
        ['normal-maps', 'on'],
        ['color-mode', 'bgr'],
      ])
        await set(page, key, value);
      await set(page, 'eye', '1,2,30');
      await set(page, 'target', '0.5,-1,0');
      await page.evaluate(() => window.gnomon.load('torus'));
      await set(page, 'eye', '2,3,9');
      const wanted = await page.evaluate(() => window.gnomon.settings());
      const shown = await picture(page);
      await until(
        'the address',
        async () =>
          /scene=torus.*eye=2,3,9/.test(page.url()) ||
          /scene=torus.*eye=2,3,9/.test(await page.evaluate(() => location.search)),
      );
      const query = (await page.evaluate(() => location.search)).slice(1);
      assert.ok(!query.includes('normal-maps') && !query.includes('scale'), `only what differs: ${query}`);
      await withPage(query, {}, async (restored) => {
        const { eye, target, ...others } = await restored.evaluate(() => window.gnomon.settings());
        const { eye: eyeWanted, target: targetWanted, ...othersWanted } = wanted;
        assert.deepEqual(others, othersWanted);
        assert.ok(far(numbers(eye), numbers(eyeWanted)) < 1e-5, eye);
        assert.ok(far(numbers(target), numbers(targetWanted)) < 1e-5, target);
        assert.equal(await restored.evaluate(() => window.gnomon.scene), 'torus');
        const wrong = differences(shown, await picture(restored), 1);
        assert.ok(wrong <= 8, `${wrong} bytes differ`);
      });
    });

    test('a lost context comes back with the same picture', async () => {
      await withPage(`${still}&time=2`, {}, async (own) => {
        const before = await picture(own);
        await own.evaluate(() => {
          const gl = document.getElementById('view').getContext('webgl2');
          window.loser = gl.getExtension('WEBGL_lose_context');
          window.loser.loseContext();
        });
        await until('the message', async () => (await textOf(own, '.problems')).includes('context was lost'));
        await own.keyboard.press('ArrowRight'); // what happens meanwhile is not lost
        await own.keyboard.press('ArrowLeft');
        await own.evaluate(() => window.gnomon.set('glow', 'on'));
        await own.evaluate(() => window.loser.restoreContext());
        await until('the message gone', async () => !(await textOf(own, '.problems')).includes('context was lost'));
        assert.equal(differences(before, await picture(own)), 0);
      });
    });

    test('bad parameters and a bad scene name are told, and the view lives', async () => {
      const options = { expectErrors: [/404/, /nowhere/] };
      await withPage(`${still}&depth=99&shadow=off&scene=nowhere&eye=1,2`, options, async (own) => {
        const said = await textOf(own, '.problems');
        for (const part of [
          'depth: 99 is out of range',
          "did you mean 'shadows'",
          "no scene 'nowhere'",
          "'1,2' is not a point",
        ])
          assert.ok(said.includes(part), `${part} in: ${said}`);
        assert.equal(await own.evaluate(() => window.gnomon.scene), 'lite');
        assert.ok(new Set((await picture(own)).data).size > 50);
      });
    });

    test('a bad scene is told with its place, and the old one stays', async () => {
      const before = await page.evaluate(() => window.gnomon.scene);
      const message = await page.evaluate(() =>
        window.gnomon.load({ objects: [{ sphere: { center: [0, 0, 0], radius: -1 } }] }).then(
          () => '',
          (error) => error.message,
        ),
      );
      assert.match(message, /objects\[0\].*radius/);
      assert.equal(await page.evaluate(() => window.gnomon.scene), before);
      await picture(page);
    });

    test('outputs come back as floats', async () => {
      await page.evaluate(() => window.gnomon.load('lite'));
      const output = await page.evaluate(async () => {
        const { width, height, channels, data } = await window.gnomon.readOutput('distance');
        return { width, height, channels, least: Math.min(...data), aov: window.gnomon.get('aov') };
      });
      assert.deepEqual([output.width, output.height, output.channels, output.aov], [160, 120, 1, 'color']);
      assert.ok(output.least > 10 && output.least < 35, `nearest surface ${output.least}`);
      const bench = await page.evaluate(() => window.gnomon.bench({ frames: 3 }));
      assert.ok(bench.medianMs > 0 && bench.minMs <= bench.medianMs && bench.medianMs <= bench.maxMs);
    });

    test('a half resolution keeps the canvas and its picture', async () => {
      await set(page, 'scale', '0.5');
      assert.equal((await picture(page)).width, 160);
      await until('the read-out', async () => (await textOf(page, '#state')).includes('80 × 60'));
      await set(page, 'scale', '1');
      page.verify();
    });

    test('the canvas follows window and pixel ratio', async () => {
      const size = (own) => own.$eval('#view', (canvas) => `${canvas.width}x${canvas.height}`);
      await withPage(
        'pause=on&depth=1&shadows=off',
        { viewport: { width: 120, height: 90, deviceScaleFactor: 2 } },
        async (own) => {
          await until('240x180', async () => (await size(own)) === '240x180');
          await own.setViewport({ width: 150, height: 100, deviceScaleFactor: 1 });
          await until('150x100', async () => (await size(own)) === '150x100');
          assert.equal((await picture(own)).width, 150);
        },
      );
    });

    test('starts paused where the system asks for little motion', async () => {
      const calm = await launch(name, { calm: true });
      try {
        const own = await openPage(calm, `${server.url}?${small}`);
        assert.equal(await get(own, 'pause'), 'on');
        assert.ok(!(await own.evaluate(() => location.search)).includes('pause'));
        own.verify();
      } finally {
        await calm.close();
      }
    });

    test('a still picture becomes sharp, also where the GPU is slow', async () => {
      const shown = (own) => own.evaluate(() => window.gnomon.sharpFrameMs);
      await withPage('scene=pro&size=320x240&pause=on', {}, async (own) => {
        await until('the full resolution', () => shown(own));
        assert.ok((await shown(own)) >= (await own.evaluate(() => window.gnomon.firstFrameMs)));
      });
    });

    test('complained of nothing all along', () => page.verify());
  });
