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

/** Status line of a request whose path is sent as it is: fetch would tidy it up. */
const rawStatus = (port, path) =>
  new Promise((resolve, reject) => {
    const socket = connect(port, '127.0.0.1', () =>
      socket.write(`GET ${path} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n`),
    );
    let answer = '';
    socket.on('data', (data) => (answer += data));
    socket.on('end', () => resolve(answer.split('\r\n')[0]));
    socket.on('error', reject);
  });

describe('scripts/serve', () => {
  let folder, server, url;

  before(async () => {
    folder = await mkdtemp(join(tmpdir(), 'gnomon-serve-'));
    await mkdir(join(folder, 'site', 'page'), { recursive: true });
    for (const name of ['index.html', 'a.wasm', 'a.js', 'a.mjs', 'a.json', 'a.css', 'a.png', 'a.svg', 'page/b.js'])
      await writeFile(join(folder, 'site', name), 'x');
    await writeFile(join(folder, 'secret'), 'x');
    await symlink(join(folder, 'secret'), join(folder, 'site', 'link'));
    server = spawn(script, ['--port=0', `--folder=${join(folder, 'site')}`]);
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

  test('explains itself, and says what is missing', () => {
    assert.match(spawnSync(script, ['--help'], { encoding: 'utf8' }).stdout, /--port/);
    const missing = spawnSync(script, [`--folder=${join(folder, 'nothing')}`], { encoding: 'utf8' });
    assert.equal(missing.status, 1);
    assert.match(missing.stderr, /there is no page; build it/);
  });
});
