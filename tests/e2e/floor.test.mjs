// The size of a floor by hand and keys, its units, its robots as a file, and a breakdown in a sentence.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { adapt, running } from "./change.mjs";
import { flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

describe("the floor", () => {
  const flow = flows();

  flow("has sides that are dragged, and moved by keys", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    const columns = Number(await playground.board.getAttribute("aria-colcount"));
    await page.getByText("Edit scene", { exact: true }).click();
    await page.getByRole("button", { name: "Rows and columns at any side" }).click();
    const side = page.getByRole("slider", { name: "Columns at the right" });
    const value = () => side.getAttribute("aria-valuenow").then(Number);
    const box = await side.boundingBox();
    const cell = await cellPixels(playground);
    const from = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 2 * cell, from.y, { steps: 4 });
    await eventually("two columns more", value, (n) => n === 2);
    await page.keyboard.press("Escape");
    await eventually("as it was", value, (n) => n === 0);
    await page.mouse.up();
    await side.focus();
    for (const key of ["ArrowRight", "Shift+ArrowRight", "ArrowLeft"]) {
      await page.keyboard.press(key);
    }
    await eventually("five columns more", value, (n) => n === 5);
    assert.match(await side.getAttribute("aria-valuetext"), /^5 columns more: /);
    const above = page.getByRole("slider", { name: "Rows above" });
    await above.focus();
    await page.keyboard.press("ArrowDown");
    assert.equal(await page.locator("path.comes").count(), 1);
    assert.equal(await page.locator("path.goes").count(), 1);
    await audit(playground, "sides of the floor");
    await playground.picture("floor-sides");
    await page.keyboard.press("ArrowUp");
    await page.getByRole("button", { name: /^Make it/ }).click();
    const now = () => playground.board.getAttribute("aria-colcount").then(Number);
    await eventually("five columns more", now, (n) => n === columns + 5);
    assert.equal(await page.getByRole("slider", { name: "Rows above" }).count(), 0);
  }, { screens: ["desktop"] });

  flow("has columns and rows that are selected by their numbers", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    await playground.pause();
    const press = async (number, button) => {
      const { x, y, width, height } = await page.locator(".axis text").getByText(String(number), { exact: true }).first().boundingBox();
      await page.mouse.click(x + width / 2, y + height / 2, { button });
    };
    const bar = page.locator(".areabar");
    await press(3, "left");
    await bar.getByRole("button", { name: "Remove column 3" }).waitFor();
    await audit(playground, "a column that is selected");
    await press(4, "right");
    await bar.getByRole("button", { name: "Insert 1 column left" }).click();
    await eventually("a column more", () => playground.board.getAttribute("aria-colcount"), (now) => now === "11");
  }, { screens: ["desktop"] });

  flow("has columns and rows that come and go in the middle", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    // Nobody drives past the cells that are pressed.
    await playground.pause();
    await playground.time.focus();
    await playground.key("End");
    const size = async () => `${await playground.board.getAttribute("aria-colcount")} ${await playground.board.getAttribute("aria-rowcount")}`;
    const before = await size();
    await pressCell(playground, 1, 0);
    await page.getByText("Rows and columns here", { exact: true }).click();
    await playground.press("Insert 1 column right");
    await eventually("a column more", size, (now) => now === "11 3");
    await playground.press("Undo");
    await eventually("as it was", size, (now) => now === before);
    // A robot starts in the first column: it is said before.
    await pressCell(playground, 0, 1);
    await playground.press("Remove column 0");
    await playground.says(/^A smaller floor: 2 robots would lose their start or goal\.$/);
    assert.equal(await page.locator("path.goes").count(), 1);
    await audit(playground, "a column that goes");
    await playground.picture("floor-column-goes");
    await page.getByRole("button", { name: /^Make it 9 × 3/ }).click();
    await eventually("a column less", size, (now) => now === "9 3");
    await playground.press("Undo");
    await eventually("as it was", size, (now) => now === before);
  }, { screens: ["desktop"] });

  flow("has an area that scrolls the map where it is dragged to the edge", async (playground, { page }) => {
    await playground.example("Large warehouse");
    await playground.says(/^(Optimal|Best plan)/);
    for (let time = 0; time < 6; time += 1) {
      await page.getByRole("button", { name: "Zoom in", exact: true }).click();
    }
    const view = () => playground.board.evaluate((svg) => svg.viewBox.baseVal.x);
    const before = await view();
    const box = await playground.board.boundingBox();
    const [y, edge] = [box.y + box.height / 2, box.x + box.width - 6];
    await page.keyboard.down("Shift");
    await page.mouse.move(box.x + box.width / 2, y);
    await page.mouse.down();
    await page.mouse.move(edge, y, { steps: 6 });
    await page.keyboard.up("Shift");
    await eventually("the map to scroll under the hand", view, (x) => x > before + 300);
    await page.mouse.up();
    await page.getByRole("toolbar", { name: /cells?/ }).first().waitFor();
    const rest = await view();
    await page.waitForTimeout(300);
    assert.equal(await view(), rest, "it rests with the hand");
  }, { screens: ["desktop"] });

  flow("has units, which stand beside steps and leave the plan as it is", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    await page.getByText("Edit scene", { exact: true }).click();
    await page.getByRole("button", { name: "Metres and seconds" }).click();
    const step = page.getByLabel("Seconds a step", { exact: true });
    await step.fill("0");
    await step.press("Enter");
    await page.getByText("Possible: 0.001 to 1000000, with at most three decimals.").waitFor();
    await step.fill("1,5");
    await step.press("Enter");
    await eventually("the step", () => step.inputValue(), (text) => text === "1.5");
    await playground.inspector.getByText(/\(\d+(\.\d)? s\)|\(\d+ min/).first().waitFor();
    await playground.says(/^Optimal/);
    await audit(playground, "units");
    await page.getByRole("button", { name: "Cells and steps" }).click();
    assert.equal(await step.count(), 0);
  }, { screens: ["desktop"] });

  flow("has robots that are saved as a table", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    await page.getByRole("tab", { name: "Robots" }).click();
    await page.getByRole("grid", { name: "Robots" }).getByRole("checkbox").nth(1).check();
    await page.locator(".litring").first().waitFor();
    await playground.picture("floor-robots-selected");
    const saving = page.waitForEvent("download");
    await page.locator(".robots").getByRole("button", { name: "Save robots (CSV)" }).click();
    const file = await saving;
    assert.match(file.suggestedFilename(), /-robots\.csv$/);
    const lines = readFileSync(await file.path(), "utf8").split("\r\n");
    assert.match(lines[0], /^\uFEFFName,Start,Waypoints,Goal,/);
    assert.match(lines[1], /^A1,"\d+, \d+"/);
  }, { screens: ["desktop"] });

  flow("has a robot that breaks down, in a sentence with slots", async (playground, { page }) => {
    await running(playground);
    await playground.board.focus();
    await page.getByRole("button", { name: /^A1/ }).first().click();
    await page.getByRole("button", { name: /^Breaks down here/ }).click();
    const card = page.getByRole("group", { name: "Breaks down here" });
    await card.getByRole("button", { name: "How long: 10 steps" }).click();
    const delay = card.getByLabel("Delay, steps", { exact: true });
    await delay.fill("1");
    await delay.press("Enter");
    await card.getByRole("button", { name: "How long: 1 step" }).waitFor();
    await card.getByRole("button", { name: "Which robot: A1" }).click();
    await card.getByRole("button", { name: "A2", exact: true }).click();
    await card.getByRole("button", { name: "Which robot: A2" }).waitFor();
    await audit(playground, "a breakdown");
    await playground.picture("floor-breakdown");
    await adapt(playground);
    await playground.picture("floor-breakdown-answers");
  }, { screens: ["desktop"] });
});

async function pressCell(playground, x, y) {
  const at = await playground.middleOf(x, y);
  await playground.page.mouse.click(at.x, at.y);
}

/** The side of a cell on the board, in pixels. */
function cellPixels(playground) {
  return playground.board.evaluate((svg) => (100 * svg.getBoundingClientRect().width) / svg.viewBox.baseVal.width);
}
