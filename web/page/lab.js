// The laboratory: the page's second program, which measures beside the viewer. It loads when it is first asked for.
//
// Each piece of work has a canvas, a context and a memory of its own, from its beginning to its end, so that the view
// stays as it is and nothing is left behind. One waits for the other: each would make the other's times wrong, and a
// browser gives few contexts.

import { labCalls } from './lab_calls.js';
import { loadProgram } from './module.js';
import { watchContext } from './context.js';

const noContext =
  'the browser gives no further WebGL 2 context, which measuring needs; close other pages that draw with WebGL';

let program = null; // a promise of it, once asked for; asked for anew where it could not be loaded
let turn = Promise.resolve();

/** @param task begins a task of the loading bar, see progress.js; none is shown without */
export function loadLab(task) {
  if (program) return program;
  const loading = task?.('Loading the laboratory');
  program = loadProgram('gnomon-lab', (soFar, total) => loading?.at(soFar / total));
  program.catch(() => (program = null)).finally(() => loading?.done());
  return program;
}

/**
 * A promise of what `work(lab)` answers.
 * @param page { task }
 * @param work called with the calls of lab_calls.js, and `alive`: there is a context
 */
export function inLab({ task }, work) {
  const mine = turn.then(async () => {
    const { lab, close } = openLab(await (await loadLab(task))());
    try {
      return await work(lab);
    } finally {
      close();
    }
  });
  turn = mine.catch(() => {});
  return mine;
}

function openLab(module) {
  const canvas = Object.assign(document.createElement('canvas'), { id: 'lab', width: 1, height: 1, hidden: true });
  document.body.append(canvas); // where the program finds it by name
  if (!module.createContext('#lab')) {
    canvas.remove();
    throw new Error(noContext);
  }
  const context = watchContext(canvas, module);
  const lab = Object.defineProperty(labCalls(module), 'alive', { get: () => context.alive });
  const close = () => {
    context.end();
    context.gl.getExtension('WEBGL_lose_context')?.loseContext(); // what it holds goes at once, not some day
    canvas.remove();
  };
  return { lab, close };
}

// --- what is asked of it ---------------------------------------------------------------------------------------------

/** How exact this browser's GL computes, as docs/page.md has it. */
export const measureNumerics = (page) =>
  inLab(page, (lab) => {
    const { worst_point: worstPoint, worst_along: worstAlong, ...others } = lab.numerics();
    return { ...others, worstPoint, worstAlong };
  });

/** The answers to the rays, as docs/page.md has them; fails with the problems. */
export async function traceRays(page, scene, rays) {
  const numbers = Float32Array.from(rays);
  if (numbers.length % 8) throw new Error(`${numbers.length} numbers are no rays: each has 8, see docs/page.md`);
  const text = typeof scene === 'string' ? scene : JSON.stringify(scene);
  return inLab(page, (lab) => {
    const { problems, answers } = lab.traceRays(text, numbers);
    if (problems) throw new Error(problems);
    return answers;
  });
}
