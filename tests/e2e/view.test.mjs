// What is drawn over the map, and the camera that goes with an agent.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { flows, MOVING } from "./flow.mjs";
import { eventually } from "./wait.mjs";

describe("the view", () => {
  const flow = flows();

  flow("shades cells by their use, and keeps to it", async (playground, { page }) => {
    await playground.says(/^Optimal: makespan 18/);
    await playground.pause();
    const chip = playground.button("Heat map");
    await chip.click();
    const legend = page.getByRole("list", { name: "Legend" });
    await legend.getByText("Darker: used more often").waitFor({ state: "attached" });
    const shades = () => page.locator(".heat path").evaluateAll((paths) => paths.map((path) => path.getAttribute("d").length));
    assert.ok((await shades()).at(-1) > 0, "the most used cell is shaded");
    await playground.picture("use");
    await playground.reload();
    await playground.says(/^Optimal/);
    assert.equal(await chip.getAttribute("aria-pressed"), "true");
    await chip.click();
    await eventually("no shade", shades, (found) => found.length === 0);
  }, { screens: ["desktop"] });

  flow("follows the agent selected through a large map", async (playground, { page }) => {
    await playground.example("Large warehouse");
    await playground.says(/^Optimal/);
    await playground.pause();
    await playground.press("To start");
    await playground.showTab("Inspector");
    await playground.key("Escape");
    await playground.inspector.getByRole("button", { name: /^A1\b/ }).first().click();
    const follow = page.getByRole("button", { name: "Follow A1" });
    await follow.click();
    await eventually("to be pressed", () => follow.getAttribute("aria-pressed"), (pressed) => pressed === "true");
    // As far as the map goes it is in the middle of the board.
    const frame = () => playground.board.getAttribute("viewBox").then((box) => box.split(" ").map(Number));
    const [, y, width] = await frame();
    assert.ok(width < 16_100, `${width} units are in sight`);
    const steps = 30;
    for (let step = 0; step < steps; step += 1) {
      await playground.key(".");
    }
    await playground.reaches(steps);
    await eventually("the camera to move", frame, ([, now]) => Math.abs(now - y) > 100);
    await playground.picture("following");
    await playground.key("f");
    await eventually("to be let go", () => follow.getAttribute("aria-pressed"), (pressed) => pressed === "false");
  }, { screens: ["desktop"], ...MOVING });

  flow("is chosen on a phone by touch", async (playground, { page }) => {
    await playground.says(/^Optimal: makespan 18/);
    await playground.pause();
    await playground.openSettings();
    const part = playground.settings.getByRole("group", { name: "On the board" });
    const choice = (name) => part.getByRole("switch", { name });
    assert.equal(await choice(/^Follow/).count(), 0, "no agent is selected");
    for (const name of ["Trails", "Heat map"]) {
      const { width, height } = await choice(name).boundingBox();
      assert.ok(width >= 44 && height >= 44, `${name} is ${width} by ${height}`);
    }
    await choice("Heat map").tap();
    await choice("Trails").tap();
    const legend = page.getByRole("list", { name: "Legend", includeHidden: true });
    await legend.getByText("Darker: used more often").waitFor({ state: "attached" });
    assert.equal(await choice("Trails").isChecked(), false);
    await playground.picture("view-settings");
    await playground.closeSettings();

    await playground.example("Large warehouse");
    await playground.says(/^Optimal/);
    await playground.pause();
    await playground.showTab("Inspector");
    await playground.inspector.getByRole("button", { name: /^A1\b/ }).first().tap();
    const width = () => playground.board.getAttribute("viewBox").then((box) => Number(box.split(" ")[2]));
    const whole = await width();
    await playground.openSettings();
    await choice("Follow A1").tap();
    await playground.closeSettings();
    await eventually("the camera to come near", width, (now) => now < whole);
    await playground.fits();
  }, { screens: ["phone"] });
});
