// Takes a text for results, or says what is wrong with it, where, and what to do: as `gnomon report` does
// (lab/results/read_results.cpp).

const remedy = 'write it anew with --json=FILE';

/** What is wrong, in words for people. */
class Fault extends Error {}

const fail = (path, what, todo = remedy) => {
  throw new Fault(`${path ? `${path}: ` : ''}${what}; ${todo}`);
};

const names = { string: 'a string', number: 'a number', boolean: 'true or false', object: 'an object' };
const describe = (value) => (value === null ? 'null' : Array.isArray(value) ? 'a list' : names[typeof value]);
const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

const need = (value, path, right, wanted) => {
  if (value === undefined) fail(path, 'is missing');
  if (!right(value)) fail(path, `has to be ${wanted}, not ${describe(value)}`);
  return value;
};
const textIn = (value, path) => need(value, path, (text) => typeof text === 'string', 'a string');
const numberIn = (value, path) => need(value, path, (number) => typeof number === 'number', 'a number');
const listIn = (value, path) => need(value, path, Array.isArray, 'a list');
const objectIn = (value, path) => need(value, path, isObject, 'an object');
const textsIn = (object, path, keys) => {
  for (const key of keys) textIn(object[key], `${path}.${key}`);
};

function checkWord(value, path, known) {
  if (value !== undefined && !known.includes(textIn(value, path)))
    fail(path, `"${value}" is none of ${known.join(', ')}`);
}

function checkRow(row, path, count) {
  if (listIn(row, path).length !== count) fail(path, `the row has ${row.length} cells instead of ${count}`);
  row.forEach((cell, i) => {
    if (cell !== null && !['number', 'string'].includes(typeof cell))
      fail(`${path}[${i}]`, `${describe(cell)} is no number, text or null`);
  });
}

function checkTable(table, path) {
  textsIn(objectIn(table, path), path, ['name', 'title']);
  listIn(table.columns, `${path}.columns`).forEach((column, i) => {
    const at = `${path}.columns[${i}]`;
    textsIn(objectIn(column, at), at, ['key', 'title', 'unit', 'help']);
    checkWord(column.kind, `${at}.kind`, ['time', 'ratio', 'error', 'count']);
    checkWord(column.better, `${at}.better`, ['lower', 'higher']);
  });
  listIn(table.rows, `${path}.rows`).forEach((row, i) => checkRow(row, `${path}.rows[${i}]`, table.columns.length));
  const keys = numberIn(table.keys ?? 0, `${path}.keys`);
  if (!(Number.isInteger(keys) && keys >= 0 && keys <= table.columns.length))
    fail(`${path}.keys`, `${keys} is no number of columns; there are ${table.columns.length}`);
}

function tableNamed(name, path, tables) {
  return (
    tables.find((table) => table.name === textIn(name, `${path}.table`)) ??
    fail(`${path}.table`, `there is no table "${name}"`)
  );
}

function checkChart(chart, path, tables) {
  textIn(objectIn(chart, path).title, `${path}.title`);
  const table = tableNamed(chart.table, path, tables);
  const checkColumn = (name, at, optional) => {
    const known = table.columns.some(({ key }) => key === textIn(name, at));
    if (!known && !(optional && name === '')) fail(at, `table "${table.name}" has no column "${name}"`);
  };
  checkColumn(chart.x, `${path}.x`);
  checkColumn(chart.series, `${path}.series`, true);
  checkColumn(chart.facet, `${path}.facet`, true);
  checkColumn(chart.front ?? '', `${path}.front`, true);
  if (!listIn(chart.y, `${path}.y`).length) fail(`${path}.y`, 'the chart has no lines');
  chart.y.forEach((line, i) => {
    const at = `${path}.y[${i}]`;
    checkColumn(objectIn(line, at).column, `${at}.column`);
    textIn(line.label, `${at}.label`);
  });
  for (const [key, value] of Object.entries(objectIn(chart.where, `${path}.where`)))
    textIn(value, `${path}.where.${key}`);
  for (const key of ['log_x', 'log_y'])
    need(chart[key], `${path}.${key}`, (value) => typeof value === 'boolean', 'true or false');
}

function checkPicture(picture, path, tables, images) {
  textIn(objectIn(picture, path).title, `${path}.title`);
  const table = tableNamed(picture.table, path, tables);
  checkRow(picture.row, `${path}.row`, table.keys ?? 0);
  const checkImage = (index, at) => {
    if (!images[numberIn(index, at)]) fail(at, `${index} is no image; there are ${images.length}`);
  };
  checkImage(picture.image, `${path}.image`);
  if (picture.reference === undefined) return;
  checkImage(objectIn(picture.reference, `${path}.reference`).image, `${path}.reference.image`);
  textIn(picture.reference.title, `${path}.reference.title`);
}

function checkImages(results) {
  const images = listIn(results.images, 'images');
  images.forEach((image, i) => {
    if (!textIn(image, `images[${i}]`).startsWith('data:image/png;base64,'))
      fail(`images[${i}]`, 'is no PNG as a data URL');
  });
  listIn(results.pictures, 'pictures').forEach((picture, i) =>
    checkPicture(picture, `pictures[${i}]`, results.tables, images),
  );
}

/** The same value, if it is one run's results. Throws an Error that is for people to read. */
export function checkedResults(results) {
  if (!isObject(results) || results.format !== 'gnomon-results')
    fail('', 'this is no file of results', 'give a file that gnomon bench, gnomon lab or this page wrote');
  if (numberIn(results.version, 'version') !== 1)
    fail(
      'version',
      `version ${results.version} of results is unknown; this page reads version 1`,
      'read it with the gnomon that wrote it',
    );
  for (const key of ['title', 'command']) textIn(results[key], key);
  for (const [key, value] of Object.entries(objectIn(results.environment, 'environment')))
    textIn(value, `environment.${key}`);
  listIn(results.tables, 'tables').forEach((table, i) => checkTable(table, `tables[${i}]`));
  listIn(results.charts, 'charts').forEach((chart, i) => checkChart(chart, `charts[${i}]`, results.tables));
  if (results.pictures !== undefined) checkImages(results);
  return results;
}

/** The results that a file's text holds. Throws as checkedResults() does. */
export function readResults(text) {
  if (!text.trim()) fail('', 'the file is empty');
  let value;
  try {
    value = JSON.parse(text);
  } catch (error) {
    fail('', `this is no JSON (${error.message})`, 'give a file that gnomon bench, gnomon lab or this page wrote');
  }
  return checkedResults(value);
}
