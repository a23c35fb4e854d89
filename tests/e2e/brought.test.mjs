// What people bring beside scenes: links without their beginning, changes, breakdowns, long plans.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const SCENE = { giveway: 1, name: "lane", map: ["....", "...."], agents: [
  { name: "R1", start: [0, 0], goal: [3, 0] }, { name: "R2", start: [0, 1], goal: [3, 1] },
] };
const R2 = [[0, 1], [1, 1], [2, 1], [3, 1]];
const file = (name, content) => ({ name, bytes: Buffer.from(JSON.stringify(content)) });
const scene = file("lane.json", SCENE);
const plan = (waits) => file("plan.json", { giveway: 1, paths: {
  R1: [[0, 0], [1, 0], ...Array.from({ length: waits }, () => [1, 0]), [2, 0], [3, 0]], R2,
} });
const delay = (steps) => file("changes.json", { giveway: 1, changes: [{ at: 1, change: "delay-agent", agent: "R1", steps }] });

describe("what people bring", () => {
  const flow = flows();

  flow("a link without its beginning is told", async (playground, { page, host }) => {
    await playground.goto(`${host.url}#check=35.035698fb&map=1.f&rules=0.0&costs=012&agents=`);
    await playground.warns(/This link was cut: its beginning is missing/);
    assert.equal(await page.evaluate(() => location.hash), "", "it is told once");
    // In a page that is open already, too.
    await playground.key("Escape");
    await page.evaluate(() => { location.hash = "map=3.3f&name=x&rules=0.0&costs=012&agents=A.0.0.2.0"; });
    await playground.warns(/its beginning is missing/);
  });

  flow("changes that the plan does not know lead to new plans", async (playground) => {
    await playground.open(scene, plan(0), delay(4));
    await playground.says(/^The world changes at time 1: 1 change listed/);
    assert.match(await playground.notice.getByRole("status").innerText(), /press Find new plans/);
    await playground.picture("changes-dropped");
    await playground.press("Find new plans");
    await playground.says(/^At time 1: /);
    // On the board the plan is known already.
    await playground.open(scene, plan(0));
    await playground.says(/^Optimal: makespan 3/);
    await playground.open(delay(4));
    await playground.says(/^The world changes at time 1: 1 change listed/);
  }, { screens: ["desktop", "phone"] });

  for (const theme of ["light", "dark"]) {
    flow(`a broken robot has a mark of its own, ${theme}`, async (playground, { page, screen }) => {
      await playground.open(scene, plan(4), delay(4));
      // Nothing was searched yet.
      const said = await playground.says(/the plan went on/);
      assert.match(said, /Nobody has checked here whether it is the best/);
      assert.doesNotMatch(said, /Best so far/);
      assert.equal(await playground.button("Go on").count(), 0);
      await playground.press("Step forward");
      await playground.press("Step forward");
      await playground.reaches(2);
      assert.match(await playground.onCell(1, 0), /R1 is here, broken down/);
      if (screen === "desktop") {
        await page.locator(".legend").getByText("Broken down").waitFor();
      }
      const marks = await page.evaluate(() => ["brbadge", "wbadge"].map((name) => document.querySelectorAll(`.map .${name}[data-on]`).length));
      assert.deepEqual(marks, [1, 0]);
      await playground.picture(`broken-${theme}`);
    }, { theme, screens: ["desktop", "phone"] });
  }

  flow("the plan table has all of a long plan", async (playground, { page }) => {
    await playground.open(scene, plan(1500));
    await playground.says(/makespan 1503/);
    for (const [key, time, cell] of [["To end", 1503, "3,0"], ["Step back", 1502, "2,0"]]) {
      await playground.press(key);
      await playground.reaches(time);
      const now = () => page.evaluate(() => {
        const entry = document.querySelector(".tbl tbody tr.first td.now");
        const box = entry?.getBoundingClientRect();
        const place = document.querySelector(".tblwrap").getBoundingClientRect();
        const head = document.querySelector(".tbl thead th.now")?.getBoundingClientRect();
        return entry && { text: entry.textContent, isSeen: box.left >= place.left && box.right <= place.right + 1, isBelowItsHead: Math.abs(box.left - head.left) < 2 };
      });
      await eventually("the last entries", now, (entry) => entry?.text === cell && entry.isSeen && entry.isBelowItsHead);
    }
    await playground.picture("plan-table-long");
  });
});
