// A worker that does not start, or breaks off: it is told, and mended.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { bytes, files } from "./dist.mjs";
import { flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const OPENING = /^Optimal: makespan 18/;
const LOADER = "**/worker-*.js";
const SCRIPT = "**/solver-*.js";
const ANALYST = /\/analyst[-_]/;
const PROGRAM = "**/solver-*.wasm";

describe("a broken worker", () => {
  const flow = flows();
  const screens = ["desktop"];

  const missing = (route) => route.fulfill({ status: 404 });
  const garbage = (contentType) => (route) => route.fulfill({ body: "this is none", contentType });
  for (const [what, path, answer] of [
    ["no script", LOADER, garbage("text/javascript")],
    ["not there", LOADER, missing],
    ["of a garbled script", SCRIPT, garbage("text/javascript")],
    ["without its script", SCRIPT, (route) => route.abort()],
    ["of a garbled program", PROGRAM, garbage("application/wasm")],
    ["without its program", PROGRAM, missing],
  ]) {
    flow(`that is ${what} is told, and tried again`, async (playground, { context }) => {
      // What is shown first needs none.
      await playground.says(OPENING);
      await playground.example("Who waits?");
      await playground.warns(/The solver could not be started\. Press Solve to try again\./);
      await playground.says(/^No plan yet\.$/);
      await playground.shows("scenario 1");
      await playground.picture("worker-broken");
      await context.unroute(path);
      await playground.press("Solve");
      await playground.says(/^Optimal: /);
      await playground.warns(/^\s*$/);
    }, { screens, complains: true, before: (context) => context.route(path, answer) });
  }

  flow("that answers is loaded when something is asked; where it is missing, solving goes on", async (playground, { context, page }) => {
    const asked = [];
    page.on("request", (request) => asked.push(request.url()));
    await playground.example("Who waits?");
    await playground.says(/^Optimal: /);
    assert.deepEqual(asked.filter((url) => ANALYST.test(url)), [], "loaded before anything was asked");
    await context.route(ANALYST, missing);
    await ask(playground);
    await playground.warns(/The part of the solver that answers could not be loaded\. Try again when the network is back\./);
    await playground.example("Crossing");
    await playground.says(/^Optimal: /);
    await context.unroute(ANALYST);
    await playground.example("Who waits?");
    await playground.says(/^Optimal: /);
    await ask(playground);
    await playground.inspector.getByText("same cost").first().waitFor();
    // The solver is still there.
    await playground.example("Crossing");
    await playground.says(/^Optimal: /);
  }, { screens, complains: true });

  flow("that solves stays warm beside the one that answers", async (playground, { page }) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: /);
    const solvers = page.workers();
    const ended = [];
    for (const solver of solvers) solver.on("close", () => ended.push(solver.url()));
    await ask(playground);
    await playground.inspector.getByText("same cost").first().waitFor();
    assert.equal(solvers.length, 1);
    assert.deepEqual(ended, [], "ended for a question");
    assert.equal(page.workers().length, 2);
  }, { screens });

  flow("that breaks off is replaced, and the scene stays", async (playground, { context, page }) => {
    await playground.says(OPENING);
    // The next one answers its first request with an exception.
    const fault = 'addEventListener("message", ({ data }) => { if (!(data instanceof WebAssembly.Module)) throw new Error("out of order"); });';
    const loader = files().find((path) => /(^|\/)worker-[^/]*\.js$/.test(path));
    const body = `${bytes(loader)}\n;${fault}`;
    // Answered at once: what is still on its way when a route ends is answered twice.
    let given = 0;
    await context.route(LOADER, async (route) => {
      await route.fulfill({ body, contentType: "text/javascript" });
      given += 1;
    });
    await playground.example("Thirty robots");
    await playground.button("Cancel").waitFor();
    const broken = page.waitForEvent("worker");
    await playground.press("Cancel");
    await broken;
    await playground.solver.click();
    await playground.warns(/The solver broke off and was started again\. Your scene is as it was\..*out of order/s);
    await playground.shows("thirty robots");
    // The worker that was started in place of it is broken, too; a script that is still on its way
    // when the route ends is never answered.
    await eventually("two broken workers to be given", () => given, (given) => given >= 2);
    await context.unroute(LOADER);
    await playground.solver.click();
    await playground.says(/^No plan yet\.$|^Solving|You stopped the search/);
    await playground.example("Who waits?");
    await playground.says(/^Optimal: /);
  }, { screens, complains: true });

  flow("of which there are many is only one at last", async (playground, { page }) => {
    for (let times = 0; times < 3; times += 1) {
      await playground.example("Thirty robots");
      await playground.button("Cancel").waitFor();
      await playground.press("Cancel");
      await playground.solver.waitFor();
    }
    await playground.example("Who waits?");
    await playground.says(/^Optimal: /);
    await eventually("no worker but one", () => page.workers().length, (count) => count === 1);
  }, { screens });
});

/** Asks why the second agent of `Who waits?` waits. */
async function ask(playground) {
  await playground.inspector.getByRole("button", { name: /^A2\b/ }).first().click();
  await playground.inspector.getByRole("button", { name: /^Why does A2 wait at \(3, 1\)\?/ }).first().click();
}
