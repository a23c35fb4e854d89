// An answer while it comes and what is done with it: places, what could be done instead, robots
// and cells in its sentences, waits that are pressed in a lane.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

describe("an answer layer by layer", () => {
  const flow = flows();

  flow("has a place for every part from the first moment, and keeps them", async (playground) => {
    await begun(playground);
    // What is on the screen is remembered at each change: no part is missing once it was there.
    await playground.page.evaluate(() => {
      globalThis.panels = [];
      const look = () => {
        const card = document.querySelector(".insp .qh")?.closest(".insp");
        if (card) {
          panels.push({
            verdict: !!card.querySelector(".verdict"),
            foot: card.querySelector(".foot")?.innerText ?? "",
            // Where what is stopped or closed by stands, and how high the sentence above the board is.
            last: card.querySelector(".foot .last")?.getBoundingClientRect().bottom,
            head: document.querySelector(".status")?.getBoundingClientRect().height,
          });
        }
      };
      new MutationObserver(look).observe(document.querySelector("#inspector"), { subtree: true, childList: true });
    });
    await playground.inspector.getByRole("button", { name: /^Why does A2 wait at \(3, 1\)\?/ }).first().click();
    await playground.button("Show the other plan").waitFor({ timeout: 60_000 });
    await playground.answered();
    const panels = await playground.page.evaluate(() => globalThis.panels);
    assert.ok(panels.length > 0);
    assert.deepEqual(panels.filter(({ verdict }) => !verdict), [], "the verdict or its place");
    for (const part of ["last", "head"]) {
      const places = panels.map((panel) => panel[part]).filter((place) => place !== undefined);
      assert.ok(Math.max(...places) - Math.min(...places) < 2, `${part} keeps its place: ${new Set(places)}`);
    }
    assert.ok(panels.some(({ foot }) => /Whole/.test(foot) && /Cancel/.test(foot)), "how far it is, and a way to stop");
    assert.match(await playground.inspector.locator(".qh").innerText(), /A2 waits at \(3, 1\) from time 0 to 1\./);
    await playground.picture("answered");
  }, { screens: BOTH });

  flow("lights up robots of its sentence, and shows what could be done instead", async (playground) => {
    await begun(playground);
    await playground.inspector.getByRole("button", { name: /^Why does A2 wait at \(3, 1\)\?/ }).first().click();
    await playground.answered();
    const robot = playground.inspector.locator(".vs").getByRole("button", { name: "A1" }).first();
    await robot.click();
    const row = playground.inspector.getByRole("button", { name: /^A1 arrives/ });
    await eventually("its row to be lit", () => row.getAttribute("aria-pressed"), (pressed) => pressed === "true");
  }, { screens: ["desktop"] });

  flow("asks about the wait that is pressed in a lane", async (playground) => {
    await begun(playground);
    await playground.key("Escape");
    await playground.press("To end");
    // The bars take the press: a wait is a hollow bar. A phone has the question in another tab.
    await playground.showTab("Timeline");
    const wait = await playground.page.locator(".lane").filter({ hasText: "A2" }).locator(".waits").first().boundingBox();
    await playground.page.mouse.click(wait.x + wait.width / 2, wait.y + wait.height / 2);
    await playground.inspector.getByRole("heading", { name: "A2", level: 2 }).waitFor();
    if (!playground.isPhone()) {
      await playground.reaches(0);
    }
    await playground.inspector.getByRole("button", { name: /^Why does A2 wait at \(3, 1\)\?/ }).first().click();
    await playground.button("Show the other plan").waitFor({ timeout: 60_000 });
  }, { screens: ["desktop", "phone"] });
});

/** Two robots, of which A2 waits at the start, and A2 is selected. */
async function begun(playground) {
  await playground.example("Who waits?");
  await playground.says(/^Optimal: makespan 4/);
  await playground.press("To start");
  await playground.reaches(0);
  await playground.showTab("Inspector");
  await playground.inspector.getByRole("button", { name: /^A2\b/ }).first().click();
}
