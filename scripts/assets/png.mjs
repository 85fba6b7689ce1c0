// PNG: the smallest lossless file that this encoder knows for a picture of 8-bit grey or RGB texels.
//
// encodePng({width, height, channels, data}) -> Buffer; channels is 1 (grey) or 3 (RGB), row 0 is the top
//
// A picture whose texels are all grey is stored as grey, one of at most 256 colours as a palette (of 1, 2, 4 or 8
// bits). Every row filter is tried, and the smallest result kept. No chunk holds a date or a program's name, so that
// equal pictures give equal bytes.
import zlib from 'node:zlib';

const signature = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);
const colorType = { grey: 0, rgb: 2, palette: 3 };

const crcTable = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let bit = 0; bit < 8; ++bit) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});

function crc(bytes) {
  let c = 0xffffffff;
  for (const byte of bytes) c = crcTable[(c ^ byte) & 255] ^ (c >>> 8);
  return (c ^ 0xffffffff) >>> 0;
}

function chunk(type, content) {
  const bytes = Buffer.alloc(content.length + 12);
  bytes.writeUInt32BE(content.length, 0);
  bytes.write(type, 4, 'latin1');
  content.copy(bytes, 8);
  bytes.writeUInt32BE(crc(bytes.subarray(4, content.length + 8)), content.length + 8);
  return bytes;
}

function paeth(left, up, corner) {
  const p = left + up - corner;
  const a = Math.abs(p - left), b = Math.abs(p - up), c = Math.abs(p - corner);
  return a <= b && a <= c ? left : b <= c ? up : corner;
}

const predictors = [
  () => 0,
  (left) => left,
  (left, up) => up,
  (left, up) => (left + up) >> 1,
  paeth,
];

// One row after the given filter, its type byte first.
function filteredRow(rows, stride, step, y, type) {
  const out = Buffer.alloc(stride + 1);
  const predict = predictors[type], at = y * stride;
  out[0] = type;
  for (let i = 0; i < stride; ++i) {
    const left = i >= step ? rows[at + i - step] : 0;
    const up = y > 0 ? rows[at + i - stride] : 0;
    const corner = y > 0 && i >= step ? rows[at + i - stride - step] : 0;
    out[i + 1] = rows[at + i] - predict(left, up, corner);
  }
  return out;
}

function deflateSmallest(rows, stride, step, height) {
  const plans = [[], [], [], [], [], []];          // five fixed filters, and the row-wise choice of least magnitude
  for (let y = 0; y < height; ++y) {
    let best = null, least = Infinity;
    for (let type = 0; type < 5; ++type) {
      const row = filteredRow(rows, stride, step, y, type);
      let magnitude = 0;
      for (let i = 1; i < row.length; ++i) magnitude += row[i] < 128 ? row[i] : 256 - row[i];
      plans[type].push(row);
      if (magnitude < least) { least = magnitude; best = row; }
    }
    plans[5].push(best);
  }
  let smallest = null;
  for (const plan of plans) {
    const bytes = Buffer.concat(plan);
    for (const strategy of [zlib.constants.Z_DEFAULT_STRATEGY, zlib.constants.Z_FILTERED]) {
      const packed = zlib.deflateSync(bytes, { level: 9, memLevel: 9, windowBits: 15, strategy });
      if (smallest === null || packed.length < smallest.length) smallest = packed;
    }
  }
  return smallest;
}

function isGrey({ channels, data }) {
  if (channels === 1) return true;
  for (let i = 0; i < data.length; i += 3) if (data[i] !== data[i + 1] || data[i] !== data[i + 2]) return false;
  return true;
}

// The colours in ascending order, or null where there are more than 256.
function paletteOf({ channels, data }) {
  const colors = new Set();
  for (let i = 0; i < data.length; i += channels) {
    colors.add(channels === 1 ? data[i] * 0x10101 : (data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
    if (colors.size > 256) return null;
  }
  return [...colors].sort((a, b) => a - b);
}

function packBits(indices, width, height, bits) {
  if (bits === 8) return indices;
  const stride = Math.ceil((width * bits) / 8), rows = Buffer.alloc(stride * height);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const bit = x * bits;
      rows[y * stride + (bit >> 3)] |= indices[y * width + x] << (8 - bits - (bit & 7));
    }
  }
  return rows;
}

export function encodePng(image) {
  const { width, height, channels, data } = image;
  const grey = isGrey(image), palette = paletteOf(image);
  let type = colorType.rgb, bits = 8, step = 3, rows = data;
  if (grey && (palette === null || palette.length > 16)) {
    type = colorType.grey;
    step = 1;
    rows = channels === 1 ? data : Uint8Array.from({ length: width * height }, (_, i) => data[3 * i]);
  } else if (palette !== null) {
    type = colorType.palette;
    step = 1;
    bits = palette.length <= 2 ? 1 : palette.length <= 4 ? 2 : palette.length <= 16 ? 4 : 8;
    const indexOf = new Map(palette.map((color, index) => [color, index]));
    const indices = new Uint8Array(width * height);
    for (let i = 0; i < indices.length; ++i) {
      const at = i * channels;
      indices[i] =
        indexOf.get(channels === 1 ? data[at] * 0x10101 : (data[at] << 16) | (data[at + 1] << 8) | data[at + 2]);
    }
    rows = packBits(indices, width, height, bits);
  }
  const stride = rows.length / height;
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header[8] = bits;
  header[9] = type;
  const chunks = [signature, chunk('IHDR', header)];
  if (type === colorType.palette) {
    chunks.push(chunk('PLTE', Buffer.from(palette.flatMap((color) => [color >> 16, (color >> 8) & 255, color & 255]))));
  }
  chunks.push(chunk('IDAT', deflateSmallest(rows, stride, step, height)), chunk('IEND', Buffer.alloc(0)));
  return Buffer.concat(chunks);
}
