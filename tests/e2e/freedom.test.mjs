// What all best plans share: laid over the best plan, cut off, closed cells, another plan as good.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { BOTH, LOOKS, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

/** Two robots may choose, the third has no choice: 3 x 1 x 5 best plans. */
const THREE_WAYS = {
  giveway: 1,
  name: "three ways",
  map: ["##......", "##......", "#...#...", "......##", "#.#....."],
  agents: [
    { name: "A1", start: [6, 1], goal: [4, 3] },
    { name: "A2", start: [7, 2], goal: [1, 4] },
    { name: "A3", start: [3, 2], goal: [7, 0] },
  ],
};

const QUESTION = "What do all best plans share?";
const COUNTED = /^Optimal: makespan 8, .* There are 15 such plans\.$/;

describe("what must be so", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`is laid over the plan and told (${theme})`, async (playground) => {
      await solve(playground);
      await playground.press(QUESTION);
      await settled(playground);
      const { inspector } = playground;
      await inspector.getByRole("heading", { name: "What all best plans share" }).waitFor();
      const text = await inspector.innerText();
      assert.match(text, /11 of 19 steps are the same in every best plan\./);
      assert.match(text, /A1\s[^]*3 ways\s+A2\s+every step is fixed\s+1 way\s+A3\s[^]*5 ways/);
      assert.match(text, /3 × 1 × 5 = 15 best plans/);
      assert.match(text, /A2 decides the makespan\s+one step late makes it 9/);
      assert.match(text, /Close \(1, 3\): no plan is left\s+Close \(5, 2\): makespan 10, not 8\s+and 4 more cells that cost 2 steps of the makespan/);
      // Who does not see the board hears the numbers from its cells.
      await playground.cellTells(5, 2, /, closing it costs 2 steps of the makespan$/);
      await playground.cellTells(1, 3, /, closing it leaves no plan$/);
      await playground.cellTells(3, 1, /, closing it costs 2 steps in all$/);
      await audit(playground, "what must be so");
      await playground.picture(`freedom-${theme}`);
      await playground.showTab("Timeline");
      await lane(playground, /^A2: .*, 8 of 8 steps in every best plan$/).waitFor();
      await lane(playground, /^A3: .*, 1 of 6 steps in every best plan$/).waitFor();
      // Labels are wider then: the line of the time stands where its number does.
      const [line, thumb] = await Promise.all([".head", ".thumb"].map((part) => playground.page.locator(`#lanes ${part}`).boundingBox()));
      assert.ok(Math.abs(line.x + line.width / 2 - thumb.x) < 1.5, `${line.x} and ${thumb.x}`);
      await playground.picture(`freedom-lanes-${theme}`);
      await playground.showTab("Inspector");
      await inspector.getByRole("button", { name: "Whole plan" }).click();
      await playground.says(/^Optimal: makespan 8, sum of costs 19, 0 charges\.$/);
      await playground.cellTells(5, 2, /^[^,]*$/);
    }, { screens, theme });
  }

  flow("is asked, looked at and closed by keys alone", async (playground, { page }) => {
    await solve(playground);
    await playground.board.focus();
    await playground.key("m");
    await playground.says(COUNTED);
    const chip = playground.button("What all best plans share");
    assert.equal(await chip.getAttribute("aria-pressed"), "true");
    await goTo(playground, 5, 2);
    await playground.key("Enter");
    await playground.inspector.getByText("A2 must be here at time 2.").waitFor();
    await settled(playground, /A1 must be here at time 3\./);
    const close = playground.inspector.getByRole("button", { name: "Close (5, 2): makespan 10, not 8" });
    await close.focus();
    await playground.key("Enter");
    await playground.says(/^Optimal: makespan 10/);
    const card = playground.inspector.getByRole("group", { name: "Closed for a look" });
    assert.match(await card.innerText(), /\(5, 2\) is closed\s+Makespan 10, not 8\./);
    await playground.cellTells(5, 2, /^obstacle/);
    // Beside it, the cell is open still, and robots pass.
    await playground.cellTells(5, 2, /^free/, playground.other);
    await page.getByText("while the cell was open").waitFor();
    await audit(playground, "a closed cell");
    await playground.picture("freedom-closed");
    await playground.key("Escape");
    await playground.says(COUNTED);
    // The cell is selected as it was before.
    await playground.key("Escape", "Escape");
    await playground.says(/0 charges\.$/);
    assert.equal(await chip.getAttribute("aria-pressed"), "false");
    await playground.key("?");
    await page.getByRole("dialog", { name: "Keys" }).getByText("What all best plans share").waitFor();
  });

  flow("closes the cell whose number is pressed, and opens it", async (playground, { page }) => {
    await shown(playground);
    const number = await corner(playground, 5, 3);
    await (playground.isPhone() ? page.touchscreen.tap(number.x, number.y) : page.mouse.click(number.x, number.y));
    await playground.says(/^Optimal: makespan 10/);
    await playground.press("Open it again");
    await playground.says(COUNTED);
    await playground.press("Close (1, 3): no plan is left");
    await playground.says(/^No plan exists/);
    await playground.picture("freedom-no-plan");
    await playground.press("Undo");
    await playground.says(COUNTED);
    await playground.press("Redo");
    await playground.says(/^No plan exists/);
    await playground.press("Open it again");
    await playground.says(COUNTED);
  }, { screens: BOTH });

  flow("shows another plan as good that differs most", async (playground) => {
    await shown(playground);
    await playground.inspector.getByText("In it robots are elsewhere 6 times. No best plan differs in more.").waitFor();
    if (playground.isPhone()) {
      await playground.press("Show it beside this one");
      await playground.other.waitFor();
      await playground.showTab("Timeline");
      await playground.press("Step forward");
      await playground.reaches(1);
      await playground.picture("freedom-other");
      await playground.showTab("Inspector");
      await playground.press("One plan");
    } else {
      await playground.press("Show it beside this one");
      await playground.other.waitFor();
      await playground.press("Step forward");
      await playground.reaches(1);
      await audit(playground, "another plan as good");
      await playground.picture("freedom-other");
      await playground.press("One plan");
      await playground.other.waitFor({ state: "detached" });
    }
    await playground.says(COUNTED);
  }, { screens: BOTH });

  flow("is asked of a robot and of a cell", async (playground) => {
    await solve(playground);
    await playground.cell(6, 1).click();
    await playground.press("Could A1 be later?");
    await playground.inspector.getByText(/^A1 could (be \d steps? late|not be late) without harm\.$/).waitFor();
    await playground.inspector.getByText("It has 3 ways to choose from.").waitFor();
    await playground.picture("freedom-robot");
    await playground.cell(2, 3).click();
    await playground.inspector.getByText("A2 must be here at time 6.").waitFor();
    await playground.cell(4, 0).click();
    await playground.inspector.getByText(/^A3 (may pass here: in another best plan it does|need not be here at time \d)\.$/).waitFor();
  }, { screens: BOTH });

  flow("ends with an edit, is cut off, goes on, and comes back with undo", async (playground) => {
    await playground.example("Ten robots");
    await playground.says(/^Optimal: /);
    await playground.press(QUESTION);
    await playground.says(/^(Looking for|Counting|Closing cells|Checking that)/);
    await playground.press("Cancel");
    await playground.inspector.getByText("You stopped it. Results may be incomplete.").waitFor();
    await playground.picture("freedom-cut-off");
    await audit(playground, "cut off");
    await playground.press("Look for the rest");
    await playground.says(/^(Looking for|Counting|Closing cells|Checking that)/);
    await playground.pick("Obstacle");
    await playground.cell(0, 0).click();
    await playground.says(/^(The plan above is of the scene before|The scene has changed)/);
    await eventually("the column to go", () => playground.inspector.getByRole("heading", { name: "What all best plans share" }).count(), (n) => n === 0);
    await playground.press("Undo");
    await playground.inspector.getByText("You stopped it. Results may be incomplete.").waitFor();
  });

  flow("is refused where no plan is proved best, and says why", async (playground) => {
    await playground.open(file());
    await playground.shows("three ways");
    await playground.board.focus();
    await playground.key("m");
    await playground.warns(/^Solve first: this is about the best plan\./);
  });

  flow("is saved with certificates of all of it, of a robot, of a cell", async (playground, { page }) => {
    await shown(playground);
    const certificates = async (words) => {
      const download = page.waitForEvent("download", { timeout: 60_000 });
      await playground.press(words);
      const saved = await download;
      assert.equal(saved.suggestedFilename(), "three-ways-certificate.zip");
      const told = await playground.warns(/three-ways-certificate\.zip is saved\./);
      assert.match(told, /It holds \d+ certificates?, all checked\./);
      assert.match(told, /giveway verify three-ways-certificate\.zip/);
      await playground.notice.getByRole("button", { name: "Dismiss" }).click();
      const bytes = readFileSync(await saved.path());
      assert.equal(bytes.subarray(0, 2).toString(), "PK");
      return bytes.toString("latin1");
    };
    const all = await certificates("Save all certificates");
    for (const file of ["best/manifest.json", "robot-2-at-3/manifest.json", "without-1-3/manifest.json"]) {
      assert.ok(all.includes(file), file);
    }
    await playground.inspector.getByRole("button", { name: /^A2/ }).first().click();
    const own = await certificates("Save its certificates");
    assert.ok(own.includes("robot-2-at-3/README.md") && !own.includes("robot-1-") && !own.includes("best/"));
    await playground.says(COUNTED);
  });

  flow("is saved as JSON", async (playground, { page }) => {
    await shown(playground);
    const download = page.waitForEvent("download");
    await playground.press("Save");
    await playground.press("Save what must be so");
    const saved = await download;
    assert.equal(saved.suggestedFilename(), "three-ways-freedom.json");
    const told = JSON.parse(readFileSync(await saved.path(), "utf8"));
    assert.deepEqual(told.plans.count, 15);
    assert.equal(told.critical.find(({ cell }) => `${cell}` === "1,3").status, "impossible");
  });
});

