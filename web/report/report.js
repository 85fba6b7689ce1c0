// Shows results (docs/results.md) of one run or several: what made them, charts, tables that sort. Chart.js is there as `Chart`.

const colors = ['#0b62a8', '#d1495b', '#2e8b57', '#8a5fbf', '#c77d0a', '#4d5966', '#1796a3', '#b0417f', '#7a8b1f', '#8c5a3c'];

const element = (name, attributes = {}, ...children) => {
  const made = Object.assign(document.createElement(name), attributes);
  made.append(...children);
  return made;
};

/** How a column shows its numbers: with as many decimals in every row, so that they line up, where four digits of the largest leave two of the least. */
function formatOf(values) {
  const sizes = values.filter((value) => typeof value === 'number' && value !== 0).map(Math.abs);
  const most = Math.max(...sizes);
  const fixed = sizes.length > 0 && most < 1e7 && most / Math.min(...sizes) <= 1000 && sizes.some((size) => !Number.isInteger(size));
  const decimals = fixed ? Math.min(12, Math.max(0, 3 - Math.floor(Math.log10(most)))) : 0;
  return (value) => {
    if (value === null) return '–';
    if (typeof value !== 'number') return value;
    if (fixed) return value.toLocaleString('en', { minimumFractionDigits: decimals, maximumFractionDigits: decimals });
    return Number.isInteger(value) ? value.toLocaleString('en') : String(Number(value.toPrecision(4)));
  };
}

/** Rows as objects by column key. */
const rowsOf = (table) =>
  table.rows.map((row) => Object.fromEntries(table.columns.map(({ key }, i) => [key, row[i]])));

const byValue = (key, direction) => (a, b) => {
  const [x, y] = [a[key], b[key]];
  if (x === null || y === null) return (x === null) - (y === null); // what is not there comes last, either way
  return direction * (typeof x === 'number' && typeof y === 'number' ? x - y : String(x).localeCompare(String(y), 'en', { numeric: true }));
};

/** Columns as they are shown: the quartiles of a median stand in its cell. */
function columnsOf(table, rows) {
  const keys = new Set(table.columns.map(({ key }) => key));
  const hasQuartiles = (key) => keys.has(`${key}_low`) && keys.has(`${key}_high`);
  const isQuartile = (key) => /_(low|high)$/.test(key) && hasQuartiles(key.replace(/_(low|high)$/, '')) && keys.has(key.replace(/_(low|high)$/, ''));
  return table.columns.filter(({ key }) => !isQuartile(key)).map((column) => {
    const { key } = column;
    const parts = hasQuartiles(key) ? [key, `${key}_low`, `${key}_high`] : [key];
    const format = formatOf(rows.flatMap((row) => parts.map((part) => row[part])));
    const word = rows.some((row) => typeof row[key] === 'string');
    const spreadOf = parts.length > 1 && ((row) => (row[key] === null ? '' : `${format(row[parts[1]])} … ${format(row[parts[2]])}`));
    const spread = spreadOf && 0.55 * Math.max(0, ...rows.map((row) => spreadOf(row).length)); // em: so that the medians line up
    return { ...column, format, word, spreadOf, spread };
  });
}

function cellOf({ key, format, word, spreadOf }, row) {
  const cell = element('td', { className: word ? `word ${row[key]}` : '', textContent: format(row[key]) });
  if (spreadOf) cell.append(element('small', { textContent: spreadOf(row) }));
  return cell;
}

const spaced = ({ spread }, cell) => {
  if (spread) cell.style.setProperty('--spread', `${spread.toFixed(1)}em`);
  return cell;
};

