// The tracer at work on a canvas: scenes and their images, the frames, a context that goes and comes back.

import { fetchImage, fetchScene, giveFiles, handImage } from './load.js';
import { watchContext } from './context.js';

const mostPatienceMs = 3000;

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/**
 * @param task begins a task of the loading bar, see progress.js
 * @param emit tells of: 'problem' text · 'frame' · 'first' and 'sharp' (in full resolution) ms since navigation ·
 *   'scene' name · 'lost' · 'restored'
 */
export function startSession({ tracer, canvas, task, emit }) {
  let sceneName = null;
  let wantedScene = 0; // counts the scenes asked for: what comes for an older one is dropped
  let imagesAwaited = 0;
  let suspended = 0;
  let compiling = null;
  let failure = '';
  let later = []; // what was asked for while there was no context

  const alive = () => context.alive;

  const report = (problems) => problems && emit('problem', problems);

  /** Takes what frames and polls had to say. */
  const gather = () => {
    const problems = tracer.takeProblems();
    if (problems) failure = problems;
    report(problems);
  };

  const watchCompile = () => {
    const progress = tracer.progress();
    const baking = progress.compiled === 1 && progress.baked < 1;
    if (progress.compiling) compiling ??= task('Compiling the shader');
    else if (compiling) compiling = void compiling.done();
    compiling?.named(baking ? 'Baking distances' : 'Compiling the shader');
    if (baking) compiling?.at(progress.baked);
    return progress;
  };

  // --- frames --------------------------------------------------------------------------------------------------------

  let frames = 0;
  let sharp = false; // a picture in full resolution has been shown
  let letImagesIn; // each blocks the page for a moment: the first frame goes before them
  const imagesMayCome = new Promise((resolve) => (letImagesIn = resolve));
  setTimeout(letImagesIn, mostPatienceMs); // it may never come, in a hidden tab or with a shader that fails

  const tick = (ms) => {
    requestAnimationFrame(tick);
    if (suspended || !alive()) return;
    watchCompile();
    const drawn = tracer.frame(ms / 1000);
    gather();
    if (!drawn) return;
    frames += 1;
    if (frames === 1)
      whenDrawn().then(() => {
        emit('first', performance.now());
        letImagesIn();
      });
    if (!sharp && tracer.sharp()) {
      sharp = true;
      whenDrawn().then(() => emit('sharp', performance.now()));
    }
    emit('frame');
  };

  /** Waits for the GPU without blocking the page. */
  const whenDrawn = async () => {
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (fence && alive() && gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) await pause(4);
    gl.deleteSync(fence);
  };

  /** Until the picture is what scene and settings ask for: images in, program ready. */
  const settled = async () => {
    failure = '';
    for (;;) {
      if (alive() && sceneName !== null && imagesAwaited === 0) {
        const { ready, failed } = watchCompile();
        gather();
        if (ready) return;
        if (failed) throw new Error(failure || 'the shader does not compile');
      }
      await pause(4);
    }
  };

  /** Runs `work` while no frames are drawn. */
  const alone = async (work) => {
    suspended += 1;
    letImagesIn();
    try {
      return await work();
    } finally {
      suspended -= 1;
    }
  };

  // --- scenes --------------------------------------------------------------------------------------------------------

  let imagesBefore = imagesMayCome;

  const loadImages = (order) => {
    const names = tracer.imageNames();
    imagesAwaited = names.length;
    for (const name of names) loadImage(name, order);
  };

  const loadImage = async (name, order) => {
    const loading = task(`Loading ${name}`);
    try {
      const bytes = await fetchImage(name, (soFar, total) => loading.at(soFar / total));
      await (imagesBefore = imagesBefore.then(() => pause(0))); // one at a time, so that the page can answer between
      if (order === wantedScene) whenAlive(async () => report(await handImage(tracer, name, bytes)));
    } catch (error) {
      report(`${error.message}; one flat colour stands in for the image`);
    }
    loading.done();
    if (order === wantedScene) imagesAwaited -= 1;
  };

  const takeScene = (text, name, order) => {
    const problems = tracer.loadScene(text, name);
    if (problems) throw new Error(problems);
    sceneName = name;
    emit('scene', name);
    loadImages(order);
  };

  /** Loads a scene by name, or from text under a name; throws where it is wrong, and the old one stays. */
  const load = async (name, text = fetchScene(name)) => {
    const order = ++wantedScene;
    const json = await text;
    while (!alive()) await pause(50);
    if (order === wantedScene) await giveFiles(tracer, json);
    if (order === wantedScene) takeScene(json, name, order);
  };

  // --- a context that goes and comes back ----------------------------------------------------------------------------

  const whenAlive = (work) => (alive() ? work() : void later.push(work));

  const context = watchContext(canvas, tracer, {
    lost() {
      compiling = void compiling?.done();
      emit('lost');
    },
    restored() {
      for (const work of later.splice(0)) work();
      emit('restored');
    },
  });
  const { gl } = context;

  requestAnimationFrame(tick);

  return {
    get sceneName() {
      return sceneName;
    },
    get frames() {
      return frames;
    },
    /** Nothing loads or compiles, and no script has the pictures to itself. */
    get resting() {
      return alive() && suspended === 0 && imagesAwaited === 0 && tracer.progress().ready;
    },
    load,
    settled,
    alone,
    whenAlive,
  };
}
