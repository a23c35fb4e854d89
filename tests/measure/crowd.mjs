// Many agents, and large maps.

import { join } from "node:path";

import { root } from "../e2e/dist.mjs";
import { SOLVED, figure, inPage, smoothness } from "./figure.mjs";
import { Tab } from "./process.mjs";

/** Cells a side of the crowd's map. */
const SIDE = 64;
/** Cells that are painted, one a frame. */
const PAINTED = 100;

/** Crowds of 100 and of 300 agents that all move, on 64 x 64 cells. */
export async function crowd(url) {
  const figures = [];
  for (const [count, least] of [[100, 58], [300, 30]]) {
    figures.push(...await inPage(url, async (playground, browser) => {
      await playground.says(SOLVED);
      await playground.open(...files(count));
      await playground.shows(`crowd of ${count}`);
      await playground.button("Play").or(playground.button("Pause")).first().waitFor();
      if (await playground.button("Play").isVisible()) {
        await playground.press("Play");
      }
      await playground.reaches("1 or later", (now) => now >= 1);
      return smoothness(playground, browser, `${count} agents playing on ${SIDE} x ${SIDE} cells`, least);
    }));
  }
  return figures;
}

/** A scene and a plan of it: each agent goes to and fro in cells of its own. */
function files(count) {
  const width = Math.floor((SIDE * SIDE) / count / 2) * 2;
  const length = Math.min(width, 12);
  const places = Math.floor(SIDE / length);
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
  const map = Array.from({ length: SIDE }, () => ".".repeat(SIDE));
  const name = `crowd of ${count}`;
  return [
    { name: "crowd.json", bytes: JSON.stringify({ giveway: 1, name, map, agents }) },
    { name: "crowd.plan.json", bytes: JSON.stringify({ giveway: 1, paths }) },
  ];
}

/** Obstacles on the largest of the standard maps, one a frame. */
export function painting(url) {
  return inPage(url, async (playground, browser) => {
    const { page } = playground;
    await playground.says(SOLVED);
    await playground.open(join(root, "tests/data/movingai/warehouse-10-20-10-2-1.map"));
    await playground.shows("warehouse-10-20-10-2-1");
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
    return [figure("painting on 161 x 63 cells, one cell", (busy * 1000) / PAINTED, "ms of CPU", { most: 16, digits: 1 })];
  });
}
