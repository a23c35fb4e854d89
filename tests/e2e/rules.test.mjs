// Rules of a scene's own: a place is limited and its price asked for, by mouse, by keys, by a finger.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { BOTH, LOOKS, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

/** Three aisles between two halls. A1 and A2 take the left one, one behind the other. */
const AISLES = {
  giveway: 1,
  name: "three aisles",
  map: [".......", "##.#.##", "##.#.##", "##.#.##", "......."],
  agents: [
    { name: "A1", start: [0, 0], goal: [0, 4] },
    { name: "A2", start: [1, 0], goal: [3, 4] },
    { name: "A3", start: [6, 4], goal: [5, 0] },
  ],
  constraints: [{ kind: "one-way", lane: [[0, 0], [1, 0], [2, 0], [3, 0], [4, 0], [5, 0]] }],
};

const OPTIMAL = /^Optimal: makespan 8, sum of costs 21/;
const ASK = /^What do the rules cost\?/;

describe("rules of a scene's own", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`one robot at a time in an aisle, and what that costs (${theme})`, async (playground) => {
      await solve(playground);
      await playground.pick("Zone");
      await playground.stroke([2, 1], [2, 3]);
      const { inspector } = playground;
      const judge = inspector.locator(".judged");
      await eventually("the judge", () => judge.innerText(), (text) => /^This plan breaks it [^]*A1 and A2 are in zone 1 then\.$/.test(text));
      await playground.says(OPTIMAL);
      await rename(playground, "middle aisle");
      await audit(playground, "a rule that is written");
      await playground.picture(`rule-add-${theme}`);
      await playground.press("Add the rule");
      await inspector.getByRole("group", { name: /^At most 1 robot in middle aisle, broken / }).waitFor();
      await inspector.getByRole("button", { name: ASK }).click();
      await inspector.getByRole("group", { name: "At most 1 robot in middle aisle, costs 2 steps of the makespan" }).waitFor();
      await inspector.getByRole("group", { name: "One way from (0, 0) to (5, 0), costs nothing" }).waitFor();
      // The plan on the board is older than the limit: its price does not hide that it is broken.
      assert.match(await inspector.locator(".own-rules").innerText(), /costs 2 steps of the makespan\s+broken /);
      await playground.cellTells(2, 2, /zone middle aisle/);
      await audit(playground, "prices of rules");
      await playground.picture(`rules-${theme}`);
      // The scene has a rule more than the plan.
      await playground.solver.click();
      await playground.says(/^Optimal: makespan 10, sum of costs 23/);
      await playground.picture(`rules-solved-${theme}`);
    }, { screens, theme });
  }

  flow("a rule is filled, switched, edited and taken back", async (playground) => {
    await solve(playground);
    await playground.pick("Zone");
    await playground.stroke([2, 1], [2, 3]);
    const { inspector } = playground;
    const slot = (name) => inspector.getByRole("button", { name, exact: true });
    await slot("number: 1").click();
    await slot("One more").click();
    await inspector.getByText("This plan keeps it").waitFor();
    await slot("when: always").click();
    await slot("From, to").click();
    await inspector.getByLabel("To", { exact: true }).fill("9");
    await inspector.getByLabel("To", { exact: true }).press("Tab");
    await slot("who: all robots").click();
    await slot("A1").click();
    await slot("who: A1").waitFor();
    await playground.picture("rule-slots");
    await playground.press("Add the rule");
    const row = inspector.getByRole("group", { name: "At most 2 of A1 in zone 1 from 0 to 9" });
    await row.or(inspector.getByRole("group", { name: "At most 2 of A1 in zone 1 up to 9" })).waitFor();
    await playground.says(OPTIMAL);
    const toggle = inspector.getByRole("switch", { name: /^At most 2 of A1 in zone 1 .*: in force$/ });
    // Its label is what is seen of it.
    await toggle.locator("..").click();
    assert.equal(await toggle.isChecked(), false);
    await playground.press("Undo");
    await eventually("the rule in force", () => toggle.isChecked(), Boolean);
    await inspector.getByRole("button", { name: /^At most 2 of A1 .*: show and open$/ }).click();
    await inspector.getByRole("button", { name: "Remove", exact: true }).click();
    await toggle.waitFor({ state: "detached" });
    await playground.press("Undo");
    await toggle.waitFor();
  });

  flow("that is in force already is not added again", async (playground) => {
    await solve(playground);
    const { inspector } = playground;
    await playground.pick("Zone");
    await playground.stroke([2, 1], [2, 3]);
    await playground.press("Add the rule");
    await playground.says(/^This plan breaks a rule that came after it: /);
    await inspector.getByRole("group", { name: /^At most 1 robot in zone 1, broken .* by A1 and A2$/ }).waitFor();
    await inspector.getByRole("button", { name: "Zone zone 1" }).first().click();
    await inspector.getByText("It is in force already").waitFor();
    assert.ok(await inspector.getByRole("button", { name: "Add the rule" }).isDisabled());
  });

  flow("turns a nose by hand, by buttons, and takes it back", async (playground, { page }) => {
    await playground.open({ name: "turns.json", bytes: JSON.stringify({
      ...AISLES,
      constraints: [{ kind: "turns", quarter: 1 }],
    }) });
    await playground.says(/^No plan yet\.$/);
    const at = await playground.middleOf(6, 4);
    await page.mouse.click(at.x, at.y);
    await playground.showTab("Inspector");
    const faces = playground.inspector.getByRole("group", { name: "Faces at its start" });
    const pressed = (name) => faces.getByRole("button", { name, pressed: true }).waitFor();
    await pressed("Any");
    const grip = await page.locator(".turned-nose .nose-grip").boundingBox();
    await page.mouse.move(grip.x + grip.width / 2, grip.y + grip.height / 2);
    await page.mouse.down();
    await page.mouse.move(at.x, at.y - 60, { steps: 4 });
    await page.mouse.up();
    await pressed("Up");
    await playground.picture("turned-nose");
    // The robot itself stays where it is.
    await playground.cellTells(6, 4, /A3/);
    await playground.press("Undo");
    await pressed("Any");
    await faces.getByRole("button", { name: "Left" }).focus();
    await playground.key("Enter");
    await pressed("Left");
  });

  flow("is done by keys alone", async (playground) => {
    await solve(playground);
    await playground.board.focus();
    await playground.key("z", "Home", "Control+ArrowUp", "ArrowDown", "ArrowRight", "ArrowRight", "Shift+ArrowDown", "Shift+ArrowDown", "Enter");
    const { inspector } = playground;
    await inspector.getByRole("button", { name: "number: 1" }).focus();
    await playground.key("ArrowUp");
    await inspector.getByRole("button", { name: "number: 2" }).waitFor();
    await playground.key("ArrowDown");
    await inspector.getByText(/^This plan breaks it/).waitFor();
    await inspector.getByRole("button", { name: "Add the rule" }).focus();
    await playground.key("Enter");
    await inspector.getByRole("button", { name: ASK }).focus();
    await playground.key("Enter");
    await inspector.getByRole("group", { name: "At most 1 robot in zone 1, costs 2 steps of the makespan" }).waitFor();
    await playground.board.focus();
    await playground.key("r", "Home", "Control+ArrowUp", "ArrowDown", "ArrowDown", "ArrowDown", "ArrowDown", "Enter", "ArrowRight", "ArrowRight", "Enter");
    await inspector.getByRole("group", { name: "One way from (0, 4) to (2, 4)" }).waitFor();
  });

  flow("a finger marks a zone and leads a lane", async (playground) => {
    await solve(playground);
    await playground.pick("One-way");
    await playground.stroke([3, 0], [2, 0]);
    await playground.showTab("Inspector");
    await playground.inspector.getByRole("group", { name: "One way from (5, 0) to (0, 0)" }).waitFor();
    await playground.cellTells(3, 0, /one way to \(2, 0\)/);
    await playground.picture("rules-lane");
  }, { screens: BOTH });
});

