// The world changes: how soon the page has a new plan.

import { begin, join as joins } from "../e2e/change.mjs";
import { SOLVED, figure, inPage, middle } from "./figure.mjs";
import { Tab } from "./process.mjs";

const SIDE = 10;
const AGENTS = 10;
/** At which time an agent joins, each measured in a page of its own. */
const TIMES = [1, 2, 3];

/** An agent joins ten on 10 x 10 cells; the plan is revised. */
export async function revising(url) {
  const cpu = [];
  for (const at of TIMES) {
    await inPage(url, async (playground, browser) => {
      await playground.says(SOLVED);
      await playground.open({ name: "ten.json", bytes: JSON.stringify(ten()) });
      await playground.shows("ten on 10 x 10");
      await playground.press("Solve");
      await playground.says(SOLVED);
      if (await playground.button("Pause").isVisible()) {
        await playground.pause();
      }
      await playground.press("To start");
      for (let step = 0; step < at; step += 1) {
        await playground.press("Step forward");
      }
      await playground.reaches(at);
      await begin(playground);
      await joins(playground, [0, 9], [9, 0]);
      await playground.key("Escape");
      for (const method of ["Near the old paths", "Everything new"]) {
        await playground.page.getByRole("checkbox", { name: new RegExp(`^${method}`) }).uncheck();
      }
      const tab = await Tab.of(browser);
      const before = tab.workerSeconds();
      await playground.press("Find new plans");
      await playground.says(/^At time \d+: /);
      await playground.page.getByRole("article", { name: "New times" }).getByRole("button", { name: /^Use this plan/ }).waitFor();
      cpu.push(tab.workerSeconds() - before);
    });
  }
  return [figure(`a new plan by revise, an agent joins ${AGENTS} on ${SIDE} x ${SIDE} cells`, middle(cpu), "s of CPU", { most: 0.5, digits: 2 })];
}

/** Agents that cross: from a place of the upper left half to its mirror image. */
function ten() {
  const agents = Array.from({ length: AGENTS }, (_, n) => {
    const [x, y] = [(n * 3) % SIDE, n];
    return { name: `A${n + 1}`, start: [x, y], goal: [SIDE - 1 - y, SIDE - 1 - x] };
  });
  return { giveway: 1, name: "ten on 10 x 10", map: Array.from({ length: SIDE }, () => ".".repeat(SIDE)), agents };
}
