// What stands on the page keeps its place, its meaning and its time while other things come and go.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { flows, sample } from "./flow.mjs";
import { eventually } from "./wait.mjs";

/** Takes the solver longer than what is done here. */
const HARD = sample("mmapf/A17_mm_20x20_o15_a30.json");

describe("places that are kept", () => {
  const flow = flows();

  flow("the board and the tabs below it stay where they are, whatever stands there", async (playground, { page }) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4/);
    await playground.press("Step forward");
    await playground.press("Step forward");
    await playground.reaches(2);
    const tab = (name) => page.getByRole("tab", { name, exact: true });
    const places = async () => [await playground.board.boundingBox(), await tab("Timeline").boundingBox()];
    const before = await places();
    for (const name of ["Proof: how it was proved", "Robots", "Timeline"]) {
      await tab(name).click();
      await eventually(`${name} to be chosen`, () => tab(name).getAttribute("aria-selected"), (chosen) => chosen === "true");
      assert.deepEqual(await places(), before, name);
    }
    // The time of the plan was left and is there again.
    await playground.reaches(2);
    await tab("Robots").click();
    const filter = page.getByRole("searchbox", { name: "Filter robots" });
    const field = await filter.boundingBox();
    await filter.pressSequentially("A1x");
    await page.getByText("No robot has that.").waitFor();
    assert.deepEqual(await filter.boundingBox(), field, "the field that is typed in");
  });

  flow("a second press does not undo the first", async (playground, { page }) => {
    await playground.open(HARD);
    await playground.solver.dblclick();
    await playground.button("Cancel").waitFor();
    assert.equal(await playground.button("Go on").count(), 0, "it searches on");
    // Cancelled, it does not go on under the same press either.
    await playground.button("Cancel").dblclick();
    await playground.button("Cancel").waitFor({ state: "detached" });
    await page.waitForTimeout(700);
    assert.equal(await playground.button("Cancel").count(), 0, "it stays stopped");
  });

  flow("what is unfolded stays so while the scene is edited and solved", async (playground) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4/);
    const { inspector } = playground;
    const seed = inspector.getByLabel("Seed", { exact: true });
    await inspector.locator("summary", { hasText: "Edit scene" }).click();
    await inspector.getByRole("button", { name: "Random scene" }).click();
    await playground.solver.click();
    await playground.says(/^(Optimal|No plan)/);
    assert.ok(await seed.isVisible(), "it is still open");
  });

  flow("a cost is asked about at its row", async (playground) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4/);
    await playground.inspector.getByRole("button", { name: "Makespan: Why does it take this long?" }).click();
    await playground.inspector.getByRole("heading", { name: "Why does it take this long?", level: 2 }).waitFor();
  });
});

/** A1 stays and turns on its way around a zone. */
const RULED = {
  giveway: 1,
  name: "ruled",
  map: ["......", ".####.", "......"],
  agents: [{ name: "A1", start: [0, 0], goal: [5, 2], waypoints: [[2, 0]], heading: "east" }],
  zones: [{ name: "aisle", rect: [1, 1, 4, 1] }],
  constraints: [
    { kind: "turns", quarter: 1 },
    { kind: "visit", agents: ["A1"], cell: [2, 0], stay: 2 },
    { kind: "capacity", zone: "aisle", most: 1 },
  ],
};

describe("signs of rules", () => {
  const flow = flows();

  flow("a robot that turns or stays shows it, on the board and in its lane", async (playground, { page }) => {
    await ruled(playground);
    // Two clocks for the stay, and an arrow for the turn at the corner.
    const lane = page.getByRole("img", { name: /^A1: .* 3 waits, 1 of them to turn, 2 of them for a stay/ });
    await lane.waitFor();
    const turning = page.locator(".map[data-board=main] .tbadge[data-on]");
    const last = Number(await playground.time.getAttribute("aria-valuemax"));
    let turns = 0;
    for (let time = 0; time < last; time += 1) {
      turns += await turning.count();
      await playground.press("Step forward");
      await playground.reaches(time + 1);
    }
    assert.ok(turns >= 1, "it turns in a step of its own");
    await playground.picture("rule-turning");
  });

  flow("the tab of a zone shows and opens its rule", async (playground, { page, screen }) => {
    await ruled(playground);
    const tab = await page.locator(".map[data-board=main] .zone .signs").first().boundingBox();
    const [x, y] = [tab.x + tab.width / 2, tab.y + tab.height / 2];
    await (screen === "phone" ? page.touchscreen.tap(x, y) : page.mouse.click(x, y));
    const rule = playground.inspector.getByRole("button", { name: /^At most 1 robot in aisle: show and open$/ });
    await eventually("the rule to be open", () => rule.getAttribute("aria-expanded"), (open) => open === "true");
  }, { screens: ["desktop", "phone"] });
});

async function ruled(playground) {
  await playground.open({ name: "ruled.json", bytes: JSON.stringify(RULED) });
  await playground.shows("ruled");
  await playground.solver.click();
  await playground.says(/^Optimal/);
  await playground.button("To start").click({ timeout: 1000 }).catch(() => undefined);
  await playground.reaches(0);
}
