// A static host as plain as any: files of a folder under a path, with the types of
// their endings and no special header.

import { createServer } from "node:http";
import { readFile, stat } from "node:fs/promises";
import { extname, join, normalize } from "node:path";
import { setTimeout } from "node:timers/promises";
import { promisify } from "node:util";
import { brotliCompress } from "node:zlib";

const compressed = promisify(brotliCompress);

const TYPES = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".map": "text/plain; charset=utf-8",
  ".scen": "text/plain; charset=utf-8",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
};

/**
 * Serves a folder.
 * @param {string} folder its path; may be changed later, as a deployment does
 * @param {string} base the path it is served under, from "/" to "/"
 * @param {object} options `compress`: by brotli, as most hosts do
 * @returns {Promise<Host>}
 */
export async function serve(folder, base = "/some/where/", { compress = false } = {}) {
  const host = new Host(folder, base, compress);
  await new Promise((resolve) => host.server.listen(0, "127.0.0.1", resolve));
  return host;
}

class Host {
  /** Paths that were asked for and are not there. */
  missing = [];
  /** Paths that were sent, each as often as it was. */
  sent = [];
  /** Paths within the base that take long, milliseconds: until the headers, and from them until the end. */
  slow = new Map();

  /** What was compressed, by file. */
  #compressed = new Map();

  constructor(folder, base, compress) {
    this.folder = folder;
    this.base = base;
    this.compress = compress;
    this.server = createServer((request, response) => {
      this.#answer(request, response).catch((error) => response.destroy(error));
    });
  }

  /** Where the page is. */
  get url() {
    return `http://127.0.0.1:${this.server.address().port}${this.base}`;
  }

  /** Ends it, connections that are still open too. */
  async close() {
    if (!this.server.listening) {
      return;
    }
    const closed = new Promise((resolve) => this.server.close(resolve));
    this.server.closeAllConnections();
    await closed;
  }

  async #answer(request, response) {
    const path = normalize(decodeURIComponent(new URL(request.url, "http://host").pathname));
    const file = await this.#file(path);
    if (!file) {
      this.missing.push(path);
      response.writeHead(404, { "Content-Type": "text/plain" }).end("not here\n");
      return;
    }
    this.sent.push(path.slice(this.base.length));
    const accepts = request.headers["accept-encoding"]?.includes("br");
    const [body, encoding] = this.compress && accepts
      ? [await this.#compress(file), { "Content-Encoding": "br" }]
      : [await readFile(file), {}];
    const type = TYPES[extname(file)] ?? "application/octet-stream";
    const { headers = 0, end = 0 } = this.slow.get(path.slice(this.base.length)) ?? {};
    await setTimeout(headers);
    response.writeHead(200, { "Content-Type": type, "Content-Length": body.length, ...encoding });
    const half = body.length >> 1;
    response.write(body.subarray(0, half));
    await setTimeout(end);
    response.end(body.subarray(half));
  }

  /** A file compressed, each only once: the best quality takes seconds. */
  #compress(file) {
    if (!this.#compressed.has(file)) {
      this.#compressed.set(file, readFile(file).then((body) => compressed(body)));
    }
    return this.#compressed.get(file);
  }

  async #file(path) {
    if (!path.startsWith(this.base)) {
      return undefined;
    }
    const rest = path.slice(this.base.length);
    const file = join(this.folder, rest === "" ? "index.html" : rest);
    const found = await stat(file).catch(() => undefined);
    return found?.isFile() ? file : undefined;
  }
}
