// The settings: each changes what is solved.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { BOTH, flows, MOVING } from "./flow.mjs";

const OPENING = /^Optimal: makespan 18, sum of costs 35, 3 charges\.$/;
const STALE = /^The scene has changed since this plan/;

describe("settings", () => {
  const flow = flows();

  flow("orders the costs", async (playground) => {
    await playground.says(OPENING);
    await playground.openSettings();
    await playground.picture("settings");
    const press = (name) => playground.settings.getByRole("button", { name, exact: true }).click();
    await press("Raise Charges");
    await press("Raise Charges");
    await press("Remove Sum of costs");
    await press("Add Waits");
    const order = playground.settings.getByRole("listitem");
    assert.deepEqual(await order.evaluateAll((items) => items.map((item) => item.innerText.replaceAll(/\s+/g, " ").match(/^\d \w+/)[0])), [
      "1 Charges", "2 Makespan", "3 Waits",
    ]);
    await playground.closeSettings();
    await playground.says(STALE);
    await playground.press("Solve");
    await playground.says(/^Optimal: 3 charges, makespan 18, \d+ waits?\.$/);
  }, { screens: BOTH });

  // Proved by the command, too: giveway solve on the warehouse with rules.battery_floor.
  flow("keeps a floor under the batteries", async (playground) => {
    await playground.says(OPENING);
    await change(playground, "Battery floor", 2);
    await playground.says(/^Optimal: makespan 20, sum of costs 39, 4 charges\. No battery may fall below 2\.$/);
    await change(playground, "Battery floor", 9);
    await playground.says(/^No plan exists, no matter how many steps you allow/);
    // The answer is taken back, then the floor: the plan of before is there again.
    await playground.press("Undo");
    await playground.press("Undo");
    await playground.says(/^Optimal: makespan 20/);
  });

  flow("keeps to a horizon", async (playground) => {
    await playground.says(OPENING);
    await change(playground, "Horizon, steps", 17);
    await playground.says(/^No plan within makespan 17/);
    await change(playground, "Horizon, steps", "");
    await playground.says(OPENING);
  });

  flow("lets agents leave at their goals", async (playground) => {
    await playground.example("No way past");
    await playground.says(/^No plan exists, no matter how many steps you allow/);
    await playground.openSettings();
    await playground.settings.getByRole("button", { name: "leaves the map" }).click();
    assert.equal(await playground.settings.getByRole("button", { name: "leaves the map" }).getAttribute("aria-pressed"), "true");
    await playground.closeSettings();
    await playground.says(/Solve again/);
    const saved = await sceneText(playground);
    assert.match(saved, /"at_goal": "vanish"/);
  });

  flow("takes back what is no number", async (playground) => {
    await playground.openSettings();
    for (const [label, typed, kept] of [
      ["Time limit, s", "soon", "30"],
      ["Time limit, s", "0", "30"],
      ["Battery floor", "-3", "0"],
      ["Horizon, steps", "1e9", ""],
      ["Horizon, steps", "99999", ""],
    ]) {
      await playground.set(label, typed);
      assert.equal(await playground.settings.getByLabel(label, { exact: true }).inputValue(), kept, `${label}: ${typed}`);
    }
  }, { screens: ["desktop"] });

  flow("keeps what is being typed while time goes on", async (playground) => {
    await playground.says(OPENING);
    await playground.openSettings();
    const field = playground.settings.getByLabel("Battery floor", { exact: true });
    await field.fill("7");
    const now = await playground.now();
    await playground.reaches(`later than ${now}`, (time) => time > now);
    assert.equal(await field.inputValue(), "7");
  }, MOVING);

  flow("solves on every change, where that is wanted", async (playground) => {
    await playground.says(OPENING);
    await playground.openSettings();
    await playground.settings.getByRole("switch", { name: "Solve on every change" }).check();
    await playground.closeSettings();
    await playground.pick("Obstacle");
    await playground.stroke([0, 1]);
    await playground.says(/^Optimal: makespan 23, sum of costs 40, 3 charges\.$/);
    await playground.press("Undo");
    await playground.says(OPENING);
  });

  flow("tells the version of the workspace", async (playground) => {
    await playground.openSettings();
    const manifest = readFileSync(new URL("../../Cargo.toml", import.meta.url), "utf8");
    const [, version] = /^version = "(.*)"$/m.exec(manifest);
    const commit = process.env.GIVEWAY_COMMIT ? ` (${process.env.GIVEWAY_COMMIT.slice(0, 7)})` : "";
    await playground.settings.getByText(`Giveway ${version}${commit}`, { exact: true }).waitFor();
  }, { screens: ["desktop"] });

  flow("closes by Escape and by a press elsewhere", async (playground) => {
    await playground.openSettings();
    await playground.key("Escape");
    await playground.settings.waitFor({ state: "detached" });
    await playground.openSettings();
    await playground.page.mouse.click(20, 20);
    await playground.settings.waitFor({ state: "detached" });
  }, { screens: BOTH });
});

/** Changes one number and solves. */
async function change(playground, label, value) {
  await playground.openSettings();
  await playground.set(label, value);
  await playground.closeSettings();
  await playground.press("Solve");
}

/** The scene on the board as it would be saved. */
async function sceneText(playground) {
  const download = playground.page.waitForEvent("download");
  await playground.press(playground.isPhone() ? "More" : "Save");
  await playground.press("Save scene");
  const stream = await (await download).createReadStream();
  return (await stream.setEncoding("utf8").toArray()).join("");
}
