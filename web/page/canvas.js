// The canvas in device pixels: as large as its place on the screen, or fixed by `?size=WxH`.

/** Width and height of `WxH`, or null. */
export function parseSize(text) {
  const match = /^(\d{1,5})x(\d{1,5})$/.exec(text ?? '');
  return match ? { width: Number(match[1]), height: Number(match[2]) } : null;
}

/**
 * Keeps the canvas' pixels in step with its place on the screen.
 * @param onSize called with the new (width, height) in canvas pixels
 * @returns { fix({ width, height } or null) }
 */
export function fitCanvas(canvas, onSize) {
  let fixed = null;
  let box = { width: 0, height: 0 };

  const apply = () => {
    const width = fixed?.width ?? Math.max(1, Math.round(box.width));
    const height = fixed?.height ?? Math.max(1, Math.round(box.height));
    if (canvas.width === width && canvas.height === height) return;
    canvas.width = width;
    canvas.height = height;
    onSize(width, height);
  };

  const measure = (entry) => {
    const rect = canvas.getBoundingClientRect();
    const about = { width: rect.width * devicePixelRatio, height: rect.height * devicePixelRatio };
    const exact = entry?.devicePixelContentBoxSize?.[0]; // where it is known, no pixel is stretched
    const near = (a, b) => Math.abs(a - b) <= 2; // with an emulated pixel ratio it knows only the real one
    const trusted = exact && near(exact.inlineSize, about.width) && near(exact.blockSize, about.height);
    box = trusted ? { width: exact.inlineSize, height: exact.blockSize } : about;
    apply();
  };
  const observer = new ResizeObserver((entries) => measure(entries.at(-1)));
  try {
    observer.observe(canvas, { box: 'device-pixel-content-box' });
  } catch {
    observer.observe(canvas);
  }
  measure(); // the observer answers a frame later, the first picture should not wait for it

  // Where the observer cannot tell, a move to a screen of another pixel ratio changes no CSS size.
  const watchRatio = () =>
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener(
      'change',
      () => {
        measure();
        watchRatio();
      },
      { once: true },
    );
  watchRatio();

  return {
    fix(size) {
      fixed = size;
      canvas.classList.toggle('fixed', fixed !== null);
      canvas.style.setProperty('--ratio', fixed ? fixed.width / fixed.height : 1);
      apply();
    },
  };
}
