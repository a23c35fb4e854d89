// Forced colours, as people choose who see little: what is pressed, selected or pointed at
// is shown in the system's own colours.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { flows, LOOKS } from "./flow.mjs";

describe("forced colours", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    const options = { forcedColors: "active", reducedMotion: "reduce", theme, screens };

    flow(`what is pressed or selected is seen, ${theme}`, async (playground, { page }) => {
      await playground.says(/\b18\b/);
      await playground.pause();
      await differ(playground.tools.getByRole("button", { name: "Select" }), playground.tools.getByRole("button", { name: "Obstacle" }));
      if (playground.isPhone()) {
        const tab = (name) => page.getByRole("tab", { name, exact: true });
        await tab("Timeline").click();
        await differ(tab("Timeline"), tab("Plan"));
      } else {
        // All speeds and views stand side by side where there is room.
        await page.setViewportSize({ width: 1680, height: 900 });
        await differ(playground.button("1×"), playground.button("2×"));
        await differ(playground.button("Trails"), playground.button("Heat map"));
        await differ(playground.plan.locator("td.now").first(), playground.plan.locator("td:not(.now)").first());
      }
      const lane = (name) => page.getByRole("button", { name: new RegExp(`^${name}`) }).and(page.locator("[data-lane]"));
      await lane("A1").click();
      await differ(lane("A1"), lane("A2"));
      await playground.picture(`forced-${theme}`);

      await playground.openSettings();
      const boxes = playground.settings.getByRole("switch");
      const [on, off] = [boxes.and(page.locator(":checked")).first(), boxes.and(page.locator(":not(:checked)")).first()];
      assert.ok(await on.count() + await off.count() > 0, "there is no switch");
      for (const [box, marked] of [[on, true], [off, false]]) {
        if (await box.count() > 0) {
          assert.equal(await isMarked(box.locator("+ i")), marked);
        }
      }
      await playground.picture(`forced-settings-${theme}`);
    }, options);

    flow(`the cell of the keyboard is seen, ${theme}`, async (playground, { page }) => {
      await playground.says(/\b18\b/);
      await playground.pause();
      await playground.board.focus();
      await playground.key("ArrowRight");
      const cursor = page.locator("[aria-label=Board] .cursor");
      assert.equal(await cursor.evaluate((it) => getComputedStyle(it).display), "inline");
      assert.equal(await isMarked(cursor, "stroke"), true);
      await playground.picture(`forced-cursor-${theme}`);
    }, { ...options, screens: ["desktop"] });
  }
});

async function differ(marked, plain) {
  assert.equal(await isMarked(marked), true, `not marked: ${await marked.textContent()}`);
  assert.equal(await isMarked(plain), false, `marked: ${await plain.textContent()}`);
}

/** Whether something has the ground, or the line, of the system's selection. */
function isMarked(locator, property = "background-color") {
  return locator.evaluate((it, name) => {
    const probe = document.body.appendChild(document.createElement("i"));
    probe.style.setProperty("forced-color-adjust", "none");
    probe.style.setProperty("background-color", "Highlight");
    const selection = getComputedStyle(probe).backgroundColor;
    probe.remove();
    return getComputedStyle(it)[name] === selection;
  }, property);
}
