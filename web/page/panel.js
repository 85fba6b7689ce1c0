// The settings panel, generated from the table of settings: one folder a group, one control a row.

import { label } from './labels.js';

const notHere = ['size', 'vsync']; // the window and the browser decide about these

/** The value a control holds for the setting's text. */
function valueOf(row, text) {
  if (row.type === 'bool') return text === 'on';
  if (row.type === 'int') return Number(text);
  if (row.type === 'real' && row.default !== null) return Number(Number(text).toPrecision(5));
  return text; // choices, points, and numbers that may be unset
}

const textOf = (value) => (typeof value === 'boolean' ? (value ? 'on' : 'off') : String(value).trim());

/** A setting's control; `live`: it counts while it is being changed, not only when the user is done. */
function addControl(folder, values, row) {
  if (row.type === 'bool') return { control: folder.add(values, row.key), live: true };
  if (row.type === 'choice') return { control: folder.add(values, row.key, row.names), live: true };
  if (row.type === 'int') return { control: folder.add(values, row.key, row.min, row.max, 1), live: true };
  const slides = row.step && row.default !== null && row.max - row.min <= 1000 * row.step;
  if (slides) return { control: folder.add(values, row.key, row.min, row.max, row.step), live: true };
  return { control: folder.add(values, row.key), live: false }; // half typed most of the time
}

/**
 * @param table rows as settingsJson() of tracer/settings/settings.h gives them
 * @param settings Map of key → text as they stand
 * @param set called with (key, text) when the user changes one
 * @returns { show(settings) }: brings the controls up to date
 */
export async function makePanel(place, { table, settings, set, open }) {
  const { GUI } = await import('../vendor/lil-gui.js');
  const gui = new GUI({ container: place, title: 'Settings' });
  const values = {};
  const controls = new Map();
  const folders = new Map();

  for (const row of table) {
    if (notHere.includes(row.key)) continue;
    if (!folders.has(row.group)) folders.set(row.group, gui.addFolder(row.group));
    values[row.key] = valueOf(row, settings.get(row.key));
    const { control, live } = addControl(folders.get(row.group), values, row);
    control.name(label(row.key));
    const keys = row.hotkeys.length ? ` (${row.hotkeys.join(', ')})` : '';
    control.domElement.title = `${row.help}${keys}`;
    control.domElement.querySelector('input, select')?.setAttribute('aria-description', row.help);
    const change = (value) => set(row.key, textOf(value));
    if (live) control.onChange(change);
    else control.onFinishChange(change);
    controls.set(row.key, { row, control });
  }
  for (const name of ['Camera', 'Canvas']) folders.get(name)?.close();
  if (!open) gui.close();

  return {
    show(now) {
      for (const [key, { row, control }] of controls) {
        const value = valueOf(row, now.get(key));
        if (values[key] === value || control.domElement.contains(document.activeElement)) continue;
        values[key] = value;
        control.updateDisplay();
      }
    },
  };
}
