// window.gnomon: the page for scripts and tests, described in docs/page.md.

import { events } from './events.js';

const median = (values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];

/** Makes window.gnomon at once; open() fills it with life, fail() makes `ready` fail. */
export function makeApi() {
  const { on, emit } = events();
  let open, fail;
  const ready = new Promise((resolve, reject) => {
    open = resolve;
    fail = reject;
  });
  ready.catch(() => {}); // the page says it, a script may not ask
  const api = { ready, on, firstFrameMs: null, sharpFrameMs: null };
  window.gnomon = api;

  return {
    emit,
    fail,
    first: (ms) => void (api.firstFrameMs = ms),
    sharp: (ms) => void (api.sharpFrameMs = ms),

    /** @param page what connect() in main.js makes */
    open(page) {
      const { tracer, session, set, load, numerics } = page;
      const check = (problems) => {
        if (problems) throw new Error(problems);
      };
      const known = (key) => {
        const settings = tracer.settings();
        if (!settings.has(key)) throw new Error(`there is no setting '${key}'; gnomon.settings() lists them`);
        return settings.get(key);
      };

      const methods = {
        load,
        set: (key, value) => check(set(key, String(value), 'script')),
        get: known,
        settings: () => Object.fromEntries(tracer.settings()),
        table: () => tracer.table(),
        settled: () => session.settled(),

        async image() {
          await session.settled();
          const { width, height, data } = tracer.readPicture();
          return new ImageData(data, width, height);
        },

        async png() {
          const image = await methods.image();
          const paper = Object.assign(document.createElement('canvas'), { width: image.width, height: image.height });
          paper.getContext('2d').putImageData(image, 0, 0);
          return paper.toDataURL('image/png');
        },

        readOutput: (aov = 'color') =>
          session.alone(async () => {
            const before = known('aov');
            methods.set('aov', aov);
            try {
              await session.settled();
              const output = tracer.readOutput();
              check(tracer.takeProblems());
              return output;
            } finally {
              methods.set('aov', before);
            }
          }),

        bench: ({ frames = 30 } = {}) =>
          session.alone(async () => {
            await session.settled();
            tracer.drawAndWait(); // the first draw may still compile
            const times = [];
            for (let i = 0; i < frames; ++i) {
              const start = performance.now();
              tracer.drawAndWait();
              times.push(performance.now() - start);
              await new Promise((resolve) => setTimeout(resolve));
            }
            return { frames, medianMs: median(times), minMs: Math.min(...times), maxMs: Math.max(...times) };
          }),

        // These load when they are first asked for.
        compare: async (options) => (await import('./compare.js')).compare(page, options),

        numerics,
        traceRays: async (scene, rays) => (await import('./lab.js')).traceRays(page, scene, rays),

        stats: () => ({
          compileMs: tracer.compileMs(),
          sourceBytes: tracer.sourceBytes(),
          glObjects: tracer.liveGlObjects(),
          renderer: tracer.renderer(),
        }),
        source: () => tracer.source(),

        async shaders(files) {
          check(tracer.replaceShaders(files));
          await session.settled();
        },
      };
      Object.assign(api, methods);
      Object.defineProperties(api, {
        fps: { get: () => tracer.framesPerSecond(), enumerable: true },
        frames: { get: () => session.frames, enumerable: true },
        scene: { get: () => session.sceneName, enumerable: true },
      });
      open(api);
    },
  };
}
