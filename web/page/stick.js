// The stick for thumbs: pushed a little it walks at half speed, pushed to the rim at full speed, in eight directions.

const idle = 0.2; // of the radius: a resting thumb does not walk
const full = 0.65;

/** The keys that stand for the stick at (x, y), in radii, y down. */
export function keysOf(x, y) {
  const length = Math.hypot(x, y);
  if (length < idle) return new Set();
  const keys = new Set();
  const octant = Math.sin(Math.PI / 8);
  if (-y / length > octant) keys.add('W');
  if (y / length > octant) keys.add('S');
  if (-x / length > octant) keys.add('A');
  if (x / length > octant) keys.add('D');
  if (length < full) keys.add('Shift');
  return keys;
}

/** @param keys { down(name), up(name) } */
export function listenToStick(stick, keys) {
  const knob = stick.firstElementChild;
  let held = new Set();
  let pointer = null;

  const hold = (wanted) => {
    for (const key of held) if (!wanted.has(key)) keys.up(key);
    for (const key of wanted) if (!held.has(key)) keys.down(key);
    held = wanted;
  };

  const move = (event) => {
    const box = stick.getBoundingClientRect();
    const radius = box.width / 2;
    const x = (event.clientX - box.left - radius) / radius;
    const y = (event.clientY - box.top - radius) / radius;
    const shorten = 1 / Math.max(1, Math.hypot(x, y));
    knob.style.translate = `${x * shorten * radius * 0.6}px ${y * shorten * radius * 0.6}px`;
    hold(keysOf(x, y));
  };

  stick.addEventListener('pointerdown', (event) => {
    if (pointer !== null) return;
    pointer = event.pointerId;
    try {
      stick.setPointerCapture(pointer);
    } catch {
      // see pointer.js
    }
    move(event);
  });
  stick.addEventListener('pointermove', (event) => event.pointerId === pointer && move(event));
  const end = (event) => {
    if (event.pointerId !== pointer) return;
    pointer = null;
    knob.style.translate = '';
    hold(new Set());
  };
  stick.addEventListener('pointerup', end);
  stick.addEventListener('pointercancel', end);
  stick.addEventListener('lostpointercapture', end);
}
