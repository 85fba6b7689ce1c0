// A canvas' WebGL context as the browser takes it and gives it back, told to the program that draws in it.

/**
 * @param module as module.js gives it, which has made the context
 * @param told { lost(), restored() }, each called after the program has heard of it
 * @returns { gl, alive: there is a context, end(): of watching }
 */
export function watchContext(canvas, module, { lost, restored } = {}) {
  const gl = canvas.getContext('webgl2'); // the program's own: asked only whether it lives and is done
  const watching = new AbortController();
  let gone = false;
  const listen = (event, act) => canvas.addEventListener(`webglcontext${event}`, act, { signal: watching.signal });
  listen('lost', (event) => {
    event.preventDefault(); // without this it never comes back
    gone = true;
    module.contextLost();
    lost?.();
  });
  listen('restored', () => {
    gone = false;
    module.contextRestored();
    restored?.();
  });
  return {
    gl,
    get alive() {
      return !gone && !gl.isContextLost();
    },
    end: () => watching.abort(),
  };
}
