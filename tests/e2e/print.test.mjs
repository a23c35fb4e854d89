// The page on paper: what the browser prints of a scene, an answer, an audit and a lesson.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { flows, sample } from "./flow.mjs";

const OPENING = /^Optimal: makespan 18/;

describe("on paper", () => {
  const flow = flows();
  const screens = ["desktop"];

  flow("a scene has its board with coordinates, its costs and its whole plan, and nothing to press", async (playground, { page }) => {
    await playground.says(OPENING);
    const told = await printed(page);
    assert.match(told.text, /warehouse\s+Optimal: makespan 18, sum of costs 35, 3 charges\./);
    assert.match(told.text, /2 robots; map of 10 × 3 cells/);
    assert.match(told.text, /Makespan\s+18\s/);
    assert.equal(told.rows, 19, "a row for each time from 0 to 18");
    assert.deepEqual(told.columns, ["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"]);
    assert.equal(told.robots, 2);
    isPaper(told);
  }, { screens: ["desktop", "phone"], theme: "dark" });

  flow("the table is there as soon as the browser prints, also right after another render", async (playground, { page }) => {
    await playground.says(OPENING);
    await playground.pause();
    // The browser waits for nothing between its event and the paper; nor does this.
    const rows = await page.evaluate(() => {
      document.querySelector(".dock input[type=range]")?.dispatchEvent(new Event("input", { bubbles: true }));
      dispatchEvent(new Event("beforeprint"));
      return document.querySelectorAll(".paper-plan tbody tr").length;
    });
    assert.equal(rows, 19);
    await page.evaluate(() => dispatchEvent(new Event("afterprint")));
    await page.locator(".paper").first().waitFor({ state: "detached" });
  }, { screens });

  flow("a long time in which nobody moves is one line, not a hundred pages", async (playground, { page }) => {
    await playground.open(...breakdown(5000));
    await playground.says(/the plan went on/);
    const told = await printed(page);
    assert.ok(told.rows < 30, `${told.rows} rows`);
    assert.match(told.text, /Nobody moves: all as in the row above/);
    isPaper(told);
    const pdf = await page.pdf({ format: "A4" });
    const pages = pdf.toString("latin1").match(/\/Type\s*\/Page\b(?!s)/g).length;
    assert.ok(pages <= 4, `${pages} pages`);
  }, { screens });

  flow("a question has its answer, its facts and what would help", async (playground, { page }) => {
    await playground.example("No way past");
    await playground.says(/^No plan exists, no matter how many steps you allow/);
    await playground.inspector.getByRole("button", { name: /^Why is there no plan\?/ }).first().click();
    await playground.inspector.getByRole("heading", { name: "What would help" }).waitFor();
    const told = await printed(page);
    for (const part of [/Why is there no plan\?/, /Impossible/, /Remove the obstacle at \(1, 0\)/, /Because of/, /A1 and A2 must not collide/]) {
      assert.match(told.text, part);
    }
    assert.equal(told.rows, 0, "there is no plan");
    isPaper(told);
  }, { screens });

  flow("a plan from elsewhere has its verdict and what goes wrong", async (playground, { page }) => {
    const bytes = (text) => Buffer.from(text);
    await playground.open(
      { name: "a.map", bytes: bytes("type octile\nheight 2\nwidth 4\nmap\n....\n....\n") },
      { name: "a.txt", bytes: bytes("Agent 0: (0,0)->(0,1)->(0,2)->\nAgent 1: (0,2)->(0,1)->(0,0)->\n") },
    );
    await playground.says(/breaks a rule once/);
    const told = await printed(page);
    assert.match(told.text, /Not legal/);
    assert.match(told.text, /A1 and A2 are both at \(1, 0\)/);
    assert.equal(told.rows, 3);
    isPaper(told);
  }, { screens });

  flow("a lesson has its step, its task and no word of clicks", async (playground, { page, host }) => {
    await playground.goto(`${host.url}#lesson=two-robots-one-cell.2`);
    await page.getByRole("heading", { name: "Two in one cell" }).waitFor();
    const step = await printed(page);
    assert.match(step.text, /Two robots may never be in one cell/);
    assert.match(step.text, /Your turn/);
    assert.equal(step.rows, 5);
    isPaper(step);
    await page.evaluate(() => {
      window.print = () => {};
    });
    await page.getByRole("button", { name: "Print", exact: true }).click();
    await page.locator("#print h1").first().waitFor({ state: "attached" });
    const whole = await page.evaluate(() => document.getElementById("print").textContent);
    assert.doesNotMatch(whole, /\b(click|tap|slider)\b/i);
    const boards = await page.evaluate(() => [...document.querySelectorAll("#print img")].map((img) => decodeURIComponent(img.src)));
    assert.ok(boards.length > 2);
    for (const board of boards) {
      assert.doesNotMatch(board, />Step</, "a line of the time that nobody can move");
    }
  }, { screens });

  flow("a floor of 40 x 24 with 16 robots loses nothing", async (playground, { page }) => {
    await playground.open(sample("depot/depot.json"), sample("depot/depot-plan.json"));
    await playground.says(/Depot|legal|plan/i);
    const told = await printed(page);
    assert.match(told.text, /16 robots; map of 40 × 24 cells/);
    assert.equal(told.robots, 16);
    assert.ok(told.rows >= 80, `${told.rows} rows`);
    assert.equal(told.entries % told.rows, 0, "each row is whole");
    isPaper(told);
    // The page has gone back to the screen before it is printed again.
    await page.locator(".paper").first().waitFor({ state: "detached" });
    await playground.now();
    await page.waitForTimeout(500);
    const pdf = await page.pdf({ format: "A4" });
    const pages = pdf.toString("latin1").match(/\/Type\s*\/Page\b(?!s)/g).length;
    assert.ok(pages >= 4, `${pages} pages`);
  }, { screens });
});

