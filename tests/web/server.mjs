// A static server of the tests' own, on a free port of this machine, optionally under a sub-path.
import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';

export const site = fileURLToPath(new URL('../../build/web/', import.meta.url));

const types = {
  '.html': 'text/html; charset=utf-8',
  '.css': 'text/css',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
};

// The page may then have clocks of microseconds.
const isolation = { 'Cross-Origin-Opener-Policy': 'same-origin', 'Cross-Origin-Embedder-Policy': 'require-corp' };

/**
 * Serves the folder; answers { url, close() }.
 * @param options.path where the page lies, as '/' or '/some/where/'
 * @param options.missing a pattern of paths that are not found
 * @param options.isolated no other site shares the page's process
 * @param options.plainTypes gives every file but pages and scripts a type that says nothing, as a careless server does
 */
export async function serve({
  folder = process.env.GNOMON_SITE ?? site,
  path = '/',
  missing,
  isolated = false,
  plainTypes = false,
} = {}) {
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, 'http://localhost');
    const inside = pathname.startsWith(path) ? normalize(decodeURIComponent(pathname.slice(path.length - 1))) : null;
    try {
      if (inside === null || inside.startsWith('..') || missing?.test(inside)) throw new Error('outside');
      const file = join(folder, inside.endsWith('/') ? `${inside}index.html` : inside);
      const body = await readFile(file);
      const type = types[extname(file)] ?? 'application/octet-stream';
      const careless = plainTypes && !/html|css|javascript/.test(type);
      response.writeHead(200, {
        'Content-Type': careless ? 'application/octet-stream' : type,
        'Content-Length': body.length,
        'Cache-Control': 'no-store',
        ...(isolated ? isolation : {}),
      });
      response.end(body);
    } catch {
      response.writeHead(404, { 'Content-Type': 'text/plain' }).end('not found');
    }
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    url: `http://127.0.0.1:${server.address().port}${path}`,
    close: () => {
      server.closeAllConnections();
      return new Promise((resolve) => server.close(resolve));
    },
  };
}
