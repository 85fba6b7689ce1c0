// The scenes that are made by rule are what scripts/make-scenes makes.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..', '..');

test('every scene made by rule is the one that stands among the assets', () => {
  const out = mkdtempSync(path.join(os.tmpdir(), 'gnomon-scenes-'));
  try {
    execFileSync(process.execPath, [path.join(root, 'scripts', 'make-scenes'), '--out', out]);
    const files = readdirSync(out);
    assert.ok(files.length >= 7);
    for (const file of files)
      assert.equal(
        readFileSync(path.join(out, file), 'utf8'),
        readFileSync(path.join(root, 'assets', 'scenes', file), 'utf8'),
      );
  } finally {
    rmSync(out, { recursive: true });
  }
});
