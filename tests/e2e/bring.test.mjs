// Scenes that are made anew, and files that are dropped for what is on the board.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { flows, LOOKS, sample } from "./flow.mjs";
import { drop, OPENING, save, stroke } from "./recover.mjs";

describe("new and dropped", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`a new scene of a size, as one step, ${theme}`, async (playground, { page }) => {
      await playground.says(OPENING);
      await (playground.isPhone() ? playground.act("New scene") : playground.press("New"));
      const dialog = page.getByRole("dialog", { name: "New scene" });
      await dialog.getByLabel("Name").fill("my hall");
      await dialog.getByLabel("Columns").fill("5");
      await dialog.getByLabel("Rows").fill("4");
      await playground.picture(`new-scene-${theme}`);
      await dialog.getByRole("button", { name: "Create" }).click();
      await playground.shows("my hall");
      assert.equal(await playground.board.getAttribute("aria-colcount"), "5");
      assert.equal(await playground.board.getAttribute("aria-rowcount"), "4");
      await playground.press("Undo");
      await playground.shows("warehouse");
      await playground.says(OPENING);
    }, { theme, screens });
  }

  flow("a plan for the scene on the board is judged", async (playground, { page }) => {
    await playground.says(OPENING);
    const plan = await save(playground, "Save plan");
    await stroke(playground, "Obstacle", [9, 1]);
    await drop(page, { name: "plan.json", text: plan });
    await playground.says(/plan\.json breaks (a rule once|rules \d+ times)/);
    await playground.press("Undo");
    await playground.press("Undo");
    await drop(page, { name: "plan.json", text: plan });
    await playground.says(/makespan 18/);
    await playground.shows("warehouse");
  }, { screens: ["desktop"] });

  flow("a scenario for the map on the board is used with it", async (playground, { page }) => {
    const scen = { name: "empty-8-8-even-1.scen", text: readFileSync(sample("movingai/empty-8-8-even-1.scen"), "utf8") };
    await drop(page, scen);
    await playground.warns(/empty-8-8\.map: open both files together.*the map on the board is 10 x 3/s);
    await playground.press("Dismiss");
    await playground.open(sample("movingai/empty-8-8.map"));
    await playground.shows("empty-8-8");
    await drop(page, scen);
    const dialog = page.getByRole("dialog", { name: "How many robots?" });
    await dialog.getByLabel("Robots", { exact: true }).fill("3");
    await dialog.getByRole("button", { name: "Open scene" }).click();
    await playground.shows("empty-8-8-even-1");
  }, { screens: ["desktop"] });
});
