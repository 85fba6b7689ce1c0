// Several files of tests in one process, which share their browsers: node tests/web/suite.mjs FILE …
import { pathToFileURL } from 'node:url';

for (const file of process.argv.slice(2)) await import(pathToFileURL(file));
