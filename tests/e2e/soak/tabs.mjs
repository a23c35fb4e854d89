// Another tab of the same browser: what is done there takes nothing away here.

import assert from "node:assert/strict";

import { scenes, stroke } from "../recover.mjs";
import { eventually } from "../wait.mjs";
import { EXAMPLES, cellOf, openExample, pressIf } from "./hands.mjs";
import { look, made, nameOf, shared, tellsAgain } from "./told.mjs";

/** Opens another scene in another tab, edits it and closes it: this one stays, and the other is among the scenes. */
async function worksElsewhere(sitting) {
  const { dice, playground, page } = sitting;
  const before = await sitting.calm();
  const other = await sitting.tab();
  // What is done there to a scene of the same name would be shown here, too.
  const [title] = dice.pick(EXAMPLES.filter(([, name]) => name !== nameOf(sitting.document)));
  sitting.note(title);
  await openExample(other, title);
  const cell = await cellOf({ playground: other, dice }, (words) => words === "free");
  if (cell) {
    await stroke(other, "Charger", cell);
    await other.cellTells(...cell, /^charger/);
  }
  const left = await shared(other);
  await tellsAgain(page, "while another tab works on another scene", before);
  await sitting.close(other);
  await tellsAgain(page, "after another tab was closed", before);
  if (!sitting.isRefused && left !== sitting.document && dice.oneIn(2)) {
    await findsAgain(sitting, left);
  }
}

/** What a closed tab left is among the scenes; opening it is a step that Undo takes back. */
async function findsAgain(sitting, left) {
  const { playground, page } = sitting;
  const name = nameOf(left);
  sitting.note(`and opens ${name} here`);
  await scenes(playground);
  const dialog = page.getByRole("dialog", { name: "Scenes" });
  const others = dialog.getByRole("button", { name, exact: true });
  await others.first().waitFor();
  // The one left last stands first among those of other tabs.
  const heading = dialog.getByRole("heading", { name: "Left in other tabs" });
  const list = await heading.count() > 0 ? heading.locator("xpath=following-sibling::ul[1]") : dialog;
  await list.getByRole("button", { name, exact: true }).first().click();
  await dialog.waitFor({ state: "detached" });
  assert.equal(made(await shared(playground)), made(left), "what the other tab left");
}

/** The same scene is edited in another tab: it is shown here, or a person is asked; nothing of either is lost. */
async function editsElsewhere(sitting) {
  const { dice, playground, page } = sitting;
  if (sitting.isRefused) {
    return;
  }
  await eventually("this tab to be kept", () => playground.keeps(), (text) => text !== "");
  await new Promise((resolve) => setTimeout(resolve, 500));
  const other = await sitting.tab();
  const mine = made(sitting.document);
  const isSame = made(await shared(other)) === mine;
  const cell = await cellOf({ playground: other, dice }, (words) => words === "free");
  // Else an edit would be a change of the world, or refused.
  const edits = !/^(Steering|Changing|\d answers?|Impossible At)/.test((await look(other.page)).status);
  if (!isSame || !cell || !edits || !await other.tools.isVisible()) {
    await sitting.close(other);
    return;
  }
  await stroke(other, "Slow zone", cell);
  await other.cellTells(...cell, /slow zone/);
  const theirs = made(await shared(other));
  await sitting.close(other);
  sitting.hasMoved = true;
  await eventually("what the other tab did to be told", () => look(page), ({ slot }) => slot.includes("Another tab changed this scene"));
  const take = dice.oneIn(2);
  const asked = await pressIf(playground.button(take ? "Take theirs" : "Keep mine"));
  sitting.note(asked ? `asked, and takes ${take ? "theirs" : "its own"}` : "taken");
  assert.equal(made(await shared(playground)), asked && !take ? mine : theirs, "what the page shows after another tab's edit");
  await playground.press("Undo");
  const back = made(await shared(playground));
  await playground.press("Redo");
  assert.equal(back, asked && !take ? theirs : mine, "Undo brings back the one that was not taken");
}

export const elsewhere = [
  [1, worksElsewhere],
  [1, editsElsewhere],
];
