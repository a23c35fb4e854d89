// A floor is drawn by shapes and filled with robots in rows: the actions are counted.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { LOOKS, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const DEPOT = /16 robots, 4 chargers, 21 slow cells, 234 obstacles/;
/** Presses, drags and typed fields from an empty page to a plan. */
const MOST_ACTIONS = 25;
/** The same where the robots come as a pasted table. */
const MOST_WITH_TABLE = 20;

describe("a floor", () => {
  const flow = flows();

  for (const { theme } of LOOKS) {
    flow(`of 16 robots is drawn and solved in ${MOST_ACTIONS} actions (${theme})`, async (playground, { page }) => {
      await playground.says(/^Optimal/);
      let actions = 0;
      const press = async (name, place = page) => {
        actions += 1;
        await place.getByRole("button", { name, exact: true }).first().click();
      };
      const type = async (label, value) => {
        actions += 1;
        const field = page.getByLabel(label, { exact: true });
        await field.fill(String(value));
        await field.press("Enter");
      };
      const drag = async (from, to) => {
        actions += 1;
        const [first, last] = [await middle(playground, from), await middle(playground, to)];
        await page.mouse.move(first.x, first.y);
        await page.mouse.down();
        await page.mouse.move(last.x, last.y, { steps: 4 });
        await page.mouse.up();
      };
      await press("New");
      actions += 1;
      await page.getByLabel("Columns").fill("40");
      await type("Rows", 24);
      await playground.says(/^No plan yet/);

      await drawFloor({ press, type, drag });

      await press("Robot");
      await press("Several");
      await drag([1, 1], [1, 15]);
      await drag([38, 1], [38, 15]);
      await press("as many back");
      await type("Waypoints of each", 2);
      await type("Battery, steps", 80);
      await type("Level at the start", 60);
      await audit(playground, "robots that are to be added");
      await playground.picture(`floor-robots-${theme}`);
      await press("Solve");
      assert.ok(actions <= MOST_ACTIONS, `${actions} actions`);
      await eventually("the floor", () => playground.inspector.innerText(), (text) => DEPOT.test(text));
      await eventually("a plan with what is proved", () => playground.status.textContent(), (text) => /^(Optimal|Best so far|At most)/.test(text), 60_000);
      await playground.press("Undo");
      await playground.press("Undo");
      await eventually("no robots", () => playground.inspector.innerText(), (text) => /4 chargers, 21 slow cells, 234 obstacles/.test(text) && !/16 robots/.test(text));
    }, { screens: ["desktop"], theme, reducedMotion: "reduce" });
  }

  flow(`of 16 robots in a pasted table is drawn and solved in ${MOST_WITH_TABLE} actions`, async (playground, { page }) => {
    await playground.says(/^Optimal/);
    let actions = 0;
    const act = async (deed) => {
      actions += 1;
      await deed();
    };
    const press = (name) => act(() => page.getByRole("button", { name, exact: true }).first().click());
    const type = (label, value) => act(async () => {
      const field = page.getByLabel(label, { exact: true });
      await field.fill(String(value));
      await field.press("Enter");
    });
    const drag = (from, to) => act(() => dragged(playground, page, from, to));
    await press("New");
    await act(() => page.getByLabel("Columns").fill("40"));
    await type("Rows", 24);
    await playground.says(/^No plan yet/);
    await drawFloor({ press, type, drag });
    const rows = Array.from({ length: 16 }, (_, i) => {
      const row = 1 + 2 * (i % 8);
      const [start, goal] = i < 8 ? [1, 38] : [38, 1];
      return `A${i + 1}\t${start}, ${row}\t${goal}, ${row}\t80\t60`;
    });
    await act(() => pasted(page, ["Name\tStart\tGoal\tBattery\tAt the start", ...rows].join("\n")));
    await press("Solve");
    assert.ok(actions <= MOST_WITH_TABLE, `${actions} actions`);
    await eventually("the floor", () => playground.inspector.innerText(), (text) => DEPOT.test(text));
    await eventually("a plan with what is proved", () => playground.status.textContent(), (text) => /^(Optimal|Best so far|At most)/.test(text), 60_000);
  }, { screens: ["desktop"], reducedMotion: "reduce" });

  flow("has parts that are framed, repeated, moved and erased", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    await page.getByRole("button", { name: "New", exact: true }).click();
    await page.getByLabel("Columns").fill("20");
    await page.getByLabel("Rows").fill("14");
    await page.getByLabel("Rows").press("Enter");
    await playground.says(/^No plan yet/);
    await playground.pick("Obstacle");
    await page.getByRole("button", { name: "Rectangle", exact: true }).click();
    await dragged(playground, page, [3, 2], [8, 3]);
    await playground.pick("Select");
    await dragged(playground, page, [9, 4], [2, 1]);
    const bar = page.getByRole("toolbar", { name: /^8 by 4 cells, 12 obstacles/ });
    await bar.waitFor();
    await page.keyboard.press("Escape");
    await dragged(playground, page, [2, 2], [8, 3]);
    await page.keyboard.press("Control+d");
    await page.getByLabel("Copies", { exact: true }).fill("2");
    await page.getByLabel("Copies", { exact: true }).press("Enter");
    await audit(playground, "an area that is repeated");
    await playground.picture("floor-area");
    await page.getByRole("button", { name: "Do it" }).click();
    await playground.cellTells(3, 5, /^obstacle$/);
    await playground.cellTells(8, 9, /^obstacle$/);
    await playground.board.focus();
    for (const key of ["ArrowRight", "ArrowRight", "Enter"]) {
      await page.keyboard.press(key);
    }
    await playground.cellTells(10, 2, /^obstacle$/);
    await playground.cellTells(3, 2, /^free$/);
    await page.keyboard.press("Delete");
    await playground.cellTells(10, 2, /^free$/);
    await page.keyboard.press("Control+z");
    await playground.cellTells(10, 2, /^obstacle$/);
  }, { screens: ["desktop"] });

  flow("has its robots in a table that keys edit", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    await page.getByRole("tab", { name: "Robots" }).click();
    const grid = page.getByRole("grid", { name: "Robots" });
    const cell = (row, column) => grid.locator("tbody tr").nth(row).locator("td").nth(column + 1);
    await cell(0, 4).click();
    await page.keyboard.type("55");
    await page.keyboard.press("Tab");
    await page.keyboard.type("44");
    await page.keyboard.press("Enter");
    await eventually("the battery", () => cell(0, 4).innerText(), (text) => text === "55");
    await eventually("its level", () => cell(0, 5).innerText(), (text) => text === "44");
    await cell(0, 1).dblclick();
    await page.keyboard.press("Control+a");
    await page.keyboard.type("99, 99");
    await page.keyboard.press("Enter");
    await grid.getByText("(99, 99) is not on the map.").waitFor();
    await audit(playground, "a table with a fault");
    await playground.picture("floor-table");
    await page.keyboard.press("Escape");
    await eventually("no fault", () => grid.locator(".rfault").count(), (count) => count === 0);
  }, { screens: ["desktop"] });

  flow("gets rows above and loses columns after it was asked", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    await page.getByText("Edit scene", { exact: true }).click();
    await page.getByRole("button", { name: "Rows and columns at any side" }).click();
    await page.getByRole("button", { name: "Rows above: one more" }).click();
    await page.getByRole("button", { name: "Columns at the right: one less" }).click();
    await audit(playground, "the size of the floor");
    await playground.picture("floor-size");
    await page.getByRole("button", { name: /^Make it/ }).click();
    await eventually("a row more", () => playground.board.getAttribute("aria-rowcount"), (rows) => Number(rows) > 1);
  }, { screens: ["desktop"] });

  flow("is drawn by keys: a shape is stretched by arrows", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    await playground.board.focus();
    for (const key of ["s", "2", "Control+Home", "Home", "ArrowDown", "ArrowDown", "Enter", "ArrowRight", "ArrowUp", "Enter"]) {
      await page.keyboard.press(key);
    }
    await playground.cellTells(0, 1, /slow zone/);
    await playground.cellTells(0, 2, /slow zone/);
    await page.keyboard.press("Control+z");
    await playground.cellTells(0, 1, /^free$/);
  }, { screens: ["desktop"] });

  flow("is drawn on a phone: the shapes lie below the board", async (playground, { page }) => {
    await playground.says(/^Optimal/);
    await playground.pick("Obstacle");
    await page.getByRole("group", { name: "Shape" }).getByRole("button", { name: "Rectangle" }).tap();
    await audit(playground, "shapes on a phone");
    await playground.picture("floor-shapes");
    await playground.stroke([0, 1], [0, 1]);
    await playground.cellTells(0, 1, /^obstacle$/);
  }, { screens: ["phone"] });
});

