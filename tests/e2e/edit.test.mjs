// Painting on the board, by mouse and by keyboard; a stroke is one step of undo.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows, MOVING } from "./flow.mjs";

const OPENING = /^Optimal: makespan 18/;
const STALE = /^The scene has changed since this plan/;

describe("editing", () => {
  const flow = flows();

  flow("paints an obstacle, and solves around it", async (playground) => {
    await playground.says(OPENING);
    await playground.pick("Obstacle");
    await playground.stroke([0, 1]);
    await playground.cellTells(0, 1, /^obstacle$/);
    await playground.says(STALE);
    await playground.picture("stale");
    await playground.press("Solve");
    // Proved by the command, too.
    await playground.says(/^Optimal: makespan 23, sum of costs 40, 3 charges\.$/);
  }, { screens: BOTH, ...MOVING });

  flow("takes a stroke back as one, and forth again", async (playground) => {
    await playground.says(OPENING);
    assert.equal(await playground.button("Undo").isDisabled(), true);
    await playground.pick("Charger");
    await playground.stroke([0, 1], [0, 2], [2, 2]);
    for (const [x, y] of [[0, 1], [0, 2], [1, 2], [2, 2]]) {
      await playground.cellTells(x, y, /^charger/);
    }
    await playground.press("Undo");
    for (const [x, y] of [[0, 1], [0, 2], [2, 2]]) {
      await playground.cellTells(x, y, /^free$/);
    }
    await playground.cellTells(1, 2, /^waypoint of A2/);
    await playground.says(OPENING);
    assert.equal(await playground.button("Undo").isDisabled(), true, "one stroke was more than one step");
    await playground.press("Redo");
    await playground.cellTells(2, 2, /^charger$/);
    await playground.says(STALE);
    assert.equal(await playground.button("Redo").isDisabled(), true);
  });

  flow("takes back by keys", async (playground) => {
    await playground.says(OPENING);
    await playground.pick("Slow zone");
    await playground.stroke([0, 1]);
    await playground.cellTells(0, 1, /^slow zone$/);
    await playground.key("Control+z");
    await playground.cellTells(0, 1, /^free$/);
    await playground.key("Control+Shift+z");
    await playground.cellTells(0, 1, /^slow zone$/);
  });

  flow("erases", async (playground) => {
    await playground.says(OPENING);
    await playground.pick("Erase");
    await playground.stroke([1, 1]);
    await playground.cellTells(1, 1, /^free$/);
    await playground.stroke([3, 2]);
    await playground.cellTells(3, 2, /^free$/);
  });

  flow("paints by keyboard alone", async (playground) => {
    await playground.says(OPENING);
    await playground.board.focus();
    await playground.key("Control+Home", "ArrowDown", "o", "Enter");
    await playground.cellTells(0, 1, /^obstacle$/);
    await playground.key("c", "ArrowDown", "Space");
    await playground.cellTells(0, 2, /^charger$/);
    await playground.picture("keyboard");
    assert.match(await active(playground), /^0, 2: charger$/);
    await playground.key("Control+z", "Control+z");
    await playground.cellTells(0, 1, /^free$/);
    await playground.cellTells(0, 2, /^free$/);
  });

  flow("misses no key however fast they come", async (playground) => {
    await playground.says(OPENING);
    await playground.board.focus();
    // All within one task: the page cannot be drawn between them.
    await playground.board.evaluate((board) => {
      const press = (key, more) => board.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, ...more }));
      press("Home", { ctrlKey: true });
      for (const key of ["ArrowDown", "o", "Enter", "c", "ArrowDown", " "]) press(key);
    });
    await playground.cellTells(0, 1, /^obstacle$/);
    await playground.cellTells(0, 2, /^charger$/);
  });

  flow("picks tools by keys and by arrows", async (playground) => {
    for (const [key, tool] of [["o", "Obstacle"], ["c", "Charger"], ["s", "Slow zone"], ["e", "Erase"], ["z", "Zone"], ["r", "One-way"], ["a", "Robot"], ["g", "Goal"], ["w", "Waypoint"], ["v", "Select"]]) {
      await playground.key(key);
      await playground.tools.getByRole("button", { name: tool, exact: true, pressed: true }).waitFor();
      assert.equal(await playground.tools.getByRole("button", { pressed: true }).count(), 1);
    }
    await playground.pick("Select");
    await playground.key("ArrowDown", "Enter");
    await playground.tools.getByRole("button", { name: "Obstacle", pressed: true }).waitFor();
  }, { screens: ["desktop"] });

  flow("leaves nothing of a stroke that ends beside the board", async (playground) => {
    await playground.says(OPENING);
    await playground.pick("Obstacle");
    const from = await playground.middleOf(0, 1);
    const { mouse } = playground.page;
    await mouse.move(from.x, from.y);
    await mouse.down();
    await mouse.move(5, 5, { steps: 3 });
    await mouse.up();
    await playground.cellTells(0, 1, /^obstacle$/);
    // Lifted outside, it does not go on painting.
    const other = await playground.middleOf(9, 1);
    await mouse.move(other.x, other.y, { steps: 5 });
    await playground.cellTells(9, 1, /^free$/);
  });

  flow("selects an agent and a cell, and tells of them", async (playground) => {
    await playground.says(OPENING);
    await playground.pause();
    await playground.press("To start");
    await playground.reaches(0);
    const start = await playground.middleOf(0, 0);
    await playground.page.mouse.click(start.x, start.y);
    await playground.showTab("Inspector");
    await playground.inspector.getByRole("heading", { name: "A1", level: 2 }).waitFor();
    await playground.picture("agent");
    const cell = await playground.middleOf(3, 1);
    await playground.page.mouse.click(cell.x, cell.y);
    await playground.inspector.getByText("Who is here when").waitFor();
    await playground.picture("cell");
    await playground.key("Escape");
    await playground.inspector.getByRole("table", { name: "Costs" }).waitFor();
    // An agent is pressed where it is seen, and on the way to a time it is elsewhere.
  }, { screens: BOTH, reducedMotion: "reduce" });
});

/** The name of the cell that the keyboard is on. */
function active(playground) {
  return playground.board.evaluate((board) => document.getElementById(board.getAttribute("aria-activedescendant")).ariaLabel);
}
