// Real browsers for the tests: Chromium without a window, Firefox in a virtual screen of its own (WebGL needs one
// there).
//
//   const browser = await launch('firefox');
//   const page = await openPage(browser, url); // gathers console errors, page errors and foreign requests
//   …; page.verify();                          // throws where there are any
//   await browser.close();
import { mkdtemp, rm } from 'node:fs/promises';
import { spawn } from 'node:child_process';
import { tmpdir } from 'node:os';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import puppeteer from 'puppeteer-core';

/** Both, or those that GNOMON_BROWSERS names. */
export const browserNames = (process.env.GNOMON_BROWSERS ?? 'chromium,firefox').split(',');

/** Long enough for a software renderer on a busy machine. */
export const patienceMs = 60_000;

const firstOf = (paths) => paths.find((path) => existsSync(path));
const programs = {
  chromium:
    process.env.CHROMIUM ?? firstOf(['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome']),
  firefox:
    process.env.FIREFOX ?? firstOf(['/usr/lib/firefox-esr/firefox-esr', '/usr/bin/firefox-esr', '/usr/bin/firefox']),
};

const chromiumArguments = [
  '--no-sandbox', // tests run as root in containers
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--ignore-gpu-blocklist',
  '--disable-gpu-watchdog', // a long frame is no hang here
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-domain-reliability',
  '--disable-sync',
  '--disable-default-apps',
  '--no-first-run',
  '--no-default-browser-check',
  '--disable-dev-shm-usage',
];

const firefoxPreferences = {
  'webgl.force-enabled': true,
  'webgl.disable-fail-if-major-performance-caveat': true,
  'layers.acceleration.force-enabled': false,
  'dom.w3c_touch_events.enabled': 1,
  'dom.max_script_run_time': 0,
  'app.update.enabled': false,
  'browser.safebrowsing.update.enabled': false,
  'browser.shell.checkDefaultBrowser': false,
  'datareporting.policy.dataSubmissionEnabled': false,
  'extensions.getAddons.cache.enabled': false,
  'network.captive-portal-service.enabled': false,
  'network.connectivity-service.enabled': false,
  'services.settings.server': 'http://127.0.0.1:1', // no downloads beside the page
  'toolkit.telemetry.enabled': false,
};

/** The program of that browser; throws with what to do where there is none. */
export function programOf(name) {
  if (!(name in programs))
    throw new Error(`there is no browser '${name}' here; use ${Object.keys(programs).join(' or ')}`);
  const variable = name.toUpperCase();
  if (!programs[name]) throw new Error(`${name} is not installed; install it, or set ${variable} to its path`);
  if (!existsSync(programs[name])) throw new Error(`${variable}=${programs[name]}: there is no such program`);
  return programs[name];
}

/** A virtual screen on a display number that the X server picks. */
async function startScreen() {
  const server = spawn('Xvfb', ['-displayfd', '1', '-screen', '0', '1600x1200x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'pipe', 'ignore'],
    detached: true, // Ctrl-C in a terminal is for us, not for it
  });
  const display = await new Promise((resolve, reject) => {
    server.stdout.once('data', (number) => resolve(`:${String(number).trim()}`));
    server.once('error', reject);
    server.once('exit', () => reject(new Error('Xvfb does not start')));
  });
  const stop = () => server.kill();
  process.once('exit', stop);
  return { display, stop: () => (process.off('exit', stop), stop()) };
}

/**
 * Starts `chromium` or `firefox`; close() ends it and removes what it left.
 * @param options.calm as on a system that asks for little motion
 * @param options.handleSIGINT false: Ctrl-C does not end the browser
 */
export async function launch(name, { calm = false, handleSIGINT = true } = {}) {
  const program = programOf(name);
  const profile = await mkdtemp(join(tmpdir(), `gnomon-${name}-`));
  const screen = name === 'firefox' ? await startScreen() : null;
  const settings =
    name === 'firefox'
      ? {
          browser: 'firefox',
          headless: false,
          extraPrefsFirefox: { ...firefoxPreferences, ...(calm ? { 'ui.prefersReducedMotion': 1 } : {}) },
          env: { ...process.env, DISPLAY: screen.display, MOZ_X11_EGL: '0' },
        }
      : {
          browser: 'chrome',
          headless: true,
          args: [...chromiumArguments, ...(calm ? ['--force-prefers-reduced-motion'] : [])],
        };
  const tidy = async () => {
    screen?.stop();
    await rm(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  };
  try {
    const browser = await puppeteer.launch({
      ...settings,
      handleSIGINT,
      executablePath: program,
      userDataDir: profile,
      timeout: patienceMs,
      protocolTimeout: 3 * patienceMs,
    });
    const close = browser.close.bind(browser);
    browser.close = async () => {
      await close();
      await tidy();
    };
    browser.gnomonName = name;
    return browser;
  } catch (error) {
    await tidy();
    throw error;
  }
}

/**
 * Opens the page and waits until window.gnomon is ready and the picture is what was asked for.
 * @param options.expectErrors patterns of console lines that the test brings about itself
 * @param options.before runs with the page before it loads
 * @param options.ready false: does not wait
 */
export async function openPage(
  browser,
  url,
  { expectErrors = [], before, ready = true, viewport = { width: 640, height: 480 } } = {},
) {
  const page = await browser.newPage();
  const faults = [];
  const fault = (text) => expectErrors.some((pattern) => pattern.test(text)) || faults.push(text);
  page.on('console', (line) => {
    if (['error', 'warn', 'warning'].includes(line.type())) fault(`console ${line.type()}: ${line.text()}`);
  });
  page.on('pageerror', (error) => fault(`page error: ${error.message}`));
  page.on('request', (request) => {
    const { protocol, hostname } = new URL(request.url());
    if (/^(https?|wss?):$/.test(protocol) && hostname !== '127.0.0.1') fault(`foreign request: ${request.url()}`);
  });
  page.verify = () => {
    if (faults.length) throw new Error(`the page complained:\n${faults.join('\n')}`);
  };
  await page.setViewport(viewport);
  await before?.(page);
  await page.goto(url, { waitUntil: 'load', timeout: patienceMs });
  if (ready) {
    const there = await page.evaluate(() => Boolean(window.gnomon));
    if (!there) faults.push('the page has no window.gnomon') && page.verify();
    await page.evaluate(() => window.gnomon.ready.then(() => window.gnomon.settled()));
  }
  return page;
}

/** Polls until `ask` answers something true; `what` stands in the message where it never does. */
export async function until(what, ask, ms = patienceMs) {
  const end = Date.now() + ms;
  for (;;) {
    const answer = await ask();
    if (answer) return answer;
    if (Date.now() > end) throw new Error(`waited ${ms / 1000} s in vain for: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

/** The current picture as { width, height, data: Buffer of RGBA }. */
export async function picture(page) {
  const { width, height, text } = await page.evaluate(async () => {
    const image = await window.gnomon.image();
    let bytes = '';
    for (let i = 0; i < image.data.length; i += 8192) bytes += String.fromCharCode(...image.data.subarray(i, i + 8192));
    return { width: image.width, height: image.height, text: btoa(bytes) };
  });
  return { width, height, data: Buffer.from(text, 'base64') };
}

/** How many bytes of two pictures differ by more than `tolerance`. */
export function differences(a, b, tolerance = 0) {
  if (a.width !== b.width || a.height !== b.height) return Infinity;
  let count = 0;
  for (let i = 0; i < a.data.length; ++i) if (Math.abs(a.data[i] - b.data[i]) > tolerance) ++count;
  return count;
}
