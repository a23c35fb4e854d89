// Search by hand: a person splits the conflict tree, takes back, and proves a plan; by the mouse and by keys.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { BOTH, LOOKS, flows } from "./flow.mjs";
import { look } from "./inside.mjs";
import { eventually } from "./wait.mjs";

/** The second split can give a plan; another branch is cheaper then. */
const LANES = {
  giveway: 1,
  name: "three lanes",
  map: ["......", "#..##.", ".#..#.", "......"],
  objective: ["sum-of-costs"],
  agents: [
    { name: "A1", start: [0, 3], goal: [2, 0] },
    { name: "A2", start: [3, 2], goal: [2, 2] },
    { name: "A3", start: [4, 0], goal: [0, 3] },
  ],
};

/** The search by hand in the view of CBS. */
class ByHand {
  constructor(playground) {
    this.playground = playground;
    this.page = playground.page;
    this.column = playground.inspector;
    this.tree = this.page.getByRole("tree", { name: "Conflict tree" });
    this.nodes = this.tree.getByRole("treeitem");
  }

  /** Opens it by its switch. */
  async opens() {
    await look(this.playground, LANES, "Conflict tree");
    await this.page.getByRole("group", { name: "Who splits" }).getByRole("button", { name: "By hand" }).click();
    await this.has(1);
  }

  /** Waits until the tree has so many nodes. */
  has(count) {
    return eventually(`${count} nodes`, () => this.nodes.count(), (n) => n === count);
  }

  /** Chooses the node of a cost, where the tree has so many nodes. */
  async goes(cost, count) {
    await this.shows("Tree");
    await this.has(count);
    await this.nodes.filter({ hasText: new RegExp(`^${cost}`) }).first().click();
  }

  async shows(tab) {
    await this.playground.showTab(tab);
  }

  /** The conflict of two robots. */
  conflict(a, b) {
    const conflicts = this.column.getByRole("radiogroup", { name: "Conflict to split on" });
    return conflicts.getByRole("radio", { name: new RegExp(`(${a}|${b}).*(${a}|${b})`) }).first();
  }

  /** Chooses a conflict and the robot, and splits. */
  async splits(a, b, named, before) {
    await this.shows("By hand");
    await this.conflict(a, b).click();
    await this.column.getByRole("radiogroup", { name: "Split on" }).getByRole("radio", { name: named, exact: true }).click();
    const costs = await this.column.locator(".kids b").allInnerTexts();
    assert.deepEqual(costs, before, "both costs are told before");
    await this.column.getByRole("button", { name: "Split here" }).click();
  }

  async rows() {
    const rows = this.column.getByRole("table", { name: "What it took" }).getByRole("row");
    return (await rows.allInnerTexts()).slice(1).map((row) => row.trim().split(/\s*\t\s*/));
  }
}

