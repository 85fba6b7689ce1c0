// The rooms of the house and who includes whom, read from the `#include "…"` lines of the C++ sources.

import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';

const libraries = ['tracer', 'lab', 'native', 'web'];

function sources(root, folder) {
  return readdirSync(join(root, folder), { withFileTypes: true }).flatMap((entry) => {
    const path = `${folder}/${entry.name}`;
    if (entry.isDirectory()) return sources(root, path);
    return /\.(h|cpp)$/.test(entry.name) ? [path] : [];
  });
}

/** The room of a file: `tracer/scene`, `lab/reference/exact`, `web`; files beside the rooms are in one of their own. */
export function roomOf(file) {
  const [library, room, reference] = dirname(file).split('/');
  if (library === 'web' || room === undefined) return library;
  return room === 'reference' && reference ? `${library}/${room}/${reference}` : `${library}/${room}`;
}

/** A map from every room, in alphabetical order, to the set of rooms that it includes. The main program is no room. */
export function readIncludes(root) {
  const all = libraries.flatMap((library) => sources(root, library)).sort();
  const files = all.filter((file) => file !== 'native/main.cpp');
  const graph = new Map([...new Set(files.map(roomOf))].sort().map((room) => [room, new Set()]));
  for (const file of files)
    for (const [, included] of readFileSync(join(root, file), 'utf8').matchAll(/^#include "([^"]+)"/gm)) {
      const room = roomOf(included);
      if (graph.has(room) && room !== roomOf(file)) graph.get(roomOf(file)).add(room);
    }
  return graph;
}

/** Rooms that include each other, in a row that begins and ends with the same one; undefined where there are none. */
export function findCircle(graph) {
  const done = new Set();
  const visit = (room, way) => {
    if (way.includes(room)) return [...way.slice(way.indexOf(room)), room];
    if (done.has(room)) return undefined;
    for (const next of graph.get(room)) {
      const circle = visit(next, [...way, room]);
      if (circle) return circle;
    }
    done.add(room);
    return undefined;
  };
  for (const room of graph.keys()) {
    const circle = visit(room, []);
    if (circle) return circle;
  }
  return undefined;
}

/** The same graph without what follows from the rest: a → c where a → b → c. Wants a graph without circles. */
export function reduced(graph) {
  const reach = new Map();
  const reachable = (room) => {
    if (!reach.has(room)) reach.set(room, new Set([...graph.get(room)].flatMap((next) => [next, ...reachable(next)])));
    return reach.get(room);
  };
  return new Map([...graph].map(([room, next]) => {
    const implied = new Set([...next].flatMap((one) => [...reachable(one)]));
    return [room, new Set([...next].filter((one) => !implied.has(one)))];
  }));
}
