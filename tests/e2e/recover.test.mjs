// Nobody loses work, and nobody has to wonder whether they did: links, reloads, data that
// cannot be read, a browser that keeps nothing.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { BOTH, flows, LOOKS } from "./flow.mjs";
import { edit, follow, LINK, look, NEWER, OPENING, planted, scenes, stroke } from "./recover.mjs";
import { eventually } from "./wait.mjs";

describe("a link", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`keeps what it takes the place of, ${theme}`, async (playground, { page }) => {
      await edit(playground);
      await follow(page, LINK);
      await playground.shows("sent");
      await playground.tells(/Your own scene is kept.*Yours, “warehouse”, is where you left it\./s);
      await look(playground, `slot-link-${theme}`);
      await page.setViewportSize({ width: 1024, height: 768 });
      await look(playground, `slot-link-tablet-${theme}`);
    }, { theme, screens });
  }

  flow("is left by one press, and comes back by another", async (playground, { page }) => {
    await edit(playground);
    await follow(page, LINK);
    await playground.tells(/Your own scene is kept/);
    await playground.press("Back to it");
    await playground.shows("warehouse");
    await playground.cellTells(0, 1, /^obstacle/);
    await playground.tells(/The scene of the link is kept/);
    await playground.press("Back to it");
    await playground.shows("sent");
    await playground.slot.getByRole("button", { name: "Close" }).click();
    await playground.tells(/^$/);
    await playground.press("Undo");
    await playground.cellTells(0, 1, /^obstacle/);
  }, { screens: BOTH });

  flow("may be loaded again: the press is still there, and the scene among the others", async (playground, { page, host }) => {
    await edit(playground);
    await page.goto("about:blank");
    await playground.goto(`${host.url}#${LINK}`);
    await playground.tells(/Your own scene is kept/);
    await eventually("the link to be kept", () => playground.keeps(), (text) => text.includes("=name=sent"));
    await playground.reload();
    await playground.tells(/Your own scene is kept/);
    await scenes(playground);
    const dialog = page.getByRole("dialog", { name: "Scenes" });
    await dialog.getByRole("button", { name: "warehouse (before the link)", exact: true }).waitFor();
    await playground.picture("scenes-before-the-link");
    await playground.key("Escape");
    await playground.press("Back to it");
    await playground.cellTells(0, 1, /^obstacle/);
    // Kept once, not once a reload.
    const names = await page.evaluate(() => Object.keys(localStorage).filter((name) => name.includes("before the link")));
    assert.deepEqual(names, ["giveway.scene.warehouse (before the link)"]);
  });

  flow("takes the place of an example that nobody touched without a word", async (playground, { page }) => {
    await playground.says(OPENING);
    await follow(page, LINK);
    await playground.shows("sent");
    await playground.tells(/^$/);
  }, { screens: ["desktop"] });
});

describe("a reload", () => {
  const flow = flows();

  flow("keeps undo", async (playground) => {
    await edit(playground);
    await playground.pick("Charger");
    await playground.stroke([9, 1]);
    await playground.cellTells(9, 1, /^charger/);
    await playground.reload();
    await playground.cellTells(9, 1, /^charger/);
    await playground.press("Undo");
    await playground.cellTells(9, 1, /^(?!charger)/);
    await playground.cellTells(0, 1, /^obstacle/);
    await playground.press("Undo");
    await playground.cellTells(0, 1, /^(?!obstacle)/);
    await playground.says(OPENING);
  });

  flow("keeps what was done while it played", async (playground) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4/);
    // The plan plays round and round: only the time changes.
    await eventually("it to be kept", () => playground.keeps(), (text) => text.includes("name=scenario%201") && text.includes("plan="));
    await playground.reload();
    await playground.shows("scenario 1");
    await playground.says(/^Optimal: makespan 4/);
  }, { screens: ["desktop"] });

  flow("opens what the version before kept", async (playground, { page }) => {
    // It kept links without a check sum.
    const former = LINK.replace(/check=[^&]*&/, "");
    await playground.says(OPENING);
    await page.evaluate((former) => {
      const plant = () => {
        localStorage.clear();
        localStorage.setItem("giveway.page", former);
      };
      addEventListener("pagehide", plant);
      document.addEventListener("visibilitychange", plant);
    }, former);
    await playground.reload();
    await playground.shows("sent");
    await eventually("it to be kept", () => playground.keeps(), (text) => text.includes("=name=sent"));
    // A page of that version that is still open somewhere does no harm.
    assert.equal(await page.evaluate(() => localStorage.getItem("giveway.page")), former);
  }, { screens: ["desktop"] });
});

