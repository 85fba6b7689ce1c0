// Moon: a procedural one. Craters by a power law, each with bowl, rim and blanket; dark plains on the side that faces
// longitude 0; bright rays about the young. Everything is measured on the sphere: there is no seam, and the poles are
// whole.
//
// makeMoon() -> {'moon-color.png': picture, 'moon-normal.png': picture}
import { clamp, fractal, gradientNoise, mix, randomStream, smoothstep } from './noise.mjs';
import { direction, latitudeOf, normalMap, texelDirection } from './sphere.mjs';

const width = 1024, height = 512;
const degree = Math.PI / 180;

// Dark plains: longitude, latitude, radius in degrees, depth. In the manner of the real near side, not its map.
const maria = [
  [-32, 34, 20, 1], [-45, 14, 19, 0.9], [-38, -8, 15, 0.75], [16, 28, 12, 1], [19, 18, 9, 0.8], [30, 8, 14, 1],
  [58, 16, 8, 0.95], [49, -5, 10, 0.85], [-23, -20, 11, 0.8], [-39, -24, 7, 0.9], [4, 56, 8, 0.35], [-14, 55, 9, 0.4],
  [35, -15, 6, 0.7], [88, -3, 6, 0.5], [148, 27, 5, 0.7], [-95, -20, 4, 0.5],
];

// Young craters with rays: longitude, latitude, radius of the crater and of its rays in degrees.
const young = [
  [-11, -43, 1.7, 46], [-20, 9.5, 1.5, 19], [-38, 8, 0.9, 11], [62, -20, 1.3, 20], [-47, 24, 1, 12],
  [100, 36, 1.4, 26], [-128, -4, 1.5, 30], [170, -32, 1.2, 22], [-84, 52, 1.1, 15], [28, 62, 0.9, 13],
];

const radiusMost = 6.5 * degree, radiusLeast = 0.42 * degree, craterCount = 5200;

function makeCraters() {
  const random = randomStream(1969);
  const craters = [];
  for (let i = 0; i < craterCount; ++i) {
    // N(larger than r) ~ r^-1.9, cut off at both ends.
    const share = random();
    const least = Math.pow(radiusLeast, -1.9), most = Math.pow(radiusMost, -1.9);
    const radius = Math.pow(least + share * (most - least), -1 / 1.9);
    const z = 2 * random() - 1, angle = 2 * Math.PI * random(), flat = Math.sqrt(1 - z * z);
    craters.push({ center: [flat * Math.cos(angle), flat * Math.sin(angle), z], radius, age: random() });
  }
  craters.sort((a, b) => b.radius - a.radius);      // the small came later: they lie on the large
  for (const [lon, lat, radius] of young)
    craters.push({ center: direction(lon, lat), radius: radius * degree, age: 0 });
  return craters;
}

// Calls visit(texel, angle) for all texels within `reach` of `center`, angles in radians.
function forTexelsNear(directions, center, reach, visit) {
  const latitude = Math.asin(clamp(center[2], -1, 1)), longitude = Math.atan2(center[1], center[0]);
  const top = Math.max(0, Math.floor(((Math.PI / 2 - latitude - reach) / Math.PI) * height - 1));
  const bottom = Math.min(height - 1, Math.ceil(((Math.PI / 2 - latitude + reach) / Math.PI) * height + 1));
  const limit = Math.cos(reach);
  for (let y = top; y <= bottom; ++y) {
    const rowLatitude = latitudeOf(y, height) * degree;
    // The cosine of the longitude difference at which this row leaves the cap.
    const edge = (limit - Math.sin(rowLatitude) * center[2]) / (Math.cos(rowLatitude) * Math.cos(latitude));
    if (!(edge <= 1)) continue;
    const half = edge <= -1 ? Math.PI : Math.acos(edge);
    const middle = ((longitude + Math.PI) / (2 * Math.PI)) * width, span = (half / (2 * Math.PI)) * width;
    const from = span >= width / 2 - 1 ? 0 : Math.floor(middle - span),
      to = span >= width / 2 - 1 ? width - 1 : Math.ceil(middle + span);
    for (let x = from; x <= to; ++x) {
      const texel = y * width + ((x % width) + width) % width;
      const dot =
        directions[3 * texel] * center[0] + directions[3 * texel + 1] * center[1]
        + directions[3 * texel + 2] * center[2];
      if (dot > limit) visit(texel, Math.acos(clamp(dot, -1, 1)));
    }
  }
}

// Height in crater radii at r crater radii from the middle: a bowl, or for the large a flat floor with a peak; a rim; a
// blanket.
function craterProfile(r, large) {
  const floor = mix(-0.16, -0.1, large);
  const bowl = floor + (0.05 - floor) * Math.pow(r, mix(2.2, 5, large));
  const peak = large * 0.07 * Math.exp(-r * r * 60);
  if (r < 1) return bowl + peak;
  return 0.05 * Math.pow(r, -3.2) * smoothstep(2.4, 1.4, r);
}

