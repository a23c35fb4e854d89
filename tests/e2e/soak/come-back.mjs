// Going and coming back: undo, redo, reloads, links, scenes by name. Nothing is lost by any of it.

import assert from "node:assert/strict";

import { follow, scenes } from "../recover.mjs";
import { eventually } from "../wait.mjs";
import { pressIf } from "./hands.mjs";
import { reloadsUnkept } from "./refused.mjs";
import { look, made, nameOf, shared, tellsAgain } from "./told.mjs";

const SENT = "giveway=1&map=3.9f&name=sent&rules=0.0&costs=0&agents=A.0.0.2.2&plan=2r2d";

/** Some steps back, and perhaps some forth. */
async function undoes(sitting) {
  sitting.hasMoved = true;
  for (let steps = 1 + sitting.dice.roll(4); steps > 0; steps -= 1) {
    await pressIf(sitting.playground.button("Undo"));
  }
  for (let steps = sitting.dice.roll(3); steps > 0; steps -= 1) {
    await pressIf(sitting.playground.button("Redo"));
  }
}

/** All is as it was after a reload. */
async function reloads(sitting) {
  if (sitting.isRefused) {
    return reloadsUnkept(sitting);
  }
  const before = await sitting.calm();
  await sitting.reload();
  await tellsAgain(sitting.page, "after a reload", before);
  assert.equal(await shared(sitting.playground), sitting.document, "after a reload");
}

/** Opens a link, and perhaps goes back to what it took the place of by one press. */
async function opensLink(sitting) {
  const { dice, playground, page } = sitting;
  const before = await sitting.calm();
  sitting.links.push(sitting.document);
  const link = dice.oneIn(2) ? SENT : dice.pick(sitting.links);
  const isTouched = await playground.button("Undo").isEnabled();
  await follow(page, link);
  await eventually("the link to be taken", () => page.evaluate(() => location.hash), (hash) => hash === "");
  await sitting.calm();
  assert.equal(made(await shared(playground)), made(link), "the link is shown");
  const back = playground.button("Back to it");
  assert.equal(await back.count() > 0 || (await look(page)).slot !== "", isTouched, "the scene that the link displaced is offered");
  if (dice.oneIn(2) && await back.count() > 0) {
    sitting.note("and goes back");
    await back.click();
    await tellsAgain(page, "back from a link", before);
  }
}

/** Keeps the scene by its name, or opens one that was kept. */
async function keepsScene(sitting) {
  const { dice, playground, page, document } = sitting;
  await scenes(playground);
  const dialog = page.getByRole("dialog", { name: "Scenes" });
  const name = nameOf(document);
  await dialog.getByRole("button", { name: /^Keep/ }).click();
  if (sitting.isRefused) {
    await playground.warns(/has no room for the scene/);
    await playground.key("Escape");
    return;
  }
  sitting.kept.set(name, document);
  const [opened, kept] = dice.pick([...sitting.kept]);
  sitting.note(`${name}, and opens ${opened}`);
  await dialog.getByRole("button", { name: opened, exact: true }).first().click();
  await dialog.waitFor({ state: "detached" });
  await sitting.calm();
  assert.equal(made(await shared(playground)), made(kept), "the scene that was kept");
}

export const comingBack = [
  [4, undoes],
  [3, reloads],
  [2, opensLink],
  [1, keepsScene],
];
