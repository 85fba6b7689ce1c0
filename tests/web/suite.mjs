// All tests of the page in one process, which starts each browser once; a file of them runs by itself as well.
//
//   node --test tests/web/suite.mjs
import { readdirSync } from 'node:fs';

for (const file of readdirSync(new URL('.', import.meta.url)).sort())
  if (file.endsWith('.test.mjs')) await import(new URL(file, import.meta.url));
