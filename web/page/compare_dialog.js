// The dialog that compares frame rates: what to draw, how far it is, and what came of it.

import { compare } from './compare.js';
import { label } from './labels.js';

const sizes = ['400x300', '800x600', '1280x720', '1920x1080'];
const chosenAtFirst = { scenes: ['lite', 'pro'], depth: ['1', '4', '8'], shadows: ['off', 'hard'], size: ['800x600'] };
const limits = [
  ['1 minute', 60],
  ['2½ minutes', 150],
  ['10 minutes', 600],
  ['an hour', 3600],
];
const standardLimit = 150;

const runs = []; // all results of this visit, for the report

function make(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** A row of boxes to tick; at least one always is. */
function choices(name, title, values) {
  const boxes = values.map((value) => {
    const box = make('input', { type: 'checkbox', name, value, checked: chosenAtFirst[name].includes(value) });
    return make('label', {}, box, make('span', { textContent: sizeText(value) }));
  });
  return make('fieldset', {}, make('legend', { textContent: title }), make('div', { className: 'choices' }, ...boxes));
}

function rangeOf(table, key) {
  const row = table.find((candidate) => candidate.key === key);
  return row.names ?? Array.from({ length: row.max - row.min + 1 }, (_, i) => String(row.min + i));
}

const sizeText = (value) => String(value).replace(/^(\d+)x(\d+)$/, '$1 × $2');

function timeText(seconds) {
  const whole = Math.ceil(seconds);
  return whole < 60 ? `${whole} s` : `${Math.floor(whole / 60)} min ${whole % 60} s`;
}

const figures = (value) =>
  value === null ? '–' : value >= 100 ? value.toFixed(0) : value >= 10 ? value.toFixed(1) : value.toFixed(2);

/** What of the results fits a dialog: what varies, FPS, frame and ratio, quartiles below their median. */
function tableOf({ columns, rows, keys }) {
  const at = (key) => columns.findIndex((column) => column.key === key);
  const varies = (index) => new Set(rows.map((row) => row[index])).size > 1;
  const names = columns
    .slice(0, keys)
    .map((_, index) => index)
    .filter((index) => index === 0 || varies(index));
  const median = (key) => (row) => {
    const cell = make('td', { className: 'number', textContent: figures(row[at(key)]) });
    const [low, high] = [row[at(`${key}_low`)], row[at(`${key}_high`)]];
    if (low !== undefined && low !== null)
      cell.append(make('small', { textContent: `${figures(low)}…${figures(high)}` }));
    return cell;
  };
  const head = [
    ...names.map((index) => [columns[index].title, '']),
    ['FPS', 'number'],
    ['frame, ms', 'number'],
    ['ratio', 'number'],
  ];
  const body = rows.map((row) =>
    make(
      'tr',
      {},
      ...names.map((index) => make('td', { textContent: sizeText(row[index]) })),
      median('fps')(row),
      median('frame')(row),
      median('ratio')(row),
    ),
  );
  return make(
    'table',
    {},
    make(
      'thead',
      {},
      make('tr', {}, ...head.map(([text, className]) => make('th', { textContent: text, className, scope: 'col' }))),
    ),
    make('tbody', {}, ...body),
  );
}

function saveAs(name, results) {
  const href = URL.createObjectURL(new Blob([`${JSON.stringify(results, null, 1)}\n`], { type: 'application/json' }));
  make('a', { download: name, href }).click();
  setTimeout(() => URL.revokeObjectURL(href), 10_000);
}

function openReport() {
  localStorage.setItem('gnomon.results', JSON.stringify(runs));
  window.open(new URL('../report.html', import.meta.url), '_blank');
}

/**
 * Makes the dialog; answers show().
 * @param page { tracer, session, task, sceneNames: Promise of names }
 */
export async function makeCompareDialog(page) {
  const style = make('link', { rel: 'stylesheet', href: new URL('compare.css', import.meta.url) });
  const styled = new Promise((resolve) => (style.onload = style.onerror = resolve));
  document.head.append(style);

  const table = page.tracer.table();
  const close = make('button', { className: 'close', type: 'button', textContent: '×' });
  close.setAttribute('aria-label', 'Close');
  const content = make('div', { className: 'content' });
  const dialog = make(
    'dialog',
    { id: 'compare-dialog', className: 'sheet' },
    make('header', {}, make('h2', { id: 'compare-title', textContent: 'Compare frame rates' }), close),
    content,
  );
  dialog.setAttribute('aria-labelledby', 'compare-title');
  document.body.append(dialog);

  let stop = null; // of the run under way

  // --- what to draw --------------------------------------------------------------------------------------------------

  const names = await page.sceneNames;
  const count = make('p', { className: 'count' });
  const start = make('button', { className: 'main', textContent: 'Start' });
  const limit = make(
    'select',
    { name: 'limit' },
    ...limits.map(([text, seconds]) => new Option(text, seconds, seconds === standardLimit, seconds === standardLimit)),
  );
  const form = make(
    'form',
    {},
    make('p', {
      className: 'lead',
      textContent: 'Every combination is a row. Rows draw in turn, so that what slows the machine slows all of them.',
    }),
    choices('scenes', 'Scenes', names),
    choices('depth', label('depth'), rangeOf(table, 'depth')),
    choices('shadows', label('shadows'), rangeOf(table, 'shadows')),
    choices('size', 'Pixels', sizes),
    make('footer', {}, count, make('label', { className: 'limit' }, 'at most ', limit), start),
  );

  const chosen = (name) => [...form.querySelectorAll(`[name=${name}]:checked`)].map((box) => box.value);
  const countRows = () => {
    const rows = Object.keys(chosenAtFirst).reduce((product, name) => product * chosen(name).length, 1);
    start.disabled = rows === 0;
    count.textContent = rows === 0 ? 'Choose one of each at least' : rows === 1 ? '1 row' : `${rows} rows`;
  };
  form.onchange = countRows;
  form.onsubmit = (event) => {
    event.preventDefault();
    run();
  };

  // --- how far it is -------------------------------------------------------------------------------------------------

  const bar = make('progress', { max: 1, value: 0 });
  bar.setAttribute('aria-label', 'Progress');
  const stage = make('p', { className: 'stage' }),
    row = make('p', { className: 'row' });
  const stopButton = make('button', { textContent: 'Stop and keep what is done' });
  const progress = make('div', { className: 'progress' }, stage, bar, row, stopButton);
  stopButton.onclick = () => stop?.abort();

  const words = { compiling: 'Compiling', drawing: 'Drawing' };
  const onprogress = (told) => {
    if (!words[told.stage]) return;
    bar.value = told.done / told.all;
    const left = told.stage === 'drawing' ? `, about ${timeText(told.secondsLeft)} left` : '';
    stage.textContent = `${words[told.stage]} ${told.done} of ${told.all}${left}`;
    row.textContent = told.row;
  };

  async function run() {
    stop = new AbortController();
    bar.value = 0;
    stage.textContent = 'Loading';
    row.textContent = '';
    content.replaceChildren(progress);
    stopButton.focus();
    try {
      const options = Object.fromEntries(Object.keys(chosenAtFirst).map((name) => [name, chosen(name)]));
      showResults(
        await compare(page, {
          ...options,
          repeats: undefined,
          limit: Number(limit.value),
          signal: stop.signal,
          onprogress,
        }),
      );
    } catch (error) {
      content.replaceChildren(make('p', { className: 'wrong', role: 'alert', textContent: error.message }), form);
    } finally {
      stop = null;
    }
  }

  // --- what came of it -----------------------------------------------------------------------------------------------

  function showResults(results) {
    const measured = results.tables[0].rows.some(
      (cells) => cells[results.tables[0].columns.findIndex(({ key }) => key === 'fps')] !== null,
    );
    if (measured) runs.push(results);
    const button = (text, action, className = '') => make('button', { textContent: text, onclick: action, className });
    const { rounds, renderer, 'left out': out } = results.environment;
    const [, counts, ended] = /(\d+ of \d+)(?:; (.*))?$/.exec(rounds);
    const why = ended ? ` (${ended === 'interrupted' ? 'stopped' : 'the time was up'})` : '';
    const drawn = chosen('size').length === 1 ? `${sizeText(chosen('size')[0])}, drawn` : 'Drawn';
    const said = [
      make('p', {
        className: 'lead',
        textContent:
          `Medians of ${counts} rounds${why}, their quartiles below. ` + 'Ratio: to the first row of the scene.',
      }),
      make('p', {
        className: 'lead drawn-by',
        textContent: `${drawn} by ${renderer}`,
      }),
      ...(out ? [make('p', { className: 'wrong', textContent: `Left out: ${out}` })] : []),
    ];
    const actions = make(
      'footer',
      {},
      button('Again', () => content.replaceChildren(form)),
      ...(measured
        ? [
            button('Save JSON', () => saveAs(`gnomon-${results.tables[0].rows[0][1]}.json`, results)),
            button('Open report', openReport, 'main'),
          ]
        : []),
    );
    content.replaceChildren(
      ...(measured
        ? said
        : [
            make('p', { className: 'lead', textContent: 'Stopped before the first round: nothing was measured.' }),
            ...said.slice(2),
          ]),
      ...(measured ? [make('div', { className: 'scroll' }, tableOf(results.tables[0]))] : []),
      actions,
    );
    actions.lastChild.focus();
  }

  const leave = (event) => {
    if (!stop) return dialog.close();
    event.preventDefault();
    stop.abort(); // what is done is shown first
  };
  close.onclick = leave;
  dialog.addEventListener('cancel', leave);

  countRows();
  content.replaceChildren(form);
  await styled;
  return () => dialog.showModal();
}
