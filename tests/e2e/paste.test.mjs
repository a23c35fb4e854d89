// What is copied from the page, and what is pasted into it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { BOTH, flows, sample, scene } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const OPENING = /^Optimal: makespan 18/;
const CLIPBOARD = { permissions: ["clipboard-read", "clipboard-write"] };
const read = (page) => page.evaluate(() => navigator.clipboard.readText());
const write = (page, text) => page.evaluate((text) => navigator.clipboard.writeText(text), text);

describe("copying and pasting", () => {
  const flow = flows();

  flow("copies the scene, and opens it again as one step of undo", async (playground, { page }) => {
    await playground.says(OPENING);
    await playground.press(playground.isPhone() ? "More" : "Save");
    await playground.picture("save-menu");
    await playground.press("Copy scene");
    await playground.button("Scene copied").waitFor();
    const copied = JSON.parse(await read(page));
    assert.deepEqual(copied.map, scene("seed/warehouse.json").map);
    await playground.key("Escape");

    await playground.example("No way past");
    await playground.shows("scenario 6");
    await playground.act(playground.isPhone() ? "Paste" : "Open");
    if (!playground.isPhone()) {
      await playground.picture("open-menu");
      await playground.press("Paste");
    }
    await playground.shows("warehouse");
    await playground.press("Undo");
    await playground.shows("scenario 6");
  }, { screens: BOTH, ...CLIPBOARD });

  flow("opens a plan, a map and a link that are pasted", async (playground, { page }) => {
    await playground.says(OPENING);
    const download = page.waitForEvent("download");
    await playground.press("Save");
    await playground.press("Save plan");
    const plan = readFileSync(await (await download).path(), "utf8");
    await playground.pick("Robot");
    await playground.stroke([0, 0]);
    await playground.key("Escape");

    await write(page, plan);
    await playground.key("Control+v");
    await playground.says(/^Optimal: makespan 18, sum of costs 35, 3 charges/);
    await write(page, readFileSync(sample("movingai/empty-8-8.map"), "utf8"));
    await playground.key("Control+v");
    await playground.shows("Pasted text");
    await write(page, "https://example.org/giveway/#giveway=1&map=3.3f&name=linked&rules=0.0&costs=0&agents=A.0.0.2.0");
    await playground.key("Control+v");
    await playground.shows("linked");
    for (const before of ["Pasted text", "warehouse"]) {
      await playground.press("Undo");
      await playground.shows(before);
    }
  }, { ...CLIPBOARD, screens: ["desktop"] });

  flow("refuses what cannot be opened, with its place, and the scene stays", async (playground, { page }) => {
    await playground.says(OPENING);
    await playground.pause();
    for (const [text, told] of [
      ['{\n  "giveway": 1,\n  "map": [".."', /Pasted text cannot be opened; the scene stays as it is\..*line 3.*column \d+/s],
      ["good morning", /Pasted text cannot be opened.*good morning.*expected a map, a scenario, an instance or a plan/s],
      ["https://example.org/#giveway=7&map=1.f", /link cannot be opened.*version 7/s],
    ]) {
      await write(page, text);
      await playground.key("Control+v");
      await playground.warns(told);
      await playground.picture("paste-refused");
      await playground.press("Dismiss");
      await playground.warns(/^\s*$/);
    }
    await playground.shows("warehouse");
    await playground.says(OPENING);
    assert.ok(await playground.button("Undo").isDisabled(), "nothing was changed");
  }, { ...CLIPBOARD, screens: ["desktop"] });

  flow("leaves to a field what is pasted there, and to a dialog what is open over the page", async (playground, { page }) => {
    await playground.says(OPENING);
    await playground.openSettings();
    const field = playground.settings.getByLabel("Time limit, s", { exact: true });
    await field.fill("");
    await write(page, "42");
    await field.press("Control+v");
    await eventually("the text in the field", () => field.inputValue(), (value) => value === "42");
    await playground.closeSettings();
    await playground.key("?");
    await page.getByRole("dialog", { name: "Keys" }).waitFor();
    await write(page, '{"giveway": 1, "map": [".."], "agents": []}');
    await playground.key("Control+v", "Escape");
    await playground.shows("warehouse");
    await playground.says(OPENING);
  }, { ...CLIPBOARD, screens: ["desktop"] });
});
