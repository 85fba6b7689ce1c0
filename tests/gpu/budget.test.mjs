// What a scene's shader may take of a real GPU, as Mesa's RADV compiles it without one (scripts/gpu-stats).
//
// Bound  no scratch, no spilled register, and at least the waves of each row: 8 on RDNA2 are 128 registers a pixel, in
//        waves of 64 as of 32. No depth takes more: the ray stack has three entries at all of them.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..', '..');
const script = path.join(root, 'scripts', 'gpu-stats');

// Rows of the table as objects by column.
function measured(families, shader) {
  const folder = mkdtempSync(path.join(os.tmpdir(), 'gnomon-gpu-'));
  try {
    const file = path.join(folder, 'gpu.json');
    const options = [`--families=${families}`, `--json=${file}`, ...shader];
    execFileSync(script, options, { stdio: ['ignore', 'inherit', 'inherit'] });
    const { columns, rows } = JSON.parse(readFileSync(file, 'utf8')).tables[0];
    return rows.map(row => Object.fromEntries(columns.map(({ key }, i) => [key, row[i]])));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const budget = [
  { shader: ['lite'], waves: { navi21: 10, 'navi21/32': 10, gfx1100: 16, vega10: 2, polaris10: 2 } },
  { shader: ['pro'], waves: { navi21: 8, 'navi21/32': 8, gfx1100: 12, vega10: 2, polaris10: 2 } },
  { shader: ['torus'], waves: { navi21: 14, 'navi21/32': 12, gfx1100: 20, vega10: 3, polaris10: 3 } },
  { shader: ['shapes'], waves: { navi21: 8, 'navi21/32': 9, gfx1100: 14, vega10: 2, polaris10: 2 } },
  // Clear bodies in one another: a ray carries what it is inside of.
  { shader: ['tests/gpu/media.json'], waves: { navi21: 8, 'navi21/32': 9, gfx1100: 12, vega10: 2, polaris10: 2 } },
  { shader: ['pro', '--data=texture'], waves: { navi21: 8, 'navi21/32': 8, gfx1100: 12, vega10: 2, polaris10: 2 } },
  { shader: ['pro', '--depth=8'], waves: { navi21: 8, 'navi21/32': 8, gfx1100: 12, vega10: 2, polaris10: 2 } },
];

for (const { shader, waves } of budget) {
  test(`${shader.join(' ')} stays in registers and keeps its waves: ${JSON.stringify(waves)}`, () => {
    const families = Object.keys(waves), rows = measured(families, shader);
    assert.deepEqual(rows.map(row => row.family), families);
    for (const row of rows) {
      const line = JSON.stringify(row);
      assert.equal(row.scratch, 0, line);
      assert.equal(row.spilled_vgprs, 0, line);
      assert.equal(row.spilled_sgprs, 0, line);
      assert.ok(row.instructions > 500, `an empty shader is no measurement: ${line}`);
      assert.ok(row.occupancy >= waves[row.family], `fewer than ${waves[row.family]} waves: ${line}`);
    }
  });
}

test('a chip that the driver does not know is an error, not an empty table', () => {
  const { status, stderr, stdout } = spawnSync(script, ['--families=navi99', 'torus'], { encoding: 'utf8' });
  assert.notEqual(status, 0);
  assert.equal(stdout, '');
  assert.match(stderr, /no figures for navi99/);
});
