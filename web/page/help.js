// The help: keys from the table of settings, and the gestures that have no row there.

import { label } from './labels.js';

const caps = { Left: '←', Right: '→', Up: '↑', Down: '↓' };

const moving = [
  [['W', 'A', 'S', 'D'], 'Move; half as fast while Shift is held'],
  ['Drag', 'Look around'],
  ['Wheel', 'Move forward and back'],
  [['H'], 'This help'],
  [['F'], 'Full screen'],
];
const touching = [
  ['One finger', 'Look around'],
  ['Two fingers', 'Pinch to move forward and back, slide to move sideways'],
  ['Stick', 'Walk; the further out, the faster'],
];

function rowsOf(pairs) {
  const body = document.createElement('tbody');
  for (const [keys, text] of pairs) {
    const row = body.insertRow();
    const what = row.insertCell();
    for (const key of [keys].flat()) {
      const cap = document.createElement(Array.isArray(keys) ? 'kbd' : 'span');
      cap.textContent = caps[key] ?? key;
      what.append(cap);
    }
    row.insertCell().textContent = text;
  }
  const table = document.createElement('table');
  table.append(body);
  return table;
}

/** Fills the dialog; answers toggle(). `about` gives the last line when it opens. */
export function makeHelp(dialog, table, about) {
  const settings = table
    .filter((row) => row.hotkeys.length && row.key !== 'vsync')
    .map((row) => [row.hotkeys, `${label(row.key)}: ${row.help.replace(/^./, (letter) => letter.toLowerCase())}`]);
  const heading = (text) => Object.assign(document.createElement('h3'), { textContent: text });
  const top = document.createElement('header');
  const close = Object.assign(document.createElement('button'), { className: 'close', textContent: '×' });
  close.setAttribute('aria-label', 'Close');
  close.onclick = () => dialog.close();
  top.append(
    Object.assign(document.createElement('h2'), { id: 'help-title', textContent: 'Keys and gestures' }),
    close,
  );
  const bottom = document.createElement('footer');
  dialog.replaceChildren(
    top,
    heading('Moving'),
    rowsOf(moving),
    heading('Picture'),
    rowsOf(settings),
    heading('Touch'),
    rowsOf(touching),
    bottom,
  );
  dialog.addEventListener('click', (event) => event.target === dialog && dialog.close()); // the backdrop

  return () => {
    if (dialog.open) return dialog.close();
    bottom.replaceChildren(
      about(),
      ' · ',
      Object.assign(document.createElement('a'), {
        href: 'report.html',
        target: '_blank',
        style: 'color: inherit',
        textContent: 'Results viewer',
      }),
    );
    dialog.showModal();
  };
}
