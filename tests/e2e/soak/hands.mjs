// What a person does in passing: looks for a cell, closes what is in the way, sees to it that
// there is a plan.

import { eventually } from "../wait.mjs";
import { look } from "./told.mjs";

/** Examples that are solved within a second, each with the name of its scene. */
export const EXAMPLES = [
  ["Warehouse", "warehouse"],
  ["Who waits?", "scenario 1"],
  ["No way past", "scenario 6"],
  ["Nine cells", "nine cells"],
  ["Siding", "siding"],
  ["Swap", "swap"],
  ["Crossing", "crossing"],
  ["Roundabout", "roundabout"],
  ["Last in, first out", "last in"],
  ["Through the door", "door"],
  ["Short but slow", "short cut"],
  ["Detour to charge", "detour"],
  ["One charger for three", "one charger"],
];

/** The name of what begins the work that is due. */
const WORK = /^(Solve|Go on|Find new plans|Find again|Check my plan)$/;

/** What something that is there may take to be pressed, in milliseconds. */
const SOON = 5000;

/** The button that begins the work that is due. */
export function worker({ page }) {
  return page.getByRole("button", { name: WORK });
}

/** Presses a button if it is there to be pressed; whether it was. It may go just then. */
export async function pressIf(button) {
  const first = button.first();
  const soon = { timeout: SOON };
  if (!await first.isVisible() || !await first.isEnabled(soon).catch(() => false)) {
    return false;
  }
  return first.click(soon).then(() => true, () => false);
}

/** Closes what says or asks something, leaves the mode the page is in, and selects nothing. */
export async function home(sitting) {
  const { playground, page } = sitting;
  await sitting.calm();
  await pressIf(playground.button("Dismiss"));
  await pressIf(playground.inspector.getByRole("button", { name: "Back", exact: true }).and(page.locator(".crumb")));
  await pressIf(page.getByRole("button", { name: "Discard", exact: true }));
  await pressIf(page.getByRole("button", { name: "Whole plan", exact: true }));
  await playground.pick("Select");
}

/** Opens an example, and waits until it is on the board and solved. */
export async function openExample(playground, title) {
  const { page } = playground;
  await playground.example(title);
  await playground.shows(new Map(EXAMPLES).get(title));
  await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 50)));
  await eventually("the example to be solved", () => look(page), ({ works }) => !works);
}

/** Sees to it that the scene has a plan of now: another scene is opened where it can have none. */
export async function planned(sitting) {
  await home(sitting);
  const { playground } = sitting;
  for (const example of ["", "Who waits?"]) {
    if (example !== "") {
      await openExample(playground, example);
    }
    const { status } = await look(sitting.page);
    if (/scene has changed|No plan yet/i.test(status)) {
      await pressIf(worker(sitting));
      await sitting.calm();
      await pressIf(playground.button("Dismiss"));
    }
    if (await playground.time.count() > 0 && !/scene has changed/i.test((await look(sitting.page)).status)) {
      return;
    }
  }
  throw new Error("there is no plan, not even of an example");
}

/** Chooses what is to be asked or edited of one robot, and gives its name; `undefined` where there is none. */
export async function selectRobot(sitting) {
  const { inspector } = sitting.playground;
  const robots = inspector.getByRole("button", { name: /\(\d+, ?\d+\) to \(\d+, ?\d+\)/ });
  const count = await robots.count();
  if (count === 0) {
    return undefined;
  }
  const robot = robots.nth(sitting.dice.roll(count));
  const name = (await robot.locator("b").innerText()).trim();
  await robot.click();
  await inspector.getByRole("heading", { level: 2, name, exact: true }).waitFor();
  return name;
}

/** Opens what is edited beside the board, unless it is. */
export async function openEdit(sitting, title) {
  const summary = sitting.playground.inspector.locator("summary", { hasText: title });
  if (await summary.count() === 0) {
    return false;
  }
  if (!await summary.evaluate((element) => element.parentElement.open)) {
    await summary.click();
  }
  return true;
}

/** Types into a field of the inspector, and leaves it. */
export async function type(sitting, label, text) {
  const field = sitting.playground.inspector.getByLabel(label, { exact: true });
  await field.fill(String(text));
  await field.press("Tab");
}

/** The columns and rows of the board that have names. */
async function named(sitting) {
  const labels = await sitting.playground.board.getByRole("gridcell").evaluateAll((cells) => cells.map((cell) => cell.ariaLabel));
  return labels.map((label) => {
    const [, x, y, words] = label.match(/^(\d+), (\d+): (.*)$/s);
    return { at: [Number(x), Number(y)], words };
  });
}

/** A cell whose words are accepted; `undefined` where there is none. */
export async function cellOf(sitting, accepts) {
  const cells = (await named(sitting)).filter(({ words }) => accepts(words));
  return cells.length > 0 ? sitting.dice.pick(cells).at : undefined;
}

/** Takes a tool, and shows the board where something else has its place. */
export async function take(sitting, tool) {
  const { playground, page } = sitting;
  await pressIf(playground.button("Dismiss"));
  await pressIf(page.getByRole("button", { name: "Add a change on the board" }));
  if (!await playground.tools.isVisible()) {
    await home(sitting);
  }
  await playground.pick(tool);
  await playground.cell(0, 0).waitFor();
}

/** Draws from cell to cell, all of the map in sight. */
export async function draw(sitting, ...cells) {
  await pressIf(sitting.playground.button("Fit"));
  await sitting.playground.stroke(...cells);
}

/** Waits until a cell tells something else than these words, or a notice says why it does not. */
export function changes(sitting, [x, y], words) {
  return eventually(`cell ${x}, ${y} to change, or a notice`, async () => {
    const notice = (await look(sitting.page)).notice;
    const now = await sitting.playground.onCell(x, y).catch(() => "gone");
    return notice !== "" || now !== words;
  });
}
