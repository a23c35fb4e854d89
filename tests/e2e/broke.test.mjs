// A page that breaks down saves first, says so, and offers to go on.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { flows, LOOKS } from "./flow.mjs";
import { breakDown, edit, look, OPENING } from "./recover.mjs";
import { eventually } from "./wait.mjs";

describe("a page that breaks down", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`saves, says so, and goes on, ${theme}`, async (playground, { page }) => {
      await edit(playground);
      await breakDown(playground);
      const overlay = page.getByRole("alertdialog", { name: "Something went wrong in the page." });
      await overlay.getByText("Your work is saved.").waitFor();
      await look(playground, `broke-${theme}`);
      await overlay.getByText("What happened").click();
      await overlay.getByText(/panicked at/).waitFor();
      await overlay.getByRole("button", { name: "Reload the page" }).click();
      await overlay.waitFor({ state: "detached" });
      await playground.board.waitFor();
      await playground.cellTells(0, 1, /^obstacle/);
      await playground.tells(/^$/);
      await playground.press("Undo");
      await playground.cellTells(0, 1, /^(?!obstacle)/);
    }, { theme, screens, complains: true });
  }

  flow("as it opens puts aside what it opened", async (playground, { context, page }) => {
    await edit(playground);
    await eventually("the edit to be kept", () => playground.keeps(), (text) => text.includes("touched"));
    // It breaks down when it opens what is kept, and only then.
    await context.addInitScript(() => {
      const create = Document.prototype.createElementNS;
      Document.prototype.createElementNS = function (...words) {
        if (sessionStorage.getItem("giveway.opening")) {
          throw new Error("out of order");
        }
        return create.apply(this, words);
      };
    });
    const overlay = page.getByRole("alertdialog");
    await page.reload();
    await overlay.getByRole("button", { name: "Reload the page" }).waitFor();
    await overlay.getByRole("button", { name: "Reload the page" }).click();
    await playground.says(OPENING);
    await playground.tells(/broke down when it opened what was kept/);
    await look(playground, "slot-breaks");
    await playground.cellTells(0, 1, /^(?!obstacle)/);
    const download = page.waitForEvent("download");
    await playground.press("Download it");
    assert.match(readFileSync(await (await download).path(), "utf8"), /^giveway-kept=2\n/);
  }, { complains: true, fresh: true, screens: ["desktop"] });
});
