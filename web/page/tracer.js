// The tracer, compiled to WebAssembly, as a JavaScript object: text and numbers in, text and typed arrays out.
//
// What a call means stands at its C twin in web/context.cpp and web/*_exports.cpp. Calls that answer a string of
// problems answer '' when all is well.

import { fetchCounted } from './load.js';

/**
 * Loads and starts the module.
 * @param report called with each line the user should know of
 * @param onBytes called with (bytes so far, bytes in all) while it loads
 */
export async function startTracer({ report, onBytes }) {
  const wasm = fetchCounted(new URL('../gnomon.wasm', import.meta.url), onBytes, 'application/wasm');
  wasm.catch(() => {}); // told below, once the module asks for it
  const { default: createModule } = await import('../gnomon.js');
  return new Promise((resolve, reject) => {
    const instantiateWasm = (imports, done) => {
      wasm
        .then((response) => WebAssembly.instantiateStreaming(response, imports))
        .then(({ instance, module }) => done(instance, module))
        .catch(reject);
      return {}; // the instance comes later
    };
    createModule({ report, instantiateWasm }).then((module) => resolve(wrap(module)), reject);
  });
}

function wrap(module) {
  const text = (address) => module.UTF8ToString(address);

  // Calls an exported function with JavaScript strings, which live in the module's memory for the call, and numbers.
  const withStrings = (name, ...values) => {
    const addresses = [];
    const given = values.map((value) => {
      if (typeof value === 'number') return value;
      const size = module.lengthBytesUTF8(value) + 1;
      const address = module._malloc(size);
      module.stringToUTF8(value, address, size);
      addresses.push(address);
      return address;
    });
    const answer = module[`_${name}`](...given);
    addresses.forEach(module._free);
    return answer;
  };

  const withBytes = (name, string, bytes, count = bytes.length, ...more) => {
    const size = module.lengthBytesUTF8(string) + 1;
    const nameAt = module._malloc(size);
    const bytesAt = module._malloc(bytes.length);
    module.stringToUTF8(string, nameAt, size);
    module.HEAPU8.set(bytes, bytesAt);
    const answer = module[`_${name}`](nameAt, bytesAt, count, ...more);
    module._free(bytesAt);
    module._free(nameAt);
    return answer;
  };

  const readback = (address, Type) => {
    const [width, height, channels, data] = module.HEAP32.subarray(address >> 2, (address >> 2) + 4);
    const values = new Type(module.HEAPU8.buffer, data, width * height * channels);
    return { width, height, channels, data: values.slice() }; // a copy: the memory may grow and move
  };

  return {
    createContext: (selector) => withStrings('createContext', selector) !== 0,
    createViewer: (lines, place) => text(withStrings('createViewer', lines, place)),
    table: () => JSON.parse(text(module._settingsTableJson())),

    sceneFiles: (json) => text(withStrings('sceneFiles', json)).split('\n').filter(Boolean),
    giveFile: (path, bytes) => void withBytes('giveFile', path, bytes),
    loadScene: (json, name) => text(withStrings('loadScene', json, name)),
    imageNames: () => text(module._imageNames()).split('\n').filter(Boolean),
    measure: (name, bytes) => text(withBytes('measureImageFile', name, bytes)),
    give: (name, bytes, width) => text(withBytes('giveImage', name, bytes, bytes.length, width)),

    set: (key, value, place) => text(withStrings('setSetting', key, String(value), place)),
    settings: () => new Map(pairsOf(text(module._settingsText()))),
    urlQuery: () => text(module._urlQuery()),

    keyDown: (key) => void withStrings('keyDown', key),
    keyUp: (key) => void withStrings('keyUp', key),
    releaseAllKeys: () => module._releaseAllKeys(),
    drag: (dx, dy, height) => module._drag(dx, dy, height),
    pinch: (ratio, dx, dy, height) => module._pinch(ratio, dx, dy, height),

    resize: (width, height) => module._resize(width, height),
    frame: (seconds) => module._frame(seconds) !== 0,
    sharp: () => module._sharp() !== 0,
    shownScale: () => module._shownScale(),
    takeProblems: () => text(module._takeProblems()),
    /** How far the picture is that scene and settings ask for; images that load are the session's. */
    progress() {
      const at = module._progress() >> 3;
      const [compiled, images, baked, samples, ...flags] = module.HEAPF64.subarray(at, at + 7);
      const [compiling, ready, failed] = flags.map(Boolean);
      return { compiled, images, baked, samples, compiling, ready, failed };
    },
    compileMs: () => module._compileMs(),
    sourceBytes: () => module._sourceBytes(),
    liveGlObjects: () => module._liveGlObjects(),
    source: () => text(module._shaderSource()),
    replaceShaders(files) {
      for (const [name, glsl] of Object.entries(files)) withStrings('addShader', name, glsl);
      return text(module._useShaders());
    },
    framesPerSecond: () => module._framesPerSecond(),
    title: () => text(module._title()),
    glRenderer: () => text(module._glRenderer()),

    drawAndWait: () => module._drawAndWait(),
    readPicture: () => readback(module._readPicture(), Uint8ClampedArray),
    readOutput: () => readback(module._readOutput(), Float32Array),

    numerics: () => JSON.parse(text(module._measureNumerics())),
    /** Answers { problems, answers }: eight numbers a ray, in and out. */
    traceRays(json, rays) {
      const bytes = new Uint8Array(rays.buffer, rays.byteOffset, rays.byteLength);
      const problems = text(withBytes('traceRays', json, bytes, rays.length / 8));
      return { problems, answers: readback(module._tracedRays(), Float32Array).data };
    },

    /** For modules that load later: calls an export with strings and numbers, or bytes; answers text or a number. */
    call: (name, ...values) => withStrings(name, ...values),
    callForText: (name, ...values) => text(withStrings(name, ...values)),
    callWithBytes: (name, string, bytes) => text(withBytes(name, string, bytes)),

    contextLost: () => module._contextLost(),
    contextRestored: () => module._contextRestored(),
  };
}

/** Lines `key=value` in their order. */
export function pairsOf(lines) {
  const pairOf = (line) => [line.slice(0, line.indexOf('=')), line.slice(line.indexOf('=') + 1)];
  return lines.split('\n').filter(Boolean).map(pairOf);
}