describe("what cannot be read", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`is offered and not overwritten, ${theme}`, async (playground, { page }) => {
      await edit(playground);
      await playground.reloadOn(NEWER);
      await playground.says(OPENING);
      await playground.tells(/We could not read what was kept.*newer version/s);
      await look(playground, `slot-lost-${theme}`);
      assert.equal(await playground.slot.getByRole("button", { name: "Close" }).count(), 0);
      // Editing is free, and is kept beside it. On a phone the sheet has to be answered first.
      if (playground.isPhone()) {
        await playground.press("Download it");
      }
      await edit(playground);
      await eventually("the edit to be kept", () => playground.keeps(), (text) => text.includes("touched"));
      assert.equal(await planted(page, NEWER), 1);
      if (playground.isPhone()) {
        return;
      }
      await playground.reload();
      await playground.cellTells(0, 1, /^obstacle/);
      await playground.tells(/We could not read what was kept/);

      const download = page.waitForEvent("download");
      await playground.press("Download it");
      const saved = await download;
      assert.equal(saved.suggestedFilename(), "kept.giveway");
      assert.equal(readFileSync(await saved.path(), "utf8"), NEWER);
      await playground.tells(/^$/);
      await playground.reload();
      await playground.cellTells(0, 1, /^obstacle/);
      await playground.tells(/^$/);
      assert.equal(await planted(page, NEWER), 1, "a newer page may still read it");
    }, { theme, screens });
  }

  for (const damaged of ["{", "giveway-kept=2\n+0.-.0", "giveway=1&map=5.7f", "\u0000"]) {
    flow(`begins anew on ${JSON.stringify(damaged)}`, async (playground, { page }) => {
      await playground.says(OPENING);
      await playground.reloadOn(damaged, { "giveway.preferences": damaged });
      await playground.says(OPENING);
      await playground.tells(/We could not read what was kept.*Nothing was deleted\./s);
      assert.equal(await planted(page, damaged), 1);
      await playground.press("Start afresh");
      await playground.tells(/^$/);
      await playground.reload();
      await playground.says(OPENING);
      await playground.tells(/^$/);
    }, { screens: ["desktop"] });
  }
});

describe("a browser that keeps nothing", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`is told of once, with a download, ${theme}`, async (playground, { page }) => {
      await playground.says(OPENING);
      await page.evaluate(() => {
        window.setItem = Storage.prototype.setItem;
        Storage.prototype.setItem = () => {
          throw new DOMException("no room", "QuotaExceededError");
        };
      });
      await edit(playground);
      await playground.tells(/Your work is not being kept/);
      await look(playground, `slot-unkept-${theme}`);
      const download = page.waitForEvent("download");
      await playground.press("Download it");
      const saved = await download;
      assert.equal(saved.suggestedFilename(), "warehouse.giveway");
      const bytes = readFileSync(await saved.path());
      await playground.tells(/^$/);
      await stroke(playground, "Charger", [9, 1]);
      await playground.pick("Select");
      await new Promise((resolve) => setTimeout(resolve, 1000));
      assert.equal(await playground.slot.getByRole("button").count(), 0, "it was told already");
      await page.evaluate(() => {
        Storage.prototype.setItem = window.setItem;
      });
      // What was downloaded can be opened again.
      await playground.open({ name: "warehouse.giveway", bytes });
      await playground.cellTells(9, 1, /^(?!charger)/);
      await playground.cellTells(0, 1, /^obstacle/);
    }, { theme, screens });
  }
});
