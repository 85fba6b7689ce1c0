// Lays a graph without circles out in rows, each room above all that it includes (Sugiyama, Tagawa, Toda 1981): rows by
// longest paths, order within a row by the mean of its neighbours, positions by least squares. Equal graphs give equal
// pictures.

const sweeps = 40;

function rows(graph) {
  const depth = new Map();
  const depthOf = (room) => {
    if (!depth.has(room)) depth.set(room, Math.max(-1, ...[...graph.get(room)].map(depthOf)) + 1);
    return depth.get(room);
  };
  for (const room of graph.keys()) depthOf(room);
  // A room with more users than rooms below it moves up to its users, which shortens the lines.
  const users = (room) => [...graph.keys()].filter((other) => graph.get(other).has(room));
  for (const room of [...graph.keys()].sort((a, b) => depth.get(b) - depth.get(a))) {
    const above = users(room);
    if (above.length > graph.get(room).size) depth.set(room, Math.min(...above.map((user) => depth.get(user))) - 1);
  }
  return depth;
}

/** Nodes by row from the bottom, and links from row to row; a line that passes a row gets a bend, a node of no room. */
function layers(graph, depth) {
  const nodes = [...graph.keys()].map((room) => ({ room, row: depth.get(room), down: [], up: [] }));
  const byRoom = new Map(nodes.map((node) => [node.room, node]));
  const join = (upper, lower) => { upper.down.push(lower); lower.up.push(upper); };
  const lines = [];
  for (const [room, included] of graph)
    for (const target of included) {
      const line = [byRoom.get(room)];
      while (line.at(-1).row > depth.get(target) + 1) {
        const bend = { row: line.at(-1).row - 1, down: [], up: [] };
        nodes.push(bend);
        join(line.at(-1), bend);
        line.push(bend);
      }
      join(line.at(-1), byRoom.get(target));
      lines.push([...line, byRoom.get(target)]);
    }
  const inRow = (row) => nodes.filter((node) => node.row === row);
  const all = Array.from({ length: Math.max(...depth.values()) + 1 }, (_, row) => inRow(row));
  return { all, lines };
}

const sum = (values) => values.reduce((total, value) => total + value, 0);
const mean = (values, otherwise) => (values.length ? sum(values) / values.length : otherwise);

function crossings(all) {
  let count = 0;
  for (const row of all) {
    const links = row.flatMap((node) => node.down.map((lower) => [node.slot, lower.slot]));
    for (const [a, b] of links) for (const [c, d] of links) if (a < c && b > d) count++;
  }
  return count;
}

const number = (row) => row.forEach((node, slot) => { node.slot = slot; });

function order(all) {
  all.forEach(number);
  let best = { count: Infinity };
  for (let sweep = 0; sweep < sweeps; sweep++) {
    const upwards = sweep % 2 === 0;
    for (const row of upwards ? all : [...all].reverse()) {
      const neighbours = (node) => (upwards ? node.down : node.up).map(({ slot }) => slot);
      const wish = new Map(row.map((node) => [node, mean(neighbours(node), node.slot)]));
      row.sort((a, b) => wish.get(a) - wish.get(b) || a.slot - b.slot);
      number(row);
    }
    const count = crossings(all);
    if (count < best.count) best = { count, rows: all.map((row) => [...row]) };
  }
  best.rows.forEach(number);
  return best.rows;
}

/** Positions nearest to the wished ones that keep a row's nodes apart: nodes in each other's way are moved as one. */
function settle(row, wishes, apart) {
  const groups = [];
  let offset = 0;
  row.forEach((node, i) => {
    offset += i === 0 ? 0 : apart(row[i - 1], node);
    let group = { nodes: [[node, offset]], total: wishes[i] - offset };
    while (groups.length && groups.at(-1).total / groups.at(-1).nodes.length >= group.total / group.nodes.length) {
      const before = groups.pop();
      group = { nodes: [...before.nodes, ...group.nodes], total: before.total + group.total };
    }
    groups.push(group);
  });
  for (const { nodes, total } of groups) for (const [node, shift] of nodes) node.x = total / nodes.length + shift;
}

/** Where a node would like to be: bends weigh more than rooms, so that long lines are straight. */
function wished(node) {
  const weighed = [...node.down, ...node.up].flatMap((other) => {
    const bends = [node, other].filter(({ room }) => !room).length;
    return Array.from({ length: 4 ** bends }, () => other.x);
  });
  return mean(weighed, node.x);
}

/**
 * Rows from the bottom, whose nodes have `x`, their middle, and lines as lists of nodes. `apart(a, b)`: the distance
 * that the middles of two neighbours keep.
 */
export function layout(graph, apart) {
  const { all, lines } = layers(graph, rows(graph));
  const ordered = order(all);
  for (const row of ordered) settle(row, row.map(() => 0), apart);
  for (let sweep = 0; sweep < sweeps; sweep++)
    for (const row of sweep % 2 === 0 ? ordered : [...ordered].reverse())
      settle(row, row.map(wished), apart);
  return { rows: ordered, lines };
}
