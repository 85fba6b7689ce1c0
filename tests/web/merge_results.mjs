// Results of the same plan from several browsers as one, as `gnomon bench` writes those of several contexts.

/** One text for all: what is not the same in every context stands as `chromium: …; firefox: …`. */
function mergedEnvironment(runs) {
  const names = new Set(runs.flatMap(({ environment }) => Object.keys(environment)));
  const merge = (name) => {
    const values = runs.map(({ environment }) => environment[name] ?? (name === 'left out' ? '' : 'unknown'));
    if (name === 'rounds') return values.join(', ');
    if (values.every((value) => value === values[0])) return values[0];
    if (name === 'context') return values.join('; ');
    return runs
      .map(({ environment }, i) => values[i] && `${environment.context}: ${values[i]}`)
      .filter(Boolean)
      .join('; ');
  };
  return Object.fromEntries([...names].map((name) => [name, merge(name)]));
}

/** All rows under the columns of all runs: a browser without timers of the GPU has no such column. */
function mergedTable(tables) {
  const { columns, ...table } = tables.reduce((most, next) =>
    next.columns.length > most.columns.length ? next : most,
  );
  const rows = tables.flatMap((each) => {
    const places = columns.map(({ key }) => each.columns.findIndex((column) => column.key === key));
    return each.rows.map((row) => places.map((place) => (place < 0 ? null : row[place])));
  });
  return { ...table, columns, rows };
}

/** @param runs results objects of one plan, each of a context of its own, whose charts are of all contexts */
export function merged(runs, command) {
  const table = mergedTable(runs.map(({ tables }) => tables[0]));
  const contexts = new Set(runs.map(({ environment }) => environment.context));
  const charts = runs[0].charts.filter(({ where }) => !where.context || contexts.has(where.context));
  return { ...runs[0], command, environment: mergedEnvironment(runs), tables: [table], charts };
}
