// The main flow from an example to a plan that was chosen, by keyboard alone and by
// fingers alone: paint, place, solve, play, select, ask, take, undo.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { flows, MOVING } from "./flow.mjs";
import { eventually } from "./wait.mjs";
import { Playground } from "./page.mjs";

/** More than there are places for the focus on the page. */
const PLACES = 150;

describe("the main flow", () => {
  const flow = flows();

  flow("goes by keyboard alone", async (playground, { page }) => {
    const { board, inspector } = playground;
    await playground.says(/^Optimal: makespan 18/);
    await focus(playground, playground.button("Examples"));
    await playground.key("Enter");
    const dialog = page.getByRole("dialog", { name: "Examples" });
    await focus(playground, Playground.pick(dialog, "Who waits?"));
    await playground.key("Enter");
    await playground.says(/^Optimal: makespan 4, sum of costs 7/);

    await focus(playground, board);
    await playground.key("o", "Control+Home", "Enter");
    await playground.cellTells(0, 0, /^obstacle$/);
    await playground.key("a", "ArrowDown", "ArrowDown", "Enter");
    await playground.says(/^A3 starts at \(0, 2\)/);
    await playground.key("ArrowRight", "Enter");
    await playground.cellTells(1, 2, /goal of A3/);
    await playground.key("v", "Control+Enter");
    await playground.says(/^Optimal: makespan 4, sum of costs 8/);

    await focus(playground, playground.button("To start"));
    await playground.key("Enter");
    await playground.reaches(0);
    await focus(playground, playground.button("Play"));
    await playground.key("Space");
    await playground.reaches(4);
    await playground.key("Home");
    await playground.reaches(0);

    const waiting = await waits(playground);
    await focus(playground, board);
    await playground.key("Control+Home", ...steps(waiting.start), "Enter");
    await inspector.getByRole("heading", { name: waiting.name, level: 2 }).waitFor();
    await focus(playground, inspector.getByRole("button", { name: waiting.question }).first());
    await playground.key("Enter");
    await focus(playground, playground.button("Show the other plan"));
    await playground.key("Enter");
    await playground.other.waitFor();
    await focus(playground, playground.button("Take the other plan"));
    await playground.key("Enter");
    await playground.other.waitFor({ state: "detached" });
    await playground.says(/^Optimal: makespan 4, sum of costs 8/);
    assert.notEqual((await waits(playground)).name, waiting.name);

    // Taking the other plan, solving, and the last robot: each is a step.
    await playground.key("Control+z");
    await playground.button("Take the other plan").waitFor();
    await playground.key("Control+z");
    await playground.button("Take the other plan").waitFor({ state: "detached" });
    await playground.key("Control+z");
    await playground.cellTells(0, 2, /^free$/);
    await playground.key("Control+z");
    await playground.cellTells(0, 0, /^free$/);
  }, { screens: ["desktop"], ...MOVING });

  flow("goes by fingers alone", async (playground, { page }) => {
    const { inspector, tools } = playground;
    const tool = (name) => tools.getByRole("button", { name, exact: true }).tap();
    await playground.says(/^Optimal: makespan 18/);
    await playground.button("More").tap();
    await playground.button("Examples").tap();
    await Playground.pick(page.getByRole("dialog", { name: "Examples" }), "Who waits?").tap();
    await playground.says(/^Optimal: makespan 4, sum of costs 7/);

    await tool("Obstacle");
    await tap(playground, 0, 0);
    await playground.cellTells(0, 0, /^obstacle$/);
    await tool("Robot");
    await tap(playground, 0, 2);
    await playground.says(/^A3 starts at \(0, 2\)/);
    await tap(playground, 1, 2);
    await playground.cellTells(1, 2, /goal of A3/);
    await tool("Select");
    await playground.button("Solve").tap();
    await playground.says(/^Optimal: makespan 4, sum of costs 8/);

    await playground.button("To start").tap();
    await playground.reaches(0);
    await playground.button("Play").tap();
    await playground.reaches(4);
    await playground.button("To start").tap();
    await playground.reaches(0);

    const waiting = await waits(playground);
    await tap(playground, ...waiting.start);
    await page.getByRole("tab", { name: "Inspector" }).tap();
    await inspector.getByRole("heading", { name: waiting.name, level: 2 }).waitFor();
    await inspector.getByRole("button", { name: waiting.question }).first().tap();
    await playground.button("Show the other plan").tap();
    await playground.button("Keep this plan").waitFor();
    await playground.other.waitFor();
    await playground.button("Take the other plan").tap();
    await playground.says(/^Optimal: makespan 4, sum of costs 8/);
    assert.notEqual((await waits(playground)).name, waiting.name);

    // Taking the other plan, solving, and the last robot: each is a step.
    await playground.button("Undo").tap();
    await playground.button("Take the other plan").waitFor();
    await playground.button("Undo").tap();
    await playground.button("Take the other plan").waitFor({ state: "detached" });
    await playground.button("Undo").tap();
    await playground.cellTells(0, 2, /^free$/);
    await playground.button("Undo").tap();
    await playground.cellTells(0, 0, /^free$/);
    // An agent is tapped where it is seen, and on the way to a time it is elsewhere.
  }, { screens: ["phone"], reducedMotion: "reduce" });
});

/** Goes on with the Tab key until something has the focus. */
async function focus({ page }, wanted) {
  await wanted.waitFor();
  for (let place = 0; place < PLACES; place += 1) {
    if (await wanted.evaluate((element) => element === document.activeElement)) {
      return;
    }
    await page.keyboard.press("Tab");
  }
  assert.fail(`the Tab key never comes to ${wanted}`);
}

/** The arrows from the first cell to one. */
function steps([column, row]) {
  return [...Array(column).fill("ArrowRight"), ...Array(row).fill("ArrowDown")];
}

/** Which of the two agents of the example waits, where it starts, and how it is asked about. */
async function waits(playground) {
  if (playground.isPhone()) {
    await playground.page.getByRole("tab", { name: "Timeline" }).tap();
  }
  const starts = { A1: [2, 2], A2: [3, 1] };
  const lane = /^(A[12]): .*1 wait/;
  const all = playground.page.getByRole("img", { includeHidden: true });
  const name = await eventually("an agent that waits", async () => {
    const labels = await all.evaluateAll((images) => images.map((image) => image.getAttribute("aria-label") ?? ""));
    return labels.map((label) => lane.exec(label)?.[1]).find(Boolean);
  });
  const start = starts[name];
  return { name, start, question: new RegExp(`^Why does ${name} wait at \\(${start.join(", ")}\\)\\?`) };
}

async function tap(playground, column, row) {
  const { x, y } = await playground.middleOf(column, row);
  await playground.page.touchscreen.tap(x, y);
}
