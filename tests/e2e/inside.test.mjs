// How the plan was found and proved: its steps, the conflict tree, orders; by hand and by keys.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { describe } from "node:test";
import { isDeepStrictEqual } from "node:util";

import { audit } from "./audit.mjs";
import { BOTH, LOOKS, flows, sample } from "./flow.mjs";
import { PILLARS, look, stepsOf } from "./inside.mjs";
import { eventually } from "./wait.mjs";

/** Takes the solver longer than what is done here. */
const HARD = sample("mmapf/A17_mm_20x20_o15_a30.json");

describe("how it was proved", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`is stepped through (${theme})`, async (playground) => {
      await look(playground, PILLARS, "Bounds");
      const { page, inspector } = playground;
      const isWhole = (steps) => /No plan is better/.test(steps.at(-1));
      const all = await eventually("all steps", () => stepsOf(playground), isWhole);
      assert.match(all[0], /^0\s*Each robot alone, by its fastest way\s*at least 17$/);
      assert.match(all.at(-1), /Plan and bound meet: .* No plan is better/);
      await audit(playground, "the proof");
      await playground.picture(`inside-proof-${theme}`);

      // What robots cannot do together is seen on the board, and told beside it.
      await step(playground, /cannot both be on time/).click();
      await playground.showTab("Step");
      await inspector.getByRole("heading", { name: /cannot both be on time/ }).waitFor();
      await inspector.getByText(/^To be on time, A\d must/).first().waitFor();
      await audit(playground, "a step");
      await playground.picture(`inside-step-${theme}`);

      // The robots of the step alone have a small proof of their own.
      await inspector.getByRole("button", { name: /^Why can A\d and A\d not both be on time\?/ }).click();
      await inspector.getByText(/^A\d and A\d alone: step 0 of \d$/).waitFor();
      await playground.showTab("How it was proved");
      const own = await stepsOf(playground);
      assert.ok(own.length < 10, `${own.length} steps cannot be followed by eye`);
      await playground.showTab("Step");
      await audit(playground, "robots alone");
      await playground.press("All robots again");
      await inspector.getByRole("heading", { name: /cannot both be on time/ }).waitFor();
      await playground.showTab("How it was proved");
      // Steps are drawn as far as they are in sight, which is measured first.
      await eventually("all steps again", () => stepsOf(playground), (steps) => isDeepStrictEqual(steps, all));

      // At the end the plan is played.
      await page.getByRole("button", { name: "Last step" }).click();
      await playground.showTab("Step");
      await playground.press("Play the plan");
      await playground.reaches(8);
    }, { theme, screens, reducedMotion: "reduce" });
  }

  flow("is stepped through by keys alone", async (playground) => {
    await look(playground, PILLARS);
    const { page } = playground;
    await page.getByRole("tab", { name: "Timeline" }).focus();
    await playground.key("End");
    const list = page.getByRole("list", { name: "Steps" });
    await list.waitFor();
    await isFocused(playground, /^Proof$/);
    await chosen(playground, /^Each robot alone/);
    await playground.button("Play").focus();
    await playground.key(".", ".");
    await stands(playground, 2);
    await playground.key(",");
    await stands(playground, 1);
    await playground.key("End");
    await chosen(playground, /^Plan and bound meet/);
    await playground.key("Home");
    await stands(playground, 0);

    // In the list, and on the chart.
    await list.getByRole("button").first().focus();
    await playground.key("ArrowDown", "ArrowDown", "ArrowUp");
    await stands(playground, 1);
    await isFocused(playground, /^1\s*A plan is found/);
    const slider = page.getByRole("slider", { name: "Step" });
    await slider.focus();
    await playground.key("ArrowRight");
    assert.equal(await slider.getAttribute("aria-valuenow"), "2");

    // The methods are tabs, too, and no two tabs have one name.
    const names = await page.getByRole("tab").allTextContents();
    assert.deepEqual(names.filter((name, at) => names.indexOf(name) !== at), []);
    await page.getByRole("tab", { name: "Bounds", exact: true }).focus();
    await playground.key("ArrowRight");
    const tree = page.getByRole("tree", { name: "Conflict tree" });
    await tree.waitFor();
    await tree.focus();
    await playground.key("ArrowRight");
    await eventually("the first child", () => selected(tree), (name) => /^Cost 18: /.test(name));
    await playground.key("ArrowLeft");
    await eventually("the root", () => selected(tree), (name) => /^Cost 17: /.test(name));
    await page.getByRole("tab", { name: "How it was proved" }).focus();
    await playground.key("Home");
    await playground.time.waitFor();
    assert.equal(await list.count(), 0);
  });

  flow("grows while the search goes on", async (playground) => {
    await playground.open(HARD);
    await playground.says(/^No plan yet/);
    await playground.press("Solve");
    await playground.button("Cancel").waitFor();
    await openOn(playground, "Bounds");
    const { page } = playground;
    await eventually("steps to come", () => count(playground), (n) => n > 3);
    const image = page.getByRole("img", { name: /proved bound and best plan by step/ });
    await image.waitFor();
    const before = await count(playground);
    await eventually("more steps", () => count(playground), (n) => n > before);
    await playground.picture("inside-live");
    // Whoever chose a step is left there. At its beginning the list stands still.
    const steps = page.getByRole("list", { name: "Steps" });
    await steps.evaluate((list) => list.scrollTo(0, 0));
    await steps.locator("[aria-posinset='1']").getByRole("button").click();
    const at = await steps.locator("[aria-current]").innerText();
    const then = await count(playground);
    await eventually("more steps after that", () => count(playground), (n) => n > then);
    assert.equal(await steps.locator("[aria-current]").innerText(), at);
    await playground.press("Cancel");
    await playground.button("Go on").waitFor();
    await audit(playground, "stopped");
  }, { screens: BOTH });

  flow("saves its record", async (playground) => {
    await look(playground, PILLARS, "Bounds");
    const download = playground.page.waitForEvent("download");
    await playground.press("Save this record");
    const saved = await download;
    assert.equal(saved.suggestedFilename(), "four-pillars-trace.json");
    const trace = JSON.parse(await readFile(await saved.path(), "utf8"));
    assert.equal(trace.giveway, 1);
    assert.deepEqual(trace.events.slice(0, 1).map(({ event }) => event), ["alone"]);
  });

  for (const { theme, screens } of LOOKS) {
    flow(`shows the conflict tree (${theme})`, async (playground) => {
      await look(playground, PILLARS, "Conflict tree");
      const tree = playground.page.getByRole("tree", { name: "Conflict tree" });
      const items = tree.getByRole("treeitem");
      assert.match(await selected(tree), /^Cost 17: A2 and A3 meet, \(3, 1\) at time 2/);
      assert.equal(await items.first().getAttribute("aria-level"), "1");
      await audit(playground, "the tree");
      await playground.picture(`inside-tree-${theme}`);
      await items.filter({ hasText: "the best plan" }).click();
      await playground.showTab("Node");
      await playground.inspector.getByRole("heading", { name: "Cost 19, and no conflict" }).waitFor();
      await audit(playground, "the best node");
      await playground.press("Parent");
      await playground.inspector.getByRole("heading", { name: "Cost 18, and still a conflict" }).waitFor();
    }, { theme, screens, reducedMotion: "reduce" });

    flow(`shows orders of robots (${theme})`, async (playground) => {
      await playground.example("Last in, first out");
      await playground.says(/^Optimal: /);
      await openOn(playground, "One by one");
      const { inspector, page } = playground;
      await playground.showTab("Order");
      await inspector.getByRole("heading", { name: "All 6 orders get stuck" }).waitFor();
      const orders = inspector.getByRole("button", { name: /stuck$/ });
      await orders.last().click();
      await inspector.getByText(/no free cell at time 6/).waitFor();
      assert.equal(await orders.last().getAttribute("aria-current"), "true");
      await audit(playground, "the orders");
      await playground.showTab("How it was proved");
      const lanes = page.getByRole("group", { name: "Lanes" }).getByRole("button");
      assert.deepEqual(await lanes.evaluateAll((all) => all.map((lane) => lane.title)), [
        "A3, 1, plans freely", "A2, 2, plans around A3", "A1, 3, around A3 and A2",
      ]);
      await audit(playground, "the lanes");
      await playground.picture(`inside-orders-${theme}`);
    }, { theme, screens, reducedMotion: "reduce" });
  }

  for (const { theme, screens } of LOOKS) {
    flow(`shows who pushes whom, and configurations (${theme})`, async (playground) => {
      await look(playground, PILLARS, "PIBT");
      const { inspector } = playground;
      await playground.showTab("Step");
      await inspector.getByRole("heading", { name: "The step from 0 to 1" }).waitFor();
      await inspector.getByText(/^A[123] chooses first$/).waitFor();
      await inspector.getByText(/^PIBT on this scene, not the plan by the search for the best plan/).waitFor();
      await audit(playground, "a step of PIBT");
      await playground.picture(`inside-pibt-${theme}`);
      await look(playground, undefined, "LaCAM");
      await playground.showTab("Step");
      await inspector.getByRole("heading", { name: "The start" }).waitFor();
      await playground.key(".");
      await inspector.getByRole("heading", { name: "Configuration 1, after 1 step" }).waitFor();
      await audit(playground, "a configuration of LaCAM");
      await playground.picture(`inside-lacam-${theme}`);
    }, { theme, screens, reducedMotion: "reduce" });
  }

  flow("is gone after an edit, and says when nothing is known", async (playground) => {
    await look(playground, PILLARS, "Bounds");
    await playground.pick("Obstacle");
    await playground.cell(0, 3).click();
    await playground.page.getByText("Nothing is proved yet").waitFor();
    await audit(playground, "nothing");
    await playground.press("Undo");
    await playground.page.getByRole("list", { name: "Steps" }).waitFor();
  });
});

