// Points and directions as arrays.
export const add = (a, b) => a.map((x, i) => x + b[i]);
export const sub = (a, b) => a.map((x, i) => x - b[i]);
export const scale = (s, a) => a.map((x) => s * x);
export const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
export const size = (a) => Math.sqrt(dot(a, a));
export const unit = (a) => scale(1 / size(a), a);

const degrees = (radians) => (radians * 180) / Math.PI;

/** Direction at an angle from +y, so far around it from +x towards +z; degrees. */
export const direction = (fromUp, around) => {
  const [a, b] = [fromUp, around].map((angle) => (angle * Math.PI) / 180);
  return [Math.sin(a) * Math.cos(b), Math.cos(a), Math.sin(a) * Math.sin(b)];
};

/** The "rotate" of scene files that takes +y to a direction. */
export const rotationTo = ([x, y, z]) => [degrees(Math.atan2(Math.hypot(x, z), y)), degrees(Math.atan2(x, z)), 0];
