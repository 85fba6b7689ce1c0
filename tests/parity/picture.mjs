// Pictures compared pixel by pixel: PNG as hosts show them, PFM as the shader computed them.
import { readFileSync, writeFileSync } from 'node:fs';
import { PNG } from 'pngjs';

export const readPng = (file) => PNG.sync.read(readFileSync(file));

/** One-channel PFM: rows top to bottom. */
export function readPfm(file) {
  const bytes = readFileSync(file);
  const header = /^Pf\n(\d+) (\d+)\n(-[\d.]+)\n/.exec(bytes.subarray(0, 64).toString('latin1'));
  if (!header) throw new Error(`${file} is no one-channel little-endian PFM`);
  const width = Number(header[1]),
    height = Number(header[2]);
  const data = new Float32Array(width * height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x)
      data[(height - 1 - y) * width + x] = bytes.readFloatLE(header[0].length + 4 * (y * width + x));
  return { width, height, data };
}

/** Share of pixels whose channels all agree within `tolerance`, and which do not. */
export function agreement(a, b, tolerance) {
  if (a.width !== b.width || a.height !== b.height) throw new Error('the pictures have different sizes');
  const apart = [];
  for (let i = 0; i < a.width * a.height; ++i) {
    const off = Math.max(...[0, 1, 2].map((c) => Math.abs(a.data[4 * i + c] - b.data[4 * i + c])));
    if (off > tolerance) apart.push({ x: i % a.width, y: Math.floor(i / a.width), off });
  }
  return { share: 1 - apart.length / (a.width * a.height), apart };
}

/** Is there another value within one pixel of (x, y)? */
export function onAnEdge(image, x, y) {
  const here = image.data[y * image.width + x];
  for (let dy = -1; dy <= 1; ++dy)
    for (let dx = -1; dx <= 1; ++dx) {
      const nx = x + dx,
        ny = y + dy;
      if (nx >= 0 && ny >= 0 && nx < image.width && ny < image.height && image.data[ny * image.width + nx] !== here)
        return true;
    }
  return false;
}

/** Differences, ten times enlarged, for a person to look at. */
export function writeDifference(a, b, file) {
  const picture = new PNG({ width: a.width, height: a.height });
  for (let i = 0; i < a.width * a.height; ++i) {
    for (let c = 0; c < 3; ++c)
      picture.data[4 * i + c] = Math.min(255, 10 * Math.abs(a.data[4 * i + c] - b.data[4 * i + c]));
    picture.data[4 * i + 3] = 255;
  }
  writeFileSync(file, PNG.sync.write(picture));
}
