// What the page weighs on the wire until something moves, until the application is there,
// until it can solve, and until all of it is there.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { brotliCompressSync, constants } from "node:zlib";

import { launch, open } from "./browser.mjs";
import { bytes, dist } from "./dist.mjs";
import { Playground } from "./page.mjs";
import { serve } from "./server.mjs";
import { eventually } from "./wait.mjs";

/** What a first visit does not run. */
const LATER = /^app-.*_later\.wasm$/;

/**
 * What is asked for by then, and how much it may be, compressed by brotli, in bytes. What
 * that takes at 1.6 Mbit/s and 150 ms stands in docs/page.md.
 */
const STAGES = [
  ["until something moves", /^$|^(end-)?style-|^opening-|^guard-|^boot-|^static\/opening\.json$|^icon\.svg$|^manifest\./, 30_200],
  ["until the application is there", /^app-(?!.*_later)|^unstarted-|^static\/icons\.svg$/, 618_500],
  ["until it can solve", /^worker-|^solver-(?!.*_later)/, 776_500],
  ["until all of the page is there", /^app-.*_later\.wasm$|^later-style-/, 1_404_000],
];

let host;
let browser;
before(async () => {
  host = await serve(dist, "/");
  browser = await launch();
});
after(async () => {
  await browser?.close();
  await host?.close();
});

function onTheWire(path) {
  const content = bytes(path || "index.html");
  return brotliCompressSync(content, {
    params: {
      [constants.BROTLI_PARAM_QUALITY]: constants.BROTLI_MAX_QUALITY,
      [constants.BROTLI_PARAM_SIZE_HINT]: content.length,
    },
  }).length;
}

const kilobytes = (size) => `${(size / 1000).toFixed(1).padStart(7)} kB`;

test("no program is fetched twice, and no stage of the first visit takes more than it may", async (t) => {
  const { page } = await open(browser, { serviceWorkers: "block" });
  const playground = new Playground(page);
  await playground.goto(host.url);
  await playground.press("Solve");
  await playground.button("Solve").waitFor();
  await playground.says(/^Optimal: /);
  await eventually("all of the page to be there", () => host.sent.some((path) => LATER.test(path)));
  await page.close();

  assert.deepEqual(host.missing, []);
  const programs = host.sent.filter((path) => /\.(wasm|js)$/.test(path));
  assert.deepEqual(programs, [...new Set(programs)], "something was fetched twice");
  const at = (pattern) => host.sent.findIndex((path) => pattern.test(path));
  assert.ok(at(LATER) > at(/^solver-.*\.wasm$/), "what a first visit does not run comes after what it does");
  const left = new Set(host.sent);
  let total = 0;
  for (const [when, pattern, limit] of STAGES) {
    for (const path of [...left].filter((path) => pattern.test(path))) {
      const size = onTheWire(path);
      total += size;
      left.delete(path);
      t.diagnostic(`${kilobytes(size)}  ${path || "index.html"}`);
    }
    t.diagnostic(`${kilobytes(total)}  ${when}, of ${kilobytes(limit).trim()}`);
    assert.ok(total <= limit, `${kilobytes(total).trim()} ${when} are more than ${kilobytes(limit).trim()}`);
  }
  assert.deepEqual([...left], [], "of no stage");
});