function tableOf(table, heading) {
  const rows = rowsOf(table);
  const columns = columnsOf(table, rows);
  const body = element('tbody');
  const fill = () => body.replaceChildren(...rows.map((row) => element('tr', {}, ...columns.map((column) => spaced(column, cellOf(column, row))))));
  const heads = columns.map(({ key, title, unit, help, word, spread }) => {
    const button = element('button', { type: 'button', title: help }, title);
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
  if (columns.some(({ spread }) => spread)) section.append(element('p', { className: 'note', textContent: 'Small beside a median: the quartiles of the rounds; beside the ratio of two runs: what noise leaves of it. A heading tells more under the pointer and sorts by a click.' }));
  section.append(element('div', { className: 'table' }, grid));
  return section;
}

/** The words of a column, each once; none where it holds numbers. */
const wordsOf = (rows, key) => [...new Set(rows.map((row) => row[key]).filter((value) => typeof value === 'string'))];

/** A line, or bars over words, for every series and y column; the first column is a solid line, the next ones are dashed. */
function linesOf(chart, rows, words) {
  const names = [...new Set(rows.map((row) => row[chart.series] ?? ''))];
  return names.flatMap((name, i) =>
    chart.y.map(({ column, label }, style) => ({
      label: [name, label].filter(Boolean).join(', '),
      data: rows
        .filter((row) => (row[chart.series] ?? '') === name && typeof row[column] === 'number' && !(chart.log_y && row[column] <= 0))
        .map((row) => ({ x: words.length ? words.indexOf(row[chart.x]) : row[chart.x], y: row[column] })),
      borderColor: colors[i % colors.length],
      backgroundColor: colors[i % colors.length],
      borderDash: style ? [5, 4] : [],
      borderWidth: 2,
      pointRadius: 2.5,
    })));
}

function drawChart(canvas, chart, columns, rows) {
  const words = wordsOf(rows, chart.x);
  const places = [...new Set(rows.map((row) => row[chart.x]))].sort((a, b) => a - b);
  const lines = linesOf(chart, rows, words);
  const axis = (key, log) => ({
    type: log ? 'logarithmic' : 'linear',
    beginAtZero: key !== chart.x, // a ratio seen through a keyhole looks like a mountain range
    title: { display: true, text: [columns.get(key).title, columns.get(key).unit].filter(Boolean).join(', ') },
    ...(key === chart.x && !log && places.length <= 12 ? { afterBuildTicks: (axis) => (axis.ticks = places.map((value) => ({ value }))) } : {}),
    ticks: { callback: (value) => (log && !Number.isInteger(Math.log10(value)) ? null : Number(value.toPrecision(3)).toLocaleString('en')) },
  });
  return new Chart(canvas, {
    type: words.length ? 'bar' : 'line',
    data: { labels: words, datasets: lines },
    options: {
      animation: false,
      maintainAspectRatio: false,
      parsing: false,
      scales: { x: words.length ? { type: 'category' } : axis(chart.x, chart.log_x), y: axis(chart.y[0].column, chart.log_y) },
      plugins: { legend: { display: lines.some(({ label }) => label !== ''), labels: { boxWidth: 26, boxHeight: 0, font: { size: 11 } } } },
    },
  });
}

function chartsOf(chart, table, heading) {
  const columns = new Map(table.columns.map((column) => [column.key, column]));
  const rows = rowsOf(table).filter((row) => Object.entries(chart.where).every(([key, value]) => String(row[key]) === value));
  const facets = chart.facet ? [...new Set(rows.map((row) => row[chart.facet]))] : [''];
  const figures = facets.map((facet) => {
    const canvas = element('canvas', { role: 'img', ariaLabel: [chart.title, facet].filter(Boolean).join(': ') });
    const figure = element('figure', {}, element('div', { className: 'canvas' }, canvas));
    if (facet) figure.prepend(element('figcaption', { textContent: facet }));
    drawChart(canvas, chart, columns, rows.filter((row) => !chart.facet || row[chart.facet] === facet));
    return figure;
  });
  return element('section', {}, element(heading, { textContent: chart.title }), element('div', { className: 'charts' }, ...figures));
}

/** One run, under a heading of `level`. */
function runOf(results, level, id) {
  const environment = element('dl');
  for (const [name, value] of Object.entries(results.environment))
    environment.append(element('dt', { textContent: name }), element('dd', { textContent: value }));
  const command = element('code', { className: 'command', textContent: results.command });
  const below = `h${level + 1}`;
  const run = element('article', { id }, element(`h${level}`, { textContent: results.title }), command, environment);
  for (const chart of results.charts) run.append(chartsOf(chart, results.tables.find(({ name }) => name === chart.table), below));
  for (const table of results.tables) run.append(tableOf(table, below));
  return run;
}

/** Where several runs stand on the page, and what tells them apart. */
function contentsOf(runs) {
  const told = ['date', 'commit', 'renderer'];
  const entries = runs.map(({ title, environment }, i) =>
    element('li', {}, element('a', { href: `#run-${i + 1}`, textContent: title }), ' ',
      element('small', { textContent: told.map((name) => environment[name]).filter(Boolean).join(' · ') })));
  return element('nav', { ariaLabel: 'Runs' }, element('ol', {}, ...entries));
}

function showResults(runs, place) {
  const one = runs.length === 1;
  document.title = one ? runs[0].title : `Gnomon: ${runs.length} results`;
  place.replaceChildren();
  if (!one) place.append(element('h1', { textContent: document.title }), contentsOf(runs));
  runs.forEach((run, i) => place.append(runOf(run, one ? 1 : 2, `run-${i + 1}`)));
}
