// Shows results (docs/results.md) of one run or several: what made them, charts, tables that sort, pictures.

import { element } from './elements.js';
import { chartsOf } from './charts.js';
import { galleryOf, picturesOf } from './pictures.js';
import { tableOf } from './tables.js';
import { together } from './together.js';

/** Charts, tables and pictures, under headings of `level`. */
function partsOf(results, drawn, level) {
  const below = `h${level}`;
  const parts = results.charts.map((chart) => {
    const table = drawn.find(({ name }) => name === chart.table);
    return chartsOf(chart, table, picturesOf(results, table), below);
  });
  for (const table of results.tables) {
    if (!table.rows.length) continue;
    const pictures = picturesOf(results, table);
    parts.push(tableOf(table, pictures, below));
    if (pictures.all.length) parts.push(galleryOf(pictures, below));
  }
  return parts;
}

/** One run, under a heading of `level`. */
function runOf(results, level, id) {
  const environment = element('dl');
  for (const [name, value] of Object.entries(results.environment))
    environment.append(element('dt', { textContent: name }), element('dd', { textContent: value }));
  const command = element('code', { className: 'command', textContent: results.command });
  return element(
    'article',
    { id },
    element(`h${level}`, { textContent: results.title }),
    command,
    environment,
    ...partsOf(results, results.tables, level + 1),
  );
}

/** Where several runs stand on the page, what tells them apart, and a button that takes one away. */
function contentsOf(runs, remove) {
  const told = ['date', 'commit', 'context', 'renderer'];
  const entries = runs.map(({ title, environment }, i) => {
    const entry = element(
      'li',
      {},
      element('a', { href: `#run-${i + 1}`, textContent: title }),
      ' ',
      element('small', {
        textContent: told
          .map((name) => environment[name])
          .filter(Boolean)
          .join(' · '),
      }),
    );
    if (remove) {
      const button = element('button', {
        type: 'button',
        textContent: 'Remove',
        ariaLabel: `Remove run ${i + 1}: ${title}`,
      });
      button.addEventListener('click', () => remove(i));
      entry.append(' ', button);
    }
    return entry;
  });
  return element('nav', { ariaLabel: 'Runs' }, element('ol', {}, ...entries));
}

/** Takes away what showResults() made. */
export function clearResults(place) {
  for (const canvas of place.querySelectorAll('canvas')) Chart.getChart(canvas)?.destroy();
  place.replaceChildren();
}

/** `remove(index)`: where runs may be taken away. */
export function showResults(runs, place, remove) {
  const one = runs.length === 1;
  const all = together(runs);
  clearResults(place);
  document.title = one ? runs[0].title : `Gnomon: ${runs.length} results`;
  if (!one) place.append(element('h1', { textContent: document.title }));
  if (!one || remove) place.append(contentsOf(runs, remove));
  const level = one ? 1 : 2;
  if (all)
    place.append(
      element(
        'article',
        { id: 'together' },
        element(`h${level}`, { textContent: all.title }),
        ...partsOf(all, all.drawn, level + 1),
      ),
    );
  runs.forEach((run, i) => place.append(runOf(run, level, `run-${i + 1}`)));
}
