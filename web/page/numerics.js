// How exact this browser's GL computes: measured once a page, when nobody waits for anything. It blocks the page for as
// long as a shader compiles.

const calmMs = 1000;

// Safari has no idle callbacks.
const whenIdle = (work) => (window.requestIdleCallback ? requestIdleCallback(work) : setTimeout(work));

/**
 * Answers measure(): a promise of what was found, as docs/page.md has it, the same one each time; it fails where the
 * laboratory does not load, and the next call tries again.
 * @param onFound called with it, once
 */
export function numericsOf(page, onFound) {
  const measure = async () => {
    const { measureNumerics } = await import('./lab.js');
    const numerics = await measureNumerics(page);
    onFound(numerics);
    return numerics;
  };
  let found = null;
  return () => {
    found ??= measure();
    found.catch(() => (found = null));
    return found;
  };
}

/** Measures by itself, the first time that it can without being in anybody's way. */
export async function numericsWhenCalm(page) {
  if (navigator.connection?.saveData) return;
  await calmOf(page);
  const { loadLab } = await import('./lab.js');
  await loadLab();
  await calmOf(page); // the user may have moved on meanwhile
  await page.numerics();
}

/** Once the picture stands in full resolution, view and settings have rested and the browser is idle. */
const calmOf = ({ tracer, session }) =>
  new Promise((resolve) => {
    let before = '';
    const state = () => [session.sceneName, ...[...tracer.settings()].filter(([key]) => key !== 'time')].join();
    const calm = () => !document.hidden && session.resting && tracer.sharp() && state() === before;
    const look = () => {
      if (calm()) return whenIdle(() => (calm() ? resolve() : later()));
      before = state();
      later();
    };
    const later = () => setTimeout(look, calmMs);
    later();
  });
