// Two plans side by side: opened at the first difference, stepped through, left at the time before; who pays.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

describe("two plans compared", () => {
  const flow = flows();

  flow("opens the other plan at its first difference, and comes back to the time before", async (playground, { page }) => {
    await answered(playground);
    await playground.board.focus();
    await playground.key("n");
    await playground.other.waitFor();
    await playground.reaches(1);
    const row = page.getByRole("group", { name: "Differences" });
    assert.match(await row.innerText(), /Difference 1 of \d at time 1:/);
    await playground.inspector.getByRole("heading", { name: "What differs" }).waitFor();
    await playground.picture("compare");
    await playground.key("Shift+n");
    await playground.reaches(1);
    await playground.key("Escape");
    await playground.other.waitFor({ state: "detached" });
    await playground.reaches(0);
    // The answer is still there.
    await playground.button("Show the other plan").waitFor();
    await playground.key("Escape");
    await playground.button("Show the other plan").waitFor({ state: "detached" });
  });

  flow("says who pays, and lights who is pressed", async (playground, { page }) => {
    await answered(playground);
    const pays = playground.inspector.getByRole("table", { name: "Who pays" });
    const robot = pays.getByRole("button", { name: /^A1 arrives: 3 here, 4 in the other plan, 1 more/ });
    await robot.click();
    await eventually("the row to be pressed", () => robot.getAttribute("aria-pressed"), (pressed) => pressed === "true");
    await page.locator(".litring").first().waitFor({ state: "attached" });
    await playground.picture("pays");
    await robot.click();
    await eventually("the row to be free", () => robot.getAttribute("aria-pressed"), (pressed) => pressed === "false");
    const { y, height } = await playground.inspector.locator(".vs").boundingBox();
    const foot = await playground.button("Show the other plan").boundingBox();
    assert.ok(y + height <= foot.y, "the sentence is in sight");
  }, { screens: BOTH });
});

async function answered(playground) {
  await playground.example("Who waits?");
  await playground.says(/^Optimal: makespan 4, sum of costs 7/);
  await playground.press("To start");
  await playground.reaches(0);
  await playground.showTab("Inspector");
  await playground.inspector.getByRole("button", { name: /^A2\b/ }).first().click();
  await playground.inspector.getByRole("button", { name: /^Why does A2 wait at \(3, 1\)\?/ }).first().click();
  await playground.button("Show the other plan").waitFor();
  await playground.answered();
}
