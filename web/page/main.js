// The page: starts the tracer and connects it with keys, fingers, panel, address bar and scripts.

import { addressBar, readQuery, writeQuery } from './url.js';
import { connectTools, toggleFullscreen } from './tools.js';
import { fetchScene, fetchSceneIndex } from './load.js';
import { fitCanvas, parseSize } from './canvas.js';
import { listenToKeys } from './keyboard.js';
import { listenToPointers } from './pointer.js';
import { listenToStick } from './stick.js';
import { makeApi } from './api.js';
import { makeHelp } from './help.js';
import { makePanel } from './panel.js';
import { messages } from './messages.js';
import { numericsOf, numericsWhenCalm } from './numerics.js';
import { progressBar } from './progress.js';
import { sceneChooser } from './scenes.js';
import { showNumerics, showReadout } from './readout.js';
import { startSession } from './session.js';
import { startTracer } from './tracer.js';

const defaultScene = 'lite';
const refreshMs = 250;
const noWebGL =
  'Gnomon draws with WebGL 2, which this browser does not give. ' +
  'Try a current Firefox, Chrome, Edge or Safari, switch hardware acceleration on, or update the graphics driver.';

const $ = (id) => document.getElementById(id);
const canvas = $('view');
const say = messages($('messages'));
const task = progressBar($('bar'), $('loading'));
const api = makeApi();
const query = readQuery(location.search);
const startsPaused = matchMedia('(prefers-reduced-motion: reduce)').matches;
const asks = (key) => query.values.some(([name]) => name === key);

document.body.classList.add('running');
start().catch((error) => {
  say.fatal(error.title ?? 'Gnomon could not start', error.message);
  api.fail(error);
});

async function start() {
  // Everything that the first picture needs is asked for at once.
  const firstName = query.scene ?? defaultScene;
  const firstScene = fetchScene(firstName);
  firstScene.catch(() => {}); // told when its turn comes
  const sceneIndex = fetchSceneIndex();

  const tracer = await loadTracer();
  const page = connect(tracer, sceneIndex);
  await page.loadFirst(firstName, firstScene);
  listen(page);
  watch(page);
  api.open(page);
  numericsWhenCalm(page).catch(({ message }) =>
    showNumerics({ measured: false, summary: `numerics not measured: ${message}` }),
  );

  // The panel comes after the first picture: nobody waits for it.
  await page.session.settled().catch(() => {});
  await addPanel(page).catch((error) => say.problem(`The settings panel does not load: ${error.message}`));
}

/** The tracer with its context and with the settings that the address asks for. */
async function loadTracer() {
  const loading = task('Loading the tracer');
  const tracer = await startTracer({
    onBytes: (soFar, total) => loading.at(soFar / total),
    report(line) {
      say.note(line);
      api.emit('report', line);
    },
  });
  loading.done();
  if (!tracer.createContext('#view')) throw Object.assign(new Error(noWebGL), { title: 'No WebGL 2 here' });

  const wanted = [...(startsPaused ? [['pause', 'on']] : []), ...query.values];
  const wrong = tracer.createViewer(wanted.map(([key, text]) => `${key}=${text}\n`).join(''), 'URL');
  if (wrong) say.problem(wrong);
  return tracer;
}

