// What `./x serve` puts together and serves; that it builds and reloads is tested with a
// real build (tests/setup/long/).

import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync, mkdirSync } from "node:fs";
import { request } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { assemble } from "../../scripts/page/assemble.mjs";
import { serve } from "../../scripts/serve/server.mjs";

let folder;
let host;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "giveway-serve-"));
  for (const built of ["app.js", "app_bg.wasm", "solver.js", "solver_bg.wasm", "analyst.js", "analyst_bg.wasm", "reader.js", "reader_bg.wasm", "course.js", "course_bg.wasm"]) {
    writeFileSync(join(folder, built), built);
  }
  assemble(".", folder);
  host = await serve(folder, { address: "127.0.0.1", port: 0 });
});

after(() => {
  host.close();
  rmSync(folder, { recursive: true });
});

/** An answer to a path exactly as it is written. */
function ask(path) {
  const { port } = new URL(host.url);
  return new Promise((resolve, reject) => {
    const asked = request({ host: "127.0.0.1", port, path }, (response) => {
      let body = "";
      response.on("data", (piece) => { body += piece; });
      response.on("end", () => resolve({ status: response.statusCode, type: response.headers["content-type"], body }));
    });
    asked.on("error", reject);
    asked.end();
  });
}

test("the page names only files that are there, and holds no element for the build", () => {
  const page = readFileSync(join(folder, "index.html"), "utf8");
  const named = [...page.matchAll(/(?:href|src|data-wasm)="([^"#]+)"/g)].map(([, path]) => path).filter((path) => !path.startsWith("data:"));
  assert.ok(named.length > 20, `found ${named.length} files named`);
  assert.deepEqual(named.filter((path) => !existsSync(join(folder, path))), []);
  assert.doesNotMatch(page, /data-build/);
  assert.match(page, /id="application" rel="modulepreload" href="\.\/app\.js" data-wasm="\.\/app_bg\.wasm"/);
});

test("an element that it does not know is refused with its text", () => {
  const source = mkdtempSync(join(tmpdir(), "giveway-source-"));
  writeFileSync(join(source, "index.html"), '<link data-build rel="sass" href="a.scss">');
  mkdirSync(join(source, "out"));
  assert.throws(() => assemble(source, join(source, "out")), /found <link data-build rel="sass" href="a\.scss">, expected one of/);
  rmSync(source, { recursive: true });
});

test("files have their types, and nothing outside of the folder is sent", async () => {
  assert.equal((await ask("/")).type, "text/html; charset=utf-8");
  assert.equal((await ask("/app_bg.wasm")).type, "application/wasm");
  assert.equal((await ask("/static/icons.svg")).type, "image/svg+xml");
  for (const path of ["/gone.js", "/static", "/../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/%", "//"]) {
    const { status, body } = await ask(path);
    assert.ok(status === 404 || body.startsWith("<!doctype"), `${path}: ${status}`);
    assert.doesNotMatch(body, /root:/);
  }
});

test("a page that listens is told of each change", async () => {
  const stop = new AbortController();
  const response = await fetch(new URL("events", host.url), { signal: stop.signal });
  const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
  host.changed();
  assert.match((await reader.read()).value, /^data: /);
  host.changed();
  assert.match((await reader.read()).value, /^data: /);
  stop.abort();
});

test("a port in use is said, with another to take", async () => {
  const port = Number(new URL(host.url).port);
  await assert.rejects(serve(folder, { address: "127.0.0.1", port }), new RegExp(`port ${port} is in use; ./x serve --port ${port + 1} `));
});

test("what binds the Wasm is of the version that it was compiled for", () => {
  const locked = readFileSync("Cargo.lock", "utf8").match(/name = "wasm-bindgen"\nversion = "([^"]+)"/)[1];
  assert.match(readFileSync("scripts/bind/Cargo.toml", "utf8"), new RegExp(`wasm-bindgen-cli-support = "=${locked.replaceAll(".", "\\.")}"`));
});
