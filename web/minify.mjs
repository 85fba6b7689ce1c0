// Writes files of the page as a visitor downloads them: modules minified, so that comments and long names stay in the
// repository, all else as it is.
//
//   node web/minify.mjs FROM TO   two modules, or two folders: what is newer in FROM is written, what is gone from it
//                                 is removed
import { copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { minify } from 'terser';

const [from, to] = process.argv.slice(2);

const isNewer = (file, than) => statSync(file).mtimeMs > (statSync(than, { throwIfNoEntry: false })?.mtimeMs ?? 0);

async function write(source, target) {
  if (!source.endsWith('.js')) return copyFileSync(source, target);
  const { code } = await minify(readFileSync(source, 'utf8'), { module: true, compress: true, mangle: true });
  writeFileSync(target, code);
}

async function mirror(source, target) {
  mkdirSync(target, { recursive: true });
  const names = readdirSync(source);
  for (const name of readdirSync(target)) if (!names.includes(name)) rmSync(join(target, name), { recursive: true });
  for (const name of names)
    if (isNewer(join(source, name), join(target, name))) await write(join(source, name), join(target, name));
}

await (statSync(from).isDirectory() ? mirror : write)(from, to);