describe("search by hand", () => {
  const flow = flows();

  for (const { theme } of LOOKS) {
    flow(`proves a plan, and is compared with the planner (${theme})`, async (playground) => {
      const hand = new ByHand(playground);
      await hand.opens();
      await playground.says(/^No plan yet. The cheapest open branch costs 13, so no plan costs less\.$/);
      await audit(playground, "the root");
      await hand.splits("A2", "A3", "A2", ["17", "15"]);
      await hand.shows("By hand");
      await hand.column.getByText("Planner: A1 runs into A2, on A2, gives 16 and 21").waitFor();
      await hand.goes("15", 3);
      await hand.splits("A1", "A2", "A2", ["18", "21"]);
      await playground.says(/^A plan of 18 is found. A branch of 17 is still open, so it may not be the best\.$/);
      await hand.goes("17", 5);
      await hand.shows("By hand");
      await hand.column.getByRole("heading", { name: "Cost 17. Which conflict?" }).waitFor();
      await audit(playground, "a plan that is not proved");
      await playground.picture(`by-hand-${theme}`);
      await hand.shows("Tree");
      await playground.picture(`by-hand-tree-${theme}`);

      // What is taken back is as it was; it can be split again.
      await hand.page.getByRole("button", { name: "Take back the last split" }).click();
      await hand.has(3);
      await playground.says(/^No plan yet/);
      await hand.splits("A1", "A2", "A2", ["18", "21"]);
      await hand.goes("17", 5);
      await hand.splits("A1", "A3", "A1", ["18", "18"]);
      await playground.says(/^Optimal: sum of costs 18\. Found and proved by hand\.$/);
      await hand.shows("By hand");
      await hand.column.getByRole("heading", { name: "You took 7 nodes, the planner 9" }).waitFor();
      assert.deepEqual(await hand.rows(), [
        ["Nodes", "7", "9"],
        ["Splits", "3", "4"],
        ["Nodes to the first plan", "5", "7"],
        ["Dead ends", "0", "1"],
        ["Sum of costs", "18", "18"],
      ]);
      await audit(playground, "proved by hand");
      await playground.picture(`by-hand-done-${theme}`);

      // The planner's own tree has as many nodes as was told.
      await hand.column.getByRole("button", { name: "Planner's tree" }).click();
      await hand.shows("How it was proved");
      await hand.has(9);
    }, { theme, screens: BOTH, reducedMotion: "reduce" });
  }

  flow("is done by keys alone", async (playground) => {
    const hand = new ByHand(playground);
    await hand.opens();
    await hand.tree.focus();
    // A conflict by its number, the robot by the arrows, then Enter.
    const place = await hand.conflict("A2", "A3").getAttribute("title");
    await playground.key(place.replace("Key ", ""));
    await hand.conflict("A2", "A3").and(hand.page.getByRole("radio", { checked: true })).waitFor();
    const named = hand.column.getByRole("radiogroup", { name: "Split on" });
    await named.getByRole("radio", { name: "A2", exact: true, checked: true }).focus();
    await playground.key("ArrowRight");
    await named.getByRole("radio", { name: "A3", exact: true, checked: true }).waitFor();
    await playground.key("ArrowRight");
    await named.getByRole("radio", { name: "A2", exact: true, checked: true }).waitFor();
    await playground.key("Enter");
    await hand.has(3);
    const spoken = hand.page.locator(".dock > [aria-live=polite]");
    await eventually("the split to be told", () => spoken.innerText(), (text) => /gives 17 and 15/.test(text));

    // Arrows move in the tree; Ctrl and Z takes back the split, not an edit.
    await hand.tree.focus();
    await playground.key("ArrowLeft");
    await hand.column.getByRole("heading", { name: "Cost 13, split already" }).waitFor();
    await playground.key("Control+z");
    await hand.has(1);
    await playground.says(/^No plan yet/);
    await playground.key("Control+Shift+z");
    await hand.has(3);
    await playground.key("Enter");
    await hand.has(5);
    await playground.key("Control+z", "Control+z", "Control+z");
    await hand.has(1);
    await playground.shows(LANES.name);
  });

  flow("is in the lesson about CBS", async (playground, { host }) => {
    const { page } = playground;
    await playground.goto(`${host.url}#lesson=split-on-a-conflict.5`);
    const lesson = page.getByRole("complementary", { name: "Lesson" });
    await lesson.getByRole("heading", { name: "Search by hand" }).waitFor();
    const hand = new ByHand(playground);
    if (playground.isPhone()) {
      await hand.shows("By hand");
    } else {
      await page.getByRole("button", { name: "Search by hand", exact: true }).click();
    }
    await hand.column.getByRole("heading", { name: "Cost 13. Which conflict?" }).waitFor();
    assert.equal(await lesson.isVisible(), false);
    await audit(playground, "by hand in a lesson");
    await playground.picture("by-hand-lesson");
    await hand.splits("A2", "A3", "A2", ["17", "15"]);
    await hand.goes("15", 3);
    await hand.splits("A1", "A2", "A2", ["18", "21"]);
    await hand.goes("17", 5);
    await hand.splits("A1", "A3", "A1", ["18", "18"]);
    await hand.shows("By hand");
    await hand.column.getByRole("heading", { name: "You took 7 nodes, the planner 9" }).waitFor();
    await playground.picture("by-hand-lesson-done");
    await hand.column.getByRole("button", { name: "Back to the lesson" }).click();
    await lesson.getByTitle("Key 2", { exact: true }).click();
    await lesson.getByText("Solved").first().waitFor();

    // The planner's tree has the place of one's own, and nothing else has: no tab leads away from both.
    await page.getByRole("group", { name: "Who splits" }).getByRole("button", { name: "Planner" }).click();
    await hand.shows("How it was proved");
    await hand.has(9);
    assert.ok(await hand.tree.isVisible());
    assert.equal(await page.getByRole("tab", { name: "Timeline" }).count(), 0);
    await page.getByRole("group", { name: "Who splits" }).getByRole("button", { name: "By hand" }).click();
    await hand.shows("Tree");
    await hand.has(7);
  }, { screens: BOTH });
});
