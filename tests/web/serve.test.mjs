// scripts/serve: right media types, nothing outside its folder, clear messages.
import { after, before, describe, test } from 'node:test';
import { connect } from 'node:net';
import { fileURLToPath } from 'node:url';
import { mkdtemp, mkdir, rm, symlink, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { spawn, spawnSync } from 'node:child_process';
import { strict as assert } from 'node:assert';
import { tmpdir } from 'node:os';

const script = fileURLToPath(new URL('../../scripts/serve', import.meta.url));

/** The answer to bytes that are sent as they are: fetch would tidy them up. */
const rawAnswer = (port, bytes) =>
  new Promise((resolve, reject) => {
    const socket = connect(port, '127.0.0.1', () => socket.write(bytes));
    let answer = '';
    socket.on('data', (data) => (answer += data));
    socket.on('end', () => resolve(answer));
    socket.on('error', reject);
  });

/** Status line of a request for the path as it is. */
const rawStatus = async (port, path, host = 'Host: localhost\r\n') =>
  (await rawAnswer(port, `GET ${path} HTTP/1.1\r\n${host}Connection: close\r\n\r\n`)).split('\r\n')[0];

describe('scripts/serve', () => {
  let folder, server, url;
  let errors = '';

  before(async () => {
    folder = await mkdtemp(join(tmpdir(), 'gnomon-serve-'));
    await mkdir(join(folder, 'site', 'page'), { recursive: true });
    for (const name of ['index.html', 'a.wasm', 'a.js', 'a.mjs', 'a.json', 'a.css', 'a.png', 'a.svg', 'page/b.js'])
      await writeFile(join(folder, 'site', name), 'x');
    await writeFile(join(folder, 'secret'), 'x');
    await symlink(join(folder, 'secret'), join(folder, 'site', 'link'));
    server = spawn(script, ['--port=0', `--folder=${join(folder, 'site')}`]);
    server.stderr.on('data', (data) => (errors += data));
    const line = await new Promise((resolve) => server.stdout.once('data', (data) => resolve(String(data))));
    url = /http:\/\/localhost:\d+/.exec(line)[0].replace('localhost', '127.0.0.1');
  });
  after(async () => {
    server.kill();
    await rm(folder, { recursive: true });
  });

  test('gives every file its type', async () => {
    const types = {
      '/': 'text/html',
      '/a.wasm': 'application/wasm',
      '/a.js': 'text/javascript',
      '/a.mjs': 'text/javascript',
      '/a.json': 'application/json',
      '/a.css': 'text/css',
      '/a.png': 'image/png',
      '/a.svg': 'image/svg+xml',
    };
    for (const [path, type] of Object.entries(types)) {
      const response = await fetch(url + path);
      assert.equal(response.status, 200, path);
      assert.ok(response.headers.get('content-type').startsWith(type), path);
    }
  });

  test('lists no folder, and nothing outside can be had', async () => {
    const { port } = new URL(url);
    for (const path of ['/page/', '/none', '/../secret', '/%2e%2e/secret', '/..%2fsecret', '/link', '//etc/passwd'])
      assert.match(await rawStatus(port, path), / 404 /, path);
  });

  test('answers every path with words, and nothing on stderr', async () => {
    const { port } = new URL(url);
    for (const path of ['/%00', '/a%00.js', '/%ff', `/${'a'.repeat(300)}`, '/a.js/', '/a.js/b', '/page'])
      assert.match(await rawStatus(port, path), / 404 /, path);
    assert.match(await rawStatus(port, '/a.js?x=1#y'), / 200 /);
    assert.equal(errors, '');
  });

  test('serves this machine only, whatever name leads here', async () => {
    const { port } = new URL(url);
    for (const host of ['localhost', 'LOCALHOST:1', '127.0.0.1:8000', '[::1]:8000'])
      assert.match(await rawStatus(port, '/', `Host: ${host}\r\n`), / 200 /, host);
    for (const host of ['evil.example', 'localhost.evil.example', '127.0.0.1.evil.example:8000'])
      assert.match(await rawStatus(port, '/', `Host: ${host}\r\n`), / 421 /, host);
    assert.match(await rawStatus(port, '/', ''), / 400 /);
  });

  test('sends a file again only where it changed', async () => {
    const get = (headers) => fetch(`${url}/tagged.js`, { headers });
    await writeFile(join(folder, 'site', 'tagged.js'), 'old');
    const tag = (await get({})).headers.get('etag');
    const same = await get({ 'If-None-Match': `"other", W/${tag}` });
    assert.equal(same.status, 304);
    assert.equal(same.headers.get('etag'), tag);
    assert.equal(await same.text(), '');
    await writeFile(join(folder, 'site', 'tagged.js'), 'newer');
    assert.equal(await (await get({ 'If-None-Match': tag })).text(), 'newer');
  });

  test('sends pieces of a file', async () => {
    await writeFile(join(folder, 'site', 'long.png'), '0123456789');
    const piece = async (range, more = {}) => {
      const response = await fetch(`${url}/long.png`, { headers: { Range: range, ...more } });
      return [response.status, response.headers.get('content-range'), await response.text()];
    };
    assert.deepEqual(await piece('bytes=2-4'), [206, 'bytes 2-4/10', '234']);
    assert.deepEqual(await piece('bytes=7-'), [206, 'bytes 7-9/10', '789']);
    assert.deepEqual(await piece('bytes=-3'), [206, 'bytes 7-9/10', '789']);
    assert.deepEqual(await piece('bytes=8-99'), [206, 'bytes 8-9/10', '89']);
    assert.deepEqual(await piece('bytes=10-'), [416, 'bytes */10', '']);
    const long = `bytes=${'9'.repeat(5000)}-`;
    for (const whole of ['bytes=0-1,3-4', 'lines=1-2', 'bytes=-', 'bytes=x-', 'bytes=4-2', long])
      assert.deepEqual(await piece(whole), [200, null, '0123456789']);
    assert.deepEqual(await piece('bytes=2-4', { 'If-Range': '"another"' }), [200, null, '0123456789']);
    const head = await fetch(`${url}/long.png`, { method: 'HEAD', headers: { Range: 'bytes=2-4' } });
    assert.equal(head.status, 200, 'pieces are of GET only');
  });

  test('compresses what gets smaller, for those who take it', async () => {
    const text = 'the same again; '.repeat(1000);
    for (const name of ['text.js', 'text.png']) await writeFile(join(folder, 'site', name), text);
    const get = async (name, encodings) => {
      const response = await fetch(`${url}/${name}`, { headers: { 'Accept-Encoding': encodings } });
      assert.equal(await response.text(), text);
      return [response.headers.get('content-encoding'), Number(response.headers.get('content-length')) < text.length];
    };
    assert.deepEqual(await get('text.js', 'gzip, br'), ['gzip', true]);
    assert.deepEqual(await get('text.js', 'gzip;q=0, br'), [null, false]);
    assert.deepEqual(await get('text.js', 'identity'), [null, false]);
    assert.deepEqual(await get('text.png', 'gzip'), [null, false]);
    const head = await fetch(`${url}/text.js`, { method: 'HEAD' });
    assert.equal(head.status, 200);
    assert.equal(await head.text(), '');
  });

  test('ends connections that rest, and serves others meanwhile', { timeout: 60000 }, async () => {
    const { port } = new URL(url);
    const started = Date.now();
    const resting = Array.from({ length: 40 }, () => rawAnswer(port, 'GET / HT'));
    assert.equal((await fetch(`${url}/`)).status, 200);
    await Promise.all(resting);
    const seconds = (Date.now() - started) / 1000;
    assert.ok(seconds > 10 && seconds < 40, `${seconds} s`);
    assert.equal(errors, '');
  });

  test('explains itself, and says what is missing', () => {
    assert.match(spawnSync(script, ['--help'], { encoding: 'utf8' }).stdout, /--port/);
    const missing = spawnSync(script, [`--folder=${join(folder, 'nothing')}`], { encoding: 'utf8' });
    assert.equal(missing.status, 1);
    assert.match(missing.stderr, /there is no page; build it/);
  });
});