/** A robot that breaks down for so many steps on its way, as files that the command writes. */
function breakdown(steps) {
  const scene = { giveway: 1, name: "lane", map: ["....", "...."], agents: [
    { name: "R1", start: [0, 0], goal: [3, 0] }, { name: "R2", start: [0, 1], goal: [3, 1] },
  ] };
  const changes = { giveway: 1, changes: [{ at: 1, change: "delay-agent", agent: "R1", steps }] };
  const waits = Array.from({ length: steps }, () => [1, 0]);
  const plan = { giveway: 1, paths: {
    R1: [[0, 0], [1, 0], ...waits, [2, 0], [3, 0]], R2: [[0, 1], [1, 1], [2, 1], [3, 1]],
  } };
  const file = (name, content) => ({ name, bytes: Buffer.from(JSON.stringify(content)) });
  return [file("lane.json", scene), file("plan.json", plan), file("changes.json", changes)];
}

/** What stands on paper: as the browser has it when it prints. */
async function printed(page) {
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await page.emulateMedia({ media: "print" });
  await page.locator(".paper-head").waitFor();
  const told = await page.evaluate(() => {
    const isSeen = (element) => element.checkVisibility() && element.getBoundingClientRect().width > 1;
    const all = (selector) => [...document.querySelectorAll(selector)];
    const inks = (element) => getComputedStyle(element).backgroundColor;
    const tables = all(".paper-plan table");
    return {
      text: document.body.innerText,
      rows: tables[0]?.querySelectorAll("tbody tr").length ?? 0,
      entries: tables.reduce((sum, table) => sum + table.querySelectorAll("tbody td").length, 0),
      robots: tables.reduce((sum, table) => sum + table.querySelectorAll("thead th").length - 1, 0),
      columns: all(".paper .axis text").map((text) => text.textContent).slice(0, 10),
      controls: all("input, select, [role=slider], .btn, .tools button, .bar button, .dock button").filter(isSeen).map((element) => element.outerHTML.slice(0, 80)),
      clipped: all(".paper *, .insp *, .lesson *").filter((element) => isSeen(element) && !element.closest(".vh, svg") && element.scrollWidth > element.clientWidth + 1
        && getComputedStyle(element).overflowX !== "visible").map((element) => element.outerHTML.slice(0, 80)),
      beyond: all(".paper *, .insp *, .lesson *").filter((element) => {
        const { left, right } = element.getBoundingClientRect();
        return isSeen(element) && !element.closest(".vh") && (left < -1 || right > innerWidth + 1);
      }).map((element) => element.outerHTML.slice(0, 80)),
      wide: document.documentElement.scrollWidth > document.documentElement.clientWidth,
      ground: inks(document.body),
    };
  });
  await page.emulateMedia({ media: null });
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  return told;
}

/** No controls, nothing cut, light. */
function isPaper(told) {
  assert.deepEqual(told.controls, []);
  assert.deepEqual(told.clipped, []);
  assert.deepEqual(told.beyond, []);
  assert.equal(told.wide, false);
  assert.equal(told.ground, "rgb(255, 255, 255)");
  assert.doesNotMatch(told.text, /\b(click|tap|press|drag)\b/i);
}
