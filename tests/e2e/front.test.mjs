// The Pareto front: a plot of plans, each of them a button that shows it.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows } from "./flow.mjs";

/** Straight on there are fewer moves, round the slow zone fewer steps. */
const TRADE_OFF = {
  giveway: 1,
  map: [".~~~~~.", "......."],
  agents: [{ name: "A1", start: [0, 0], goal: [6, 0] }],
  objective: ["makespan", "moves"],
};

describe("the Pareto front", () => {
  const flow = flows();

  flow("shows every plan of it", async (playground) => {
    await playground.open({ name: "trade-off.json", bytes: JSON.stringify(TRADE_OFF) });
    await playground.openSettings();
    await playground.settings.getByText("Pareto front of two or three costs").click();
    await playground.closeSettings();
    await playground.press("Solve");
    const said = await playground.says(/^On the Pareto front of (\d+) plans: makespan 8, 8 moves\./);
    const count = Number(/front of (\d+)/.exec(said)[1]);
    assert.ok(count > 1, "there is nothing to choose");
    if (playground.isPhone()) {
      await playground.showTab("Inspector");
    }
    const points = playground.inspector.getByRole("list", { name: "Pareto front" }).getByRole("button");
    assert.equal(await points.count(), count);
    const names = await points.allInnerTexts();
    const values = names.map((name) => name.match(/\d+/g).map(Number));
    for (const one of values) {
      // Nothing on a front is beaten in every cost.
      assert.ok(!values.some((other) => other !== one && other.every((n, cost) => n <= one[cost])), names.join("; "));
    }
    await points.last().click();
    await playground.says(new RegExp(`front of ${count} plans: ${names.at(-1)}\\.`));
    await playground.showTab("Timeline");
    assert.equal(await playground.time.getAttribute("aria-valuemax"), String(values.at(-1)[0]));
    await playground.showTab("Inspector");
    assert.equal(await points.last().getAttribute("aria-pressed"), "true");
    await playground.picture("front");
    // A front is of its scene: an edit hides it, and undoing that brings it back.
    await playground.pick("Charger");
    await playground.cell(0, 1).click();
    await points.first().waitFor({ state: "detached" });
    await playground.press("Undo");
    await points.first().waitFor();
  }, { screens: BOTH });
});
