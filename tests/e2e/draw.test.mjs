// A floor is drawn by shapes and filled with robots in rows: the actions are counted.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { LOOKS, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const DEPOT = /16 robots, 4 chargers, 21 slow cells, 234 obstacles/;
/** Presses, drags and typed fields from an empty page to a plan. */
const MOST_ACTIONS = 25;

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
