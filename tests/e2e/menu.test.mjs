// Every entry of the menus does what it says, in each language: what is looked up on the page
// must not be looked up by words.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const LANGUAGES = [
  { tag: "en", more: "More", save: "Save", saves: /^Save /, solved: /^Optimal: makespan 18/ },
  { tag: "de", more: "Mehr", save: "Speichern", saves: / speichern( \(.*\))?$/, solved: /^Optimal: Makespan 18/ },
];
/** A browser without a hand at it lets no page read what was copied. */
const NEEDS_LEAVE = /^(Paste|Einfügen)$/;

describe("menus", () => {
  const flow = flows();

  for (const { tag, more, save, saves, solved } of LANGUAGES) {
    flow(`do what each entry says, ${tag}`, async (playground, { page, host, screen }) => {
      const open = async () => {
        await playground.goto(`${host.url}?lang=${tag}`);
        await playground.says(solved);
        await playground.press(screen === "phone" ? more : save);
      };
      const entries = page.locator(".menu").getByRole("button");
      await open();
      const names = await entries.allInnerTexts();
      assert.ok(names.length >= (screen === "phone" ? 18 : 8), names.join(", "));
      // A German noun stays one within a name: "Beweisgang: Schranken".
      assert.deepEqual(names.filter((name) => tag === "de" && /^Beweisgang: [a-zäöü]/.test(name)), []);
      for (const [index, name] of names.entries()) {
        if (NEEDS_LEAVE.test(name)) {
          continue;
        }
        await open();
        const loads = saves.test(name) ? page.waitForEvent("download", { timeout: 60_000 }) : Promise.resolve();
        await entries.nth(index).click();
        await loads.catch((error) => assert.fail(`${name}: ${error.message}`));
        await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
        assert.equal(await page.locator(".notices").getByRole("alert").innerText(), "", name);
      }
    }, { screens: ["desktop", "phone"], timeout: 600_000 });
  }
});

describe("notices", () => {
  const flow = flows();

  flow("are calm where they inform, and alarm where something is refused", async (playground, { page }) => {
    await playground.says(/^Optimal: makespan 18/);
    const told = async () => {
      const regions = await Promise.all(["status", "alert"].map((role) => playground.notice.getByRole(role).innerText()));
      return regions.map((text) => text.split("\n")[0]);
    };
    await playground.pick("Erase");
    await playground.cell(0, 1).click();
    await playground.cell(0, 1).click();
    await eventually("the information", told, ([calm]) => calm === "There is nothing to erase here.");
    assert.equal((await told())[1], "", "it is no alarm");
    await playground.picture("notice-information");
    await playground.open({ name: "a.png", bytes: Buffer.from("\x89PNG\r\n\x1a\n\0", "latin1") });
    await eventually("the refusal", told, ([calm, alarm]) => calm === "" && alarm !== "");
    await playground.picture("notice-refusal");
    const edges = await page.locator(".notice").evaluate((notice) => notice.className);
    assert.match(edges, /refusal/);
  }, { screens: ["desktop", "phone"] });
});