/** Session, canvas, scene list and address bar around the tracer. */
function connect(tracer, sceneIndex) {
  const fit = fitCanvas(canvas, (width, height) => tracer.resize(width, height));
  // Where none is asked for it follows the window.
  let size = query.size && tracer.settings().get('size') === query.size ? query.size : null;
  fit.fix(parseSize(size));
  tracer.resize(canvas.width, canvas.height);

  const session = startSession({
    tracer,
    canvas,
    task,
    emit(name, value) {
      happened[name]?.(value);
      api.emit(name, value);
    },
  });
  const happened = {
    problem: (text) => say.problem(text, { id: text }), // the same one does not pile up
    first(ms) {
      api.first(ms);
      performance.mark('gnomon.firstFrame');
    },
    sharp: (ms) => api.sharp(ms),
    frame: () => document.body.classList.add('drawing'),
    scene(name) {
      scenes.show(name);
      address();
    },
    lost() {
      document.body.classList.add('lost');
      say.problem('The graphics context was lost; waiting for the browser to give it back.', { id: 'context' });
    },
    restored() {
      document.body.classList.remove('lost');
      say.clear('context');
      say.note('Graphics are back');
    },
  };

  const load = (scene) =>
    typeof scene === 'string'
      ? session.load(scene)
      : session.load(String(scene.name ?? 'script'), JSON.stringify(scene));
  const scenes = sceneChooser($('scene'), sceneIndex, (name) =>
    load(name).catch((error) => {
      say.problem(error.message, { id: 'scene' });
      throw error;
    }),
  );

  let listed = [];
  sceneIndex.then((index) => (listed = index.map(({ name }) => name)));
  const address = addressBar(() =>
    writeQuery({
      changed: tracer.urlQuery(),
      scene: session.sceneName !== defaultScene && listed.includes(session.sceneName) ? session.sceneName : null,
      size,
      paused: tracer.settings().get('pause') === 'on',
      pausedAtStart: startsPaused,
    }),
  );

  /** Changes one setting; answers problems. Without a context the change waits for one. */
  const set = (key, text, place) => {
    let problems = '';
    session.whenAlive(() => {
      problems = tracer.set(key, text, place);
      if (!problems && key === 'size') fit.fix(parseSize((size = text)));
    });
    address();
    return problems;
  };

  /** The scene the address asks for, or the default one and a message. */
  const loadFirst = async (name, text) => {
    try {
      await session.load(name, text);
    } catch (error) {
      if (name === defaultScene) throw error;
      say.problem(
        `URL: scene: ${error.message}; ${defaultScene} is shown instead, there are ` +
          (await scenes.names()).join(', '),
      );
      await session.load(defaultScene);
    }
    if (startsPaused && !asks('pause')) say.note('Paused, as your system asks for little motion');
  };

  const numerics = numericsOf({ task }, (found) => {
    showNumerics(found);
    if (found.measured && !found.holds) say.problem(found.summary);
  });

  return { tracer, session, task, address, set, load, loadFirst, numerics, sceneNames: scenes.names() };
}

/** A change by hand: what is wrong with it stands on the page. */
function change({ set }, key, text) {
  const problems = set(key, text, 'panel');
  say.clear('panel');
  if (problems) say.problem(problems, { id: 'panel' });
}

/** Keys, pointers, stick and buttons. */
function listen(page) {
  const { tracer, session, address } = page;
  const about = () => [`Drawn by ${tracer.renderer()}`, $('numerics').title].filter(Boolean).join('; ');
  const help = makeHelp($('help'), tracer.table(), about);
  const own = {
    H: help,
    F: toggleFullscreen,
    V: () => say.note('v-sync: here the browser decides'),
  };
  const keys = {
    down: (name) => (own[name] ? own[name]() : session.whenAlive(() => tracer.keyDown(name))),
    up: (name) => tracer.keyUp(name),
    releaseAll: () => tracer.releaseAllKeys(),
  };
  listenToKeys(keys);
  listenToPointers(canvas, tracer);
  listenToStick($('stick'), keys);
  const touch = () => document.body.classList.add('touch');
  if (matchMedia('(pointer: coarse)').matches) touch();
  addEventListener('pointerdown', (event) => event.pointerType === 'touch' && touch());

  page.tools = connectTools({
    pause: () => change(page, 'pause', tracer.settings().get('pause') === 'on' ? 'off' : 'on'),
    help,
    link() {
      address.now();
      return location.href;
    },
    picture: () => window.gnomon.png(),
    name: () => `gnomon-${session.sceneName}`,
    compare: () => openCompare(page).catch((error) => say.problem(`The comparison does not load: ${error.message}`)),
    note: say.note,
  });
}

/** Opens the dialog that compares frame rates; it loads when it is first asked for. */
async function openCompare(page) {
  page.showCompare ??= (await import('./compare_dialog.js')).makeCompareDialog(page);
  (await page.showCompare)();
}

/** Keeps read-out, panel, buttons and address in step with the tracer, whoever changed it. */
function watch(page) {
  const { tracer } = page;
  let before = '';
  const refresh = () => {
    const settings = tracer.settings();
    showReadout({
      title: tracer.title(),
      fps: tracer.framesPerSecond(),
      settings,
      scale: tracer.shownScale(),
      width: canvas.width,
      height: canvas.height,
    });
    const now = tracer.urlQuery();
    if (now === before) return;
    before = now;
    page.panel?.show(settings);
    page.tools.show(settings);
    page.address();
  };
  refresh();
  setInterval(refresh, refreshMs);
}

async function addPanel(page) {
  page.panel = await makePanel($('panel'), {
    table: page.tracer.table(),
    settings: page.tracer.settings(),
    set: (key, text) => change(page, key, text),
    open: matchMedia('(min-width: 900px) and (min-height: 560px)').matches,
  });
}
