// A floor in parts and under rules: areas that are framed and changed as a whole, zones with rules,
// switches and prices of rules.

import { cellOf, draw, home, pressIf, take } from "./hands.mjs";

/** What is done with an area that is framed: keys, one after the other. */
const CHANGES = [
  ["Delete"], ["h", "Enter"], ["t", "Enter"], ["ArrowRight", "Enter"], ["ArrowDown", "ArrowDown", "Enter"], ["ArrowLeft", "Escape"],
  ["Control+d", "Enter"], ["Control+c", "Control+v", "ArrowUp", "Enter"], ["Escape"],
];

/** Frames some cells, and changes what is in them. */
async function changesArea(sitting) {
  const { dice, page } = sitting;
  await home(sitting);
  const from = await cellOf(sitting, (words) => words === "free");
  const to = await cellOf(sitting, () => true);
  if (!from || !to || String(from) === String(to)) {
    return;
  }
  await draw(sitting, from, to);
  const keys = dice.pick(CHANGES);
  sitting.note(`${from} to ${to}: ${keys.join(", ")}`);
  await sitting.playground.board.focus();
  for (const key of keys) {
    await page.keyboard.press(key);
  }
  // It may be refused, with a reason, and then stays.
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
}

/** Marks a zone or a lane, and adds the rule that comes with it, or does not. */
async function marks(sitting) {
  const { dice, playground } = sitting;
  const tool = dice.pick(["Zone", "Zone", "One-way"]);
  await take(sitting, tool);
  const from = await cellOf(sitting, (words) => words === "free" || words.startsWith("slow zone"));
  if (!from) {
    return;
  }
  const to = [from[0] + 1, from[1]];
  const isThere = await playground.cell(...to).count() > 0;
  sitting.note(`${tool} from ${from}`);
  await draw(sitting, from, ...(isThere ? [to] : []));
  const { inspector } = playground;
  const next = inspector.getByRole("button", { name: dice.pick(["Add the rule", "Add the rule", "Cancel"]), exact: true });
  if (await next.isVisible() && await next.isEnabled()) {
    await pressIf(next);
  }
  await home(sitting);
}

/** A rule is switched, or all have their prices told. */
async function switchesRules(sitting) {
  const { dice, playground } = sitting;
  await home(sitting);
  const { inspector } = playground;
  const switches = inspector.getByRole("switch").or(inspector.getByRole("checkbox", { name: /in force/ }));
  const count = await switches.count();
  if (count > 0 && dice.oneIn(2)) {
    sitting.note("a switch");
    await switches.nth(dice.roll(count)).click({ force: true });
  } else if (await pressIf(inspector.getByRole("button", { name: "What do the rules cost?" }))) {
    sitting.note("prices");
    await sitting.calm();
  }
}

export const flooring = [
  [3, changesArea],
  [3, marks],
  [2, switchesRules],
];
