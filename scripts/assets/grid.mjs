// Grid: one cell of the ground, to be repeated; its middle is white, its border a dark line, with finer lines between.
//
// makeGrid() -> {'grid.png': picture}
//
// The lines have soft profiles a few texels wide, and the finer ones are fainter: on the way down the mip levels the
// fine lines melt into the cell first and the border last, to a grey that differs little from the cell's mean.
const size = 512;

const lines = [
  { perCell: 1, halfWidth: 5, depth: 0.62 },
  { perCell: 2, halfWidth: 2.4, depth: 0.3 },
  { perCell: 8, halfWidth: 1.5, depth: 0.15 },
];

// 1 on a line, 0 away from it, and a soft edge of one texel and a half between.
function lineAt(x, { perCell, halfWidth }) {
  const spacing = size / perCell;
  const offset = ((x % spacing) + spacing) % spacing;
  const distance = Math.min(offset, spacing - offset);
  const t = Math.min(1, Math.max(0, (halfWidth + 0.75 - distance) / 1.5));
  return t * t * (3 - 2 * t);
}

export function makeGrid() {
  const data = new Uint8Array(size * size);
  for (let y = 0; y < size; ++y) {
    for (let x = 0; x < size; ++x) {
      // The heaviest of the lines through a texel, not their product: crossings stay as dark as the lines.
      const darkest = Math.max(...lines.map((line) =>
        line.depth * Math.max(lineAt(x + 0.5, line), lineAt(y + 0.5, line))));
      data[y * size + x] = Math.round(250 * (1 - darkest));
    }
  }
  return { 'grid.png': { width: size, height: size, channels: 1, data } };
}
