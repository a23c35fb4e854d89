// A plan of one's own: an agent is led by hand, what breaks a rule shows as it
// arises, the plan is checked, left, and brought back.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows } from "./flow.mjs";
import { lead, rows, steps } from "./steer.mjs";
import { eventually } from "./wait.mjs";

const MEETS = /A1 and A2 are both at \(1, 1\) at time 2/;

function place(playground, name) {
  return playground.inspector.getByRole("region", { name });
}

/** Waits until a place of the inspector tells this. */
function tells(playground, name, pattern) {
  return eventually(`${name} to tell ${pattern}`, () => place(playground, name).innerText(), (text) => pattern.test(text));
}

/** Waits until the answer says this. */
function answers(playground, pattern) {
  return eventually(`an answer of ${pattern}`, () => playground.inspector.innerText(), (text) => pattern.test(text));
}

describe("an agent is led by hand", () => {
  const flow = flows();

  flow("a collision shows as it arises, and the check tells it", async (playground) => {
    await rows(playground);
    await lead(playground, "A1", 0, 0);
    await tells(playground, "Against the rules", /Nothing so far/);
    const top = await playground.inspector.getByRole("heading", { name: "Your plan" }).boundingBox();
    const pane = await playground.inspector.boundingBox();
    assert.ok(top.y >= pane.y, "it begins at its top, wherever the button was");
    await steps(playground, "Down", "Right");
    await playground.says(MEETS);
    await tells(playground, "Against the rules", MEETS);
    await tells(playground, "Not done yet", /its goal is \(3, 0\)/);
    await playground.cellTells(1, 1, /A1.*A2|A2.*A1/);
    await playground.picture("steering-collision");
    await playground.press("Check my plan");
    await answers(playground, /The plan breaks a rule/);
    await playground.picture("steering-checked");
    await steps(playground, "Back");
    await steps(playground, "Back");
    await tells(playground, "Against the rules", /Nothing so far/);
    await playground.says(/^A1 is at \(0, 1\) at time 1/);
    await steps(playground, "Discard");
    await playground.says(/^Optimal: makespan 3/);
    await playground.act("Undo");
    await playground.says(/^A1 is at \(0, 1\) at time 1/);
  }, { screens: BOTH });

  flow("a plan that is as good is confirmed, and comes back after a reload", async (playground) => {
    await rows(playground);
    await lead(playground, "A1", 0, 0);
    await steps(playground, "Right", "Right");
    await playground.says(/^A1 is at \(2, 0\) at time 2/);
    await playground.reload();
    await playground.says(/^A1 is at \(2, 0\) at time 2/);
    await playground.showTab("Inspector");
    await steps(playground, "Right");
    await playground.says(/All robots do their tasks/);
    await playground.press("Check my plan");
    await answers(playground, /Optimal[^]*no plan is better/);
    await playground.picture("steering-confirmed");
  });

  flow("of a worse plan it is told what is too much, and the better one is taken", async (playground) => {
    await rows(playground);
    await lead(playground, "A1", 0, 0);
    await steps(playground, "Wait", "Right", "Right", "Right");
    await playground.says(/^A1 is at \(3, 0\) at time 4/);
    await playground.press("Check my plan");
    await answers(playground, /Improvable[^]*A1 waits 1 step less/);
    await playground.picture("steering-improvable");
    await playground.press("Show it");
    await playground.press("Take the other plan");
    await playground.says(/^Optimal: makespan 3/);
    await playground.act("Undo");
    await playground.says(/^A1 is at \(3, 0\) at time 4/);
  });

  flow("another agent is led in the same plan, and the scene stays", async (playground) => {
    await rows(playground);
    await lead(playground, "A1", 0, 0);
    await steps(playground, "Down");
    await playground.says(/^A1 is at \(0, 1\) at time 1/);
    await playground.cell(2, 1).click();
    await playground.inspector.getByRole("button", { name: "Lead A2 by hand" }).click();
    await playground.says(/^A2 is at \(2, 1\) at time 1/);
    await steps(playground, "Up", "Left");
    await playground.says(/^A2 is at \(1, 0\) at time 3/);
    await playground.cellTells(0, 1, /A1/);
    // By its key: a phone folds the tools away.
    await playground.key("o");
    await playground.warns(/You lead A2 by hand/);
    await playground.key("Escape");
    await playground.cellTells(1, 0, /A2/);
  });

  flow("all of it by keys", async (playground) => {
    await rows(playground);
    await playground.board.focus();
    await playground.key("Enter", "l");
    await playground.says(/^A1 is at \(0, 0\) at time 0/);
    await playground.key("ArrowDown", "ArrowRight");
    await playground.says(MEETS);
    await playground.key("Backspace", "Backspace", "w", "ArrowUp");
    await playground.says(/^A1 is at \(0, 0\) at time 1\. A1 stays: the map ends there/);
    await playground.inspector.getByRole("button", { name: "Discard" }).focus();
    await playground.key("ArrowRight", "ArrowRight", "ArrowRight");
    await playground.says(/^A1 is at \(3, 0\) at time 4/);
    await playground.key("Control+Enter");
    await answers(playground, /Improvable/);
    await playground.key("Escape");
    await tells(playground, "Against the rules", /Nothing so far/);
    await playground.key("Escape");
    await playground.says(/^Optimal: makespan 3/);
    await playground.key("Control+z");
    await playground.says(/^A1 is at \(3, 0\) at time 4/);
  }, { screens: ["desktop"] });

  flow("all of it with a finger", async (playground, { page }) => {
    await rows(playground);
    const tap = async (x, y) => {
      const middle = await playground.middleOf(x, y);
      await page.touchscreen.tap(middle.x, middle.y);
    };
    await tap(0, 0);
    await page.getByRole("tab", { name: "Inspector" }).tap();
    await playground.inspector.getByRole("button", { name: "Lead A1 by hand" }).tap();
    await playground.says(/^A1 is at \(0, 0\) at time 0/);
    await tap(0, 1);
    await playground.says(/^A1 is at \(0, 1\) at time 1/);
    await tap(1, 1);
    await playground.says(MEETS);
    await playground.inspector.getByRole("button", { name: "Back", exact: true }).tap();
    await playground.says(/^A1 is at \(0, 1\) at time 1/);
    await tap(3, 1);
    await playground.says(/\(3, 1\) is not beside it/);
    await playground.button("Check my plan").tap();
    await answers(playground, /The plan breaks a rule/);
    // An agent is tapped where it is seen, and on the way to a time it is elsewhere.
  }, { screens: ["phone"], reducedMotion: "reduce" });

  flow("in the warehouse it charges, goes slowly, and runs empty", async (playground) => {
    await playground.says(/^Optimal: makespan 18/);
    await playground.press("To start");
    await playground.reaches(0);
    await lead(playground, "A1", 0, 0);
    await steps(playground, "Right", "Right", "Right");
    await playground.says(/^A1 is at \(3, 0\) at time 4/);
    await steps(playground, "Down", "Down", "Charge in the next step");
    assert.equal(await playground.button("Charge in the next step").getAttribute("aria-pressed"), "true");
    await steps(playground, "Up");
    await eventually("a full battery", () => playground.inspector.innerText(), (text) => /battery 10 of 10/.test(text));
    await steps(playground, ...Array(11).fill("Wait"));
    await tells(playground, "Against the rules", /The battery of A1 is at -1/);
    await playground.picture("steering-empty");
  }, { reducedMotion: "reduce" });
});
