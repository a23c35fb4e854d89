// The page opens on a solved, playing example; time goes where it is told to go.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows, MOVING } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const OPENING = /^Optimal: makespan 18, sum of costs 35, 3 charges\.$/;
/** What a step takes at speed 1, in milliseconds. */
const STEP_MS = 480;
/** The page has a clock that can be put forward: nobody waits until a plan has been played. */
const CLOCK = { ...MOVING, fresh: true, before: (context) => context.clock.install() };

describe("playing", () => {
  const flow = flows();

  flow("opens on the warehouse, solved and playing", async (playground) => {
    await playground.shows("warehouse");
    await playground.says(OPENING);
    await playground.button("Pause").waitFor();
    const time = await playground.reaches("2 or later", (now) => now >= 2);
    await playground.picture("opening");
    await playground.reaches(`later than ${time}`, (now) => now > time);
    assert.equal(await playground.time.getAttribute("aria-valuemax"), "18");
  }, { screens: BOTH, ...MOVING });

  flow("stops at the end by itself, and starts anew from there", async (playground, { page }) => {
    await playground.says(OPENING);
    await playground.button("Pause").waitFor();
    await page.clock.runFor(20 * STEP_MS);
    await playground.button("Play").waitFor();
    assert.equal(await playground.now(), 18);
    await playground.picture("end");
    await playground.press("Play");
    await playground.reaches("an early one", (now) => now < 9);
    await playground.button("Pause").waitFor();
  }, CLOCK);

  flow("takes a press at once where a press of another button has turned it", async (playground, { page }) => {
    await playground.says(OPENING);
    await playground.button("Pause").waitFor();
    await playground.reaches("2 or later", (now) => now >= 2);
    await playground.press("To start");
    await playground.button("Play").waitFor();
    // Whether it rests is not waited for.
    await page.locator(".playb").click({ force: true });
    await playground.button("Pause").waitFor();
  }, MOVING);

  flow("takes keys that come before the page was drawn anew", async (playground, { page }) => {
    await playground.says(OPENING);
    await playground.pause();
    await playground.press("To start");
    // One task for all of them: nothing is rendered in between, as on a slow machine.
    await page.evaluate(() => {
      for (const key of [".", ".", " ", " "]) {
        document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
      }
    });
    await playground.button("Play").waitFor();
    await playground.reaches(2);
  });

  flow("shows on the board what the plan says, at every time", async (playground) => {
    await playground.says(OPENING);
    await playground.pause();
    await playground.press("To start");
    const last = {};
    for (let time = 0; time <= 18; time += 1) {
      await playground.reaches(time);
      const rows = await playground.planRows();
      const column = rows[0].indexOf(String(time));
      assert.notEqual(column, -1, `the table has no column ${time}: ${rows[0]}`);
      for (const agent of ["A1", "A2"]) {
        const row = rows.find(([name]) => name.startsWith(agent));
        // The row of one that has arrived is at its end: it stays where it is.
        last[agent] = row[column] || last[agent];
        await agrees(playground, agent, last[agent], time);
      }
      if (time < 18) {
        await playground.press("Step forward");
      }
    }
  }, MOVING);

  flow("goes by buttons", async (playground) => {
    await playground.says(OPENING);
    const time = await playground.pause();
    await playground.press("Step forward");
    await playground.reaches(time + 1);
    await playground.press("Step back");
    await playground.reaches(time);
    await playground.press("To end");
    await playground.reaches(18);
    await playground.press("To start");
    await playground.reaches(0);
    assert.equal(await playground.button("Step back").isDisabled(), true);
    await playground.press("Play");
    await playground.reaches("1 or later", (now) => now >= 1);
  }, { screens: BOTH, ...MOVING });

  flow("goes to a time that is typed", async (playground, { page }) => {
    await playground.says(OPENING);
    await playground.pause();
    const field = page.getByRole("textbox", { name: "Time, 0 to 18" });
    await field.fill("7");
    await field.press("Enter");
    await playground.reaches(7);
    // It ends at the last time.
    await field.fill("99");
    await field.press("Enter");
    await playground.reaches(18);
    await field.fill("3");
    await field.press("Escape");
    await playground.reaches(18);
    assert.equal(await field.inputValue(), "18");
  }, { screens: BOTH, ...MOVING });

  flow("goes by keys", async (playground) => {
    await playground.says(OPENING);
    await playground.reaches("1 or later", (now) => now >= 1);
    await playground.key("Space");
    await playground.button("Play").waitFor();
    await playground.key("Home");
    await playground.reaches(0);
    await playground.key(".", ".", ".");
    await playground.reaches(3);
    await playground.key(",");
    await playground.reaches(2);
    await playground.key("End");
    await playground.reaches(18);
    await playground.key("Space");
    await playground.button("Pause").waitFor();
    await playground.reaches("an early one", (now) => now < 9);
  }, MOVING);

  flow("goes where the slider is put", async (playground) => {
    await playground.says(OPENING);
    await playground.pause();
    await playground.time.focus();
    await playground.key("Home");
    await playground.reaches(0);
    await playground.key("ArrowRight", "ArrowRight");
    await playground.reaches(2);
    await playground.key("ArrowLeft");
    await playground.reaches(1);
    await playground.key("PageUp");
    await playground.reaches(6);
    await playground.key("End");
    await playground.reaches(18);
    const track = await playground.time.boundingBox();
    const middle = track.y + track.height / 2;
    const { mouse } = playground.page;
    await mouse.move(track.x + 40, middle);
    await mouse.down();
    const from = await playground.reaches("an early one", (now) => now < 9);
    await mouse.move(track.x + 160, middle, { steps: 5 });
    await mouse.up();
    await playground.reaches("a later one", (now) => now > from);
  }, { screens: BOTH, ...MOVING });

  flow("goes as fast as it is told to", async (playground) => {
    await playground.says(OPENING);
    await playground.pause();
    const slow = await timeFor(playground, "\u{bd}", 3);
    const fast = await timeFor(playground, "4\u{d7}", 3);
    assert.ok(slow > 5.5 * STEP_MS && slow < 7 * STEP_MS, `3 steps took ${slow} ms at half the speed`);
    assert.ok(fast < slow / 6, `3 steps took ${slow} ms at half the speed and ${fast} ms at four times of it`);
  }, { ...CLOCK, screens: BOTH });
});

