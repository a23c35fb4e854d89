// Who passes a cell after whom: the order of a plan, cell by cell, when a robot is late, and as a file.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { BOTH, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

describe("the order of a plan", () => {
  const flow = flows();

  flow("is told cell by cell, late, and saved", async (playground, { page }) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4, sum of costs 7/);
    await playground.showTab("Inspector");
    await playground.inspector.getByRole("button", { name: /^Who passes after whom\?/ }).click();
    const table = playground.inspector.getByRole("table", { name: "Who passes, in order" });
    await table.waitFor();
    const names = await table.locator("tbody th").allInnerTexts();
    assert.ok(names.length > 1, "the busiest cell is passed by more than one");
    await page.locator(".order-strip .order-cell").waitFor({ state: "attached" });
    await audit(playground, "the order of a plan");
    await playground.picture("order");

    await playground.inspector.getByRole("button", { name: /^What if a robot is late\?/ }).click();
    await playground.says(/^A\d comes 3 steps late to/);
    await playground.inspector.getByRole("table", { name: "When each robot arrives" }).waitFor();
    const steps = page.getByLabel("Steps late", { exact: true });
    await steps.fill("5");
    await steps.press("Enter");
    await playground.says(/^A\d comes 5 steps late to/);
    await audit(playground, "a robot is late");
    await playground.picture("order-late");
    await playground.press("Done");
    await table.waitFor();

    await playground.inspector.getByRole("button", { name: /^Show( all)? \d+ links?$/ }).click();
    const links = playground.inspector.getByRole("table", { name: "All links" });
    await links.waitFor();
    assert.ok(await links.locator("tbody tr").count() >= names.length - 1);
    await audit(playground, "all links");
    await playground.press("Done");
    await table.waitFor();

    const download = page.waitForEvent("download");
    await playground.inspector.getByRole("button", { name: /^DOT/ }).click();
    const saved = await download;
    assert.match(saved.suggestedFilename(), /-order\.dot$/);
    assert.match(readFileSync(await saved.path(), "utf8"), /^digraph order \{/);
    // The dark button takes the one that was last used.
    await playground.button("Export: DOT").waitFor();
    await playground.press("Done");
    await page.locator(".order-strip").waitFor({ state: "detached" });
  }, { screens: BOTH });

  flow("goes on with new plans from a lateness", async (playground, { page }) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4, sum of costs 7/);
    await page.getByRole("tab", { name: "Order", exact: true }).click();
    await playground.inspector.getByRole("button", { name: /^What if a robot is late\?/ }).click();
    await playground.says(/^A\d comes 3 steps late to/);
    await playground.inspector.getByRole("button", { name: /^Find new plans from \d$/ }).click();
    await page.locator(".order-strip").waitFor({ state: "detached" });
    await playground.inspector.getByText(/breaks down at/).first().waitFor();
  }, { screens: ["desktop"] });

  flow("follows the arrows on the board and is left with Escape", async (playground, { page }) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4, sum of costs 7/);
    await page.getByRole("tab", { name: "Order", exact: true }).click();
    const title = playground.inspector.getByRole("heading", { name: /^Order at \(/ });
    await title.waitFor();
    await playground.board.focus();
    await playground.key("ArrowRight");
    const first = await title.innerText();
    await playground.key("ArrowRight");
    await eventually("another cell", () => title.innerText(), (text) => text !== first);
    await playground.key("Escape");
    await page.locator(".order-strip").waitFor({ state: "detached" });
  });
});
