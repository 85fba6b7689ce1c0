// The report as a page of the site: shows results from files that are dropped or chosen, and those that the tracer's
// page left.

import { element } from './elements.js';
import { checkedResults, readResults } from './read.js';
import { clearResults, showResults } from './report.js';

const kept = 'gnomon.results'; // in localStorage: a list of results
const runs = [];
const place = document.getElementById('report');
const empty = document.getElementById('empty');
const problems = document.getElementById('problems');

function show() {
  empty.hidden = runs.length > 0;
  if (runs.length)
    return showResults(runs, place, (index) => {
      runs.splice(index, 1);
      show();
    });
  clearResults(place);
  document.title = 'Gnomon results';
}

/** What is wrong stands there until the next files come. */
const tell = (messages) =>
  problems.replaceChildren(...messages.map((message) => element('p', { textContent: message })));

async function open(files) {
  const wrong = [];
  for (const file of files)
    try {
      runs.push(readResults(await file.text()));
    } catch (error) {
      const unreadable = /^Not(Found|Readable)Error$/.test(error.name);
      wrong.push(`${file.name}: ${unreadable ? 'cannot be read; give files, no folders' : error.message}`);
    }
  if (wrong.length < files.length) show();
  tell(wrong);
}

function openKept() {
  const text = localStorage.getItem(kept);
  if (text === null) return;
  try {
    const all = JSON.parse(text);
    if (!Array.isArray(all)) throw new Error('is no list of results');
    runs.push(...all.map(checkedResults));
  } catch (error) {
    tell([`What the tracer's page left is no results (${error.message}); measure there once more, or open a file.`]);
  }
}

function connect() {
  const input = document.getElementById('files');
  for (const button of document.querySelectorAll('.open')) button.addEventListener('click', () => input.click());
  input.addEventListener('change', () => {
    open([...input.files]);
    input.value = ''; // the same file may be opened again
  });
  let inside = 0;
  const mark = (change) => document.body.classList.toggle('dropping', (inside = Math.max(0, inside + change)) > 0);
  document.addEventListener('dragenter', () => mark(1));
  document.addEventListener('dragleave', () => mark(-1));
  document.addEventListener('dragover', (event) => event.preventDefault());
  document.addEventListener('drop', (event) => {
    event.preventDefault();
    mark(-inside);
    open([...event.dataTransfer.files]);
  });
}

connect();
openKept();
show();
