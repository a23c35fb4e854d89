// The world changes while a plan runs: listed, refused, taken back, compared,
// adopted, played across, undone, kept.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { adapt, begin, join, running } from "./change.mjs";
import { BOTH, flows, MOVING } from "./flow.mjs";
import { eventually } from "./wait.mjs";

function changes(playground) {
  return playground.inspector.getByRole("region", { name: "Changes" }).getByRole("listitem");
}

/** Waits until the list tells these changes. */
function lists(playground, ...texts) {
  return eventually(`the changes ${texts}`, () => changes(playground).allInnerTexts(), (found) =>
    found.length === texts.length && texts.every((text, index) => found[index].includes(text)));
}

function column(playground, name) {
  return playground.page.getByRole("article", { name: new RegExp(name) });
}

async function inspect(playground) {
  await playground.showTab("Inspector");
}

describe("the world changes", () => {
  const flow = flows();

  flow("undo says which change it takes back", async (playground) => {
    await running(playground);
    await begin(playground);
    await join(playground, [2, 2], [1, 0]);
    // The robot that joined is selected: the list is out of sight.
    await playground.press("Undo");
    await playground.notice.getByText("Undone: A3 joins at (2, 2).").waitFor();
    await playground.press("Redo");
    await playground.notice.getByText("Listed again: A3 joins at (2, 2).").waitFor();
  });

  flow("an agent joins, the methods are compared, one is adopted and played across", async (playground) => {
    await running(playground);
    await begin(playground);
    await inspect(playground);
    await playground.picture("changing-empty");
    await join(playground, [2, 2], [1, 0]);
    await playground.cellTells(2, 2, /A3/);
    await playground.key("Escape");
    await lists(playground, "A3 joins at (2, 2)");
    await playground.picture("changing");
    await adapt(playground);
    const replan = column(playground, "Everything new");
    assert.match((await replan.innerText()).replaceAll(/\s+/g, " "), /Makespan (before )?4 ?4 same/i);
    await column(playground, "New times").waitFor();
    await column(playground, "Near the old paths").waitFor();
    await playground.picture("comparing");
    await replan.getByRole("button", { name: /^Preview/ }).click();
    await playground.page.getByRole("button", { name: /^Preview .*Everything new/, pressed: true }).waitFor();
    await replan.getByRole("button", { name: /^Use this plan/ }).click();
    await playground.says(/^The world changed at time 1; the plan went on with “[^:]+”: makespan 4/);
    await playground.picture("adopted");
    await playground.cellTells(2, 2, /A3/);
    await playground.press("To start");
    await playground.cellTells(2, 2, /^goal of A1$/);
    await playground.press("Play");
    await playground.reaches("the end", (now) => now === 4);
    await playground.cellTells(1, 0, /A3/);

    await playground.reload();
    await playground.says(/^The world changed at time 1; the plan went on with “[^:]+”: makespan 4/);
    const names = (await playground.planRows()).map((row) => row[0]);
    assert.ok(names.some((name) => name.startsWith("A3")), names.join());
  }, { screens: BOTH, ...MOVING });

  flow("undo takes an adoption back, and each change", async (playground) => {
    await running(playground);
    await begin(playground);
    await join(playground, [2, 2], [1, 0]);
    await playground.pick("Charger");
    await playground.stroke([0, 2]);
    await inspect(playground);
    await playground.key("Escape");
    await lists(playground, "A3 joins", "New charger at (0, 2)");
    await playground.button("Take back: New charger at (0, 2)").click();
    await lists(playground, "A3 joins");
    await playground.act("Undo");
    await lists(playground, "A3 joins", "New charger at");
    await playground.act("Undo");
    await adapt(playground);
    await column(playground, "New times").getByRole("button", { name: /^Use this plan/ }).click();
    await playground.says(/^The world changed at time 1/);
    await playground.act("Undo");
    await playground.says(/^At time 1: /);
    await playground.act("Redo");
    await playground.says(/^The world changed at time 1/);
  });

  flow("an obstacle on a path frees its agent; one on an agent is refused", async (playground) => {
    await running(playground);
    await begin(playground);
    await playground.pick("Obstacle");
    await playground.stroke([1, 0]);
    await playground.warns(/found an obstacle at \(1, 0\), where A1 is at time 1/);
    await playground.picture("change-refused");
    await playground.key("Escape");
    await playground.stroke([2, 0]);
    await inspect(playground);
    await lists(playground, "New obstacle at (2, 0)", "A1 would run into (2, 0) at 2");
    await adapt(playground);
    assert.match(await column(playground, "New times").innerText(), /Freed\s+A1[^]*obstacle at \(2, ?0\)/);
    await playground.picture("comparing-freed");
  });

  flow("what cannot be waited for is cancelled at once, and discarding leaves all as it was", async (playground) => {
    await playground.says(/^Optimal: makespan 18/);
    await playground.key("Home", "x");
    await playground.says(/^The world changes at time 0/);
    await playground.pick("Charger");
    await playground.stroke([1, 0]);
    await inspect(playground);
    await lists(playground, "New charger at (1, 0)");
    await playground.press("Find new plans");
    // It may be done already: that is not waited for.
    await playground.button("Cancel").click({ timeout: 2000 }).catch(() => undefined);
    await playground.page.getByRole("button", { name: /^Find (new plans|again)$/ }).waitFor();
    await playground.inspector.getByRole("button", { name: "Discard" }).or(playground.button("Discard")).first().click();
    await playground.says(/^Optimal: makespan 18/);
    await playground.cellTells(1, 0, /^(free|A1)/);
  }, { screens: ["desktop"] });

  flow("all of it by keys", async (playground) => {
    await running(playground);
    await playground.key("x");
    await playground.says(/^The world changes at time 1/);
    await playground.board.focus();
    await playground.key("a", "ArrowRight", "ArrowRight", "ArrowDown", "ArrowDown", "Enter");
    await playground.says(/^A3 starts at \(2, 2\)/);
    await playground.key("ArrowUp", "ArrowUp", "ArrowLeft", "Enter", "Escape");
    await lists(playground, "A3 joins at (2, 2)");
    await playground.key("Control+Enter");
    await playground.says(/^At time 1: /);
    await column(playground, "Everything new").getByRole("button", { name: /^Use this plan/ }).focus();
    await playground.key("Enter");
    await playground.says(/^The world changed at time 1; the plan went on with “[^”]+”/);
    await playground.key("Control+z");
    await playground.says(/^At time 1: /);
  }, { screens: ["desktop"] });

  flow("saves scene, plan and changes, and opens them together", async (playground) => {
    await running(playground);
    await begin(playground);
    await join(playground, [2, 2], [1, 0]);
    await adapt(playground);
    await column(playground, "New times").getByRole("button", { name: /^Use this plan/ }).click();
    await playground.says(/^The world changed at time 1/);
    const saved = [];
    for (const item of ["Save scene", "Save plan", "Save changes"]) {
      const download = playground.page.waitForEvent("download");
      await playground.press("Save");
      await playground.press(item);
      const file = await download;
      saved.push({ name: file.suggestedFilename(), bytes: readFileSync(await file.path()) });
    }
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4/);
    await playground.open(...saved);
    await playground.says(/^The world changed at time 1; the plan went on: makespan 4/);
    assert.match((await playground.planRows()).map((row) => row[0]).join(), /A3/);
  }, { screens: ["desktop"] });

  flow("comparing in the dark", async (playground) => {
    await running(playground);
    await begin(playground);
    await join(playground, [2, 2], [1, 0]);
    await inspect(playground);
    await playground.key("Escape");
    await adapt(playground);
    await playground.picture("comparing-dark");
  }, { colorScheme: "dark" });
});
