// How many robots a floor bears: said, solved, looked at, taken, by mouse and keys.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { BOTH, flows, sample } from "./flow.mjs";
import { eventually } from "./wait.mjs";

describe("how many robots", () => {
  const flow = flows();

  flow("are solved, charted, looked at and taken", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    const before = await playground.board.locator("g.agent").count();
    await open(page);
    await say(page, "First number of robots", "2");
    await say(page, "Last number of robots", "4");
    await say(page, "More each time", "1");
    await page.getByRole("button", { name: "Solve 3 plans" }).click();
    const charts = page.locator(".sizes svg[role=img]");
    await eventually("three charts", () => charts.count(), (n) => n === 3);
    await eventually("three plans", () => dots(page).count(), (n) => n === 3);
    await page.getByText("What it says", { exact: true }).waitFor();
    await audit(playground, "how many robots");
    await playground.picture("sizing");
    // The plan of three robots comes onto the board; the own scene waits.
    await dots(page).nth(1).click();
    await eventually("three robots", () => playground.board.locator("g.agent").count(), (n) => n === 3);
    await playground.says(/makespan \d+/);
    await page.getByRole("button", { name: "Back to my robots" }).click();
    await eventually("the own robots", () => playground.board.locator("g.agent").count(), (n) => n === before);
    await dots(page).nth(2).click();
    await page.getByRole("button", { name: "Take these 4 robots" }).click();
    await eventually("four robots", () => playground.board.locator("g.agent").count(), (n) => n === 4);
    await playground.key("Control+z");
    await eventually("the own robots", () => playground.board.locator("g.agent").count(), (n) => n === before);
  }, { screens: BOTH });

  flow("are compared with a charger more, and saved as a table", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    await open(page);
    await say(page, "First number of robots", "2");
    await say(page, "Last number of robots", "2");
    await page.getByRole("button", { name: /^A charger at/ }).click();
    await page.getByText("Now press the cell of a charger more, or less.").waitFor();
    const free = await playground.middleOf(0, 2);
    await page.mouse.click(free.x, free.y);
    await eventually("the charger", () => page.getByLabel("The floor beside it").inputValue(), (text) => /^one charger (more|less) at/.test(text));
    await page.getByRole("button", { name: "Solve 2 plans" }).click();
    await eventually("a plan", () => dots(page).count(), (n) => n === 1);
    const download = page.waitForEvent("download");
    await page.getByRole("button", { name: "Save as a table" }).click();
    const saved = await download;
    assert.match(saved.suggestedFilename(), /-how-many\.csv$/);
    const lines = readFileSync(await saved.path(), "utf8").trim().split("\r\n");
    assert.equal(lines.length, 3);
    assert.match(lines[0], /Robots,Floor,Known,Last arrival/);
    await page.getByRole("tab", { name: "Timeline" }).first().click();
    await page.locator(".dock.sizing").waitFor({ state: "detached" });
  });

  flow("are solved no further once cancelled: the plans so far stay, and the page answers meanwhile", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    await playground.open(sample("depot/depot.json"));
    await playground.says(/^No plan yet/);
    await open(page);
    await say(page, "First number of robots", "1");
    await say(page, "Last number of robots", "60");
    await say(page, "More each time", "1");
    const solve = page.getByRole("button", { name: /^Solve \d+ plans$/ });
    const all = Number((await solve.innerText()).match(/\d+/)[0]);
    await solve.click();
    await eventually("two plans", () => dots(page).count(), (n) => n >= 2, 30_000);
    // While more are solved, the theme is changed at once.
    const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
    const [before, asked] = [await theme(), Date.now()];
    await page.getByRole("button", { name: "Theme", exact: true }).click();
    await eventually("another theme", theme, (now) => now !== before);
    assert.ok(Date.now() - asked < 2000, `after ${Date.now() - asked} ms`);
    await page.getByRole("button", { name: "Cancel", exact: true }).click();
    await page.getByRole("button", { name: "Cancel", exact: true }).waitFor({ state: "detached" });
    const kept = await dots(page).count();
    assert.ok(kept >= 2 && kept < all, `${kept} of ${all} plans`);
    await page.waitForTimeout(1500);
    assert.equal(await dots(page).count(), kept, "no plan comes after it");
    await dots(page).first().click();
    await eventually("one robot", () => playground.board.locator("g.agent").count(), (n) => n === 1);
  });
});

async function open(page) {
  // A phone has no tabs below the board.
  const tab = page.getByRole("tab", { name: "How many?" });
  const row = page.getByRole("button", { name: /^How many robots does this floor bear/ });
  await ((await tab.isVisible()) ? tab : row).click();
  await page.getByRole("heading", { name: "How many?" }).waitFor();
}

/** The plans in the first chart. */
function dots(page) {
  return page.locator(".sizes .size-chart").first().locator("g.own");
}

async function say(page, name, number) {
  const field = page.getByLabel(name, { exact: true });
  await field.fill(number);
  await field.press("Enter");
}