/** The middle of a cell on the screen: of a large floor not every cell is an element. */
function middle(playground, [x, y]) {
  return playground.board.evaluate((board, [x, y]) => {
    const { a, e, f } = board.getScreenCTM();
    return { x: (100 * x + 50) * a + e, y: (100 * y + 50) * a + f };
  }, [x, y]);
}

/** Racks with aisles, a slow zone and chargers, as a person draws them. */
async function drawFloor({ press, type, drag }) {
  await press("Obstacle");
  await press("Racks");
  await drag([4, 3], [28, 10]);
  await type("Width of an aisle, cells", 2);
  await drag([4, 14], [28, 19]);
  await press("Aisle");
  await drag([12, 14], [13, 19]);
  await drag([21, 14], [22, 19]);
  await press("Slow zone");
  await drag([31, 8], [33, 14]);
  await press("Charger");
  await type("From one charger to the next, cells", 2);
  await drag([0, 9], [0, 15]);
}

async function dragged(playground, page, from, to) {
  const [first, last] = [await middle(playground, from), await middle(playground, to)];
  await page.mouse.move(first.x, first.y);
  await page.mouse.down();
  await page.mouse.move(last.x, last.y, { steps: 4 });
  await page.mouse.up();
}

/** A text is pasted where nothing has the focus. */
function pasted(page, text) {
  return page.evaluate((text) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", text);
    document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  }, text);
}
