// The programs beside a browser: they end when they are told to, whatever they have started.

import assert from "node:assert/strict";
import { describe, test } from "node:test";

import { start } from "./driver/process.mjs";

const timeout = 20_000;

describe("a program that a browser needs", () => {
  test("is ended though one that it has started goes on", { timeout }, async (t) => {
    const { said, end } = await start("/bin/sh", ["-c", "sleep 60 & echo ready $!; wait"], /ready (\d+)/);
    t.after(() => process.kill(Number(said[1])));
    await end();
  });

  test("is ended though it does not heed", { timeout }, async () => {
    const { end } = await start("/bin/sh", ["-c", "trap '' TERM; echo ready; while :; do sleep 0.1; done"], /ready/);
    await end();
  });

  test("that is not there says so", { timeout }, async () => {
    await assert.rejects(start("/not/there", [], /ready/), /\/not\/there spawn \/not\/there ENOENT/);
  });

  test("that ends too soon tells what it has printed", { timeout }, async () => {
    await assert.rejects(start("/bin/sh", ["-c", "echo no display"], /ready/), /ended:\nno display/);
  });
});
