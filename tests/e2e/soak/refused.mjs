// A browser that keeps nothing from some moment on: the page says so and goes on.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";

import { eventually } from "../wait.mjs";
import { cellOf, draw, openExample, pressIf, take } from "./hands.mjs";
import { look, made, shared } from "./told.mjs";

/** Runs in the page. */
function refuse() {
  const refused = () => {
    throw new DOMException("no room", "QuotaExceededError");
  };
  Storage.prototype.setItem = refused;
  IDBFactory.prototype.open = refused;
}

/** From now on the browser of this sitting keeps nothing, in no tab. The page says so once there is something to miss. */
export async function refusesStorage(sitting) {
  const { playground, page, context } = sitting;
  await context.addInitScript(refuse);
  await page.evaluate(refuse);
  sitting.isRefused = true;
  await openExample(playground, "Siding");
  await take(sitting, "Charger");
  await draw(sitting, await cellOf(sitting, (words) => words === "free"));
  await eventually("the page to say that nothing is kept", () => look(page), ({ slot }) => slot.includes("Your work is not being kept"));
  const download = page.waitForEvent("download");
  await playground.press("Download it");
  const bytes = readFileSync(await (await download).path());
  const document = await shared(playground);
  await openExample(playground, "Swap");
  await playground.open({ name: "siding.giveway", bytes });
  await playground.shows("siding");
  assert.equal(made(await shared(playground)), made(document), "what was downloaded");
}

/** After a reload the page is what it was when it was kept last; a link brings the document of now back. */
export async function reloadsUnkept(sitting) {
  const { playground, page, document } = sitting;
  sitting.hasMoved = true;
  await sitting.reload();
  await sitting.calm();
  await page.evaluate((link) => {
    location.hash = link;
  }, document);
  await eventually("the link to be taken", () => page.evaluate(() => location.hash), (hash) => hash === "");
  await sitting.calm();
  assert.equal(made(await shared(playground)), made(document), "the link brings it back");
  await pressIf(playground.slot.getByRole("button", { name: "Close" }));
}
