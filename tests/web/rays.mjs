// Batches of rays through the page's traceRays, and what they do in truth, in doubles: for measuring a browser's GL.
//
// A ray is { origin, direction } in numbers that float32 holds. solve() knows of a solid only its signed distance.

const add = (a, b, s = 1) => a.map((value, i) => value + s * b[i]);
const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);
const scaled = (a, s) => a.map((value) => value * s);
const unit = (a) => scaled(a, 1 / Math.hypot(...a));
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const float = (a) => a.map(Math.fround);

/** A sphere, or with `major` a torus about `axis`, as the shader has it: its numbers in float32. */
export function solid({ center, radius, major = 0, axis = [0, 0, 1] }) {
  const middle = float(center),
    up = unit(float(unit(axis))),
    minor = Math.fround(radius),
    ring = Math.fround(major);
  const distance = (point) => {
    const p = add(point, middle, -1);
    if (ring === 0) return Math.hypot(...p) - minor;
    const height = dot(p, up);
    return Math.hypot(Math.hypot(...add(p, up, -height)) - ring, height) - minor;
  };
  const shape = ring
    ? { torus: { center, axis, major_radius: major, minor_radius: radius } }
    : { sphere: { center, radius } };
  return { center: middle, axis: up, ring, minor, size: ring + minor, distance, scene: { objects: [shape] } };
}

/** Numbers in [low, high), the same in every run. */
export function randomNumbers(seed = 1) {
  let state = BigInt(seed);
  return (low, high) => {
    state = BigInt.asUintN(64, state * 6364136223846793005n + 1442695040888963407n);
    return low + (high - low) * Number(state >> 11n) * 2 ** -53;
  };
}

const directionFrom = (number) => {
  const z = number(-1, 1),
    around = number(0, 2 * Math.PI),
    r = Math.sqrt(1 - z * z);
  return [r * Math.cos(around), r * Math.sin(around), z];
};
const ray = (origin, towards) => ({ origin: float(origin), direction: float(unit(towards)) });

/** From `far` away towards a point in the bounding sphere. */
export function uniformRay(shape, far, number) {
  const origin = add(shape.center, directionFrom(number), far);
  const aim = add(shape.center, directionFrom(number), shape.size * Math.cbrt(number(0, 1)));
  return ray(origin, add(aim, origin, -1));
}

/** From `far` away, tangent to the solid but for the rounding of its origin. */
export function grazingRay(shape, far, number) {
  const out = unit(cross(shape.axis, directionFrom(number))),
    around = number(0, 2 * Math.PI);
  const normal = shape.ring ? add(scaled(out, Math.cos(around)), shape.axis, Math.sin(around)) : directionFrom(number);
  const point = add(add(shape.center, out, shape.ring), normal, shape.minor);
  const way = unit(cross(normal, directionFrom(number)));
  return ray(add(point, way, -far), way);
}

/** Where the ray first enters the solid: { hit, t, tangency }; `tangency` is how far it is from doing another thing. */
export function solve({ distance, center, size }, { origin, direction }) {
  const along = (t) => distance(add(origin, direction, t));
  const middle = dot(add(center, origin, -1), direction) / dot(direction, direction);
  const samples = 128,
    reach = 1.02 * size,
    step = (2 * reach) / samples,
    from = middle - reach;
  let tangency = Infinity,
    outside = from,
    before = along(from),
    here = along(from + step);
  for (let i = 1; i < samples; ++i) {
    const t = from + i * step,
      next = along(t + step);
    if (here <= before && here <= next) {
      const bottom = bottomOf(along, t - step, t + step),
        depth = along(bottom);
      tangency = Math.min(tangency, Math.abs(depth));
      if (depth < 0) return { hit: true, t: entryBetween(along, outside, bottom), tangency };
    }
    if (here > 0) outside = t;
    before = here;
    here = next;
  }
  return { hit: false, t: Infinity, tangency };
}

function bottomOf(along, low, high) {
  for (let i = 0; i < 45; ++i) {
    const a = low + (high - low) / 3,
      b = high - (high - low) / 3;
    if (along(a) < along(b)) high = b;
    else low = a;
  }
  return (low + high) / 2;
}

function entryBetween(along, outside, inside) {
  for (let i = 0; i < 50; ++i) {
    const middle = (outside + inside) / 2;
    if (along(middle) < 0) inside = middle;
    else outside = middle;
  }
  return (outside + inside) / 2;
}

const ulp = (x) => 2 ** (Math.floor(Math.log2(x)) - 23);

/**
 * Holds the page's answers against the truth.
 * @returns { compared, wrong, worstPoint, worstAlong }: rays beyond 2^-22 of the size from tangency, those of them that
 *   missed, hit or stopped wrongly, worst distance of the surface point in 2^-23 of the size, of o + t d in ulp of t
 */
export function compareHits(shape, rays, answers) {
  const found = { compared: 0, wrong: 0, worstPoint: 0, worstAlong: 0 };
  rays.forEach((one, i) => {
    const truth = solve(shape, one);
    if (truth.tangency < 2 ** -22 * shape.size) return;
    found.compared += 1;
    const [object, t, ...rest] = answers.subarray(8 * i, 8 * i + 8);
    if (!truth.hit && object < 0) return;
    const at = (s) => Math.abs(shape.distance(add(one.origin, one.direction, s)));
    const slack = 4 * (ulp(truth.t) + ulp(shape.size)); // between the two stops the ray stays at the surface
    const steps = Array.from({ length: 33 }, (_, k) => truth.t + ((t - truth.t) * k) / 32);
    const right = truth.hit && object === 0 && steps.every((step) => at(step) <= slack);
    if (!right) return void (found.wrong += 1);
    found.worstPoint = Math.max(found.worstPoint, Math.abs(shape.distance(rest.slice(0, 3))) / (2 ** -23 * shape.size));
    found.worstAlong = Math.max(found.worstAlong, at(t) / ulp(truth.t));
  });
  return found;
}

/** The rays as traceRays takes them. */
export const packed = (rays) =>
  Float32Array.from(rays.flatMap(({ origin, direction }) => [...origin, 0, ...direction, 0]));

/** Calls gnomon.traceRays in the page. The numbers cross as base64: JSON is longer and loses infinities. */
export async function traceRays(page, scene, rays) {
  const answer = await page.evaluate(
    async (text, base64) => {
      const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
      const answers = new Uint8Array((await window.gnomon.traceRays(text, new Float32Array(bytes.buffer))).buffer);
      let letters = '';
      for (let i = 0; i < answers.length; i += 8192) letters += String.fromCharCode(...answers.subarray(i, i + 8192));
      return btoa(letters);
    },
    typeof scene === 'string' ? scene : JSON.stringify(scene),
    Buffer.from(rays.buffer, rays.byteOffset, rays.byteLength).toString('base64'),
  );
  const bytes = Buffer.from(answer, 'base64');
  return new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
}
