// The viewer's program as a JavaScript object: see module.js.

import { linesOf, loadProgram, pairsOf } from './module.js';

/**
 * Loads and starts it.
 * @param report called with each line the user should know of
 * @param onBytes called with (bytes so far, bytes in all) while it loads
 */
export async function startTracer({ report, onBytes }) {
  const start = await loadProgram('gnomon', onBytes);
  return wrap(await start({ report }));
}

function wrap(module) {
  const { call, callForText, callWithBytes, readback, doubles } = module;
  return {
    ...module,

    createViewer: (lines, place) => callForText('createViewer', lines, place),
    table: () => JSON.parse(callForText('settingsTableJson')),

    loadScene: (json, name) => callForText('loadScene', json, name),
    imageNames: () => linesOf(callForText('imageNames')),
    give: (name, bytes, width) => callWithBytes('giveImage', name, bytes, bytes.length, width),

    set: (key, value, place) => callForText('setSetting', key, String(value), place),
    settings: () => new Map(pairsOf(callForText('settingsText'))),
    urlQuery: () => callForText('urlQuery'),

    keyDown: (key) => void call('keyDown', key),
    keyUp: (key) => void call('keyUp', key),
    releaseAllKeys: () => call('releaseAllKeys'),
    drag: (dx, dy, height) => call('drag', dx, dy, height),
    pinch: (ratio, dx, dy, height) => call('pinch', ratio, dx, dy, height),

    resize: (width, height) => call('resize', width, height),
    frame: (seconds) => call('frame', seconds) !== 0,
    sharp: () => call('sharp') !== 0,
    shownScale: () => call('shownScale'),
    takeProblems: () => callForText('takeProblems'),
    /** How far the picture is that scene and settings ask for; images that load are the session's. */
    progress() {
      const [compiled, images, baked, samples, ...flags] = doubles('progress', 7);
      const [compiling, ready, failed] = flags.map(Boolean);
      return { compiled, images, baked, samples, compiling, ready, failed };
    },
    compileMs: () => call('compileMs'),
    sourceBytes: () => call('sourceBytes'),
    liveGlObjects: () => call('liveGlObjects'),
    source: () => callForText('shaderSource'),
    replaceShaders(files) {
      for (const [name, glsl] of Object.entries(files)) call('addShader', name, glsl);
      return callForText('useShaders');
    },
    framesPerSecond: () => call('framesPerSecond'),
    title: () => callForText('title'),

    drawAndWait: () => call('drawAndWait'),
    readPicture: () => readback('readPicture', Uint8ClampedArray),
    readOutput: () => readback('readOutput', Float32Array),
  };
}
