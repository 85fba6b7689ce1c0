// scripts/bench-web: frame rates over scenes, depth, shadows, size and any other setting, in real browsers.
//
// The page measures (web/page/compare.js). Here: the command line, browsers one after the other, each of them started
// anew a few times, what is done on disk after every round, and what is left to do where a row takes the page with it.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { launch, openPage, programOf } from './browsers.mjs';
import { merged } from './merge_results.mjs';
import { serve, site } from './server.mjs';

const done = 0,
  inputWrong = 1,
  commandLineWrong = 2,
  noBrowser = 3,
  interrupted = 130;
const silentMs = 300_000; // a page that says nothing for so long is dead
const standardSeconds = 300,
  mostSeconds = 86_400,
  mostRounds = 10_000;
const standardRounds = 15,
  standardSessions = 3;
const gnomon = process.env.GNOMON_BINARY ?? fileURLToPath(new URL('../../build/native/gnomon', import.meta.url));

const usage = `usage: scripts/bench-web [SCENE …] [--depth=1,4] [--shadows=off,hard] [--size=400x300] [--KEY=VALUE,… …]
                         [--browsers=chromium,firefox] [--repeats=N] [--sessions=N] [--limit=SECONDS]
                         [--baseline=KEY=VALUE,…] [--json=FILE] [--html=FILE]

Frames a second in the built page (scripts/build web-release): what \`gnomon bench\` measures, in browsers.
  SCENE       scenes' names [lite pro]
  --KEY       any setting takes a list, every combination is a row [--size=800x600 --depth=1,4,8 --shadows=off,hard]
  --browsers  one after the other, without a window [chromium,firefox]
  --repeats   rounds, in each of which every row draws in turn [15]
  --sessions  starts of each browser among which the rounds are spread: a process keeps its luck [3]
  --limit     no round begins later, all browsers together [300; none with --repeats]
  --baseline  what each row is divided by [the first row of its scene]
  --json      all numbers; written after every round
  --html      the same as a page; needs the desktop program (scripts/build native-release)
Ctrl-C ends it and keeps what was measured.`;

class Refusal extends Error {
  constructor(code, message) {
    super(message);
    this.code = code;
  }
}
const refuse = (code, message) => {
  throw new Refusal(code, message);
};

// --- the command line ------------------------------------------------------------------------------------------------

/** Other spellings: singular or plural, and earlier names. */
const aliases = { depths: 'depth', sizes: 'size', browser: 'browsers', goes: 'sessions' };

function readArguments(words) {
  const options = { scenes: [], values: {}, help: false };
  for (const word of words) {
    const match = /^--([\w-]+)(?:=(.*))?$/s.exec(word);
    if (word === '-h' || word === '--help') options.help = true;
    else if (!match)
      word.startsWith('-')
        ? refuse(commandLineWrong, `command line: there is no option ${word}`)
        : options.scenes.push(word);
    else if (match[2] === undefined)
      refuse(commandLineWrong, `command line: ${match[1]}: has no value; write it as --${match[1]}=VALUE`);
    else options.values[aliases[match[1]] ?? match[1]] = match[2];
  }
  return options;
}

function take(values, key, standard) {
  const value = values[key] ?? standard;
  delete values[key];
  return value;
}

function countOf(values, key, most) {
  const text = take(values, key);
  if (text === undefined) return undefined;
  if (!/^\d+$/.test(text) || Number(text) < 1 || Number(text) > most)
    refuse(commandLineWrong, `command line: ${key}: ${text} is out of range; use 1…${most}`);
  return Number(text);
}

function checkFile(file) {
  if (file && !existsSync(dirname(file)))
    refuse(commandLineWrong, `command line: ${file}: there is no folder ${dirname(file)}; make it first`);
  return file;
}

/** What is asked for, or a Refusal. */
function readOptions(words) {
  const { scenes, values, help } = readArguments(words);
  if (help) return { help };
  const browsers = [...new Set(take(values, 'browsers', 'chromium,firefox').split(','))];
  const repeats = countOf(values, 'repeats', mostRounds);
  const sessions = Math.min(countOf(values, 'sessions', mostRounds) ?? standardSessions, repeats ?? standardRounds);
  const limit = countOf(values, 'limit', mostSeconds) ?? (repeats ? mostSeconds : standardSeconds);
  const files = { json: checkFile(take(values, 'json')), html: checkFile(take(values, 'html')) };
  const options = {
    scenes: scenes.length ? scenes : ['lite', 'pro'],
    browsers,
    repeats: repeats ?? standardRounds,
    sessions,
    limit,
    baseline: take(values, 'baseline', ''),
    files,
    values,
  };
  if (files.html && !existsSync(gnomon))
    refuse(inputWrong, `${gnomon}: --html needs the desktop program; build it with scripts/build native-release`);
  const folder = process.env.GNOMON_SITE ?? site;
  if (!existsSync(join(folder, 'index.html')))
    refuse(inputWrong, `${folder}: there is no page; build it with scripts/build web-release`);
  for (const name of browsers)
    try {
      programOf(name);
    } catch (error) {
      refuse(
        name in { chromium: 1, firefox: 1 } ? noBrowser : commandLineWrong,
        `command line: browsers: ${error.message}`,
      );
    }
  return options;
}

