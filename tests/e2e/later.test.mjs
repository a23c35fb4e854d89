// The page's program comes in two parts: a first visit needs the first alone, and whatever needs the later one waits for it.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { slowSolver } from "../measure/network.mjs";
import { solveAtOnce } from "../measure/watch.mjs";
import { BOTH, flows } from "./flow.mjs";
import { open } from "./browser.mjs";
import { leaveAndComeBack } from "./leaving.mjs";
import { Playground } from "./page.mjs";
import { eventually } from "./wait.mjs";

const LATER = /\/app-[0-9a-f]+_later\.wasm$/;
const SOLVER = /\/solver-[0-9a-f]+_bg\.wasm$/;

describe("the later part of the page's program", () => {
  const flow = flows();

  flow("is needed neither to open the page, nor to solve, nor to leave", async (_, { context: around, host }) => {
    const browser = around.browser();
    const { context, page, complaints } = await open(browser, { serviceWorkers: "block" });
    await page.route(LATER, (route) => route.abort());
    const playground = new Playground(page);
    await playground.goto(host.url);
    await playground.press("Solve");
    await playground.button("Solve").waitFor();
    await playground.says(/^Optimal: /);
    await playground.board.hover();
    await leaveAndComeBack(page);
    // It was asked for ahead of time, and could not be had.
    const others = complaints.filter((complaint) => !/_later\.wasm|Service Worker/.test(complaint));
    assert.deepEqual(others, []);
    assert.equal(await page.getByRole("alertdialog").count(), 0);
    await context.close();
  }, { fresh: true, screens: ["desktop"], complains: true });

  flow("is not needed to solve at once, on a slow machine", async (_, { context: around, host }) => {
    const browser = around.browser();
    const { context, page, complaints } = await open(browser, { serviceWorkers: "block" });
    await page.route(LATER, (route) => route.abort());
    await page.route(SOLVER, async (route) => {
      await page.waitForTimeout(2500);
      await route.continue();
    });
    await slowSolver(page, 100);
    await page.addInitScript(() => { window.seen = {}; });
    await page.addInitScript(solveAtOnce);
    const playground = new Playground(page);
    await playground.goto(host.url);
    await eventually("an answer", () => page.evaluate(() => window.seen.solved), Boolean, 20_000);
    const others = complaints.filter((complaint) => !/_later\.wasm|Service Worker/.test(complaint));
    assert.deepEqual(others, []);
    assert.equal(await page.getByRole("alertdialog").count(), 0);
    await context.close();
  }, { fresh: true, screens: ["desktop"], complains: true });

  flow("is waited for by what needs it, once", async (_, { context: around, host }) => {
    const browser = around.browser();
    const { context, page } = await open(browser, { serviceWorkers: "block" });
    let asked = 0;
    await page.route(LATER, (route) => {
      asked += 1;
      return asked === 1 ? route.abort() : route.continue();
    });
    const playground = new Playground(page);
    await playground.goto(host.url);
    await playground.says(/^Optimal: |^Solved|makespan/);
    await eventually("the later part to be asked for ahead of time", () => asked === 1);
    await playground.act("Share");
    await page.getByRole("dialog", { name: "Share" }).getByLabel("Link").waitFor();
    await playground.key("Escape");
    await playground.act("New");
    await page.getByRole("dialog", { name: "New scene" }).waitFor();
    assert.equal(asked, 2, "it comes once");
    await context.close();
  }, { fresh: true, screens: ["desktop"], complains: true });

  flow("that cannot be had is told, and nothing is lost", async (_, { context: around, host }) => {
    const browser = around.browser();
    const { context, page } = await open(browser, { serviceWorkers: "block" });
    let isThere = false;
    await page.route(LATER, (route) => (isThere ? route.continue() : route.abort()));
    const playground = new Playground(page);
    await playground.goto(host.url);
    await playground.says(/makespan/);
    // It never comes to the dialog.
    playground.act("Share").catch(() => undefined);
    const overlay = page.getByRole("alertdialog");
    await overlay.getByRole("button", { name: "Reload the page" }).waitFor();
    isThere = true;
    await overlay.getByRole("button", { name: "Reload the page" }).click();
    await playground.says(/makespan/);
    await playground.act("Share");
    await page.getByRole("dialog", { name: "Share" }).waitFor();
    await context.close();
  }, { fresh: true, screens: ["desktop"], complains: true });

  flow("brings a style that what a first visit shows does without", async (playground, { page }) => {
    await playground.press("Solve");
    await playground.says(/^Optimal: /);
    const link = page.locator('link[href*="later-style"]');
    await link.waitFor({ state: "attached" });
    await eventually("the style to be there", () => link.evaluate((link) => link.sheet !== null));
    const changed = await link.evaluate((link) => {
      const look = () => [...document.querySelectorAll("body *")].filter((element) => !element.ownerSVGElement).map((element) => {
        const { x, y, width, height } = element.getBoundingClientRect();
        const { display, color, fontSize, padding } = getComputedStyle(element);
        return [element.tagName, element.className, x, y, width, height, display, color, fontSize, padding].join(" ");
      });
      const before = look();
      link.disabled = true;
      const after = look();
      link.disabled = false;
      return after.filter((line, at) => line !== before[at]);
    });
    assert.deepEqual(changed, []);
  }, { screens: BOTH });
});
