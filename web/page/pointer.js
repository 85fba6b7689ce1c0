// Mouse, pen and fingers on the canvas: one looks around, two move; the wheel moves too.

const wheelPerPixel = 0.0015; // a notch of 100 px: a pinch of 14 %

/**
 * @param tracer takes drag(dx, dy, height) and pinch(ratio, dx, dy, height), all in one unit of length: CSS pixels
 */
export function listenToPointers(canvas, tracer) {
  const fingers = new Map();
  const height = () => canvas.clientHeight || 1;

  const spread = () => {
    const [a, b] = [...fingers.values()];
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, distance: Math.hypot(a.x - b.x, a.y - b.y) };
  };

  canvas.addEventListener('pointerdown', (event) => {
    if (event.pointerType === 'mouse' && event.button !== 0) return;
    if (fingers.size === 2) return;
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    try {
      canvas.setPointerCapture(event.pointerId); // a drag goes on outside the canvas
    } catch {
      // a pointer that is already gone, or that a script made up: it is followed as long as it is over the canvas
    }
    canvas.classList.add('dragging');
    if (document.activeElement instanceof HTMLElement) document.activeElement.blur(); // keys go to the view again
  });

  canvas.addEventListener('pointermove', (event) => {
    const finger = fingers.get(event.pointerId);
    if (!finger) return;
    const to = { x: event.clientX, y: event.clientY };
    if (fingers.size === 1) {
      tracer.drag(to.x - finger.x, to.y - finger.y, height());
      fingers.set(event.pointerId, to);
      return;
    }
    const before = spread();
    fingers.set(event.pointerId, to);
    const now = spread();
    const ratio = before.distance > 0 && now.distance > 0 ? now.distance / before.distance : 1;
    tracer.pinch(ratio, now.x - before.x, now.y - before.y, height());
  });

  const end = (event) => {
    fingers.delete(event.pointerId);
    canvas.classList.toggle('dragging', fingers.size > 0);
  };
  canvas.addEventListener('pointerup', end);
  canvas.addEventListener('pointercancel', end);
  canvas.addEventListener('lostpointercapture', end);

  canvas.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault(); // a pinch on a touchpad comes as ctrl + wheel and would zoom the page
      const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 32 : event.deltaY;
      tracer.pinch(Math.exp(-pixels * wheelPerPixel), 0, 0, height());
    },
    { passive: false },
  );
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
}
