// A whole scene by hand: agents with goals and waypoints, batteries, the map, and what
// is wrong with it; by mouse, by keyboard alone, and by touch.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows, LOOKS, MOVING } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const OPENING = /^Optimal: makespan 18/;
const STALE = /^The scene has changed since this plan/;

describe("a scene by hand", () => {
  const flow = flows();

  flow("places an agent with its goal in one gesture, and solves", async (playground) => {
    await playground.says(OPENING);
    await playground.pick("Robot");
    await playground.reaches(0);
    const from = await playground.middleOf(0, 2);
    const to = await playground.middleOf(9, 0);
    const { mouse } = playground.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move(to.x, to.y, { steps: 6 });
    await playground.says(/^A3 starts at \(0, 2\)\. Now choose its goal/);
    await playground.picture("placing");
    await mouse.up();
    await playground.cellTells(0, 2, /start of A3/);
    await playground.cellTells(9, 0, /goal of A3/);
    await playground.says(STALE);
    await playground.showTab("Inspector");
    await playground.inspector.getByRole("heading", { name: "A3", level: 2 }).waitFor();
    await playground.picture("placed");
    await playground.press("Undo");
    await playground.cellTells(0, 2, /^free$/);
    await playground.says(OPENING);
    assert.equal(await playground.button("Undo").isDisabled(), true, "one gesture was more than one step");
    await playground.press("Redo");
    await playground.press("Solve");
    await playground.says(/^Optimal: makespan 18, sum of costs 51, 4 charges\.$/);
  }, { screens: BOTH, ...MOVING });

  flow("builds a scene by keyboard alone", async (playground) => {
    await playground.says(OPENING);
    await playground.board.focus();
    await playground.key("a", "Control+Home", "ArrowDown", "Enter");
    await playground.says(/^A3 starts at \(0, 1\)/);
    await playground.key("ArrowDown", "Enter");
    await playground.cellTells(0, 1, /start of A3/);
    await playground.cellTells(0, 2, /goal of A3/);
    await playground.key("w", "ArrowRight", "ArrowRight", "Enter");
    await playground.cellTells(2, 2, /waypoint of A3/);
    await playground.key("Enter");
    await playground.cellTells(2, 2, /^free$/);
    await playground.key("g", "Enter");
    await playground.cellTells(2, 2, /goal of A3/);
    await playground.key("v", "Shift+ArrowLeft");
    await playground.cellTells(1, 2, /goal of A3/);
    await playground.key("Control+z", "Control+z", "Control+z", "Control+z", "Control+z");
    await playground.cellTells(0, 1, /^free$/);
    await playground.says(OPENING);
    await playground.key("a", "Enter");
    await playground.says(/Now choose its goal/);
    await playground.key("Escape");
    await playground.says(OPENING);
  }, { screens: ["desktop"] });

  flow("moves what is on the board by dragging it", async (playground) => {
    await playground.says(OPENING);
    await playground.pause();
    await playground.press("To start");
    await playground.reaches(0);
    await playground.stroke([0, 0], [0, 1]);
    await playground.cellTells(0, 1, /start of A1/);
    await playground.stroke([3, 2], [2, 2]);
    await playground.cellTells(2, 2, /^charger$/);
    await playground.stroke([2, 0], [1, 0]);
    await playground.cellTells(1, 0, /waypoint of A1/);
    await playground.stroke([4, 1], [9, 1]);
    await playground.cellTells(9, 1, /^obstacle/);
    await playground.picture("moved");
    await playground.key("Control+z", "Control+z", "Control+z", "Control+z");
    await playground.says(OPENING);
  }, { screens: ["desktop"] });

  flow("taps an agent onto the board", async (playground) => {
    await playground.says(OPENING);
    await playground.tools.getByRole("button", { name: "Robot", exact: true }).tap();
    await tap(playground, 0, 2);
    await playground.says(/^A3 starts at \(0, 2\)/);
    await playground.picture("tapped");
    await tap(playground, 8, 2);
    await playground.cellTells(8, 2, /goal of A3/);
    await playground.tools.getByRole("button", { name: "Waypoint", exact: true }).tap();
    await tap(playground, 4, 2);
    await playground.cellTells(4, 2, /waypoint of A1, waypoint of A3|waypoint of A3/);
  }, { screens: ["phone"] });

  flow("edits an agent in the inspector", async (playground) => {
    await playground.says(OPENING);
    await playground.pick("Robot");
    await playground.stroke([0, 0]);
    await playground.showTab("Inspector");
    await openEdit(playground, "Edit robot");
    await type(playground, "Name", "Robbie");
    await playground.inspector.getByRole("heading", { name: "Robbie", level: 2 }).waitFor();
    await type(playground, "Capacity, steps", "3");
    await playground.inspector.getByText("The battery of Robbie does not last to its waypoint (4, 2).").waitFor();
    await playground.picture("edit-agent");
    await playground.inspector.getByRole("button", { name: "Remove waypoint (4, 2)" }).click();
    await playground.cellTells(4, 2, /^free$/);
    await playground.inspector.getByRole("button", { name: "No battery limit", exact: true }).click();
    await eventually("no battery", () => playground.inspector.getByLabel("Capacity, steps").count(), (n) => n === 0);
    await playground.inspector.getByRole("button", { name: "Delete robot" }).click();
    await playground.cellTells(0, 0, /^goal of A2$/);
    await undo(playground, 5);
    await playground.says(OPENING);
  }, { screens: BOTH });

  flow("gives an agent another colour", async (playground) => {
    await playground.says(OPENING);
    await playground.showTab("Inspector");
    await playground.inspector.getByRole("button", { name: /^A1/ }).click();
    await openEdit(playground, "Edit robot");
    const radio = (name) => playground.inspector.getByRole("radiogroup", { name: "Colour" }).getByRole("radio", { name });
    assert.ok(await radio("Blue").isChecked());
    await radio("Mauve").check();
    const drawn = (look) => playground.page.evaluate((look) => {
      const style = (element) => getComputedStyle(element);
      const is = style(document.querySelector(`.ag-${look}`)).getPropertyValue("--c");
      const palette = style(document.documentElement);
      return Array.from({ length: 12 }, (_, n) => n + 1).filter((n) => palette.getPropertyValue(`--agent-${n}`) === is);
    }, look);
    await eventually("mauve", () => drawn(1), (colours) => colours.join() === "8");
    assert.deepEqual(await drawn(2), [2], "the other one stays as it was");
    await playground.picture("recoloured");
    await radio("Mauve").press("ArrowRight");
    await eventually("violet", () => drawn(1), (colours) => colours.join() === "9");
    await playground.page.reload();
    await playground.says(OPENING);
    await eventually("kept", () => drawn(1), (colours) => colours.join() === "9");
  });

  flow("edits the scene as a whole", async (playground) => {
    await playground.says(OPENING);
    await playground.showTab("Inspector");
    await openEdit(playground, "Edit scene");
    await type(playground, "Name", "Mine");
    await playground.shows("Mine");
    await type(playground, "Height, cells", "8");
    await eventually("eight rows", () => playground.board.getAttribute("aria-rowcount"), (n) => n === "8");
    await type(playground, "Seed", "7");
    await playground.inspector.getByRole("button", { name: "Random scene" }).click();
    await playground.inspector.getByText(/^4 robots/).waitFor();
    await playground.picture("filled");
    await playground.press("Solve");
    await playground.says(/^Optimal: makespan \d+/);
    await openEdit(playground, "Edit scene");
    await playground.inspector.getByRole("button", { name: "Clear", exact: true }).click();
    await playground.inspector.getByText("No robots.").waitFor();
    await playground.picture("cleared");
    // Solving was a step, too: all is as it was, with its plan.
    await undo(playground, 5);
    await playground.shows("warehouse");
    await playground.says(OPENING);
  });

  for (const { theme, screens } of LOOKS) {
    flow(`tells at once what is wrong, on its cell, ${theme}`, async (playground) => {
      await playground.says(OPENING);
      await playground.pick("Obstacle");
      await playground.stroke([8, 0]);
      await playground.stroke([8, 2]);
      await playground.says(/^This cannot be solved: .*\(9, 2\)/);
      await playground.cellTells(9, 2, /problem: A2 is walled in at \(9, 2\)/);
      // A phone shows the inspector where no robot has a lane.
      await playground.inspector.getByRole("heading", { name: /^Problems/ }).waitFor();
      await playground.picture(`problems-${theme}`);
      await playground.inspector.getByRole("button", { name: /^A2 is walled in/ }).click();
      await playground.inspector.getByRole("heading", { name: "9, 2" }).waitFor();
      await playground.press("Undo");
      await playground.says(STALE);
    }, { theme, screens });
  }
});

async function tap(playground, column, row) {
  const { x, y } = await playground.middleOf(column, row);
  await playground.page.touchscreen.tap(x, y);
}

/** Opens what is edited beside the board, unless it is. */
async function openEdit(playground, title) {
  const summary = playground.inspector.locator("summary", { hasText: title });
  await summary.waitFor();
  if (!await summary.evaluate((element) => element.parentElement.open)) {
    await summary.click();
  }
}

async function type(playground, label, text) {
  const field = playground.inspector.getByLabel(label, { exact: true });
  await field.fill(text);
  await field.press("Tab");
}

async function undo(playground, times) {
  for (let n = 0; n < times; n += 1) {
    await playground.press("Undo");
  }
}
