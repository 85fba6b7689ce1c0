// Results are what docs/results.schema.json says: all that the program writes is, and what is spoilt is refused, by the
// schema, by `gnomon report` and by the page.
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import Ajv2020 from 'ajv/dist/2020.js';
import { readResults } from '../../web/report/read.js';

const gnomon = process.env.GNOMON_BINARY ?? 'build/native/gnomon';
const valid = new Ajv2020({ allErrors: true, allowUnionTypes: true }).compile(
  JSON.parse(readFileSync('docs/results.schema.json')),
);

const commands = {
  bench: 'bench lite shapes --depth=1,4 --shadows=off,hard --size=32x24 --repeats=2',
  intersect: 'lab intersect --shapes=sphere --distances=3 --rays=100',
  trace: 'lab trace --scenes=lite --spheres=8 --size=32x24 --depth=1 --repeats=1',
  shadows:
    'lab shadows --scenes=simple --models=hard,silhouette,montecarlo --samples=1 --size=32x24 ' +
    '--reference=16 --repeats=1',
};

describe('results', () => {
  let folder;
  const results = {};
  const fileOf = (name) => join(folder, `${name}.json`);
  before(() => {
    folder = mkdtempSync(join(tmpdir(), 'gnomon-results-'));
    for (const [name, command] of Object.entries(commands)) {
      execFileSync(gnomon, [...command.split(' '), `--json=${fileOf(name)}`]);
      results[name] = JSON.parse(readFileSync(fileOf(name)));
    }
    execFileSync(gnomon, ['report', '--against', fileOf('shadows'), fileOf('shadows'), `--json=${fileOf('against')}`]);
    results.against = JSON.parse(readFileSync(fileOf('against')));
  });
  after(() => rmSync(folder, { recursive: true, force: true }));

  describe('what the program writes', () => {
    for (const name of [...Object.keys(commands), 'against'])
      test(`${name} is valid, and the page reads it`, () => {
        assert.ok(valid(results[name]), JSON.stringify(valid.errors));
        assert.deepEqual(readResults(readFileSync(fileOf(name), 'utf8')), results[name]);
      });

    test('every table has keys, and they tell its rows apart', () => {
      for (const [name, { tables }] of Object.entries(results))
        for (const table of tables) {
          assert.ok(table.keys > 0, `${name}: ${table.name} has keys`);
          const rows = table.rows.map((row) => JSON.stringify(row.slice(0, table.keys)));
          assert.equal(new Set(rows).size, rows.length, `${name}: ${table.name}`);
        }
    });

    test('every lab says of numbers of each sort what they are', () => {
      const kinds = (name) =>
        new Set(results[name].tables.flatMap(({ columns }) => columns.map(({ kind }) => kind)).filter(Boolean));
      assert.deepEqual([...kinds('bench')].sort(), ['count', 'ratio', 'time']);
      assert.deepEqual([...kinds('intersect')].sort(), ['count', 'error', 'ratio']);
      assert.deepEqual([...kinds('trace')].sort(), ['count', 'ratio', 'time']);
      assert.deepEqual([...kinds('shadows')].sort(), ['count', 'error', 'ratio', 'time']);
    });

    test('a column of times or ratios has quartiles', () => {
      for (const { tables } of Object.values(results))
        for (const { columns } of tables)
          for (const { key, kind } of columns)
            if (kind === 'time' || kind === 'ratio')
              for (const end of ['low', 'high'])
                assert.ok(
                  columns.some((column) => column.key === `${key}_${end}`),
                  `${key}_${end}`,
                );
    });

    test('every row of bench, trace and shadows has its picture, of a row that there is', () => {
      for (const [name, table] of [
        ['bench', 'bench'],
        ['trace', 'scenes'],
        ['trace', 'growth'],
        ['shadows', 'shadows'],
      ]) {
        const { tables, pictures } = results[name];
        const { keys, rows } = tables.find((one) => one.name === table);
        const pictured = pictures.filter((picture) => picture.table === table).map(({ row }) => JSON.stringify(row));
        assert.deepEqual(
          pictured,
          rows.map((row) => JSON.stringify(row.slice(0, keys))),
          table,
        );
      }
    });

    test('errors and counts of two runs are the same', () => {
      const again = join(folder, 'again.json');
      for (const name of ['intersect', 'shadows']) {
        execFileSync(gnomon, [...commands[name].split(' '), `--json=${again}`]);
        const compared = join(folder, 'compared.json');
        execFileSync(gnomon, ['report', '--against', fileOf(name), again, `--json=${compared}`]);
        const { tables } = JSON.parse(readFileSync(compared));
        assert.deepEqual(
          tables.filter((table) => /changed|missing/.test(table.name)).map(({ rows }) => rows),
          [],
        );
        const kinds = new Set(tables[0].rows.map((row) => row[2]));
        assert.ok(kinds.has('error') && kinds.has('count') && kinds.has('ratio'), [...kinds].join());
      }
    });
  });

  /** What may be wrong with a file, and what both readers say of it. */
  const spoilt = [
    [
      'another format',
      (all) => {
        all.format = 'results';
      },
      'no file of results',
    ],
    [
      'a later version',
      (all) => {
        all.version = 2;
      },
      'version 2 of results is unknown',
    ],
    [
      'no title',
      (all) => {
        delete all.title;
      },
      'title: is missing',
    ],
    [
      'a number in the environment',
      (all) => {
        all.environment.date = 7;
      },
      'environment.date: has to be a string',
    ],
    [
      'tables that are no list',
      (all) => {
        all.tables = {};
      },
      'tables: has to be a list',
    ],
    [
      'a cell that is a list',
      (all) => {
        all.tables[0].rows[1][2] = [1];
      },
      'tables[0].rows[1][2]: a list is no number, text or null',
    ],
    [
      'an unknown kind',
      (all) => {
        all.tables[0].columns[6].kind = 'tide';
      },
      'tables[0].columns[6].kind: "tide" is none of time, ratio, error, count',
    ],
    [
      'an unknown way to be better',
      (all) => {
        all.tables[0].columns[6].better = 'up';
      },
      'better: "up" is none of lower, higher',
    ],
    [
      'half a key',
      (all) => {
        all.tables[0].keys = 1.5;
      },
      'tables[0].keys: 1.5 is no number of columns',
    ],
    [
      'a chart without lines',
      (all) => {
        all.charts[0].y = [];
      },
      'charts[0].y: the chart has no lines',
    ],
    [
      'a word for yes',
      (all) => {
        all.charts[0].log_x = 'yes';
      },
      'charts[0].log_x: has to be true or false',
    ],
    [
      'a picture that is a page',
      (all) => {
        all.images[0] = 'https://example.org/a.png';
      },
      'images[0]: is no PNG as a data URL',
    ],
    [
      'a picture before the first',
      (all) => {
        all.pictures[0].image = -1;
      },
      'pictures[0].image: -1 is no image',
    ],
    [
      'a reference without a title',
      (all) => {
        delete all.pictures[0].reference.title;
      },
      'pictures[0].reference.title: is missing',
    ],
  ];
  /** What no schema can tell, but the readers do. */
  const contradictory = [
    [
      'a row too short',
      (all) => {
        all.tables[0].rows[0].pop();
      },
      'cells instead of',
    ],
    [
      'a chart of nothing',
      (all) => {
        all.charts[0].x = 'width';
      },
      'has no column "width"',
    ],
    [
      'a picture of no table',
      (all) => {
        all.pictures[0].table = 'none';
      },
      'there is no table "none"',
    ],
    [
      'a picture of half a row',
      (all) => {
        all.pictures[0].row.pop();
      },
      'pictures[0].row: the row has',
    ],
    [
      'a picture beyond the last',
      (all) => {
        all.pictures[0].image = 999;
      },
      'pictures[0].image: 999 is no image',
    ],
  ];

  describe('what is spoilt is refused', () => {
    const spoil = (change) => {
      const copy = structuredClone(results.shadows);
      change(copy);
      return copy;
    };
    const refusedByReaders = (value, words) => {
      const file = join(folder, 'spoilt.json');
      writeFileSync(file, JSON.stringify(value));
      assert.throws(
        () => readResults(JSON.stringify(value)),
        (error) => error.message.includes(words) && error.message.includes('; '),
      );
      const { status, stderr } = spawnSync(gnomon, ['report', file, '-o', join(folder, 'page.html')], {
        encoding: 'utf8',
      });
      assert.equal(status, 1);
      assert.ok(stderr.includes(words), stderr);
    };
    for (const [what, change, words] of spoilt)
      test(`${what}: by schema and readers`, () => {
        const value = spoil(change);
        assert.ok(!valid(value));
        refusedByReaders(value, words);
      });
    for (const [what, change, words] of contradictory)
      test(`${what}: by readers`, () => refusedByReaders(spoil(change), words));
    test('a member that nobody knows: by the schema', () =>
      assert.ok(
        !valid(
          spoil((all) => {
            all.tables[0].colour = 'red';
          }),
        ),
      ));
  });
});
