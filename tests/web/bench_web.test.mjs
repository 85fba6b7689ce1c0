// scripts/bench-web from outside: what it writes, what it refuses, what it keeps.
import { after, before, describe, test } from 'node:test';
import { strict as assert } from 'node:assert';
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { browserNames } from './browsers.mjs';
import { merged } from './merge_results.mjs';

const script = fileURLToPath(new URL('../../scripts/bench-web', import.meta.url));
const gnomon = process.env.GNOMON_BINARY ?? 'build/native/gnomon';
const tiny = ['lite', '--depths=1', '--shadows=off,hard', '--sizes=32x24'];

describe('scripts/bench-web', () => {
  let folder;
  before(() => (folder = mkdtempSync(join(tmpdir(), 'gnomon-bench-web-'))));
  after(() => rmSync(folder, { recursive: true, force: true }));

  const run = (...words) => spawnSync(script, words, { encoding: 'utf8' });
  const read = (file) => JSON.parse(readFileSync(join(folder, file), 'utf8'));

  test('writes one file of results of several browsers, with the columns of the desktop', () => {
    const [json, html] = ['all.json', 'all.html'].map((file) => join(folder, file));
    const { status, stdout, stderr } = run(
      ...tiny,
      `--browsers=${browserNames.join(',')}`,
      '--repeats=3',
      '--goes=2', // the earlier spelling of --sessions
      '--baseline=shadows=hard',
      `--json=${json}`,
      `--html=${html}`,
    );
    assert.equal(status, 0, stderr);
    assert.match(stdout, /Times are medians.*3 of 3/);
    const all = read('all.json');
    const names = browserNames.map((name) => `webgl2-${name}`);
    assert.equal(
      all.command,
      `scripts/bench-web lite --browsers=${browserNames.join(',')} --depth=1 --shadows=off,hard --size=32x24 ` +
        '--baseline=shadows=hard --repeats=3 --sessions=2',
    );
    assert.deepEqual(
      all.tables[0].rows.map((row) => row.slice(0, 5)),
      names.flatMap((name) => ['off', 'hard'].map((shadows) => ['lite', name, '32x24', 1, shadows])),
    );
    assert.equal(all.environment.rounds, names.map((name) => `${name} 3 of 3`).join(', '));
    const passes = all.tables[0].columns.findIndex(({ key }) => key === 'passes');
    assert.deepEqual(
      all.tables[0].rows.map((row) => row[passes]),
      all.tables[0].rows.map(() => 2),
      'a browser of its own for each session',
    );
    assert.equal(all.charts.length, names.length, 'one for each browser');
    const native = join(folder, 'native.json');
    execFileSync(gnomon, ['bench', ...tiny, '--repeats=1', '--baseline=shadows=hard', `--json=${native}`]);
    assert.deepEqual(
      all.tables[0].columns.filter(({ key }) => key !== 'gpu'),
      read('native.json').tables[0].columns,
    );
    assert.match(readFileSync(html, 'utf8'), /gnomon-results/);
    execFileSync(gnomon, ['report', native, json, '-o', join(folder, 'both.html')]);
  });

  test('keeps what it measured where it is interrupted', async () => {
    const json = join(folder, 'kept.json');
    const bench = spawn(script, [...tiny, `--browsers=${browserNames[0]}`, '--repeats=10000', `--json=${json}`]);
    let said = '';
    bench.stdout.on('data', (data) => (said += data));
    // It is there after the first round.
    while (!existsSync(json) && bench.exitCode === null) await new Promise((resolve) => setTimeout(resolve, 50));
    bench.kill('SIGINT');
    const code = await new Promise((resolve) => bench.once('exit', resolve));
    assert.equal(code, 130, said);
    assert.match(said, /Interrupted: what was measured is kept\./);
    assert.match(read('kept.json').environment.rounds, /of 10000; interrupted$/);
    assert.equal(read('kept.json').tables[0].rows.length, 2);
    execFileSync(gnomon, ['report', json, '-o', join(folder, 'kept.html')]);
  });

  for (const [words, code, what] of [
    [['--browsers=chromium,lynx'], 2, "there is no browser 'lynx' here; use chromium or firefox"],
    [['--repeats=0'], 2, 'command line: repeats: 0 is out of range; use 1…10000'],
    [['--json=none/all.json'], 2, 'none/all.json: there is no folder none; make it first'],
    [['-x'], 2, 'there is no option -x'],
    [['--depth'], 2, 'write it as --depth=VALUE'],
  ])
    test(`refuses ${words} before a browser starts`, () => {
      const { status, stderr } = run(...words);
      assert.equal(status, code);
      assert.ok(stderr.includes(what), stderr);
    });

  test('refuses settings as the desktop does', () => {
    const browsers = `--browsers=${browserNames[0]}`;
    const { status, stderr } = run('lite', browsers, '--depth=1,9', '--shadow=off');
    assert.equal(status, 2);
    assert.match(stderr, /command line: depth: 9 is out of range; use 1…8/);
    assert.match(stderr, /did you mean 'shadows'\?/);
    assert.equal(run('lit', browsers).status, 1);
  });

  test('tells of a browser that is missing, and explains itself', () => {
    const missing = spawnSync(script, tiny, { encoding: 'utf8', env: { ...process.env, FIREFOX: '/nowhere/firefox' } });
    assert.equal(missing.status, 3);
    assert.match(missing.stderr, /browsers: FIREFOX=\/nowhere\/firefox: there is no such program/);
    const help = run('--help');
    assert.equal(help.status, 0);
    assert.match(help.stdout, /--browsers/);
  });
});

test('results of several browsers become one, also where only one of them times its GPU', () => {
  const result = (context, columns, row) => ({
    environment: { context, system: 'x', gl: `of ${context}` },
    tables: [{ name: 'bench', columns: columns.map((key) => ({ key })), rows: [row] }],
    charts: ['a', 'b', 'c'].map((name) => ({ where: { context: name } })),
  });
  const one = merged(
    [result('a', ['scene', 'fps'], ['lite', 1]), result('b', ['scene', 'fps', 'gpu'], ['lite', 2, 3])],
    'again',
  );
  assert.deepEqual(one.tables[0].rows, [
    ['lite', 1, null],
    ['lite', 2, 3],
  ]);
  assert.deepEqual(one.environment, { context: 'a; b', system: 'x', gl: 'a: of a; b: of b' });
  assert.deepEqual(
    one.charts.map(({ where }) => where.context),
    ['a', 'b'],
    'c was never measured',
  );
  assert.equal(one.command, 'again');
});