describe("rules about a robot", () => {
  const flow = flows();

  flow("a start is set, judged and added", async (playground) => {
    await solve(playground);
    const { inspector } = playground;
    await playground.showTab("Inspector");
    await inspector.getByRole("button", { name: /^A3/ }).click();
    await playground.press("A rule about this robot");
    await inspector.getByRole("heading", { name: "A new rule" }).waitFor();
    await inspector.getByText("This plan keeps it").waitFor();
    await inspector.getByRole("button", { name: /^A3 starts from 1 on$/ }).click();
    await inspector.getByText(/^This plan breaks it/).waitFor();
    await playground.press("Add the rule");
    await inspector.getByRole("group", { name: /^A3 starts from 1 on, broken / }).waitFor();
    await playground.picture("rule-about-robot");
  }, { screens: BOTH });
});

/** Five robots on a floor with two aisles, and five rules: `design/rules` of the project's drawings. */
const TWO_AISLES = {
  giveway: 1,
  name: "two aisles",
  map: ["..............", "####.####.####", "####.####.####", "####.####.####", "+.............", ".....~~~~....+", ".###.####.###.", ".###.####.###.", "....+........."],
  agents: [
    { name: "A1", start: [0, 0], goal: [12, 4], waypoints: [[5, 4]], battery: { capacity: 20, initial: 20 } },
    { name: "A2", start: [6, 0], goal: [0, 7], waypoints: [[7, 0], [2, 8]], battery: { capacity: 17, initial: 17 } },
    { name: "A3", start: [9, 0], goal: [9, 8], waypoints: [[9, 6], [13, 5]], battery: { capacity: 14, initial: 12 } },
    { name: "A4", start: [3, 4], goal: [11, 8], waypoints: [[6, 5]], battery: { capacity: 14, initial: 13 } },
    { name: "A5", start: [10, 8], goal: [0, 6], waypoints: [[3, 8]], battery: { capacity: 14, initial: 11 } },
  ],
  zones: [
    { name: "aisle 1", rect: [4, 1, 4, 3] },
    { name: "crossing", rect: [6, 4, 7, 5] },
    { name: "cold store", rect: [8, 1, 13, 3] },
  ],
  constraints: [
    { kind: "capacity", zone: "aisle 1", most: 1 },
    { kind: "one-way", lane: [[9, 0], [9, 1], [9, 2], [9, 3], [9, 4]] },
    { kind: "closed", zone: "crossing", from: 12, to: 15, name: "people crossing" },
    { kind: "sequence", agent: "A3", cells: [[9, 6], [13, 5]] },
    { kind: "no-waiting", zone: "cold store" },
    { kind: "gap", steps: 1, off: true },
  ],
};

