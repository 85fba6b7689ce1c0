// The page's modules that need no browser.
import { strict as assert } from 'node:assert';
import { test } from 'node:test';
import { keyName } from '../../web/page/keyboard.js';
import { unturned } from '../../web/page/load.js';
import { keysOf } from '../../web/page/stick.js';
import { parseSize } from '../../web/page/canvas.js';
import { readQuery, writeQuery } from '../../web/page/url.js';

test('moving keys go by place, letters by cap, digits by place', () => {
  assert.equal(keyName({ code: 'KeyW', key: 'z' }), 'W'); // French layout
  assert.equal(keyName({ code: 'KeyZ', key: 'w' }), null); // its W lies elsewhere: no second forward
  assert.equal(keyName({ code: 'KeyA', key: 'q' }), 'A');
  assert.equal(keyName({ code: 'KeyQ', key: 'a' }), null);
  assert.equal(keyName({ code: 'Digit1', key: '&' }), '1');
  assert.equal(keyName({ code: 'KeyU', key: 'g' }), 'G'); // Dvorak
  assert.equal(keyName({ code: 'KeyG', key: 'п' }), 'G'); // Russian layout
  assert.equal(keyName({ code: 'ShiftLeft', key: 'Shift' }), 'Shift');
  assert.equal(keyName({ code: 'ArrowUp', key: 'ArrowUp' }), 'Up');
  assert.equal(keyName({ code: 'Tab', key: 'Tab' }), null);
});

test('the stick stands for keys in eight directions, half speed near its middle', () => {
  assert.deepEqual([...keysOf(0.1, 0.1)], []);
  assert.deepEqual([...keysOf(0, -1)], ['W']);
  assert.deepEqual([...keysOf(0.7, -0.7)], ['W', 'D']);
  assert.deepEqual([...keysOf(-0.4, 0)], ['A', 'Shift']);
});

test('a size is WxH and nothing else', () => {
  assert.deepEqual(parseSize('160x120'), { width: 160, height: 120 });
  for (const wrong of [null, '', '160', '160x', 'x120', '1.5x2', '-1x1']) assert.equal(parseSize(wrong), null);
});

test('the address holds what differs, and time only while it stands still', () => {
  const state = { changed: 'depth=5&time=1.25&pause=on&eye=0,1,2', scene: 'pro', size: null, pausedAtStart: false };
  assert.equal(writeQuery({ ...state, paused: true }), 'scene=pro&depth=5&time=1.25&eye=0,1,2&pause=on');
  assert.equal(writeQuery({ ...state, paused: false }), 'scene=pro&depth=5&eye=0,1,2');
  assert.equal(writeQuery({ ...state, paused: false, pausedAtStart: true }), 'scene=pro&depth=5&eye=0,1,2&pause=off');
  assert.equal(
    writeQuery({ changed: '', scene: null, size: '160x120', paused: false, pausedAtStart: false }),
    'size=160x120',
  );
});

test('the query is read as scene, size and settings', () => {
  const { scene, size, values } = readQuery('?scene=pro&size=10x20&depth=5');
  assert.deepEqual([scene, size], ['pro', '10x20']);
  assert.deepEqual(values, [
    ['size', '10x20'],
    ['depth', '5'],
  ]);
});

test("a JPEG's metadata becomes a comment before a browser sees it, and nothing else changes", () => {
  const frame = [0xff, 0xc0, 0, 4, 1, 2];
  const scan = [0xff, 0xda, 0, 2, 0xff, 0xe1, 0, 9]; // what follows is no segment
  const jpeg = (exif) => Uint8Array.from([0xff, 0xd8, 0xff, exif, 0, 5, 7, 8, 9, ...frame, ...scan]);
  assert.deepEqual(unturned(jpeg(0xe1)), jpeg(0xfe));
  assert.deepEqual(unturned(jpeg(0xe0)), jpeg(0xe0));
  assert.deepEqual(unturned(Uint8Array.from([0xff, 0xd8, 0xff])), Uint8Array.from([0xff, 0xd8, 0xff])); // it was cut
});
