// Planners of the textbook: a menu beside Solve, and a table of what they came to.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { BOTH, LOOKS, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

/** Two robots that want the cell in the middle at the same time. */
const CROSSING = {
  giveway: 1,
  map: ["...", "...", "..."],
  objective: ["sum-of-costs", "makespan"],
  agents: [
    { name: "A", start: [0, 1], goal: [2, 1] },
    { name: "B", start: [1, 0], goal: [1, 2] },
  ],
};

describe("planners", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`are chosen in a menu and compared in a table (${theme})`, async (playground) => {
      await open(playground, CROSSING);
      await playground.press("Planners");
      const menu = playground.page.getByRole("button", { name: /(Searches until|One robot after|Proves the|step by step|Hundreds of|Improves a)/ });
      assert.equal(await menu.count(), 6);
      await playground.picture(`planners-menu-${theme}`);
      await menu.nth(2).click();
      await playground.says(/^CBS found a plan: sum of costs 5, makespan 3\. No plan has a smaller sum of costs\.$/);
      assert.equal(await menu.count(), 0, "the menu stays open");

      // By the keyboard: the focus is on the button that opened the menu.
      await playground.key("Enter");
      await menu.first().waitFor();
      await audit(playground, "the menu");
      await playground.key("Escape");
      await eventually("the menu to close", () => menu.count(), (n) => n === 0);
      await playground.key("Enter", "Tab", "Tab", "Tab", "Tab", "Enter");
      await playground.says(/^PIBT found a plan: /);

      const rows = await rowsOf(playground);
      assert.deepEqual(rows.map(([name]) => name.split("\n")[0].trim()), ["CBS", "PIBT"]);
      assert.match(rows[0].join(" "), /5, 3 proved least:\s+5/);
      assert.doesNotMatch(rows[1].join(" "), /proved/);
      await audit(playground, "the table");
      await playground.picture(`planners-table-${theme}`);
      await row(playground, "CBS").click();
      await playground.says(/^CBS found a plan/);
      assert.equal(await row(playground, "CBS").getAttribute("aria-pressed"), "true");

      await playground.press("Undo");
      await eventually("only CBS to be left", () => rowsOf(playground), (rows) => rows.length === 1);
      // A menu that fades in has the contrast of no colour that it will have.
    }, { screens, theme, reducedMotion: "reduce" });
  }

  flow("say by name what they cannot do, and leave the plan as it is", async (playground) => {
    const [first, second] = CROSSING.agents;
    await open(playground, { ...CROSSING, agents: [{ ...first, battery: { capacity: 9, initial: 9 } }, second] });
    await playground.press("Solve");
    await playground.says(/^Optimal: /);
    await choose(playground, "PIBT");
    await playground.warns(/PIBT cannot plan for batteries, and A has one\./);
    await playground.says(/^Optimal: /);
    await playground.picture("planners-refused");
    const rows = await rowsOf(playground);
    assert.match(rows[0].join(" "), /Exact search.* 5, 3 proved best/s);
    assert.match(rows[1].join(" "), /PIBT Not for this planner: PIBT cannot plan for batteries/);
  }, { screens: BOTH });

  flow("show two plans side by side, and are gone after an edit", async (playground) => {
    await open(playground, CROSSING);
    await playground.press("Solve");
    await playground.says(/^Optimal: /);
    await choose(playground, "LaCAM");
    await playground.says(/^LaCAM found a plan: /);
    await playground.press("Show Exact search beside");
    await playground.other.waitFor();
    await playground.picture("planners-beside");
    await playground.pick("Obstacle");
    await playground.cell(0, 0).click();
    await playground.other.waitFor({ state: "detached" });
    assert.equal(await playground.page.getByRole("table", { name: "Planners" }).count(), 0);
  }, { screens: ["desktop"] });
});

function open(playground, scene) {
  return playground.open({ name: "scene.json", bytes: JSON.stringify(scene) });
}

async function choose(playground, name) {
  await playground.press("Planners");
  await playground.page.getByRole("button", { name: new RegExp(`^${name}`) }).click();
}

function row(playground, name) {
  return playground.page.getByRole("table", { name: "Planners" }).getByRole("button", { name, exact: true });
}

/** The rows of the table: the texts of their cells. */
async function rowsOf(playground) {
  await playground.showTab("Inspector");
  const table = playground.page.getByRole("table", { name: "Planners" });
  await table.waitFor();
  const rows = table.locator("tbody").getByRole("row");
  return rows.evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.innerText.trim())));
}