describe("rules that are there", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`when they hold, what is beside, what they are asked (${theme})`, async (playground) => {
      await playground.open({ name: "two-aisles.json", bytes: JSON.stringify(TWO_AISLES) });
      await playground.shows("two aisles");
      await playground.solver.click();
      await playground.says(/^Optimal: makespan 20, sum of costs 83/);
      if (await playground.button("Pause").isVisible()) await playground.press("Pause");
      const { inspector, page } = playground;
      await playground.showTab("Timeline");
      const stretch = page.getByRole("group", { name: "Times of rules" }).getByRole("button", { name: /^people crossing: No robot in 'crossing' from 12 to 15/ });
      await stretch.focus();
      await playground.picture(`rule-times-${theme}`);
      await audit(playground, "times of rules");
      await playground.key("Enter");
      await inspector.getByRole("group", { name: /^No robot in crossing from 12 to 15/ }).waitFor();
      await inspector.getByRole("button", { name: "Loosen", exact: true }).waitFor();
      await playground.picture(`rule-row-${theme}`);
      await page.getByRole("button", { name: "5 rules in force: show them" }).click();
      await playground.showTab("Inspector");
      const toggle = inspector.getByRole("switch", { name: /^No robot waits in cold store.*: in force$/ });
      await toggle.locator("..").scrollIntoViewIfNeeded();
      const before = await toggle.locator("..").boundingBox();
      await toggle.locator("..").click();
      await page.getByRole("button", { name: "4 rules in force: show them" }).waitFor();
      const after = await toggle.locator("..").boundingBox();
      assert.ok(Math.abs(before.y - after.y) < 2, `the switch stays under the pointer: ${before.y}, then ${after.y}`);
      await playground.press("Undo");
      await inspector.getByRole("button", { name: ASK }).click();
      const row = inspector.getByRole("group", { name: /^At most 1 robot in aisle 1, costs 2 steps of the makespan$/ });
      await row.waitFor();
      await eventually("all prices", () => inspector.locator(".rule-tag.busy").count(), (count) => count === 0);
      await inspector.getByRole("button", { name: "At most 1 robot in aisle 1: show and open" }).click();
      await inspector.getByRole("button", { name: "Show the plan without it" }).click();
      await playground.picture(`rule-beside-${theme}`);
      await inspector.getByRole("button", { name: "Show the plan without it" }).click();
      await inspector.getByRole("button", { name: "Why not a plan in which …?" }).click();
      await inspector.getByRole("button", { name: "Each cell stays free for 1 step behind any robot" }).click();
      await playground.picture(`rule-question-${theme}`);
      await audit(playground, "a rule that is asked about");
      await inspector.getByRole("button", { name: "Ask", exact: true }).click();
      await eventually("the answer", () => inspector.innerText(), (text) => /^Back\nWhy is it not so: "Each cell stays free for 1 step behind any robot"[^]*Who pays/.test(text));
      await playground.picture(`rule-asked-${theme}`);
    }, { screens, theme });
  }

  for (const { theme, screens } of LOOKS) {
    flow(`rules that leave no plan are marked, and one is loosened by the least that helps (${theme})`, async (playground, { screen }) => {
      const late = { kind: "arrive", by: 9, agents: ["A1"], name: "in time" };
      const aisle = { kind: "closed", zone: "aisles", from: 2, to: 12, agents: ["A1"] };
      const zones = [{ name: "aisles", rect: [2, 1, 4, 3] }];
      const scene = { ...AISLES, name: "too late", zones, constraints: [...AISLES.constraints, aisle, late] };
      await playground.open({ name: "late.json", bytes: JSON.stringify(scene) });
      await playground.shows("too late");
      await playground.solver.click();
      await playground.says(/^No plan/);
      const { inspector, page } = playground;
      await page.getByRole("button", { name: "Why is there no plan?" }).first().click();
      const times = page.getByRole("group", { name: "When the rules that leave no plan hold" });
      if (screen === "phone") {
        await page.getByRole("tab", { name: "Timeline" }).click();
      }
      await times.waitFor();
      await audit(playground, "times of rules that leave no plan");
      await playground.picture(`rule-clash-${theme}`);
      if (screen === "phone") {
        await page.getByRole("tab", { name: "Inspector" }).click();
        await times.waitFor({ state: "hidden" });
      }
      await inspector.getByRole("button", { name: /^Loosen: / }).first().click();
      await inspector.getByText("The least that helps", { exact: true }).waitFor();
      await audit(playground, "a rule that is loosened");
      await playground.picture(`rule-loosened-${theme}`);
      await inspector.locator(".looser .repair").first().click();
      await playground.says(/^Optimal: makespan/);
    }, { screens, theme });
  }

  flow("a closed zone with a goal in it is said at once, and what goes with a robot", async (playground) => {
    await solve(playground);
    await playground.pick("Zone");
    await playground.stroke([3, 4]);
    const { inspector } = playground;
    await inspector.getByRole("button", { name: /^No robot in zone 1$/ }).click();
    await inspector.getByText("A2 has its goal in zone 1, so no plan can keep this rule.").waitFor();
    await playground.picture("rule-never");
  }, { screens: BOTH });
});

async function solve(playground) {
  await playground.open({ name: "aisles.json", bytes: JSON.stringify(AISLES) });
  await playground.shows("three aisles");
  await playground.solver.click();
  await playground.says(OPTIMAL);
  if (await playground.button("Pause").isVisible()) {
    await playground.press("Pause");
  }
}

async function rename(playground, name) {
  const field = playground.inspector.getByLabel("Name of the zone", { exact: true });
  await field.fill(name);
  await field.press("Enter");
  await playground.inspector.getByText(`A rule for ${name}`).waitFor();
}
