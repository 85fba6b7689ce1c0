// The source document's way of tracing, for a browser: what lab/reference/textbook does for the desktop.
//
//   await page.evaluate((files) => window.gnomon.shaders(files), await sourceShaders());
//   await page.evaluate((scene) => window.gnomon.load(scene), await sourceScene('pro'));
import { readFile, readdir } from 'node:fs/promises';
import { join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));

/** Texts by the names of the library's files that they take the place of: sourceShaders() of textbook.h. */
export async function sourceShaders() {
  const folder = join(root, 'lab/reference/textbook');
  const all = (await readdir(folder, { recursive: true })).filter((name) => name.endsWith('.glsl'));
  const named = (name) => (name.startsWith('source') ? relative('source', name) : name);
  const read = async (name) => [named(name), await readFile(join(folder, name), 'utf8')];
  return Object.fromEntries(await Promise.all(all.map(read)));
}

const skyDistance = 10_000;

// A face of a cube map: where it lies, and the ways in which its image's columns and rows run: OpenGL 4.6, table 8.19,
// with x mirrored (docs/scenes.md).
const skyFaces = {
  px: { outward: [-1, 0, 0], across: [0, 0, -1], down: [0, -1, 0] },
  nx: { outward: [1, 0, 0], across: [0, 0, 1], down: [0, -1, 0] },
  py: { outward: [0, 1, 0], across: [-1, 0, 0], down: [0, 0, 1] },
  ny: { outward: [0, -1, 0], across: [-1, 0, 0], down: [0, 0, -1] },
  pz: { outward: [0, 0, 1], across: [-1, 0, 0], down: [0, -1, 0] },
  nz: { outward: [0, 0, -1], across: [1, 0, 0], down: [0, -1, 0] },
};

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const sum = (...vectors) => [0, 1, 2].map((axis) => vectors.reduce((total, vector) => total + vector[axis], 0));
const times = (vector, factor) => vector.map((value) => value * factor);

/** The plane that shows one face, and its material: a plane's uv is in scene units, from the stated point on. */
function skyPlane(suffix, cubemap) {
  const { outward, across, down } = skyFaces[suffix];
  const name = `${cubemap}-${suffix}`;
  const tangent = outward[0] === 0 ? [1, 0, 0] : [0, 0, -1];
  const bitangent = cross(tangent, times(outward, -1));
  const scale = times([dot(across, tangent), dot(down, bitangent)], 1 / (2 * skyDistance));
  const point = times(sum(outward, times(across, -1), times(down, -1)), skyDistance);
  return {
    object: { plane: { point, normal: times(outward, -1) }, material: name, casts_shadow: false },
    material: [name, { emission: 1, texture: { image: name, scale } }],
  };
}

/** Two triangles a face, wound so that their normals point out of the box. */
function trianglesOf({ center, half_size: half }) {
  const triangles = [];
  for (const axis of [0, 1, 2])
    for (const side of [-1, 1]) {
      const along = (which, length) => [0, 1, 2].map((k) => (k === which ? length * half[k] : 0));
      const [u, v] = [along((axis + 1) % 3, 1), along((axis + 2) % 3, side)];
      const corner = (a, b) => sum(center, along(axis, side), times(u, a), times(v, b));
      triangles.push([corner(-1, -1), corner(1, -1), corner(1, 1)], [corner(-1, -1), corner(1, 1), corner(-1, 1)]);
    }
  return triangles;
}

function withoutBoxes(object) {
  const { box, ...rest } = object;
  if (!box) return [object];
  const nameOf = (i) => rest.name && `${rest.name}-${i}`;
  return trianglesOf(box).map((vertices, i) => ({ ...rest, name: nameOf(i), triangle: { vertices } }));
}

/** A scene that comes with the program, as S1 modelled it: sourceScene() of source_scene.h. */
export async function sourceScene(name) {
  const text = await readFile(join(root, 'assets/scenes', `${name}.json`), 'utf8');
  const scene = JSON.parse(text.replace(/^\s*\/\/.*$|(?<=[\],}])\s*\/\/.*$/gm, ''));
  const sky = Object.keys(skyFaces).map((suffix) => skyPlane(suffix, scene.background.cubemap));
  scene.objects = [...scene.objects.flatMap(withoutBoxes), ...sky.map(({ object }) => object)];
  scene.materials = { ...scene.materials, ...Object.fromEntries(sky.map(({ material }) => material)) };
  delete scene.background;
  return scene;
}