/** The command that makes the same numbers again. */
function commandOf({ browsers, repeats, sessions, limit, baseline }, plan) {
  const inShell = (word) => (/^[\w./-]+$/.test(word) ? word : `'${word}'`);
  const settings = Object.entries(plan.values).map(([key, value]) => `--${key}=${value}`);
  return [
    'scripts/bench-web',
    ...plan.scenes.map(inShell),
    `--browsers=${browsers.join(',')}`,
    ...settings,
    ...(baseline ? [`--baseline=${baseline}`] : []),
    `--repeats=${repeats}`,
    ...(sessions === Math.min(standardSessions, repeats) ? [] : [`--sessions=${sessions}`]),
    ...(limit < mostSeconds ? [`--limit=${limit}`] : []),
  ].join(' ');
}

// --- what is told ----------------------------------------------------------------------------------------------------

const terminal = process.stderr.isTTY;
const clear = () => terminal && process.stderr.write('\r\x1b[K');
let toldAt = 0;

/** On a terminal in one line, else a line every ten seconds. */
function tell(name, { stage, done: count, all, secondsLeft, row }) {
  if (Date.now() - toldAt < (terminal ? 100 : 10_000)) return;
  toldAt = Date.now();
  const left = stage === 'drawing' ? `, ${Math.ceil(secondsLeft)} s left` : '';
  process.stderr.write(
    (terminal ? '\r' : 'bench-web: ') +
      `${name}: ${stage} ${count} of ${all}${left} (${row})` +
      (terminal ? '\x1b[K' : '\n'),
  );
}

const complain = (text) => (clear(), console.error(`bench-web: error: ${text}`));

function print(name, results) {
  const { columns, rows, keys } = results.tables[0];
  const at = (key) => columns.findIndex((column) => column.key === key);
  const figure = (value) => (typeof value !== 'number' ? '–' : value >= 100 ? value.toFixed(0) : value.toPrecision(3));
  const spread = (row, key) =>
    `${figure(row[at(key)])} (${figure(row[at(`${key}_low`)])}…${figure(row[at(`${key}_high`)])})`;
  const lines = [
    [...columns.slice(0, keys).map(({ title }) => title), 'FPS', 'frame, ms', 'ratio'],
    ...rows.map((row) => [
      ...row.slice(0, keys).map(String),
      figure(row[at('fps')]),
      spread(row, 'frame'),
      spread(row, 'ratio'),
    ]),
  ];
  const widths = lines[0].map((_, column) => Math.max(...lines.map((line) => line[column].length)));
  const { renderer, browser, clock } = results.environment;
  console.log(`\n${name}\nrenderer   ${renderer}\nbrowser    ${browser}\nclock      ${clock}\n`);
  for (const line of lines)
    console.log(
      line
        .map((text, column) => text.padEnd(widths[column]))
        .join('  ')
        .trimEnd(),
    );
}

// --- browsers --------------------------------------------------------------------------------------------------------

const contextOf = (name) => `webgl2-${name}`;

/** One session of the page at `asked`: { results, series, refused: text, dead: the last row told }, where it died. */
async function measureOnce(browser, url, asked, name, { onround, onplan, onstop }) {
  let last,
    heard = Date.now(),
    kept = {},
    finish;
  const ended = new Promise((resolve) => (finish = resolve));
  const page = await openPage(browser, `${url}?size=64x48&pause=on&depth=1&shadows=off`, {
    expectErrors: [/./],
    ready: false,
  });
  const gone = () => finish({ dead: last });
  page.on('error', gone);
  page.on('close', gone);
  browser.once('disconnected', gone);
  await page.exposeFunction('benchTold', (told) => {
    heard = Date.now();
    if (told.stage === 'planned') onplan(told);
    else if (told.stage === 'problem') complain(`${name}: ${told.text}`);
    else {
      const { browserSession, browserSessions } = asked;
      last = told;
      tell(browserSessions > 1 ? `${name}, session ${browserSession} of ${browserSessions}` : name, told);
    }
  });
  await page.exposeFunction('benchRound', (results, series) => {
    kept = { results, series };
    onround(results);
  });
  await page.exposeFunction('benchEnded', (end) => finish(end));
  await page.evaluate((asked) => {
    const stop = new AbortController();
    window.benchStop = () => stop.abort();
    let at = 0;
    const onprogress = (told) => {
      if ('done' in told && performance.now() - at < 90) return;
      at = performance.now();
      window.benchTold(told);
    };
    window.gnomon.ready
      .then(() =>
        window.gnomon.compare({
          ...asked,
          signal: stop.signal,
          onprogress,
          onround: (...round) => void window.benchRound(...round),
        }),
      )
      .then(
        () => window.benchEnded({}),
        (error) => window.benchEnded({ refused: error.message }),
      );
  }, asked);
  onstop(() => page.evaluate(() => window.benchStop()).catch(gone));
  const watch = setInterval(() => Date.now() - heard > silentMs && gone(), 1000);
  const end = await ended;
  clearInterval(watch);
  browser.off('disconnected', gone);
  return { ...end, ...kept };
}

