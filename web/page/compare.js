// Frame rates over scenes, depth, shadows, size and any other setting, as `gnomon bench` measures them (docs/bench.md).
//
// What is drawn, when, and what becomes of the numbers is decided in C++ (lab/bench/bench_run.h). Here are the loop,
// which lets the page live between samples, and what only a browser knows.

import { BenchStep } from './lab_calls.js';
import { fetchImage, fetchScene, fetchSceneIndex, giveFiles, handImage } from './load.js';
import { inLab } from './lab.js';

const standardRounds = 15,
  mostRounds = 10_000;
const standardSeconds = 150,
  mostSeconds = 86_400;
const restoreMs = 30_000; // a browser that has not given the context back by then will not
const ownOptions = [
  'scenes',
  'baseline',
  'repeats',
  'limit',
  'signal',
  'onprogress',
  'onround',
  'context',
  'contexts',
  'leaveOut',
  'place',
  'browserSession',
  'browserSessions',
  'earlier',
];

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/** Lets the page answer, without the milliseconds that timers are held back for. */
const breathe = () =>
  new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => (port1.close(), resolve());
    port2.postMessage(null);
  });

/** Seconds that the page's clock can tell apart. */
function clockStep() {
  let least = Infinity;
  for (let i = 0; i < 5; ++i) {
    const start = performance.now();
    let now = start;
    while (now === start) now = performance.now();
    least = Math.min(least, now - start);
  }
  return least / 1000;
}

