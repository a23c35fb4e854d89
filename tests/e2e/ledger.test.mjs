// Who costs whom: the ledger of a plan, its heat map, and the question about the largest loss.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

describe("who costs whom", () => {
  const flow = flows();

  flow("adds up what each robot loses, shows where, and asks about the largest loss", async (playground, { page }) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4, sum of costs 7/);
    await playground.showTab("Inspector");
    await playground.inspector.getByRole("button", { name: /^Who costs whom\?/ }).click();
    const table = playground.inspector.getByRole("table", { name: "Who loses" });
    await table.waitFor();
    await playground.inspector.getByText("1 step lost, none to be saved").waitFor();
    // The column adds up.
    const steps = await table.locator("tbody td:nth-child(2)").allInnerTexts();
    const all = Number(steps.pop());
    assert.equal(steps.reduce((sum, text) => sum + Number(text), 0), all);
    await page.locator(".losses path").first().waitFor({ state: "attached" });
    await playground.picture("ledger");

    const first = table.getByRole("button").first();
    await first.click();
    await eventually("the row to be pressed", () => first.getAttribute("aria-pressed"), (pressed) => pressed === "true");
    await playground.press("Who costs others");
    await playground.inspector.getByRole("table", { name: "Who costs others" }).waitFor();
    await playground.picture("ledger-turned");

    await playground.inspector.getByRole("button", { name: /^Why does A\d not arrive sooner\?/ }).click();
    await playground.inspector.getByRole("heading", { name: /^Why does A\d not arrive sooner\?/ }).waitFor();
    await playground.inspector.locator(".verdict").waitFor();
    await playground.button("Back").click();
    await playground.inspector.getByRole("heading", { name: "Who costs whom?" }).waitFor();
    await playground.press("Done");
    await page.locator(".losses").waitFor({ state: "detached" });
  }, { screens: BOTH });

  flow("is opened and left with the keyboard alone", async (playground, { page }) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4, sum of costs 7/);
    const question = playground.inspector.getByRole("button", { name: /^Who costs whom\?/ });
    await question.focus();
    await playground.key("Enter");
    await playground.inspector.getByRole("table", { name: "Who loses" }).waitFor();
    await playground.cellTells(3, 1, /step lost: A\d 1/);
    await playground.key("Escape");
    await page.locator(".losses").waitFor({ state: "detached" });
  });
});
