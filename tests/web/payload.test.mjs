// What a visitor downloads before the first picture, images and scenes left out, must stay small.
import { gzipSync } from 'node:zlib';
import { join, relative } from 'node:path';
import { readdir, readFile } from 'node:fs/promises';
import { strict as assert } from 'node:assert';
import { test } from 'node:test';
import { site } from './server.mjs';

const mostKilobytes = 250;
const later = /^page\/compare/; // loads when it is asked for

test(`program, shaders and page are at most ${mostKilobytes} KB when compressed`, async () => {
  const folder = process.env.GNOMON_SITE ?? site;
  const files = (await readdir(folder, { recursive: true, withFileTypes: true }))
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath ?? entry.path, entry.name))
    .filter((file) => !file.startsWith(join(folder, 'assets')) && !later.test(relative(folder, file)));
  const sizes = await Promise.all(files.map(async (file) => gzipSync(await readFile(file), { level: 9 }).length));
  const kilobytes = sizes.reduce((sum, size) => sum + size, 0) / 1000;
  console.log(`# payload: ${kilobytes.toFixed(1)} KB in ${files.length} files`);
  assert.ok(kilobytes <= mostKilobytes, `${kilobytes.toFixed(1)} KB`);
  for (const file of files.filter((name) => name.endsWith('.js')))
    assert.doesNotMatch(await readFile(file, 'utf8'), /from '\.\/compare/, `${file} loads at once what is to load later`);
});
