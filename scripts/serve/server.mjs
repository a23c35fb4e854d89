// A static host for the page while somebody works on it, which tells open pages when
// they have changed.

import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";

const TYPES = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".scen": "text/plain; charset=utf-8",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
};

/**
 * Serves a folder at an address of this machine.
 * @param {string} folder its path
 * @param {{address: string, port: number}} where port 0 takes any that is free
 * @returns {Promise<{url: string, changed: () => void, close: () => void}>} `changed` has open pages load themselves anew
 * @throws {Error} where the port is in use
 */
export async function serve(folder, { address, port }) {
  const listeners = new Set();
  const server = createServer(async (request, response) => {
    const path = pathOf(request.url);
    if (path === "/events") {
      response.writeHead(200, { "Content-Type": "text/event-stream", "Cache-Control": "no-store" }).flushHeaders();
      listeners.add(response);
      response.on("close", () => listeners.delete(response));
      return;
    }
    const file = path && join(folder, path.endsWith("/") ? `${path}index.html` : path);
    const body = file && await readFile(file).catch(() => undefined);
    if (!body) {
      response.writeHead(404, { "Content-Type": "text/plain" }).end("not here\n");
      return;
    }
    const type = TYPES[extname(file)] ?? "application/octet-stream";
    response.writeHead(200, { "Content-Type": type, "Content-Length": body.length, "Cache-Control": "no-store" }).end(body);
  });
  await new Promise((resolve, reject) => {
    server.once("error", (error) => reject(sentence(error, port)));
    server.listen(port, address, resolve);
  });
  return {
    url: `http://${address}:${server.address().port}/`,
    changed: () => listeners.forEach((response) => response.write("data: changed\n\n")),
    close: () => {
      server.close();
      server.closeAllConnections();
    },
  };
}

/** The path within the folder; none that cannot be read, or leads out of it. */
function pathOf(url) {
  try {
    return normalize(decodeURIComponent(new URL(url, "http://host").pathname));
  } catch {
    return undefined;
  }
}

function sentence(error, port) {
  return error.code === "EADDRINUSE"
    ? new Error(`port ${port} is in use; ./x serve --port ${port + 1} takes another`)
    : error;
}
