// `./x serve`: builds the page, serves it on this machine, and builds it anew when a file
// changes; open pages then load themselves anew.

import { watch } from "node:fs";
import { join } from "node:path";
import { setTimeout } from "node:timers/promises";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";

import { assemble } from "../page/assemble.mjs";
import { compile } from "../page/compile.mjs";
import { makeReloading } from "./reload.mjs";
import { serve } from "./server.mjs";

/** What the page is made of. */
const WATCHED = ["index.html", "static", "web", "crates", "Cargo.toml", "Cargo.lock"];
/** Of that, what is not compiled. */
const COPIED = /^(index\.html$|static)/;
/** Editors save in several steps, milliseconds apart. */
const SETTLED = 100;

const source = fileURLToPath(new URL("../..", import.meta.url));
const folder = join(process.env.CARGO_TARGET_DIR ?? join(source, "target"), "serve");

function fail(message) {
  console.error(`serve: ${message}`);
  process.exit(1);
}

function options() {
  try {
    const { values } = parseArgs({
      options: { port: { type: "string", default: "8080" }, address: { type: "string", default: "127.0.0.1" } },
    });
    const port = Number(values.port);
    if (!Number.isInteger(port) || port < 0 || port > 65_535) {
      fail(`--port: found "${values.port}", expected a number up to 65535`);
    }
    return { port, address: values.address };
  } catch (error) {
    return fail(`${error.message}; expected --port N or --address A`);
  }
}

/** Builds what the changed paths ask for, and says how long that took. */
async function make(changed) {
  const start = performance.now();
  if (!changed.every((path) => COPIED.test(path))) {
    await compile(source, folder, "quick");
  }
  assemble(source, folder);
  makeReloading(folder);
  console.log(`Built in ${((performance.now() - start) / 1000).toFixed(1)} s.`);
}

/** The paths that change from now on, in groups that belong together. */
function changes() {
  const changed = new Set();
  let wake = () => {};
  for (const path of WATCHED) {
    watch(join(source, path), { recursive: true }, () => {
      changed.add(path);
      wake();
    });
  }
  return (async function* groups() {
    for (;;) {
      if (changed.size === 0) {
        await new Promise((resolve) => { wake = resolve; });
      }
      await setTimeout(SETTLED);
      const paths = [...changed];
      changed.clear();
      yield paths;
    }
  })();
}

const where = options();
const later = changes();
try {
  await make(WATCHED);
} catch (error) {
  fail(error.message);
}
const host = await serve(folder, where).catch((error) => fail(error.message));
console.log(`The playground is at ${host.url} (Ctrl+C ends it). It is built anew when a file changes.`);
for await (const changed of later) {
  console.log(`\n${changed.join(", ")}: building`);
  try {
    await make(changed);
    host.changed();
  } catch (error) {
    console.error(`serve: ${error.message}; the page stays as it was`);
  }
}
