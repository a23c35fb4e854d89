// Fingers on a phone: a tap, a stroke, a pinch, a swipe over the page.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { flows, MOVING } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const OPENING = /^Optimal: makespan 18/;

describe("touch", () => {
  const flow = flows();
  const screens = ["phone"];

  flow("taps select, paint, and press", async (playground, { page }) => {
    await playground.says(OPENING);
    await playground.button("Pause").tap();
    await playground.button("Play").waitFor();
    await playground.button("To start").tap();
    await playground.reaches(0);
    await tap(playground, 9, 2);
    await page.getByRole("tab", { name: "Inspector" }).tap();
    await playground.inspector.getByRole("heading", { name: "A2", level: 2 }).waitFor();
    await playground.tools.getByRole("button", { name: "Obstacle" }).tap();
    await tap(playground, 0, 1);
    await playground.cellTells(0, 1, /^obstacle$/);
    await playground.button("Undo").tap();
    await playground.cellTells(0, 1, /^free$/);
    // An agent is tapped where it is seen, and on the way to a time it is elsewhere.
  }, { screens, reducedMotion: "reduce" });

  flow("a finger draws a stroke", async (playground, surroundings) => {
    await playground.says(OPENING);
    await playground.pick("Slow zone");
    const touch = await fingers(surroundings);
    const [from, over] = [await playground.middleOf(0, 1), await playground.middleOf(0, 2)];
    const to = await playground.middleOf(2, 2);
    await touch("touchStart", from);
    await touch("touchMove", over);
    await touch("touchMove", to);
    await touch("touchEnd");
    for (const [x, y] of [[0, 1], [0, 2], [2, 2]]) {
      await playground.cellTells(x, y, /^slow zone$/);
    }
    await playground.press("Undo");
    await playground.cellTells(0, 1, /^free$/);
    assert.equal(await playground.button("Undo").isDisabled(), true);
  }, { screens, ...MOVING });

  flow("a finger marks a zone and leads a lane", async (playground, surroundings) => {
    await playground.says(OPENING);
    const touch = await fingers(surroundings);
    const lead = async (...cells) => {
      const [first, ...rest] = await Promise.all(cells.map(([x, y]) => playground.middleOf(x, y)));
      await touch("touchStart", first);
      for (const at of rest) await touch("touchMove", at);
      await touch("touchEnd");
    };
    await playground.pick("Zone");
    await lead([0, 1], [0, 2], [2, 2]);
    const { inspector } = playground;
    await inspector.getByText("A rule for zone 1").waitFor();
    for (const [x, y] of [[0, 1], [0, 2], [1, 2], [2, 2]]) {
      await playground.cellTells(x, y, /zone 1/);
    }
    // Where the page is slow, the foot still moves under the finger: it is tapped again.
    const add = inspector.getByRole("button", { name: "Add the rule" });
    await eventually("the rule to be added", async () => {
      await add.tap({ timeout: 1_000 }).catch(() => {});
      return add.count();
    }, (count) => count === 0);
    await playground.showTab("Inspector");
    await inspector.getByRole("group", { name: "At most 1 robot in zone 1", exact: true }).waitFor();
    await playground.pick("One-way");
    await lead([0, 1], [0, 2], [1, 2]);
    await playground.showTab("Inspector");
    await inspector.getByRole("group", { name: /^One way along \(0, 1\), \(0, 2\), \(1, 2\)(, broken|$)|^One way from \(0, 1\) to \(1, 2\)(, broken|$)/ }).waitFor();
    // Back along itself the lane turns round.
    await lead([1, 2], [0, 2], [0, 1]);
    await inspector.getByRole("group", { name: /^One way (from|along) \(1, 2\)/ }).waitFor();
    await playground.press("Undo");
    await inspector.getByRole("group", { name: /^One way (from|along) \(0, 1\)/ }).waitFor();
  }, { screens, ...MOVING });

  flow("two fingers enlarge the map, and paint nothing", async (playground, surroundings) => {
    await playground.says(OPENING);
    await playground.pick("Obstacle");
    const touch = await fingers(surroundings);
    const wide = async () => (await playground.cell(4, 0).boundingBox()).width;
    const before = await wide();
    const { x, y } = await playground.middleOf(4, 0);
    await touch("touchStart", { x: x - 10, y });
    await touch("touchStart", { x: x - 10, y }, { x: x + 10, y });
    for (const apart of [20, 40, 60]) {
      await touch("touchMove", { x: x - apart, y }, { x: x + apart, y });
    }
    await touch("touchEnd");
    await eventually("larger cells", wide, (now) => now > before * 1.5);
    await playground.cellTells(4, 0, /^slow zone/);
    await playground.picture("pinched");
  }, { screens, ...MOVING });

  flow("a finger moves the time", async (playground, surroundings) => {
    await playground.says(OPENING);
    await playground.pause();
    const touch = await fingers(surroundings);
    const track = await playground.time.boundingBox();
    const y = track.y + track.height / 2;
    await touch("touchStart", { x: track.x + 20, y });
    const from = await playground.reaches("an early one", (now) => now < 6);
    await touch("touchMove", { x: track.x + 120, y });
    await touch("touchEnd");
    await playground.reaches("a later one", (now) => now > from);
  }, { screens, ...MOVING });
});

async function tap(playground, column, row) {
  const { x, y } = await playground.middleOf(column, row);
  await playground.page.touchscreen.tap(x, y);
}

/** Sends what fingers do, as a screen does. */
async function fingers({ context, page }) {
  const session = await context.newCDPSession(page);
  return (type, ...at) => session.send("Input.dispatchTouchEvent", {
    type,
    touchPoints: at.map(({ x, y }, id) => ({ x, y, id })),
  });
}
