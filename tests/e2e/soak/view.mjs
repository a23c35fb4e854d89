// Looking: playing, stepping, layers, themes, zoom. Nothing that a person made changes.

import { pressIf } from "./hands.mjs";

const BUTTONS = ["Play", "To start", "Step back", "Step forward", "To end", "Trails", "Heat map", "Plan table", "Theme", "Zoom in", "Zoom out", "Fit", "Show the other plan", "Show this plan", "Keep this plan", "Next difference"];

async function looks(sitting) {
  for (let times = 1 + sitting.dice.roll(4); times > 0; times -= 1) {
    const name = sitting.dice.pick(BUTTONS);
    if (await pressIf(sitting.page.getByRole("button", { name, exact: true }))) {
      sitting.note(name);
    }
  }
}

/** Selects what is on some cell, or follows a robot. */
async function selects(sitting) {
  const { dice, playground, page } = sitting;
  const lanes = page.locator("[data-lane]");
  const count = await lanes.count();
  if (count > 0 && await lanes.first().isVisible()) {
    await lanes.nth(dice.roll(count)).click();
    await pressIf(page.getByRole("button", { name: /^Follow / }));
    return;
  }
  await playground.key("Escape");
}

async function opensDialogs(sitting) {
  const { playground, page } = sitting;
  await playground.press(sitting.dice.pick(["Help", "Examples", "Share"]));
  await page.getByRole("dialog").first().waitFor();
  await playground.key("Escape");
  await page.getByRole("dialog").first().waitFor({ state: "detached" });
}

export const looking = [
  [4, looks],
  [2, selects],
  [1, opensDialogs],
];
