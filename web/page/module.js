// A program compiled to WebAssembly, as a JavaScript object: text and numbers in, text and typed arrays out. Here is
// what the two programs of the page share, as web/host.h has it: loading, strings, the context, the files that scenes
// name.
//
// What a call means stands at its C twin in web/context.cpp and web/*_exports.cpp. Calls that answer a string of
// problems answer '' when all is well.

import { fetchCounted } from './load.js';

/**
 * Loads `gnomon` or `gnomon-lab`.
 * @param onBytes called with (bytes so far, bytes in all) meanwhile
 * @returns start(given): a promise of the calls of a new instance, which has its own memory; `given` are the functions
 *   of the page that the program calls
 */
export async function loadProgram(name, onBytes) {
  const script = new URL(`../${name}.js`, import.meta.url);
  const [wasm, { default: createModule }] = await Promise.all([
    fetchCounted(new URL(`../${name}.wasm`, import.meta.url), onBytes, 'application/wasm').then((response) =>
      WebAssembly.compileStreaming(response),
    ),
    import(script).catch((error) => {
      throw new Error(`${name}.js: ${error.message}`);
    }),
  ]);
  return (given = {}) =>
    new Promise((resolve, reject) => {
      const instantiateWasm = (imports, done) => {
        WebAssembly.instantiate(wasm, imports).then(done, reject);
        return {}; // the instance comes later
      };
      createModule({ ...given, instantiateWasm }).then((module) => resolve(callsOf(module)), reject);
    });
}

function callsOf(module) {
  const text = (address) => module.UTF8ToString(address);

  // Calls an exported function with JavaScript strings, which live in the module's memory for the call, and numbers.
  const call = (name, ...values) => {
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
  const callForText = (...asked) => text(call(...asked));

  const callWithBytes = (name, string, bytes, count = bytes.length, ...more) => {
    const bytesAt = module._malloc(bytes.length);
    module.HEAPU8.set(bytes, bytesAt);
    const answer = callForText(name, string, bytesAt, count, ...more);
    module._free(bytesAt);
    return answer;
  };

  const readback = (name, Type) => {
    const at = call(name) >> 2;
    const [width, height, channels, data] = module.HEAP32.subarray(at, at + 4);
    const values = new Type(module.HEAPU8.buffer, data, width * height * channels);
    return { width, height, channels, data: values.slice() }; // a copy: the memory may grow and move
  };

  const doubles = (name, count) => {
    const at = call(name) >> 3;
    return [...module.HEAPF64.subarray(at, at + count)];
  };

  return {
    call,
    callForText,
    callWithBytes,
    readback,
    doubles,

    createContext: (selector) => call('createContext', selector) !== 0,
    contextLost: () => call('contextLost'),
    contextRestored: () => call('contextRestored'),
    renderer: () => callForText('glRenderer'),

    sceneFiles: (json) => linesOf(callForText('sceneFiles', json)),
    giveFile: (path, bytes) => void callWithBytes('giveFile', path, bytes),
    measure: (name, bytes) => callWithBytes('measureImageFile', name, bytes),
  };
}

export const linesOf = (text) => text.split('\n').filter(Boolean);

/** Lines `key=value` in their order. */
export const pairsOf = (lines) =>
  linesOf(lines).map((line) => [line.slice(0, line.indexOf('=')), line.slice(line.indexOf('=') + 1)]);
