// A large floor is drawn and filled: how long the main thread is busy at a time.

import { SOLVED, figure, inPage } from "./figure.mjs";
import { Tab } from "./process.mjs";

const SIDE = 128;
const ROBOTS = 300;
/** How long the browser may need to tell of a long task, in milliseconds. */
const SETTLED = 1000;

/** Racks in rows, and robots at the left side that go to the right side. */
function scene() {
  const row = (y) => (y % 4 < 2 ? ".".repeat(SIDE) : "....".concat("######..".repeat(15), "...."));
  const map = Array.from({ length: SIDE }, (_, y) => row(y).slice(0, SIDE));
  const rows = map.flatMap((line, y) => (line.includes("#") ? [] : [y]));
  const agents = Array.from({ length: ROBOTS }, (_, n) => {
    const [y, x] = [rows[n % rows.length], Math.floor(n / rows.length)];
    return { name: `A${n + 1}`, start: [x, y], goal: [SIDE - 1 - x, y] };
  });
  return { giveway: 1, name: "large floor", map, agents };
}

/** The longest task of each deed on a floor of 128 x 128 cells with 300 robots. */
export function floor(url) {
  return inPage(url, async (playground, browser) => {
    const { page } = playground;
    await playground.says(SOLVED);
    await playground.open({ name: "large-floor.json", bytes: JSON.stringify(scene()) });
    await playground.shows("large floor");
    if (await playground.button("Cancel").isVisible()) {
      await playground.press("Cancel");
    }
    await page.waitForTimeout(SETTLED);
    const tab = await Tab.of(browser);
    const figures = [];
    const measure = async (what, most, deed) => {
      await browser.startTracing(page, { categories: ["toplevel"] });
      const from = await page.evaluate(() => performance.now());
      await deed();
      await page.waitForTimeout(SETTLED);
      const tasks = await page.evaluate((from) => window.seen.longTasks.filter(({ startTime }) => startTime >= from), from);
      const longest = Math.max(0, ...tasks.map(({ duration }) => duration));
      const trace = JSON.parse(await browser.stopTracing());
      const busiest = Math.max(0, ...tab.tasks(trace).map(({ tdur }) => tdur)) / 1000;
      figures.push(
        figure(`longest task, ${what}, ${ROBOTS} robots on ${SIDE} x ${SIDE} cells`, longest, "ms", { most, below: 50 }),
        figure("the same in processor time", busiest, "ms of CPU", { most }),
      );
    };
    const button = (name) => page.getByRole("button", { name, exact: true }).first();
    await button("Obstacle").click();
    await button("Pen").click();
    const hand = await begun(page, [60, 1]);
    await measure("painting", 50, () => hand.go([90, 1], 30));
    await page.mouse.up();
    await button("Fill").click();
    await measure("filling", 100, async () => (await begun(page, [60, 5])).up());
    await page.keyboard.press("Control+z");
    await button("Select").click();
    const frame = await begun(page, [40, 0]);
    await measure("framing an area", 50, () => frame.go([80, 40], 30));
    await frame.up();
    const move = await begun(page, [60, 20]);
    await measure("dragging an area", 50, () => move.go([60, 50], 30));
    await measure("moving an area", 100, () => move.up());
    await page.keyboard.press("Control+c");
    await page.keyboard.press("Escape");
    await measure("pasting an area", 100, async () => {
      await page.keyboard.press("Control+v");
      await page.keyboard.press("Enter");
    });
    await page.keyboard.press("Escape");
    await page.keyboard.press("Escape");
    const robot = await begun(page, [2, 8]);
    await measure("dragging a robot", 50, () => robot.go([2, 40], 30));
    await measure("dropping a robot", 100, () => robot.up());
    return figures;
  });
}

/** A hand that is down on a cell. */
async function begun(page, cell) {
  const place = ([x, y]) => page.locator("svg.map[data-board=main]").evaluate((board, [x, y]) => {
    const { a, e, f } = board.getScreenCTM();
    return { x: (100 * x + 50) * a + e, y: (100 * y + 50) * a + f };
  }, [x, y]);
  const first = await place(cell);
  await page.mouse.move(first.x, first.y);
  await page.mouse.down();
  return {
    go: async (to, steps) => {
      const last = await place(to);
      await page.mouse.move(last.x, last.y, { steps });
    },
    up: () => page.mouse.up(),
  };
}
