// What the page weighs on the wire.

import assert from "node:assert/strict";
import { test } from "node:test";
import { brotliCompressSync, constants } from "node:zlib";

import { bytes, files } from "./dist.mjs";

/** What all Wasm of the page together should be at most, compressed by brotli, bytes. */
const WASM_AIM = 300_000;
/** What it may be until then: it must not grow while it is being made smaller. */
const WASM_LIMIT = 580_000;

function onTheWire(path) {
  const content = bytes(path);
  return brotliCompressSync(content, {
    params: {
      [constants.BROTLI_PARAM_QUALITY]: constants.BROTLI_MAX_QUALITY,
      [constants.BROTLI_PARAM_SIZE_HINT]: content.length,
    },
  }).length;
}

const kilobytes = (size) => `${(size / 1000).toFixed(1).padStart(7)} kB`;

test("all Wasm together does not grow", (t) => {
  const wasm = files().filter((path) => path.endsWith(".wasm"));
  assert.equal(wasm.length, 1, `expected one file for the page and its worker: ${wasm}`);
  let total = 0;
  for (const path of wasm) {
    const size = onTheWire(path);
    total += size;
    t.diagnostic(`${kilobytes(size)}  ${path}`);
  }
  t.diagnostic(`${kilobytes(total)}  all Wasm, of ${kilobytes(WASM_LIMIT).trim()}; the aim is ${kilobytes(WASM_AIM).trim()}`);
  const rest = files().filter((path) => !path.endsWith(".wasm"));
  t.diagnostic(`${kilobytes(rest.map(onTheWire).reduce((a, b) => a + b, 0))}  all other files`);
  assert.ok(total <= WASM_LIMIT, `${kilobytes(total).trim()} of Wasm are more than ${kilobytes(WASM_LIMIT).trim()}`);
});
