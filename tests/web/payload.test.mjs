// What a visitor downloads before the first picture, images and scenes left out, must stay small. The report's viewer
// is not part of it: tests/web/viewer.test.mjs sees that the page does not load it.
import { gzipSync } from 'node:zlib';
import { join } from 'node:path';
import { readdir, readFile } from 'node:fs/promises';
import { strict as assert } from 'node:assert';
import { test } from 'node:test';
import { site } from './server.mjs';

const mostKilobytes = 300;
// Loads when it is asked for, or when the picture has stood for a while (page/numerics.js).
const later = [
  'assets',
  'report',
  'report.html',
  join('vendor', 'chart.js'),
  'gnomon-lab.js',
  'gnomon-lab.wasm',
  ...['lab.js', 'lab_calls.js', 'compare.js', 'compare.css', 'compare_dialog.js'].map((file) => join('page', file)),
];

test(`program, shaders and page are at most ${mostKilobytes} KB when compressed`, async () => {
  const folder = process.env.GNOMON_SITE ?? site;
  const files = (await readdir(folder, { recursive: true, withFileTypes: true }))
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name))
    .filter((file) => !later.some((path) => file === join(folder, path) || file.startsWith(join(folder, path, '/'))));
  const sizes = await Promise.all(files.map(async (file) => gzipSync(await readFile(file), { level: 9 }).length));
  const kilobytes = sizes.reduce((sum, size) => sum + size, 0) / 1000;
  console.log(`# payload: ${kilobytes.toFixed(1)} KB in ${files.length} files`);
  assert.ok(kilobytes <= mostKilobytes, `${kilobytes.toFixed(1)} KB`);
  for (const file of files.filter((name) => name.endsWith('.js')))
    assert.doesNotMatch(
      await readFile(file, 'utf8'),
      /from\s*['"]\.\/(compare|lab\.|lab_)/,
      `${file} loads at once what is to load later`,
    );
});
