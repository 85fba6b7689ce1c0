// A table of results: sorts by a click on a heading, tells the quartiles beside a median, opens the picture of a row.

import { element } from './elements.js';
import { betterOf, columnsOf, rowsOf } from './columns.js';
import { openPicture } from './pictures.js';

const kinds = {
  time: 'A time: differs from run to run.',
  ratio: 'A ratio of times of one run: differs from run to run, less than times.',
  error: 'An error: computed alike in every run.',
  count: 'A count: the same in every run.',
};

const byValue = (key, direction) => (a, b) => {
  const [x, y] = [a[key], b[key]];
  if (x === null || y === null) return (x === null) - (y === null); // what is not there comes last, either way
  return (
    direction *
    (typeof x === 'number' && typeof y === 'number'
      ? x - y
      : String(x).localeCompare(String(y), 'en', { numeric: true }))
  );
};

const spaced = ({ spread }, cell) => {
  if (spread) cell.style.setProperty('--spread', `${spread.toFixed(1)}em`);
  return cell;
};

function cellOf({ key, format, word, spreadOf }, row) {
  const cell = element('td', { className: word ? `word ${row[key]}` : '', textContent: format(row[key]) });
  if (spreadOf) cell.append(element('small', { textContent: spreadOf(row) }));
  return cell;
}

function rowOf(row, columns, pictures) {
  const made = element('tr', {}, ...columns.map((column) => spaced(column, cellOf(column, row))));
  const picture = pictures.of(row);
  if (!picture) return made;
  const look = element('button', { type: 'button', className: 'look', ariaLabel: `Picture: ${picture.title}` });
  made.className = 'pictured';
  made.cells[0].prepend(look);
  made.addEventListener('click', () => openPicture(picture, pictures.images));
  return made;
}

/** What the pointer learns of a heading. */
function helpOf(column) {
  const better = betterOf(column);
  return [column.help, kinds[column.kind], better && `${better === 'lower' ? 'Lower' : 'Higher'} is better.`]
    .filter(Boolean)
    .join('\n');
}

export function tableOf(table, pictures, heading) {
  const rows = rowsOf(table);
  const columns = columnsOf(table, rows);
  const body = element('tbody');
  const fill = () => body.replaceChildren(...rows.map((row) => rowOf(row, columns, pictures)));
  const heads = columns.map((column) => {
    const { key, title, unit, word, spread } = column;
    const button = element('button', { type: 'button', title: helpOf(column) }, title);
    button.append(element('small', { textContent: unit }));
    const head = element('th', { scope: 'col', className: word ? 'word' : spread ? 'spread' : '' }, button);
    spaced({ spread }, head);
    button.addEventListener('click', () => {
      const direction = head.getAttribute('aria-sort') === 'descending' ? 1 : -1;
      for (const other of heads) other.removeAttribute('aria-sort');
      head.setAttribute('aria-sort', direction > 0 ? 'ascending' : 'descending');
      rows.sort(byValue(key, direction));
      fill();
    });
    return head;
  });
  fill();
  const grid = element('table', {}, element('thead', {}, element('tr', {}, ...heads)), body);
  const section = element('section', {}, element(heading, { textContent: table.title }));
  const spread = columns.some((column) => column.spread)
    ? 'Small beside a median: the quartiles of the rounds; beside the ratio of two runs: what noise leaves of it. '
    : '';
  const look = pictures.all.length ? 'A click on a row shows its picture. ' : '';
  if (spread || look)
    section.append(
      element(
        'p',
        { className: 'note' },
        spread,
        element('span', {
          className: 'screen',
          textContent: `${look}A heading tells more under the pointer and sorts by a click.`,
        }),
      ),
    );
  section.append(element('div', { className: 'table' }, grid));
  return section;
}