function file() {
  return { name: "three ways.json", bytes: JSON.stringify(THREE_WAYS) };
}

/** The scene with its best plan, at the start. */
async function solve(playground) {
  await playground.open(file());
  await playground.shows("three ways");
  await playground.press("Solve");
  await playground.says(/^Optimal: makespan 8/);
  await playground.reaches(8);
  await playground.press("To start");
  await playground.reaches(0);
  await playground.showTab("Inspector");
}

/** The same with all that must be so. */
async function shown(playground) {
  await solve(playground);
  await playground.press(QUESTION);
  await settled(playground);
}

/** Waits until all is known. */
async function settled(playground, pattern = /No best plan differs in more\./) {
  await playground.says(COUNTED);
  await eventually(`the inspector to tell ${pattern}`, () => playground.inspector.innerText(), (text) => pattern.test(text));
  await playground.says(COUNTED);
}

function lane(playground, name) {
  return playground.page.getByRole("img", { name });
}

/** Moves the cursor of the board, which has the focus. */
async function goTo(playground, x, y) {
  await playground.key("Control+Home");
  for (let at = 0; at < x; at++) {
    await playground.key("ArrowRight");
  }
  for (let at = 0; at < y; at++) {
    await playground.key("ArrowDown");
  }
}

/** Where the number of a cell is on the screen, in pixels. */
async function corner(playground, x, y) {
  const box = await playground.cell(x, y).boundingBox();
  return { x: box.x + 0.25 * box.width, y: box.y + 0.82 * box.height };
}
