// How exact this browser's GL computes: measured once a page, when nobody waits for anything. It blocks the page for as
// long as a shader compiles.

const calmMs = 1000;

// Safari has no idle callbacks.
const whenIdle = (work) => (window.requestIdleCallback ? requestIdleCallback(work) : setTimeout(work));

/**
 * Answers measure(): a promise of what was found, as docs/page.md has it, the same one each time.
 * @param onFound called with it, once
 */
export function numericsOf({ tracer, session }, onFound) {
  const measure = () => {
    const { worst_point: worstPoint, worst_along: worstAlong, ...others } = tracer.numerics();
    const found = { ...others, worstPoint, worstAlong };
    onFound(found);
    return found;
  };
  let found = null;
  return () => (found ??= session.withContext(measure));
}

/** Calls `work` once the picture stands in full resolution, view and settings have rested and the browser is idle. */
export function whenCalm({ tracer, session }, work) {
  let before = '';
  const state = () => [session.sceneName, ...[...tracer.settings()].filter(([key]) => key !== 'time')].join();
  const calm = () => !document.hidden && session.resting && tracer.sharp() && state() === before;
  const look = () => {
    if (calm()) return whenIdle(() => (calm() ? work() : later()));
    before = state();
    later();
  };
  const later = () => setTimeout(look, calmMs);
  later();
}
