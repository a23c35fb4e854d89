// The figures of the page, each with what it should be.

import { join } from "node:path";

import { root } from "../e2e/dist.mjs";
import { eventually } from "../e2e/wait.mjs";
import { asking } from "./asking.mjs";
import { revising } from "./change.mjs";
import { atOnce, crowd, painting } from "./crowd.mjs";
import { SOLVED, figure, inPage, middle, smoothness } from "./figure.mjs";
import { floor } from "./floor.mjs";
import { mustBeSo } from "./freedom.mjs";
import { network } from "./network.mjs";
import { Tab } from "./process.mjs";
import { cancelUntilGoOn, frames, solveUntil } from "./watch.mjs";

/** A sharp figure of a machine that does other things too: the middle one of so many. */
const TIMES = 5;
/** How long solving is watched, in seconds. */
const SOLVING = 8;

/** The figures by what they are about: functions of the page's address. */
export const FIGURES = { opening, network, playing, crowd, atOnce, painting, floor, solving, bound, proof, asking, mustBeSo, revising, memory };

async function opening(url) {
  const paints = [];
  const moves = [];
  for (let time = 0; time < TIMES; time += 1) {
    await inPage(url, async ({ page }) => {
      moves.push(await eventually("an agent to move", () => page.evaluate(() => window.seen.moving)));
      paints.push(await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0].startTime));
    });
  }
  return [
    figure("first paint, nothing cached", middle(paints), "ms", { most: 500 }),
    figure("until the solved example moves", middle(moves), "ms", { most: 1500 }),
  ];
}

/** 30 agents on 32 x 32 cells. */
function playing(url) {
  return inPage(url, async (playground, browser) => {
    await playground.example("Random map");
    await playground.says(SOLVED);
    await playground.reaches("2 or later", (now) => now >= 2);
    return smoothness(playground, browser, "30 agents playing on 32 x 32 cells", 58);
  });
}

function solving(url) {
  return inPage(url, async (playground, browser) => {
    const { page } = playground;
    await playground.says(SOLVED);
    await playground.example("Thirty robots");
    await playground.button("Cancel").waitFor();
    const tab = await Tab.of(browser);
    await browser.startTracing(page, { categories: ["toplevel"] });
    const from = await page.evaluate(() => performance.now());
    await playground.says(/is at least/);
    await page.evaluate(frames, SOLVING);
    const trace = JSON.parse(await browser.stopTracing());
    const cancelled = await page.evaluate(cancelUntilGoOn);
    const tasks = await page.evaluate((from) => window.seen.longTasks.filter(({ startTime }) => startTime >= from), from);
    const longest = Math.max(0, ...tasks.map(({ duration }) => duration));
    const busiest = Math.max(...tab.tasks(trace).map(({ tdur }) => tdur)) / 1000;
    return [
      figure("longest task of the main thread while 30 agents are solved", longest, "ms", { most: 50, below: 50 }),
      figure("the same in processor time", busiest, "ms of CPU", { most: 50 }),
      figure("from Cancel until the page is ready to go on", cancelled, "ms", { most: 200 }),
    ];
  });
}

/** Each time in a page of its own: what was proved of a scene once is not proved again. */
async function bound(url) {
  const times = [];
  for (let time = 0; time < TIMES; time += 1) {
    times.push(await inPage(url, async (playground) => {
      await openA05(playground);
      return playground.page.evaluate(solveUntil, "is at least|^Solving: (?!no bound)|^Optimal: ");
    }));
  }
  return [figure("from Solve to the first bound, 10 agents (A05), warm", middle(times), "ms", { most: 200 })];
}

async function proof(url) {
  const cpu = [];
  const times = [];
  for (let time = 0; time < TIMES; time += 1) {
    await inPage(url, async (playground, browser) => {
      await openA05(playground);
      const tab = await Tab.of(browser);
      const before = tab.workerSeconds();
      times.push((await playground.page.evaluate(solveUntil, "^Optimal: makespan 31, sum of costs 254, 10 charges")) / 1000);
      cpu.push(tab.workerSeconds() - before);
    });
  }
  return [
    figure("A05 proved in the worker", middle(cpu), "s of CPU", { most: 1, digits: 2 }),
    figure("from Solve to the proof of A05, seen", middle(times), "s", { most: 1.5, digits: 2 }),
  ];
}

async function openA05(playground) {
  await playground.says(SOLVED);
  await playground.open(join(root, "tests/data/mmapf/A05_mm_10x10_o10_a10.json"));
  await playground.says(/^No plan yet/);
}

/** The largest scene that the page takes. */
function memory(url) {
  const side = 256;
  const count = 1000;
  const row = ".".repeat(side);
  const at = (place) => [(place * 37) % side, Math.floor(place / 4) % side];
  const agents = Array.from({ length: count }, (_, n) => ({ name: `R${n}`, start: at(n), goal: at(count - 1 - n + 8) }));
  const scene = { giveway: 1, name: "largest", map: Array.from({ length: side }, () => row), agents };
  return inPage(url, async (playground, browser) => {
    await playground.says(SOLVED);
    await playground.open({ name: "largest.json", bytes: JSON.stringify(scene) });
    await playground.shows("largest");
    await playground.press("Solve");
    await playground.button("Cancel").waitFor();
    const tab = await Tab.of(browser);
    let most = 0;
    await eventually("the end of the solve", () => {
      most = Math.max(most, tab.bytes());
      return playground.button("Solve").or(playground.button("Go on")).first().isVisible();
    }, Boolean, 120_000);
    most = Math.max(most, tab.bytes());
    return [figure("memory of the tab at most, 1000 agents on 256 x 256 cells, opened and solved for 30 s", most / 1e6, "MB", { most: 600 })];
  });
}
