// One browser of each name for all tests of a process: a start takes seconds, a page of its own does not.
import { after } from 'node:test';
import { launch } from './browsers.mjs';

const started = new Map();

/** Runs until the last test is done: close the pages, not the browser. */
export function sharedBrowser(name) {
  if (!started.has(name)) started.set(name, launch(name));
  return started.get(name);
}

after(async () => {
  for (const browser of started.values()) await (await browser).close();
});
