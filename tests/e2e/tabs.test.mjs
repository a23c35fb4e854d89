// Two tabs of one browser do not overwrite each other: what the other one made is told, taken,
// or left to a person.

import { describe } from "node:test";

import { flows, LOOKS } from "./flow.mjs";
import { deafen, edit, follow, goApart, look, opened, OPENING, scenes, stroke, tab } from "./recover.mjs";
import { eventually } from "./wait.mjs";

describe("two tabs", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`that both go on ask, ${theme}`, async (playground, { context, host }) => {
      const other = await goApart(playground, context, host);
      await playground.tells(/Another tab changed this scene.*Undo brings back the one you do not take\./s);
      await look(playground, `slot-tab-${theme}`);
      await playground.cellTells(9, 1, /^obstacle/);
      await playground.press("Take theirs");
      await playground.tells(/^$/);
      await playground.cellTells(8, 0, /^charger/);
      await playground.cellTells(9, 1, /^(?!obstacle)/);
      await playground.press("Undo");
      await playground.cellTells(9, 1, /^obstacle/);
      await other.page.close();
    }, { theme, screens, before: deafen });
  }

  flow("that both go on may keep their own", async (playground, { context, host }) => {
    const other = await goApart(playground, context, host);
    await playground.tells(/Another tab changed this scene/);
    await playground.press("Keep mine");
    await playground.tells(/^$/);
    await playground.cellTells(9, 1, /^obstacle/);
    await playground.press("Undo");
    await playground.cellTells(8, 0, /^charger/);
    await other.page.close();
  }, { screens: ["desktop"], before: deafen });

  for (const { theme, screens } of LOOKS) {
    flow(`of which one only watches follow the other, ${theme}`, async (playground, { context, host }) => {
      await playground.says(OPENING);
      const other = await tab(playground, context, host);
      await other.says(OPENING);
      await stroke(other, "Obstacle", [0, 1]);
      await playground.tells(/Another tab changed this scene.*There \(0, 1\) is an obstacle\. It is shown here, too\./s);
      await playground.cellTells(0, 1, /^obstacle/);
      await look(playground, `slot-taken-${theme}`);
      await playground.press("Undo it here");
      await playground.cellTells(0, 1, /^(?!obstacle)/);
      await playground.tells(/^$/);
      // The other one stays as it is.
      await other.cellTells(0, 1, /^obstacle/);
      await other.page.close();
    }, { theme, screens });
  }

  flow("keep a scene each, and come back to their own", async (playground, { context, host }) => {
    await playground.example("No way past");
    await playground.shows("scenario 6");
    // What a new tab opens is what was kept once the page was calm.
    await eventually("it to be kept", () => playground.keeps(), (text) => text.includes("scenario%206"));
    const other = await tab(playground, context, host);
    await other.shows("scenario 6");
    await other.example("Who waits?");
    await other.shows("scenario 1");
    await eventually("it to be kept", () => other.keeps(), (text) => text.includes("scenario%201"));
    await playground.tells(/^$/);
    for (const [each, name] of [[playground, "scenario 6"], [other, "scenario 1"]]) {
      await each.reload();
      await each.shows(name);
      await opened(each);
    }
    // A new tab opens what was kept last.
    const before = await playground.keeps();
    await stroke(playground, "Obstacle", [1, 2]);
    await eventually("it to be kept", () => playground.keeps(), (text) => text !== before);
    const third = await tab(playground, context, host);
    await third.shows("scenario 6");
    // What a closed tab leaves behind is among the scenes.
    await other.page.close();
    await scenes(third);
    const dialog = third.page.getByRole("dialog", { name: "Scenes" });
    await third.picture("scenes-other-tabs");
    await dialog.getByRole("button", { name: "scenario 1", exact: true }).click();
    await third.shows("scenario 1");
    await third.page.close();
  }, { screens: ["desktop"] });

  flow("of one number get another one", async (playground, { context, host, page }) => {
    await edit(playground);
    await eventually("it to be kept", () => playground.keeps(), (text) => text.includes("touched"));
    const number = await page.evaluate(() => localStorage.getItem("giveway.tabs").split(" ")[0]);
    // As a browser does that duplicates a tab whose page is away.
    const other = await tab(playground, context, host, (number) => sessionStorage.setItem("giveway.tab", number), number);
    await stroke(other, "Charger", [9, 1]);
    const numbers = () => page.evaluate(() => Object.keys(localStorage).filter((name) => name.startsWith("giveway.tab.")));
    await eventually("two documents", numbers, (names) => names.length === 2);
    await other.page.close();
  }, { screens: ["desktop"] });
});
