// The schema admits exactly what the program does: for each field of the format and each of its limits a value at the
// limit, one beyond it, and one of another type is asked of a JSON-schema validator and of `gnomon check`.
//
// The fields and limits are walked in the schema, which is written from the tables that the reader uses. What no single
// field can tell, a schema cannot say: the scenes here are sound as a whole.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import Ajv2020 from 'ajv/dist/2020.js';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '..', '..');
const gnomon = process.env.GNOMON_BINARY ?? path.join(root, 'build/native/gnomon');
const schema = JSON.parse(readFileSync(path.join(root, 'assets/scenes/scene.schema.json')));
const admits = new Ajv2020({ strict: false }).compile(schema);
const folder = mkdtempSync(path.join(os.tmpdir(), 'gnomon-schema-'));
after(() => rmSync(folder, { recursive: true }));
writeFileSync(path.join(folder, 'a.obj'), 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
const net = Array.from({ length: 16 }, (_, k) => `${k % 4} 0 ${Math.floor(k / 4)}\n`);
writeFileSync(path.join(folder, 'a.bpt'), `1\n3 3\n${net.join('')}`);

/** Whether the program takes the scene; a file that it names and that is not there is no fault of the format. */
function takes(scene) {
  const file = path.join(folder, 'scene.json');
  writeFileSync(file, JSON.stringify(scene));
  const { status, stderr } = spawnSync(gnomon, ['check', file], { encoding: 'utf8' });
  const problems = stderr.split('\n').filter((line) => line && !/is missing|No such file/.test(line));
  assert.ok(status === 0 || status === 1, `exit ${status}: ${stderr}`);
  return { right: problems.length === 0, stderr };
}

const resolved = (node) => (node.$ref ? schema.$defs[node.$ref.split('/').pop()] : node);

/** What some fields need to make sense as a whole, whatever their limits. */
const sensible = {
  eye: [0, 0, 3], target: [0, 0, 0], up: [0, 1, 0], from: [0, 0, 0], to: [0, 1, 0], major_radius: 1, minor_radius: 0.25,
  vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], count: [1, 1, 1], period: [1, 1, 1], power: 8, iterations: 4,
  points: Array.from({ length: 16 }, (_, k) => [k % 4, 0, Math.floor(k / 4)]), surface: { file: 'a.bpt' },
  radii: [1, 1, 1], half_size: [1, 1, 1], radius: 1, file: 'a.obj', image: 'grid', of: undefined, ior: 1.5,
}; // prettier-ignore
const sphere = { sphere: { center: [0, 0, 0], radius: 1 } };

/** Lists of keys one of which stands in the object, and pairs that do not stand in it together. */
const alternatives = (node) => (node.allOf ?? []).filter((rule) => rule.oneOf);
const exclusions = (node) =>
  (node.allOf ?? [])
    .filter((rule) => rule.not)
    .flatMap((rule) => rule.not.anyOf.map((other) => [rule.not.required[0], other.required[0]]));

/** A value that the node admits, as small as can be. */
function example(node, key) {
  if (sensible[key] !== undefined) return sensible[key];
  node = resolved(node);
  if (key === 'of' && node.type === 'string') return 'thing';
  if (node === schema.$defs.object || node === schema.$defs.part) return sphere;
  if (node.enum) return node.enum[0];
  if (node.anyOf) return example(node.anyOf[0], key);
  if (node.type === 'boolean') return true;
  if (node.type === 'number' || node.type === 'integer') return Math.min(Math.max(1, node.minimum), node.maximum);
  if (node.type === 'string') return 'x'.repeat(Math.max(1, node.minLength ?? 1));
  if (node.type === 'array') return Array.from({ length: Math.max(1, node.minItems) }, () => example(node.items));
  if (node.type !== 'object') return 'anything';
  const keys = new Set(node.required ?? []);
  for (const group of alternatives(node)) if (group.oneOf[0].required) keys.add(group.oneOf[0].required[0]);
  return Object.fromEntries([...keys].map((name) => [name, example(node.properties[name], name)]));
}

/** The same object with one key more, and without those that exclude it. */
function withKey(node, object, key, value) {
  const result = { ...object, [key]: value };
  for (const group of alternatives(node)) {
    const keys = group.oneOf.flatMap((one) => one.required ?? []);
    if (keys.includes(key)) for (const other of keys) if (other !== key) delete result[other];
  }
  return result;
}

const step = (limit) => Math.max(Math.abs(limit) * 1e-6, 1e-9);

