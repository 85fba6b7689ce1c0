// Frames a second of all runs in one table, scenes and settings down, contexts and sizes across, and in charts: the
// `bench` tables of several runs, native or of browsers, as one more run.

import { rowsOf } from './columns.js';

const across = ['context', 'size'];

/** Every row of every bench, as an object that knows its run. */
function benchRows(runs) {
  return runs.flatMap(({ tables }, run) =>
    tables
      .filter(({ name }) => name === 'bench')
      .flatMap((table) => {
        const keys = table.columns.slice(0, table.keys ?? 0).map(({ key }) => key);
        return rowsOf(table).map((row) => ({ run: run + 1, row, keys }));
      }),
  );
}

/** What a table calls the column that a row's FPS stand in: no more than tells them apart. */
function labelled(rows) {
  const plain = ({ row }) =>
    across
      .map((key) => row[key])
      .filter(Boolean)
      .join(', ');
  const runsOf = new Map();
  for (const one of rows) runsOf.set(plain(one), (runsOf.get(plain(one)) ?? new Set()).add(one.run));
  return rows.map((one) => ({
    ...one,
    label: runsOf.get(plain(one)).size > 1 ? `run ${one.run}: ${plain(one)}` : plain(one),
  }));
}

const distinct = (values) => [...new Set(values)];

/** Keys that go down: the scene, and what else takes several values; depth last. */
function keysDown(rows) {
  const keys = distinct(rows.flatMap((one) => one.keys)).filter((key) => !across.includes(key));
  const varied = keys.filter((key) => key === 'scene' || distinct(rows.map(({ row }) => row[key])).length > 1);
  return [...varied.filter((key) => key !== 'depth'), ...varied.filter((key) => key === 'depth')];
}

const text = (row, keys) => keys.map((key) => (key === 'scene' ? row[key] : `${key} ${row[key]}`)).join(', ');

function fpsTable(rows, keys, labels) {
  const byName = new Map();
  for (const { row, label } of rows) {
    const name = text(row, keys);
    if (!byName.has(name)) byName.set(name, { row, fps: new Map() });
    byName.get(name).fps.set(label, row.fps);
  }
  return {
    name: 'together',
    title: 'Frames a second',
    keys: keys.length,
    columns: [
      ...keys.map((key) => ({ key, title: key, unit: '', help: '' })),
      ...labels.map((label, i) => ({
        key: `fps_${i}`,
        title: label,
        unit: 'FPS',
        help: 'One over the median frame',
        better: 'higher',
      })),
    ],
    rows: [...byName.values()].map(({ row, fps }) => [
      ...keys.map((key) => row[key] ?? null),
      ...labels.map((label) => fps.get(label) ?? null),
    ]),
  };
}

/** One row a measurement, for charts. */
function longTable(rows, keys) {
  const beside = keys.filter((key) => key !== 'depth');
  const names = ['run', 'scene', 'where', 'what', 'depth', 'fps', 'compile'];
  const titles = { fps: ['FPS', '1/s', 'higher'], compile: ['compile', 'ms', 'lower'] };
  return {
    name: 'measured',
    title: '',
    keys: 5,
    columns: names.map((key) => ({
      key,
      title: titles[key]?.[0] ?? key,
      unit: titles[key]?.[1] ?? '',
      help: '',
      better: titles[key]?.[2],
    })),
    rows: rows.map(({ row, label }) => [
      label,
      row.scene,
      text(row, beside),
      text(
        row,
        keys.filter((key) => key !== 'scene'),
      ) || 'all',
      row.depth ?? null,
      row.fps ?? null,
      row.compile ?? null,
    ]),
  };
}

const chart = (title, x, y, facet) => ({
  title,
  table: 'measured',
  x,
  y: [{ column: y, label: '' }],
  series: 'run',
  facet,
  where: {},
  log_x: false,
  log_y: false,
});

/**
 * As results with `tables` to be shown and `drawn` for the charts; undefined where there are no two columns to hold
 * against each other.
 */
export function together(runs) {
  const rows = labelled(benchRows(runs));
  const labels = distinct(rows.map(({ label }) => label));
  if (labels.length < 2) return undefined;
  const keys = keysDown(rows);
  const deep = distinct(rows.map(({ row }) => row.depth)).length > 1;
  const charts = [
    deep
      ? chart('Frames a second over depth', 'depth', 'fps', 'where')
      : chart('Frames a second', 'what', 'fps', 'scene'),
    ...(rows.some(({ row }) => typeof row.compile === 'number')
      ? [chart('Compile times', 'what', 'compile', 'scene')]
      : []),
  ];
  return { title: 'Together', tables: [fpsTable(rows, keys, labels)], drawn: [longTable(rows, keys)], charts };
}