/** With a browser of its own. */
async function inBrowser(name, work) {
  const browser = await launch(name, { handleSIGINT: false });
  try {
    return await work(browser);
  } finally {
    await Promise.race([browser.close().catch(() => {}), new Promise((resolve) => setTimeout(resolve, 10_000))]);
  }
}

/**
 * All rows in one browser, which each session starts anew: where a process put a program it stays, and that makes it
 * faster or slower by up to a fifth. A row that takes the page with it is told and left out, and the others begin the
 * session anew.
 */
async function measure(options, url, name, deadline, hooks) {
  const { scenes, baseline, repeats, sessions } = options;
  const leaveOut = [];
  const asked = {
    ...options.values,
    scenes,
    baseline,
    repeats,
    browserSessions: sessions,
    context: contextOf(name),
    contexts: options.browsers.map(contextOf),
    leaveOut,
    place: 'command line',
  };
  let results, earlier;
  for (let session = 1; session <= sessions && !hooks.stopped();) {
    if (session > 1 && Date.now() > deadline) break;
    const limit = Math.max(1, Math.round((deadline - Date.now()) / 1000 / (sessions - session + 1)));
    const end = await inBrowser(name, (browser) =>
      measureOnce(browser, url, { ...asked, browserSession: session, limit, earlier }, name, hooks),
    );
    if (end.refused) refuse(/there is no scene/.test(end.refused) ? inputWrong : commandLineWrong, end.refused.trim());
    results = end.results ?? results;
    if (!('dead' in end)) {
      earlier = end.series;
      ++session;
      continue;
    }
    if (hooks.stopped()) break;
    complain(
      `${name}: the page died${end.dead ? ` of ${end.dead.row}: this row is left out, the others begin anew` : ''}`,
    );
    if (!end.dead || Date.now() > deadline) break;
    leaveOut.push(end.dead.number);
  }
  return results;
}

// --- all together ----------------------------------------------------------------------------------------------------

async function run(options) {
  const deadline = Date.now() + options.limit * 1000;
  const server = await serve({ isolated: true });
  const finished = [];
  let plan,
    stopped = false,
    stop = () => {};
  const onSignal = () => {
    if (stopped) process.exit(interrupted); // once more ends the program
    stopped = true;
    stop();
  };
  process.on('SIGINT', onSignal);
  const whole = (all) => merged(all, commandOf(options, plan));
  const write = (all) =>
    options.files.json && all.length && writeFileSync(options.files.json, `${JSON.stringify(whole(all), null, 1)}\n`);
  try {
    for (const [i, name] of options.browsers.entries()) {
      if (stopped) break;
      const share = Date.now() + Math.max(0, deadline - Date.now()) / (options.browsers.length - i);
      const results = await measure(options, server.url, name, share, {
        onplan: (told) => (plan = told),
        onround: (results) => write([...finished, results]),
        onstop(now) {
          stop = now;
          if (stopped) now();
        },
        stopped: () => stopped,
      });
      clear();
      if (!results) continue;
      finished.push(results);
      print(name, results);
    }
    if (finished.length) finish(options, whole(finished));
  } finally {
    process.off('SIGINT', onSignal);
    await server.close();
  }
  if (stopped) console.log('Interrupted: what was measured is kept.');
  if (!stopped && finished.length < options.browsers.length) return inputWrong;
  return stopped ? interrupted : done;
}

function finish({ files }, results) {
  console.log(`\nTimes are medians, in brackets the quartiles of the rounds (${results.environment.rounds}).`);
  const text = `${JSON.stringify(results, null, 1)}\n`;
  if (files.json) writeFileSync(files.json, text);
  if (files.html) {
    const folder = mkdtempSync(join(tmpdir(), 'gnomon-bench-'));
    writeFileSync(join(folder, 'results.json'), text);
    execFileSync(gnomon, ['report', join(folder, 'results.json'), '-o', files.html]);
    rmSync(folder, { recursive: true });
  }
  for (const file of [files.json, files.html]) if (file) console.log(`${file} written`);
}

/** The whole program; answers its exit code. */
export async function benchWeb(words) {
  try {
    const options = readOptions(words);
    if (!options.help) return await run(options);
    console.log(usage);
    return done;
  } catch (error) {
    complain(error.message);
    return error.code && Number.isInteger(error.code) ? error.code : inputWrong;
  }
}