export function makeMoon() {
  const texels = width * height;
  const directions = new Float64Array(texels * 3);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) directions.set(texelDirection(x, y, width, height), (y * width + x) * 3);
  }
  const shape = gradientNoise(11), texture = gradientNoise(12), tone = gradientNoise(13);
  const mare = new Float32Array(texels), heights = new Float32Array(texels), albedo = new Float32Array(texels);

  const basins =
    maria.map(([lon, lat, radius, depth]) => ({ center: direction(lon, lat), radius: radius * degree, depth }));
  for (let i = 0; i < texels; ++i) {
    const [x, y, z] = directions.subarray(3 * i, 3 * i + 3);
    const ragged =
      0.3 * fractal(shape, 6, 4 * x, 4 * y, 4 * z, 0.55) + 0.06 * fractal(texture, 3, 14 * x, 14 * y, 14 * z);
    let open = 1;
    for (const { center, radius, depth } of basins) {
      const angle = Math.acos(clamp(x * center[0] + y * center[1] + z * center[2], -1, 1));
      open *= 1 - depth * smoothstep(0.06, -0.07, angle - radius + ragged);
    }
    mare[i] = 1 - open;
    const rough = fractal(texture, 6, 5 * x, 5 * y, 5 * z, 0.6);
    heights[i] = (1 - 0.8 * mare[i]) * 0.012 * rough - 0.006 * mare[i];
    albedo[i] = mix(0.63 + 0.12 * fractal(tone, 6, 4 * x, 4 * y, 4 * z, 0.6) + 0.05 * rough,
      0.34 + 0.12 * fractal(tone, 5, 5 * x, 5 * y, 5 * z, 0.6), mare[i]);
  }

  for (const { center, radius, age } of makeCraters()) {
    // Plains flooded most of what was older than they are: few and small craters are left on them.
    const middle = texelOf(center);
    if (age > 0 && mare[middle] > 0.4 && (age > 0.22 || radius > 2 * degree)) continue;
    const large = smoothstep(1.5 * degree, 3.5 * degree, radius), freshness = age === 0 ? 1 : mix(1, 0.35, age);
    let ground = 0, count = 0;
    forTexelsNear(directions, center, Math.max(radius, 0.007), (i) => { ground += heights[i]; ++count; });
    ground = count > 0 ? ground / count : heights[middle];
    forTexelsNear(directions, center, 2.4 * radius + 0.004, (i, angle) => {
      const r = angle / radius, inside = smoothstep(1.05, 0.7, r) * freshness;
      heights[i] = mix(heights[i], ground, 0.8 * inside) + freshness * radius * craterProfile(r, large);
      const rim = Math.exp(-Math.pow((r - 1) / 0.16, 2)), bowl = smoothstep(0.95, 0.6, r);
      albedo[i] += freshness * (0.05 * rim - 0.035 * bowl * (1 - mare[i])) + 0.02 * freshness * smoothstep(2.2, 1, r);
    });
  }

  const streak = gradientNoise(14);
  young.forEach(([lon, lat, radius, reach], index) => {
    const center = direction(lon, lat);
    const east = [-Math.sin(lon * degree), Math.cos(lon * degree), 0];
    const north = direction(lon, lat + 90);
    forTexelsNear(directions, center, reach * degree, (i, angle) => {
      const d = directions.subarray(3 * i, 3 * i + 3);
      const e = d[0] * east[0] + d[1] * east[1] + d[2] * east[2],
        n = d[0] * north[0] + d[1] * north[1] + d[2] * north[2];
      const length = Math.hypot(e, n) || 1, along = angle / (reach * degree), r = angle / (radius * degree);
      // Noise over the direction only makes straight rays; a little of the distance in it breaks them up.
      const ray = fractal(streak, 3, 4.2 * (e / length) + 10 * index, 4.2 * (n / length), 1.1 * along);
      const broken = 0.75 + 0.5 * fractal(texture, 3, 22 * d[0], 22 * d[1], 22 * d[2]);
      const own =
        0.4 + 0.6 * smoothstep(-0.5, 0.5, streak(1.7 * (e / length) + 5, 1.7 * (n / length) - 10 * index, 0.5));
      const rays = smoothstep(own, own * 0.4, along) * smoothstep(0.08, 0.42, ray) * broken * smoothstep(1, 2, r);
      const halo = Math.exp(-Math.pow(r / 2.6, 2));
      albedo[i] += 0.2 * rays * (1 - 0.5 * along) + 0.22 * halo;
    });
  });

  const data = new Uint8Array(texels * 3);
  for (let i = 0; i < texels; ++i) {
    const level = Math.round(clamp(albedo[i], 0.05, 0.98) * 200) / 200;
    // The tint depends on the level alone, so that the file needs no more than a palette.
    data[3 * i] = Math.round(255 * level);
    data[3 * i + 1] = Math.round(255 * level * 0.985);
    data[3 * i + 2] = Math.round(255 * level * mix(0.965, 0.95, level));
  }
  return {
    'moon-color.png': { width, height, channels: 3, data },
    'moon-normal.png': normalMap(heights, width, height),
  };
}

function texelOf([x, y, z]) {
  const column = Math.floor(((Math.atan2(y, x) + Math.PI) / (2 * Math.PI)) * width) % width;
  return Math.min(height - 1, Math.floor((Math.acos(clamp(z, -1, 1)) / Math.PI) * height)) * width + column;
}
