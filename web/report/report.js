// Shows results (docs/results.md): what made them, charts, tables that sort. Chart.js is there as `Chart`.

const colors = ['#0b62a8', '#d1495b', '#2e8b57', '#8a5fbf', '#c77d0a', '#4d5966'];

const element = (name, attributes = {}, ...children) => {
  const made = Object.assign(document.createElement(name), attributes);
  made.append(...children);
  return made;
};

const shown = (value) => {
  if (value === null) return '–';
  if (typeof value !== 'number') return value;
  return Number.isInteger(value) ? value.toLocaleString('en') : String(Number(value.toPrecision(4)));
};

/** Rows as objects by column key. */
const rowsOf = (table) =>
  table.rows.map((row) => Object.fromEntries(table.columns.map(({ key }, i) => [key, row[i]])));

const byValue = (key, direction) => (a, b) => {
  const [x, y] = [a[key], b[key]];
  if (x === null || y === null) return (x === null) - (y === null); // what is not there comes last, either way
  return direction * (typeof x === 'number' && typeof y === 'number' ? x - y : String(x).localeCompare(String(y), 'en', { numeric: true }));
};

function tableOf(table) {
  const rows = rowsOf(table);
  const words = new Set(table.columns.filter(({ key }) => rows.some((row) => typeof row[key] === 'string')).map(({ key }) => key));
  const body = element('tbody');
  const fill = () =>
    body.replaceChildren(...rows.map((row) =>
      element('tr', {}, ...table.columns.map(({ key }) => element('td', { className: words.has(key) ? 'word' : '', textContent: shown(row[key]) })))));
  const heads = table.columns.map(({ key, title, unit, help }) => {
    const button = element('button', { type: 'button', title: help }, title);
    if (unit) button.append(element('small', { textContent: unit }));
    const head = element('th', { scope: 'col', className: words.has(key) ? 'word' : '' }, button);
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
  return element('section', {}, element('h2', { textContent: table.title }), element('div', { className: 'table' }, grid));
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
  const axis = (key, log) => ({
    type: log ? 'logarithmic' : 'linear',
    beginAtZero: true, // a ratio seen through a keyhole looks like a mountain range
    title: { display: true, text: [columns.get(key).title, columns.get(key).unit].filter(Boolean).join(', ') },
    ticks: { callback: (value) => (log && !Number.isInteger(Math.log10(value)) ? null : Number(value.toPrecision(3)).toLocaleString('en')) },
  });
  return new Chart(canvas, {
    type: words.length ? 'bar' : 'line',
    data: { labels: words, datasets: linesOf(chart, rows, words) },
    options: {
      animation: false,
      maintainAspectRatio: false,
      parsing: false,
      scales: { x: words.length ? { type: 'category' } : axis(chart.x, chart.log_x), y: axis(chart.y[0].column, chart.log_y) },
      plugins: { legend: { labels: { boxWidth: 26, boxHeight: 0, font: { size: 11 } } } },
    },
  });
}

function chartsOf(chart, table) {
  const columns = new Map(table.columns.map((column) => [column.key, column]));
  const rows = rowsOf(table).filter((row) => Object.entries(chart.where).every(([key, value]) => row[key] === value));
  const facets = chart.facet ? [...new Set(rows.map((row) => row[chart.facet]))] : [''];
  const figures = facets.map((facet) => {
    const canvas = element('canvas', { role: 'img', ariaLabel: [chart.title, facet].filter(Boolean).join(': ') });
    const figure = element('figure', {}, element('div', { className: 'canvas' }, canvas));
    if (facet) figure.prepend(element('figcaption', { textContent: facet }));
    drawChart(canvas, chart, columns, rows.filter((row) => !chart.facet || row[chart.facet] === facet));
    return figure;
  });
  return element('section', {}, element('h2', { textContent: chart.title }), element('div', { className: 'charts' }, ...figures));
}

function showResults(results, place) {
  document.title = results.title;
  const environment = element('dl');
  for (const [name, value] of Object.entries(results.environment))
    environment.append(element('dt', { textContent: name }), element('dd', { textContent: value }));
  const command = element('code', { className: 'command', textContent: results.command });
  place.replaceChildren(element('h1', { textContent: results.title }), command, environment);
  for (const chart of results.charts) place.append(chartsOf(chart, results.tables.find(({ name }) => name === chart.table)));
  for (const table of results.tables) place.append(tableOf(table));
}
