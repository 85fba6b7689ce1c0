// What the columns of a table of results are, and how their numbers are shown.

/**
 * How a column shows its numbers: with as many decimals in every row, so that they line up, where four digits of the
 * largest leave two of the least.
 */
export function formatOf(values) {
  const sizes = values.filter((value) => typeof value === 'number' && value !== 0).map(Math.abs);
  const most = Math.max(...sizes);
  const fixed =
    sizes.length > 0 &&
    most < 1e7 &&
    most / Math.min(...sizes) <= 1000 &&
    sizes.some((size) => !Number.isInteger(size));
  const decimals = fixed ? Math.min(12, Math.max(0, 3 - Math.floor(Math.log10(most)))) : 0;
  return (value) => {
    if (value === null) return '–';
    if (typeof value !== 'number') return value;
    if (fixed) return value.toLocaleString('en', { minimumFractionDigits: decimals, maximumFractionDigits: decimals });
    return Number.isInteger(value) ? value.toLocaleString('en') : String(Number(value.toPrecision(4)));
  };
}

/** Rows as objects by column key. */
export const rowsOf = (table) =>
  table.rows.map((row) => Object.fromEntries(table.columns.map(({ key }, i) => [key, row[i]])));

/** Which way a column's numbers improve: 'lower', 'higher', or undefined. */
export const betterOf = ({ kind, better }) =>
  better ?? (['time', 'ratio', 'error'].includes(kind) ? 'lower' : undefined);

/** Columns as they are shown: the quartiles of a median stand in its cell. */
export function columnsOf(table, rows) {
  const keys = new Set(table.columns.map(({ key }) => key));
  const hasQuartiles = (key) => keys.has(`${key}_low`) && keys.has(`${key}_high`);
  const isQuartile = (key) =>
    /_(low|high)$/.test(key) &&
    hasQuartiles(key.replace(/_(low|high)$/, '')) &&
    keys.has(key.replace(/_(low|high)$/, ''));
  return table.columns
    .filter(({ key }) => !isQuartile(key))
    .map((column) => {
      const { key } = column;
      const parts = hasQuartiles(key) ? [key, `${key}_low`, `${key}_high`] : [key];
      const format = formatOf(rows.flatMap((row) => parts.map((part) => row[part])));
      const word = rows.some((row) => typeof row[key] === 'string');
      const spreadOf =
        parts.length > 1 && ((row) => (row[key] === null ? '' : `${format(row[parts[1]])} … ${format(row[parts[2]])}`));
      // In em: so that the medians line up.
      const spread = spreadOf && 0.55 * Math.max(0, ...rows.map((row) => spreadOf(row).length));
      return { ...column, format, word, spreadOf, spread };
    });
}
