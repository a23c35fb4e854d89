// Many robots on a large map: the overview, a robot found by its name, followed, and the
// conflicts of one robot after the other.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { lines, octile } from "./elsewhere.mjs";
import { flows, LOOKS, MOVING } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const SIDE = 128;
const ROBOTS = 60;
/** Columns that each robot goes to the right, in a row of its own. */
const WAY = 100;

/** Every robot goes to the right; the second one meets the first one, and then the third. */
function plan() {
  const paths = {};
  for (let n = 0; n < ROBOTS; n += 1) {
    paths[n] = Array.from({ length: WAY }, (_, step) => [2 + step, 2 * n]);
  }
  const waits = (cell, steps) => Array.from({ length: steps }, () => cell);
  paths[2] = [...waits([2, 4], 20), ...paths[2]];
  paths[1] = [...waits([12, 2], 9), [12, 1], [12, 0], [12, 1], ...waits([12, 2], 17), [12, 3], [12, 4], [12, 3], ...paths[1].slice(10)];
  return paths;
}

function files() {
  const map = Array.from({ length: SIDE }, (_, y) => (y % 2 === 1 ? ".".repeat(16).concat("####....".repeat(14)) : ".".repeat(SIDE)));
  return [
    { name: "large.map", bytes: octile(map) },
    { name: "paths.txt", bytes: lines(plan()) },
  ];
}

const frame = (playground) => playground.board.getAttribute("viewBox").then((box) => box.split(" ").map(Number));
const overview = ({ page }) => page.getByRole("img", { name: /^Overview: / });

async function opened(playground) {
  await playground.open(...files());
  await playground.says(/^paths\.txt breaks rules \d+ times\./);
}

/** Types a name into the field, which selects the first robot that it fits. */
async function find(playground, name, heading = name) {
  await playground.page.getByRole("textbox", { name: "Name of the robot" }).fill(name);
  await playground.inspector.getByRole("heading", { name: heading, exact: true }).waitFor();
}

const field = ({ page }) => page.getByRole("search");