/** Values at the limits of a node and beyond, and of other types. */
function* values(node, key) {
  node = resolved(node);
  yield null;
  if (node.type !== 'string') yield 'text';
  if (node.type !== 'object') yield {};
  if (node.enum) yield* [...node.enum, `${node.enum[0]}s`];
  for (const one of node.anyOf ?? []) yield* values(one, key);
  if (node.type === 'boolean') yield* [true, false, 1];
  if (node.type === 'number' || node.type === 'integer') {
    yield* [node.minimum, node.maximum, node.minimum - step(node.minimum), node.maximum + step(node.maximum)];
    yield (node.minimum + node.maximum) / 2 + 0.25;
  }
  if (node.type === 'string') {
    for (const length of [node.minLength, node.maxLength, node.maxLength + 1, node.minLength - 1])
      if (length >= 0 && length < 5000) yield 'x'.repeat(length);
    if (node.pattern)
      yield* ['a.b', 'a b', 'a/b', '../a', '/a', 'a/', '.a', 'a/.b', 'a//b', 'ä', '', 'a\\b', '-a', 'a\n'];
    else yield* ['ä'.repeat(node.maxLength), '😀'.repeat(node.maxLength)];
  }
  if (node.type === 'array') yield* lists(node, key);
  if (node.type === 'object') yield* objects(node, key);
}

function* lists(node, key) {
  const all = example(node, key);
  const few = all.slice(0, node.minItems);
  const filled = (count) => Array.from({ length: count }, (_, i) => all[i % all.length]);
  yield few;
  if (node.minItems > 0) yield all.slice(0, node.minItems - 1);
  if (node.maxItems <= 300) yield* [filled(node.maxItems), filled(node.maxItems + 1)];
  if (node.not) yield [0, 0, 0];
  const item = resolved(node.items);
  if (item.type === 'object') {
    for (const value of objects(item, key)) yield [value];
    return;
  }
  for (let i = 0; i < all.length; ++i)
    for (const value of values(item, undefined)) yield all.map((old, k) => (k === i ? value : old));
}

/** Formats whose fields have been gone through: one that stands in several places has the same limits in all. */
const walked = new Set();

function* objects(node, key) {
  node = resolved(node);
  const base = example(node, key);
  yield base;
  const format = JSON.stringify(node);
  if (walked.has(format)) return;
  walked.add(format);
  if (!node.properties) {
    const named = (name) => ({ [name]: example(node.additionalProperties) });
    yield* [{}, named(''), named('x'.repeat(64)), named('x'.repeat(65)), named('ä'.repeat(64))];
    for (const count of [node.maxProperties, node.maxProperties + 1])
      yield Object.fromEntries(Array.from({ length: count }, (_, i) => [`n${i}`, example(node.additionalProperties)]));
    for (const value of objects(node.additionalProperties, key)) yield { n: value };
    return;
  }
  yield { ...base, unknown: 1 };
  for (const name of Object.keys(base)) {
    const { [name]: gone, ...rest } = base;
    yield rest;
  }
  for (const pair of exclusions(node))
    yield pair.reduce((object, name) => withKey(node, object, name, example(node.properties[name], name)), base);
  for (const group of alternatives(node)) {
    const [one, other] = group.oneOf.flatMap((each) => each.required ?? []);
    yield { ...base, [one]: example(node.properties[one], one), [other]: example(node.properties[other], other) };
  }
  for (const [name, property] of Object.entries(node.properties))
    for (const value of values(property, name)) yield withKey(node, base, name, value);
}

/** What the schema cannot say, and the program does: reasons that it may give for refusing what the schema admits. */
const beyondSchemas = new RegExp(
  [
    'same point|parallel to the view|around itself|unknown (object|material|definition)|only spheres can glow',
    'has no area|has no axis|times its shortest|times the shorter side|its heights span|torus is not supported',
    'has no end|need a period|may meet|parts',
    'only a single object|becomes ',
  ].join('|'),
);

test('schema and program agree at both sides of every limit', () => {
  const definitions = { thing: sphere };
  const materials = { m: {} };
  const seen = new Set();
  const disagreements = [];
  for (const change of objects(schema)) {
    const scene = { definitions, materials, ...change };
    if (change.objects === undefined) delete scene.objects;
    const text = JSON.stringify(scene);
    if (seen.has(text)) continue;
    seen.add(text);
    const schemaSays = admits(scene);
    const { right, stderr } = takes(scene);
    if (schemaSays === right || (schemaSays && beyondSchemas.test(stderr))) continue;
    disagreements.push(`${text.slice(0, 300)}: schema ${schemaSays}, program ${right}: ${stderr.slice(0, 300)}`);
  }
  console.log(`${seen.size} scenes`);
  assert.ok(seen.size > 1000);
  assert.deepEqual(disagreements, []);
});
