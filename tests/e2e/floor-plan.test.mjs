// A picture of a floor lies under the grid and is turned into cells.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { LOOKS, flows } from "./flow.mjs";

/** Two racks of 10 x 2 cells and a pillar, on a floor of 20 x 12 cells of 20 pixels. */
const HALL = `<svg xmlns="http://www.w3.org/2000/svg" width="400" height="240">
<path fill="#333" d="M40 40h200v40H40ZM40 120h200v40H40ZM324 104h16v16h-16Z"/></svg>`;
/** A robot's map of 4 x 2 pixels, half a metre each: the first column is occupied. */
const PGM = "P2\n4 2\n255\n0 254 254 205\n0 254 254 205\n";
const SHEET = "image: hall.pgm\nresolution: 0.5\nnegate: 0\noccupied_thresh: 0.65\n";

const file = (name, text) => ({ name, mimeType: "", buffer: Buffer.from(text) });

describe("a floor plan", () => {
  const flow = flows();

  for (const { theme } of LOOKS) {
    flow(`is placed, given a scale and turned into cells (${theme})`, async (playground, { page }) => {
      await playground.says(/^Optimal/);
      await bring(page, [file("hall.svg", HALL)]);
      await page.getByRole("heading", { name: "Floor plan" }).waitFor();
      await type(page, "Width of the picture, cells", "20");
      await page.getByRole("button", { name: /^Make the map 20/ }).click();
      await type(page, "Metres between the two points", "12,8");
      await type(page, "Metres a cell", "0.8");
      await page.getByText("cells are 16 × 9.6 m.").waitFor();
      await page.getByText(/^\d+ cells? become/).waitFor();
      await audit(playground, "a floor plan");
      await playground.picture(`floor-plan-${theme}`);
      const before = await page.getByRole("button", { name: /^Draw \d+ obstacles/ }).textContent();
      const threshold = page.getByLabel("Dark at least, per cent");
      await threshold.focus();
      await threshold.fill("70");
      const after = await page.getByRole("button", { name: /^Draw \d+ obstacles/ }).textContent();
      assert.equal(number(before) - number(after), 1, "of the pillar 64 % of a cell is dark");
      await page.getByRole("button", { name: /^Draw \d+ obstacles/ }).click();
      assert.equal(await page.locator("image.floor-plan.faint").count(), 1);
      await playground.inspector.locator("summary", { hasText: "Edit scene" }).click();
      await page.getByRole("button", { name: "Hide", exact: true }).click();
      assert.equal(await page.locator("image.floor-plan").count(), 0);
      await page.getByRole("button", { name: "Remove", exact: true }).click();
      assert.equal(await page.getByRole("heading", { name: "Floor plan" }).count(), 0);
    });
  }

  flow("may be a robot's map, with its scale", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    await bring(page, [file("hall.yaml", SHEET), file("hall.pgm", PGM)]);
    await page.getByRole("heading", { name: "Floor plan" }).waitFor();
    assert.equal(await page.getByLabel("Width of the picture, cells").inputValue(), "2");
    await page.keyboard.press("Escape");
    await page.getByRole("heading", { name: "Floor plan" }).waitFor({ state: "detached" });
  });

  flow("is there again when the page is loaded again", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    await bring(page, [file("hall.svg", HALL)]);
    await type(page, "Width of the picture, cells", "17");
    await page.getByText("also when the page is loaded again").waitFor();
    await playground.reload();
    await playground.says(/^Optimal/);
    await page.getByRole("heading", { name: "Floor plan" }).waitFor();
    assert.equal(await page.getByLabel("Width of the picture, cells").inputValue(), "17");
    assert.equal(await page.locator("image.floor-plan").count(), 1);
    await page.keyboard.press("Escape");
    await page.getByRole("heading", { name: "Floor plan" }).waitFor({ state: "detached" });
    await playground.reload();
    await playground.says(/^Optimal/);
    assert.equal(await page.locator("image.floor-plan").count(), 0);
  });

  flow("that is no picture is refused, and the scene stays", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    await bring(page, [file("hall.png", "no picture")]);
    await page.getByText("hall.png is no picture that can be shown").waitFor();
    await playground.says(/^Optimal/);
    await bring(page, [file("hall.pgm", "P5 2 2 255\n1")]);
    await page.getByText("found 1 pixels, expected 2 x 2").waitFor();
  });
});

const bring = (page, files) => page.locator("input[type=file]").first().setInputFiles(files);

async function type(page, label, value) {
  const field = page.getByLabel(label, { exact: true });
  await field.fill(value);
  await field.press("Enter");
}

const number = (text) => Number(/\d+/.exec(text)[0]);