async function openOn(playground, method) {
  await look(playground, undefined, method);
}

function step(playground, name) {
  return playground.page.getByRole("list", { name: "Steps" }).getByRole("button", { name }).first();
}

/** How many steps there are, seen or not. */
async function count(playground) {
  const sizes = await playground.page.getByRole("list", { name: "Steps" }).locator("[aria-setsize]").evaluateAll(
    (rows) => rows.map((row) => Number(row.getAttribute("aria-setsize"))));
  return Math.max(0, ...sizes);
}

/** Waits until this step stands in large. */
function stands(playground, number) {
  const slider = playground.page.getByRole("slider", { name: "Step" });
  return eventually(`step ${number}`, async () => Number(await slider.getAttribute("aria-valuenow")), (at) => at === number);
}

function chosen(playground, pattern) {
  const row = playground.page.getByRole("list", { name: "Steps" }).locator("[aria-current]");
  return eventually(`step ${pattern}`, async () => (await row.innerText()).replace(/^\d+\s*/, ""), (text) => pattern.test(text));
}

function selected(tree) {
  return tree.locator("[aria-selected=true]").getAttribute("aria-label");
}

function isFocused({ page }, pattern) {
  return eventually(`the focus on ${pattern}`, () => page.evaluate(() => document.activeElement.innerText), (text) => pattern.test(text));
}