/** That an agent is on the board where the table has it. */
async function agrees(playground, agent, entry, time) {
  const [, x, y] = entry.match(/^\(?(\d+), ?(\d+)\)?$/) ?? [];
  if (x === undefined) {
    // In transit it is on two cells.
    const words = await playground.board.getByRole("gridcell").evaluateAll((cells) => cells.map((cell) => cell.ariaLabel));
    for (const way of ["leaves", "comes"]) {
      assert.ok(words.some((cell) => cell.includes(`${agent} ${way}`)), `${agent} ${way} no cell at ${time}, the table has ${entry}`);
    }
    return;
  }
  const here = time === 0 ? `start of ${agent}` : `${agent} is here`;
  await playground.cellTells(x, y, new RegExp(here));
}

/** Plays some steps from the start at a speed; how long that takes by the page's clock, in milliseconds. */
async function timeFor(playground, speed, steps) {
  const { clock } = playground.page;
  await setSpeed(playground, speed);
  await playground.press("To start");
  await playground.reaches(0);
  // The robots are there, too.
  await clock.runFor(4 * STEP_MS);
  await clock.pauseAt(await playground.page.evaluate(() => Date.now() + 1000));
  await playground.press("Play");
  let time = 0;
  while (await playground.now() < steps) {
    assert.ok(time < 20 * STEP_MS, `it plays no ${steps} steps`);
    await clock.runFor(80);
    time += 80;
  }
  await clock.resume();
  if (await playground.button("Pause").isVisible()) {
    await playground.pause();
  }
  return time;
}

/** Where there is little room, one button goes from speed to speed. */
async function setSpeed(playground, speed) {
  if (await playground.button(speed).isVisible()) {
    await playground.press(speed);
    assert.equal(await playground.button(speed).getAttribute("aria-pressed"), "true");
    return;
  }
  const next = playground.page.getByRole("button", { name: /^Speed / });
  await eventually(`the speed ${speed}`, async () => {
    const name = await next.innerText();
    if (!name.includes(speed)) {
      await next.click();
    }
    return name;
  }, (name) => name.includes(speed));
}
