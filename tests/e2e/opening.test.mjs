// What is there before the application: the opening scene, which moves already.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { draw, drawn } from "../../scripts/draw-opening.mjs";
import { BOTH, flows, MOVING } from "./flow.mjs";
import { Playground } from "./page.mjs";
import { eventually } from "./wait.mjs";

const PROGRAM = "**/app-*.wasm";
/** How far the board may jump when the application takes over, in pixels. */
const JUMP_PX = 2;

describe("before the application", () => {
  const flow = flows();

  flow("the picture of the opening scene is the board's own", async (playground) => {
    assert.equal(await draw(playground), drawn(), "draw it anew: ./x opening");
  }, { screens: ["desktop"] });

  flow("the opening scene moves, and the application goes on with it", async (playground, { context, page, host }) => {
    const release = await hold(context);
    await visit(page, host.url);
    const robot = page.locator(".boot .agent").first();
    const begin = await robot.getAttribute("transform");
    await eventually("the robot to be elsewhere", () => robot.getAttribute("transform"), (now) => now !== begin);
    await eventually("some steps", () => shown(page), (time) => time > 2);
    const before = await edge(page);
    await playground.picture("opening");
    const time = await shown(page);
    release();
    await playground.board.waitFor();
    assert.ok(await playground.now() >= Math.floor(time), `it began anew at ${await playground.now()}, after ${time}`);
    await playground.button("Pause").waitFor();
    const after = await edge(page);
    for (const side of ["x", "y", "width", "height"]) {
      assert.ok(Math.abs(before[side] - after[side]) <= JUMP_PX, `the board jumps: ${JSON.stringify([before, after])}`);
    }
  }, { screens: BOTH, ...MOVING });

  flow("a scene of one's own and a link are not covered by it", async (playground, { context, page, host }) => {
    await playground.press("Pause");
    await eventually("the page to be kept", () => page.evaluate(() => localStorage.getItem("giveway.tabs") !== null));
    for (const address of ["", "#giveway=1&map=.."]) {
      const release = await hold(context);
      await page.goto("about:blank");
      await (address ? visit(page, host.url + address) : page.goto(host.url, { waitUntil: "domcontentloaded" }));
      await page.getByText("Loading the playground").waitFor();
      assert.equal(await page.locator(".boot .map").isVisible(), false, `covered: ${address || "what was kept"}`);
      assert.equal(await shown(page), null);
      release();
      await new Playground(page).board.waitFor();
      await context.unroute(PROGRAM);
    }
  }, { screens: ["desktop"] });
});

/** Holds the application back until the function that this gives is called. */
async function hold(context) {
  let release;
  const released = new Promise((resolve) => {
    release = resolve;
  });
  await context.route(PROGRAM, async (route) => {
    await released;
    await route.continue();
  });
  return release;
}

/** Opens an address as if for the first time; what the application does waits until it is released. */
async function visit(page, address) {
  await page.goto(address, { waitUntil: "domcontentloaded" });
  await page.evaluate(() => localStorage.clear());
  await page.reload({ waitUntil: "domcontentloaded" });
}

/** The time that the picture shows. */
async function shown(page) {
  const time = await page.evaluate(() => document.getElementById("page").dataset.time ?? null);
  return time === null ? null : Number(time);
}

function edge(page) {
  return page.locator(".map .edge").first().boundingBox();
}
