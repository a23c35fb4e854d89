// Solving: what is told, what is impossible, and how it is ended.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows, sample } from "./flow.mjs";

const HARD = sample("mmapf/A17_mm_20x20_o15_a30.json");

describe("solving", () => {
  const flow = flows();

  flow("tells bounds while it solves, and ends at once when it is cancelled", async (playground) => {
    await open(playground, HARD);
    await playground.press("Solve");
    await playground.says(/^Solving: makespan is (at least )?\d+/);
    await playground.picture("solving");
    // The page hears while the solver works.
    await playground.key("?");
    await playground.page.getByRole("dialog", { name: "Keys" }).waitFor();
    await playground.key("Escape");
    const begin = performance.now();
    await playground.press("Cancel");
    await playground.button("Go on").waitFor();
    const seconds = (performance.now() - begin) / 1000;
    assert.ok(seconds < 3, `it took ${seconds} s to cancel`);
    await playground.says(/You stopped the search\./);
    await isAlive(playground);
  }, { screens: BOTH });

  flow("lets the plan so far be played by hand", async (playground) => {
    await open(playground, HARD);
    await playground.press("Solve");
    await playground.button("Pause").waitFor();
    // The bounds are where the lanes will be, so only the clock tells the time.
    const isAt = (time) => playground.page.getByTitle(new RegExp(`^Time ${time} of \\d+$`)).waitFor();
    await playground.press("To start");
    await isAt(0);
    await playground.press("Step forward");
    await isAt(1);
    await playground.press("Step forward");
    await isAt(2);
    await playground.press("Cancel");
    await playground.button("Go on").waitFor();
  }, { screens: BOTH });

  flow("is cancelled by Escape, and by an edit", async (playground) => {
    await open(playground, HARD);
    await playground.key("Control+Enter");
    await playground.button("Cancel").waitFor();
    await playground.key("Escape");
    await playground.page.getByRole("button", { name: /^(Solve|Go on)$/ }).waitFor();

    await playground.key("Control+Enter");
    await playground.button("Cancel").waitFor();
    await paintSomewhere(playground);
    await playground.button("Solve").waitFor();
    await playground.says(/^(No plan yet|The scene has changed)/);
  });

  flow("solves the next scene though it was at another", async (playground) => {
    await open(playground, HARD);
    await playground.press("Solve");
    await playground.button("Cancel").waitFor();
    await playground.example("Who waits?");
    await playground.says(/^Optimal: /);
  });

  flow("ends when its time is over, and says what it has", async (playground) => {
    await playground.openSettings();
    await playground.set("Time limit, s", 2);
    await playground.closeSettings();
    await open(playground, HARD);
    await playground.press("Solve");
    await playground.button("Cancel").waitFor();
    const said = await playground.says(/^(Best so far|The time limit was reached)/);
    assert.match(said, /at least|none ruled out/);
    assert.doesNotMatch(said, /^Optimal|Impossible|No plan,/);
    await playground.picture("stopped");
  });

  flow("says that a scene is impossible", async (playground) => {
    await open(playground, sample("seed/scenario-6.json"));
    await playground.press("Solve");
    await playground.says(/^No plan exists, no matter how many steps you allow/);
    assert.equal(await playground.time.count(), 0, "there is a time to show without a plan");
    await playground.picture("impossible");
    await isAlive(playground);
  });

  flow("solves ten robots with batteries", async (playground) => {
    await playground.example("Ten robots");
    // tests/data/mmapf/expected.md, A05.
    await playground.says(/^Optimal: makespan 31, sum of costs 254, 10 charges\.$/);
    await playground.reaches("2 or later", (now) => now >= 2);
    await playground.picture("ten-robots");
  });
});

/** Opens a file, once the opening scene is solved. */
async function open(playground, path) {
  await playground.says(/^Optimal: /);
  await playground.open(path);
  await playground.says(/^No plan yet\.$/);
}

/** An edit of any free cell. */
async function paintSomewhere(playground) {
  const free = playground.board.getByRole("gridcell", { name: /: free$/ }).first();
  const [, x, y] = (await free.getAttribute("aria-label")).match(/^(\d+), (\d+):/);
  await playground.pick("Obstacle");
  await playground.stroke([x, y]);
  await playground.cellTells(x, y, /^obstacle$/);
}

/** That the page can be edited, and solves again. */
async function isAlive(playground) {
  await paintSomewhere(playground);
  await playground.example("Who waits?");
  await playground.says(/^Optimal: /);
}
