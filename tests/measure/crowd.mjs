// Many agents, and large maps.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { root } from "../e2e/dist.mjs";
import { eventually } from "../e2e/wait.mjs";
import { SOLVED, figure, inPage, smoothness } from "./figure.mjs";
import { Tab } from "./process.mjs";
import { solveUntilPlaying } from "./watch.mjs";

/** Crowds: how many agents, on how many cells a side, the least frames a second, and by how many keys nearer. */
const CROWDS = [[100, 64, 58], [300, 64, 30], [50, 256, 50], [1000, 256, 30], [1000, 256, 30, 5], [1000, 512, 30]];
/** A plan of another maker on a map of the standard benchmark, and the least frames a second. */
const STANDARD = ["random-32-32-20_random-1_300.tracker.csv", "300 agents playing on random-32-32-20", 58];
/** Cells a side of the largest map that the page takes. */
const LARGEST = 512;
/** Cells that are painted, one a frame. */
const PAINTED = 100;

/** Crowds of agents that all move. */
export async function crowd(url) {
  const figures = [];
  for (const [count, side, least, nearer = 0] of CROWDS) {
    figures.push(...await inPage(url, async (playground, browser) => {
      await playground.says(SOLVED);
      await playground.open(...files(count, side));
      await playground.shows(`crowd of ${count}`);
      await plays(playground, nearer);
      const seen = nearer > 0 ? ", with the overview" : "";
      return smoothness(playground, browser, `${count} agents playing on ${side} x ${side} cells${seen}`, least);
    }));
  }
  const [file, what, least] = STANDARD;
  for (const nearer of [0, 2]) {
    figures.push(...await inPage(url, async (playground, browser) => {
      await playground.says(SOLVED);
      await playground.open(join(root, "crates/giveway-formats/tests/data/plans", file));
      await playground.says(/tracker\.csv keeps every rule/);
      if (await playground.button("Cancel").isVisible()) {
        await playground.press("Cancel");
      }
      await plays(playground, nearer);
      return smoothness(playground, browser, nearer > 0 ? `${what}, with the overview` : what, least);
    }));
  }
  return figures;
}

/** A crowd is solved: how soon it moves, while the search goes on, and what that takes. */
export async function atOnce(url) {
  const [map, count] = ["warehouse-10-20-10-2-1", 300];
  const scene = { giveway: 1, name: map, objective: ["sum-of-costs", "makespan"], ...benchmark(map, count) };
  return inPage(url, async (playground, browser) => {
    const { page } = playground;
    await playground.says(SOLVED);
    await playground.open({ name: "crowd.json", bytes: JSON.stringify(scene) });
    await playground.shows(map);
    const moved = await page.evaluate(solveUntilPlaying);
    const tab = await Tab.of(browser);
    let most = 0;
    await eventually("the end of the solve", () => {
      most = Math.max(most, tab.bytes());
      return playground.solver.isVisible();
    }, Boolean, 120_000);
    const what = `${count} agents of ${map}`;
    return [
      figure(`from Solve until ${what} move`, moved / 1000, "s", { most: 2, digits: 2 }),
      figure(`memory of the tab at most, ${what} solved for 30 s`, most / 1e6, "MB", { most: 600 }),
    ];
  });
}

/** The first agents of a scenario of the standard benchmark. */
function benchmark(name, count) {
  const read = (end) => readFileSync(join(root, `tests/data/movingai/${name}${end}`), "utf8").split("\n");
  const map = read(".map").slice(4).filter((line) => line !== "").map((line) => line.replaceAll(/[^.]/g, "#"));
  const agents = read("-random-1.scen").slice(1, count + 1).map((line, n) => {
    const fields = line.split("\t").map(Number);
    return { name: `R${n + 1}`, start: fields.slice(4, 6), goal: fields.slice(6, 8) };
  });
  return { map, agents };
}

/** Plays, so many keys nearer. */
async function plays(playground, nearer) {
  await playground.button("Play").or(playground.button("Pause")).first().waitFor();
  for (let key = 0; key < nearer; key += 1) {
    await playground.key("+");
  }
  if (nearer > 0) {
    await playground.page.getByRole("img", { name: /^Overview: / }).waitFor();
  }
  if (await playground.button("Play").isVisible()) {
    await playground.press("Play");
  }
  await playground.reaches("1 or later", (now) => now >= 1);
}

/** A scene and a plan of it: each agent goes to and fro in cells of its own. */
function files(count, side) {
  const width = Math.floor((side * side) / count / 2) * 2;
  const length = Math.min(width, 12);
  const places = Math.floor(side / length);
  const agents = [];
  const paths = {};
  for (let n = 0; n < count; n += 1) {
    const [left, y] = [(n % places) * length, Math.floor(n / places)];
    const there = Array.from({ length }, (_, step) => [left + step, y]);
    const name = `R${n + 1}`;
    agents.push({ name, start: there[0], goal: there.at(-1) });
    const round = [...there, ...there.toReversed().slice(1, -1)];
    paths[name] = [...round, ...round, ...there];
  }
  const map = free(side);
  const name = `crowd of ${count}`;
  return [
    { name: "crowd.json", bytes: JSON.stringify({ giveway: 1, name, map, agents }) },
    { name: "crowd.plan.json", bytes: JSON.stringify({ giveway: 1, paths }) },
  ];
}

function free(side) {
  return Array.from({ length: side }, () => ".".repeat(side));
}

/** Obstacles on large maps, one a frame. */
export async function painting(url) {
  const standard = join(root, "tests/data/movingai/warehouse-10-20-10-2-1.map");
  const agents = [{ name: "R1", start: [0, 0], goal: [LARGEST - 1, LARGEST - 1] }];
  const largest = { name: "largest.json", bytes: JSON.stringify({ giveway: 1, name: "largest", map: free(LARGEST), agents }) };
  return [
    await painted(url, standard, "warehouse-10-20-10-2-1", "161 x 63", 16),
    await painted(url, largest, "largest", `${LARGEST} x ${LARGEST}`, 8),
  ];
}

function painted(url, file, name, size, most) {
  return inPage(url, async (playground, browser) => {
    const { page } = playground;
    await playground.says(SOLVED);
    await playground.open(file);
    await playground.shows(name);
    await playground.pick("Obstacle");
    // Below the wall. Of so many cells only those near the cursor are told to who does not see the board.
    const [first, next] = [await playground.middleOf(1, 1), await playground.middleOf(2, 1)];
    await page.mouse.move(first.x, first.y);
    await page.mouse.down();
    const tab = await Tab.of(browser);
    const before = tab.mainSeconds();
    for (let cell = 1; cell <= PAINTED; cell += 1) {
      await page.mouse.move(first.x + (next.x - first.x) * cell, first.y);
      await page.evaluate(() => new Promise(requestAnimationFrame));
    }
    const busy = tab.mainSeconds() - before;
    await page.mouse.up();
    await playground.pick("Select");
    await page.mouse.click(first.x + (next.x - first.x) * PAINTED, first.y);
    await playground.cellTells(1 + PAINTED, 1, /^obstacle/);
    return figure(`painting on ${size} cells, one cell`, (busy * 1000) / PAINTED, "ms of CPU", { most, digits: 1 });
  });
}