/** The browser's name in the column `context`. */
export function contextName(agent = navigator.userAgent) {
  const names = [
    [/Firefox\//, 'firefox'],
    [/Edg\//, 'edge'],
    [/OPR\//, 'opera'],
    [/Chrom(e|ium)\//, 'chromium'],
    [/Safari\//, 'safari'],
  ];
  return `webgl2-${names.find(([pattern]) => pattern.test(agent))?.[1] ?? 'browser'}`;
}

function environmentOf(lab, step) {
  return [
    ['date', `${new Date().toISOString().slice(0, 16).replace('T', ' ')} UTC`],
    ['renderer', lab.renderer()],
    ['processor', `${navigator.hardwareConcurrency} threads`],
    ['system', navigator.userAgentData?.platform || navigator.platform],
    ['browser', navigator.userAgent],
    ['clock', `tells ${Number((step * 1e6).toPrecision(2))} µs apart`],
  ];
}

const earlierNames = { go: 'browserSession', goes: 'browserSessions' };

const textOf = (value) => (Array.isArray(value) ? value.join(',') : String(value));

/** The options with what is not said, checked as the command line does. */
function readOptions(given) {
  const options = Object.fromEntries(Object.entries(given).map(([key, value]) => [earlierNames[key] ?? key, value]));
  const place = options.place ?? 'compare';
  const count = (key, standard, most) => {
    const value = options[key] ?? standard;
    if (!(Number.isInteger(value) && value >= 1 && value <= most))
      throw new Error(`${place}: ${key}: ${value} is out of range; use 1…${most}`);
    return value;
  };
  const scenes = [options.scenes ?? ['lite', 'pro']]
    .flat()
    .flatMap((scene) => (typeof scene === 'string' ? scene.split(',') : [scene]));
  return {
    place,
    scenes: scenes.map((scene) =>
      typeof scene === 'string'
        ? { name: scene }
        : { name: String(scene.name ?? 'script'), text: JSON.stringify(scene) },
    ),
    values: Object.entries(options)
      .filter(([key]) => !ownOptions.includes(key))
      .map(([key, value]) => [key, textOf(value)]),
    baseline: options.baseline ?? '',
    repeats: count('repeats', standardRounds, mostRounds),
    limit: count('limit', options.repeats ? mostSeconds : standardSeconds, mostSeconds),
    context: options.context ?? contextName(),
    contexts: options.contexts ?? [options.context ?? contextName()],
    leaveOut: options.leaveOut ?? [],
    browserSession: count('browserSession', 1, mostRounds),
    browserSessions: count('browserSessions', 1, mostRounds),
    earlier: options.earlier ?? '',
    signal: options.signal,
    onprogress: options.onprogress ?? (() => {}),
    onround: options.onround ?? (() => {}),
  };
}

function check(problems) {
  if (problems) throw new Error(problems.trim());
}

/** The call that makes the same numbers again. */
function commandOf({ baseline, repeats, limit }, { scenes, values }) {
  const words = {
    scenes: scenes.join(','),
    ...values,
    ...(baseline ? { baseline } : {}),
    repeats,
    ...(limit < mostSeconds ? { limit } : {}),
  };
  const text = (value) => (typeof value === 'number' ? value : `'${value}'`);
  return `gnomon.compare({ ${Object.entries(words)
    .map(([key, value]) => `${/^\w+$/.test(key) ? key : `'${key}'`}: ${text(value)}`)
    .join(', ')} })`;
}

let underWay = false;

/**
 * Measures; answers a promise of an object in the format of docs/results.md. Options: docs/page.md.
 * @param page { session, task }
 */
export async function compare(page, options = {}) {
  const asked = readOptions(options);
  if (underWay) throw new Error(`${asked.place}: frame rates are being compared already; wait until that is done`);
  underWay = true;
  try {
    return await inLab(page, async (lab) => {
      const plan = await prepare(lab, asked);
      return page.session.alone(() => measure(lab, asked, plan));
    });
  } finally {
    underWay = false;
  }
}

/** Gives the laboratory plan, scenes and images; answers what is planned. */
async function prepare(lab, asked) {
  check(
    lab.plan(
      asked.scenes.map(({ name }) => name).join('\n'),
      asked.values.map((pair) => `${pair.join('=')}\n`).join(''),
      asked.baseline,
      asked.place,
    ),
  );
  const plan = lab.planned();
  asked.onprogress({ stage: 'planned', ...plan });
  const listed = (await fetchSceneIndex()).map(({ name }) => name);
  for (const name of plan.scenes) {
    let { text } = asked.scenes.find((scene) => scene.name === name);
    if (text === undefined && listed.length && !listed.includes(name))
      throw new Error(`${asked.place}: scenes: there is no scene '${name}'; there are ${listed.join(', ')}`);
    text ??= await fetchScene(name);
    await giveFiles(lab, text);
    check(lab.scene(text, name));
    for (const image of lab.imageNames()) check(await handImage(lab, image, await fetchImage(image, () => {})));
  }
  return plan;
}

async function measure(lab, asked, plan) {
  const step = clockStep();
  check(lab.begin(step));
  asked.leaveOut.forEach(lab.leaveOut);
  const deadline = performance.now() + asked.limit * 1000;
  const leftOut = asked.leaveOut.map((row) => `${plan.rows[row]}: left out`);
  const stopped = () => asked.signal?.aborted ?? false;

  /** What was wrong with a row, which is then not in the table. */
  const complain = (text) => {
    leftOut.push(text);
    asked.onprogress({ stage: 'problem', text });
  };

  const results = () => {
    const rounds = lab.rounds();
    const ended = stopped()
      ? '; interrupted'
      : rounds < asked.repeats && asked.browserSession === asked.browserSessions
        ? '; ended by the limit'
        : '';
    const environment = [
      ...environmentOf(lab, step),
      ...(leftOut.length ? [['left out', leftOut.join(' · ')]] : []),
      ['rounds', `${asked.context} ${rounds} of ${asked.repeats}${ended}`],
    ];
    const lines = environment.map(([name, value]) => `${name}=${value.replaceAll('\n', ' ')}\n`).join('');
    return lab.results(asked.context, asked.contexts.join('\n'), lines, commandOf(asked, plan));
  };

  const tellRound = () => {
    const all = results();
    asked.onround(all, lab.series());
    return all;
  };

  /** True once there is a context. The row that was drawn when it went is left out: see BenchRun::contextLost(). */
  const contextBack = async () => {
    complain(`${plan.rows[lab.row()]}: the graphics context was lost while this was drawn`);
    const end = performance.now() + restoreMs;
    while (!lab.alive && performance.now() < end) await pause(20);
    if (!lab.alive) complain('the browser does not give the graphics context back');
    return lab.alive;
  };

  /** Steps until all is done: true; or until the user stops it, or there is nothing to draw with. */
  const stepThrough = async (stage, all, next) => {
    const start = performance.now();
    for (let done = 0; ;) {
      if (stopped()) return false;
      if (!lab.alive && !(await contextBack())) return false;
      const made = next();
      if (!lab.alive) continue;
      const problems = lab.problems();
      if (problems) complain(`${plan.rows[lab.row()]}: ${problems.trim()}`);
      if (made === BenchStep.finished) return true;
      if (made === BenchStep.working) {
        await pause(1);
        continue;
      }
      done += 1;
      const left = ((performance.now() - start) / done) * (all - done);
      const secondsLeft = Math.max(0, Math.min(left, deadline - performance.now())) / 1000;
      asked.onprogress({ stage, done, all, secondsLeft, row: plan.rows[lab.row()], number: lab.row() });
      await breathe();
    }
  };

  let rounds = 0;
  const draw = () => {
    if (lab.rounds() > rounds + 1) {
      rounds = lab.rounds() - 1;
      tellRound();
    }
    return lab.step();
  };
  if (await stepThrough('compiling', plan.rows.length, lab.prepare)) {
    if (asked.earlier) check(lab.continueFrom(asked.earlier));
    rounds = lab.rounds();
    const here = Math.max(1, Math.ceil((asked.repeats * asked.browserSession) / asked.browserSessions) - rounds);
    lab.start(here, asked.browserSessions, Math.max(0, deadline - performance.now()) / 1000);
    await stepThrough('drawing', lab.drawn() * (here + 1), draw);
  }
  return tellRound();
}
