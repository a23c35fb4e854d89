// Asking why: the verdict, the other plan, what excludes a plan, and repairs.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows, sample } from "./flow.mjs";
import { eventually } from "./wait.mjs";

describe("asking why", () => {
  const flow = flows();

  flow("shows a plan in which the robot does not wait, and takes it", async (playground) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4, sum of costs 7/);
    await playground.reaches("its end", (now) => now === 4);
    await playground.press("To start");
    await about(playground, "A2");
    await ask(playground, /^Why does A2 wait at \(3, 1\)\?/);
    await told(playground, "same cost");
    const costs = playground.inspector.getByRole("table", { name: "Who pays" });
    assert.match(await costs.innerText(), /A1 arrives\s+3\s+4\s+\+1/);
    await playground.picture("needless");

    // It opens at the first difference.
    await playground.press("Show the other plan");
    if (!playground.isPhone()) {
      await playground.reaches(1);
    }
    // Both move in step, on one clock.
    await playground.cellTells(2, 2, /A1/, playground.other);
    await playground.cellTells(2, 1, /A2/, playground.other);
    if (playground.isPhone()) {
      // They are pages: the one that was opened is in sight with the edge of this one, and a finger brings this one back.
      const { width } = playground.page.viewportSize();
      const pages = playground.page.locator(".boards");
      const left = async () => (await playground.other.boundingBox()).x;
      await eventually("the other plan", left, (x) => x < width * 0.3);
      const own = await pages.locator("figure").first().boundingBox();
      assert.ok(own.x < 0 && own.x + own.width > 4, "the edge of this plan");
      await pages.evaluate((boards) => boards.scrollTo({ left: 0 }));
      await eventually("this plan", left, (x) => x > width * 0.6);
      await pages.evaluate((boards) => boards.scrollTo({ left: boards.scrollWidth }));
      await eventually("the other plan again", left, (x) => x < width * 0.3);
      await playground.fits();
      await playground.picture("other-plan");
    } else {
      const lane = playground.page.getByRole("button", { name: "A1", exact: false }).filter({ hasText: "this / other" });
      await lane.waitFor();
      await playground.page.getByRole("img", { name: /^Other plan: A1: .* arrives at 4$/ }).waitFor();
      await playground.picture("beside");
    }
    await playground.cellTells(2, 1, /A1/);
    await playground.press("Take the other plan");
    await playground.other.waitFor({ state: "detached" });
    await playground.cellTells(2, 2, /A1/);
    await playground.says(/^Optimal: makespan 4, sum of costs 7/);
  }, { screens: BOTH });

  flow("shows the other plan on a board of its own, dark and on a tablet too", async (playground, { page }) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4/);
    await playground.press("To start");
    await playground.reaches(0);
    await about(playground, "A2");
    await ask(playground, /^Why does A2 wait at \(3, 1\)\?/);
    await playground.press("Show the other plan");
    await playground.other.waitFor();
    await playground.cellTells(2, 2, /A1/, playground.other);
    await playground.picture("beside-dark");
    await page.setViewportSize({ width: 1024, height: 768 });
    await playground.picture("beside-tablet-dark");
    // The same part of the map is in sight of both.
    await playground.press("Zoom in");
    const wide = async (grid) => Math.round((await playground.cell(1, 1, grid).boundingBox()).width);
    await eventually("both to be enlarged", async () => [await wide(playground.board), await wide(playground.other)], ([a, b]) => a === b && a > 60);
    // A narrow window has both as pages; a low one has one board, and still both plans.
    await page.setViewportSize({ width: 600, height: 844 });
    await playground.cellTells(2, 2, /A1/, playground.other);
    await page.setViewportSize({ width: 844, height: 390 });
    await playground.other.waitFor({ state: "detached" });
    await playground.cellTells(2, 2, /A1/);
    await page.setViewportSize({ width: 1440, height: 900 });
    await playground.other.waitFor();
    await playground.press("Keep this plan");
    await playground.other.waitFor({ state: "detached" });
    await playground.cellTells(2, 1, /A1/);
  }, { screens: ["desktop"], theme: "dark", reducedMotion: "reduce" });

  flow("tells why there is no plan, and what would help", async (playground) => {
    await playground.example("No way past");
    await playground.says(/^No plan exists, no matter how many steps you allow/);
    await ask(playground, /^Why is there no plan\?/);
    await told(playground, "Impossible");
    const repairs = playground.inspector.getByRole("listitem").filter({ hasText: "makespan 6, sum of costs 8" });
    await repairs.first().waitFor();
    await playground.answered();
    await playground.picture("unsolvable");
    await repairs.first().getByRole("button").click();
    await playground.says(/^Optimal: makespan 6, sum of costs 8/);
    // The answer is there again, with its repairs.
    await playground.act("Undo");
    await playground.says(/^No plan exists, no matter how many steps you allow/);
    await repairs.first().waitFor();
  });

  flow("refuses nothing that it offers, and is left by Escape", async (playground) => {
    await playground.says(/^Optimal: /);
    await playground.press("To end");
    for (const question of [/^Why does it take this long\?/, /^Why are there not fewer charges\?/]) {
      await ask(playground, question);
      await told(playground, /Necessary|Costly|Needless|same cost/);
      await playground.answered();
      await playground.key("Escape");
      await eventually("the questions to be back", () => asks(playground, question).count());
    }
  });

  flow("checks the proof of a plan and of an answer, and tells what each claim rests on", async (playground) => {
    await playground.says(/^Optimal: /);
    await toWhole(playground);
    await playground.press("Check the proof");
    const proof = playground.inspector.getByRole("region", { name: "Proof" });
    await proof.waitFor({ timeout: 60_000 });
    const said = await proof.innerText();
    assert.match(said, /^Checked\s/);
    assert.match(said, /There is no plan with makespan at most 17/);
    assert.match(said, /A checked proof: .* steps|A search of .* repeated/);
    await playground.says(/^Optimal: /);
    await playground.picture("proof-of-a-plan");

    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4, sum of costs 7/);
    assert.equal(await proof.count(), 0, "it is of another plan");
    await ask(playground, /^Why does it take this long\?/);
    await told(playground, "Necessary");
    await playground.button("Check the proof").waitFor({ timeout: 60_000 });
    await playground.press("Check the proof");
    await proof.waitFor({ timeout: 60_000 });
    assert.match(await proof.innerText(), /There is no plan with makespan at most 3/);
    await proof.scrollIntoViewIfNeeded();
    await playground.picture("proof-of-an-answer");
  });

  flow("gives a check of a proof up at once", async (playground) => {
    await playground.open(sample("mmapf/A05_mm_10x10_o10_a10.json"));
    await playground.says(/^No plan yet/);
    await playground.press("Solve");
    await playground.says(/^Optimal: /);
    await toWhole(playground);
    await playground.press("Check the proof");
    await playground.says(/^(Proving again|Checking the proof)/);
    await playground.press("Cancel");
    await playground.button("Check the proof").waitFor();
    await playground.says(/^Optimal: /);
  }, { screens: ["desktop"] });

  flow("gives a question up at once", async (playground) => {
    await playground.openSettings();
    await playground.set("Time limit, s", 3);
    await playground.closeSettings();
    await playground.open(sample("mmapf/A17_mm_20x20_o15_a30.json"));
    await playground.says(/^No plan yet/);
    await playground.press("Solve");
    await playground.button("Cancel").waitFor();
    await playground.says(/^Best so far/);
    await playground.openSettings();
    await playground.set("Time limit, s", 60);
    await playground.closeSettings();
    await ask(playground, /^Why does it take this long\?/);
    await playground.button("Cancel").waitFor();
    await playground.press("Cancel");
    await playground.button("Go on").waitFor();
    await playground.says(/^Best so far/);
  }, { screens: ["desktop"] });
});

/** Shows the inspector, with nothing selected. */
async function toWhole(playground) {
  if (await playground.page.getByRole("tab").count()) {
    await playground.showTab("Inspector");
  }
}

/** Selects an agent in the inspector. */
async function about(playground, name) {
  await playground.showTab("Inspector");
  await playground.inspector.getByRole("button", { name: new RegExp(`^${name}\\b`) }).first().click();
  await playground.inspector.getByRole("heading", { name, level: 2 }).waitFor();
}

function asks(playground, question) {
  return playground.inspector.getByRole("button", { name: question });
}

async function ask(playground, question) {
  // Without a plan a phone has no tabs: the inspector is all there is.
  if (await playground.page.getByRole("tab").count()) {
    await playground.showTab("Inspector");
  }
  await asks(playground, question).first().click();
}

/** Waits for the verdict. */
function told(playground, verdict) {
  return playground.inspector.getByText(verdict).first().waitFor({ timeout: 60_000 });
}