describe("a large map", () => {
  const flow = flows();

  flow("a robot is found by its name, with keys, and is in view", async (playground, { page }) => {
    await opened(playground);
    assert.equal(await overview(playground).count(), 0, "all of the map is in sight");
    await playground.board.focus();
    await playground.key("/");
    await find(playground, "4", "A4");
    await field(playground).getByText(/^1 of \d+$/).waitFor();
    await playground.picture("find");
    await playground.key("Enter");
    await field(playground).getByText(/^2 of \d+$/).waitFor();
    await playground.key("ArrowUp");
    await playground.inspector.getByRole("heading", { name: "A4", exact: true }).waitFor();
    await playground.key("Escape");
    await field(playground).waitFor({ state: "detached" });
    await eventually("to be nearer", () => frame(playground), ([, , width]) => width < 12_800);
    const [x, y, width, height] = await frame(playground);
    assert.ok(x <= 200 && y <= 600 && x + width > 300 && y + height > 700, "its cell is in sight");
    // Whoever does not see the board is at its cell.
    await eventually("the focus to be on the board", () => page.evaluate(() => document.activeElement.getAttribute("aria-label")), (name) => name === "Board");
    const cell = await playground.board.getAttribute("aria-activedescendant");
    assert.match(await page.locator(`[id="${cell}"]`).getAttribute("aria-label"), /^2, 6: start of A4/);
    await playground.picture("found");
    await overview(playground).waitFor();
  });

  flow("the overview moves what is in sight", async (playground, { page }) => {
    await opened(playground);
    await playground.key("+", "+", "+");
    const map = overview(playground);
    await map.waitFor();
    const { x, y, width, height } = await map.boundingBox();
    await page.mouse.click(x + width * 0.9, y + height * 0.9);
    const [left, top] = await eventually("to be at the lower right", () => frame(playground), ([left, top]) => left > 4000 && top > 8000);
    assert.match(await map.getAttribute("aria-label"), /^Overview: columns \d+ to 127 and rows \d+ to 127 of 128 x 128 cells are in sight$/);
    await page.mouse.move(x + width * 0.9, y + height * 0.9);
    await page.mouse.down();
    await page.mouse.move(x + width * 0.3, y + height * 0.4, { steps: 4 });
    await page.mouse.up();
    await eventually("to be dragged back", () => frame(playground), ([a, b]) => a < left && b < top);
    await playground.picture("overview");
    await playground.key("0");
    await map.waitFor({ state: "detached" });
  });

  flow("a robot is followed until the map is moved by hand", async (playground, { page }) => {
    await opened(playground);
    await playground.key("/");
    await find(playground, "A9");
    await playground.key("Escape", "f");
    const follow = page.getByRole("button", { name: "Follow A9" });
    await eventually("to follow", () => follow.getAttribute("aria-pressed"), (pressed) => pressed === "true");
    await playground.press("Play");
    const [before] = await frame(playground);
    await eventually("the board to go along", () => frame(playground), ([now]) => now > before + 200);
    await playground.picture("following-large");
    const { x, y, width, height } = await playground.board.boundingBox();
    await page.mouse.move(x + width * 0.2, y + height * 0.2);
    await page.mouse.down();
    await page.mouse.move(x + width * 0.1, y + height * 0.1, { steps: 4 });
    await page.mouse.up();
    await eventually("to be left", () => follow.getAttribute("aria-pressed"), (pressed) => pressed === "false");
    const [stays] = await frame(playground);
    const from = await playground.now();
    await playground.reaches("two steps later", (now) => now >= from + 2);
    assert.equal((await frame(playground))[0], stays, "the board stands still");
  }, MOVING);

  flow("the conflicts of one robot are gone through", async (playground) => {
    await opened(playground);
    const says = (pattern) => eventually(`the inspector to say ${pattern}`, () => playground.inspector.innerText(), (text) => pattern.test(text));
    await playground.key("/");
    await find(playground, "A2");
    await playground.key("Escape");
    await says(/A2 takes part in \d+ conflicts\./);
    await playground.press("Next conflict");
    await says(/Conflict 1 of \d+, at time \d+: /);
    const first = await playground.now();
    await playground.picture("next-conflict");
    await playground.press("Next conflict");
    await says(/Conflict 2 of \d+, at time \d+: /);
    const count = Number((await playground.inspector.innerText()).match(/Conflict 2 of (\d+)/)[1]);
    for (let next = 2; next <= count; next += 1) {
      await playground.press("Next conflict");
    }
    await says(/Conflict 1 of /);
    assert.equal(await playground.now(), first, "after the last comes the first");
    await playground.key("/");
    await find(playground, "A30");
    await playground.key("Escape");
    await says(/No conflict of A30\./);
    await playground.key("n");
    await playground.warns(/No conflict of A30\./);
  });

  flow("a phone finds a robot by touch", async (playground, { page }) => {
    await opened(playground);
    await playground.press("Find a robot");
    await find(playground, "59", "A59");
    await playground.picture("find");
    const { height } = await field(playground).boundingBox();
    assert.ok(height >= 44, `the field is ${height} high`);
    await field(playground).getByRole("button", { name: "Close" }).tap();
    await overview(playground).waitFor();
    await playground.picture("found");
    const { width } = await overview(playground).boundingBox();
    assert.ok(width <= 100, `the overview is ${width} wide`);
    await page.getByRole("button", { name: "Fit", exact: true }).tap();
    await overview(playground).waitFor({ state: "detached" });
  }, { screens: ["phone"] });

  for (const { theme, screens } of LOOKS) {
    flow(`the audit finds nothing, ${theme}`, async (playground) => {
      await opened(playground);
      await playground.press("Find a robot");
      await find(playground, "A5");
      await audit(playground, "finding");
      await playground.key("Escape");
      await overview(playground).waitFor();
      await audit(playground, "found");
      await playground.picture(`large-${theme}`);
    }, { theme, screens, reducedMotion: "reduce" });
  }
});
