// Waiting for what will be so, and telling what was so instead.

import assert from "node:assert/strict";

/** Long enough for a machine that does other things too, in milliseconds. */
const PATIENCE = 30_000;

/**
 * Reads until what was read is accepted, and gives it.
 * @param what the sentence of the failure: "the status to say ..."
 * @param read gives a value, or a promise of one
 * @param accept whether that is it
 */
export async function eventually(what, read, accept = Boolean, patience = PATIENCE) {
  const end = Date.now() + patience;
  let last;
  do {
    last = await read();
    if (accept(last)) {
      return last;
    }
    await new Promise((resolve) => setTimeout(resolve, 50));
  } while (Date.now() < end);
  assert.fail(`waited for ${what}, found ${JSON.stringify(last)}`);
}

/** Reads until the same number comes five times in a row, and gives it. */
export function still(what, read) {
  let before;
  let times = 0;
  return eventually(`${what} to stand still`, read, (now) => {
    times = now === before ? times + 1 : 1;
    before = now;
    return times === 5;
  });
}
