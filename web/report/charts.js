// Charts of results: lines or bars over a column, or points with the front of those that no other one betters. Chart.js
// is there as `Chart`.

import { element } from './elements.js';
import { betterOf, rowsOf } from './columns.js';
import { openPicture, peekAt } from './pictures.js';

const colors = [
  '#0b62a8',
  '#d1495b',
  '#2e8b57',
  '#8a5fbf',
  '#c77d0a',
  '#4d5966',
  '#1796a3',
  '#b0417f',
  '#7a8b1f',
  '#8c5a3c',
];
const styles = ['circle', 'rect', 'triangle', 'rectRot', 'crossRot', 'star']; // told apart in print, too
const ink = '#1d2430';

/** The words of a column, each once; none where it holds numbers. */
const wordsOf = (rows, key) => [...new Set(rows.map((row) => row[key]).filter((value) => typeof value === 'string'))];

const pointsOf = (chart, column, rows, words) =>
  rows
    .filter((row) => typeof row[column] === 'number' && !(chart.log_y && row[column] <= 0))
    .map((row) => ({ x: words.length ? words.indexOf(row[chart.x]) : row[chart.x], y: row[column], row }));

/**
 * A line, bars over words, or points, for every series and y column; the first column is a solid line, the next ones
 * are dashed.
 */
function linesOf(chart, rows, words) {
  const names = [...new Set(rows.map((row) => row[chart.series] ?? ''))];
  return names.flatMap((name, i) =>
    chart.y.map(({ column, label }, style) => ({
      label: [name, label].filter((text) => text !== '').join(', '),
      data: pointsOf(
        chart,
        column,
        rows.filter((row) => (row[chart.series] ?? '') === name),
        words,
      ),
      borderColor: colors[i % colors.length],
      backgroundColor: colors[i % colors.length],
      borderDash: style ? [5, 4] : [],
      borderWidth: 2,
      ...(words.length
        ? {}
        : {
            pointRadius: chart.front ? 4 : 2.5,
            pointStyle: chart.front ? styles[i % styles.length] : 'circle',
            showLine: !chart.front,
            clip: 8,
          }),
    })),
  );
}

/** Marks the points of the front and joins them by steps: what a point betters begins at its corner. */
function frontOf(chart, rows) {
  const points = pointsOf(
    chart,
    chart.y[0].column,
    rows.filter((row) => row[chart.front] === 'yes'),
    [],
  ).sort((a, b) => a.x - b.x);
  return {
    label: 'front',
    data: points,
    stepped: true,
    borderColor: ink,
    backgroundColor: 'transparent',
    borderWidth: 1.5,
    pointRadius: 8,
    pointHoverRadius: 8,
    pointStyle: 'circle',
    clip: 10,
    order: 1,
  };
}

function axisTitle(column) {
  const better = betterOf(column);
  const named = [column.title, column.unit].filter(Boolean).join(', ');
  return better ? [named, `(${better} is better)`] : named;
}

/** Of a logarithmic axis 1, 2 and 5 of every power of ten are written. */
const isWritten = (value) =>
  [1, 2, 5].includes(Number((value / 10 ** Math.floor(Math.log10(value) + 1e-9)).toPrecision(6)));

function drawChart(canvas, chart, columns, rows, pictures) {
  const words = wordsOf(rows, chart.x);
  const places = [...new Set(rows.map((row) => row[chart.x]))].sort((a, b) => a - b);
  const lines = linesOf(chart, rows, words);
  if (chart.front) lines.unshift(frontOf(chart, rows));
  const axis = (key, log) => ({
    type: log ? 'logarithmic' : 'linear',
    beginAtZero: key !== chart.x && !log, // a ratio seen through a keyhole looks like a mountain range
    title: { display: true, text: axisTitle(columns.get(key)) },
    ...(key === chart.x && !log && places.length <= 12
      ? { afterBuildTicks: (axis) => (axis.ticks = places.map((value) => ({ value }))) }
      : {}),
    ticks: {
      callback: (value) =>
        log && !isWritten(value)
          ? null
          : Number(value.toPrecision(3)).toLocaleString('en', { maximumFractionDigits: 12 }),
    },
  });
  const pictureAt = (active) => active.length && pictures.of(lines[active[0].datasetIndex].data[active[0].index].row);
  canvas.addEventListener('pointerleave', () => peekAt());
  return new Chart(canvas, {
    type: words.length ? 'bar' : 'line',
    data: { labels: words, datasets: lines },
    options: {
      animation: false,
      devicePixelRatio: Math.max(2, window.devicePixelRatio), // a print shows more than a screen
      maintainAspectRatio: false,
      parsing: false,
      scales: {
        x: words.length ? { type: 'category' } : axis(chart.x, chart.log_x),
        y: axis(chart.y[0].column, chart.log_y),
      },
      plugins: {
        legend: {
          display: lines.some(({ label }) => label !== ''),
          labels: {
            usePointStyle: Boolean(chart.front),
            boxWidth: chart.front ? 8 : 26,
            boxHeight: chart.front ? 8 : words.length ? 8 : 0,
            font: { size: 11 },
          },
        },
      },
      onHover: (event, active) => {
        const picture = pictureAt(active) || undefined;
        canvas.style.cursor = picture ? 'pointer' : '';
        peekAt(picture, pictures.images);
      },
      onClick: (event, active) => {
        const picture = pictureAt(active);
        if (!picture) return;
        peekAt();
        openPicture(picture, pictures.images);
      },
    },
  });
}

export function chartsOf(chart, table, pictures, heading) {
  const columns = new Map(table.columns.map((column) => [column.key, column]));
  const rows = rowsOf(table).filter((row) =>
    Object.entries(chart.where).every(([key, value]) => String(row[key]) === value),
  );
  const facets = chart.facet ? [...new Set(rows.map((row) => row[chart.facet]))] : [''];
  const figures = facets.map((facet) => {
    const canvas = element('canvas', { role: 'img', ariaLabel: [chart.title, facet].filter(Boolean).join(': ') });
    const figure = element('figure', {}, element('div', { className: 'canvas' }, canvas));
    if (facet) figure.prepend(element('figcaption', { textContent: facet }));
    drawChart(
      canvas,
      chart,
      columns,
      rows.filter((row) => !chart.facet || row[chart.facet] === facet),
      pictures,
    );
    return figure;
  });
  return element(
    'section',
    {},
    element(heading, { textContent: chart.title }),
    element('div', { className: 'charts' }, ...figures),
  );
}
