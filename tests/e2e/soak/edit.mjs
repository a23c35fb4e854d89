// Editing beside the board: a robot, the scene as a whole, its rules; other scenes.

import { EXAMPLES, home, openEdit, openExample, pressIf, selectRobot, type } from "./hands.mjs";
import { eventually } from "../wait.mjs";
import { look } from "./told.mjs";

async function deletesRobot(sitting) {
  await home(sitting);
  const name = await selectRobot(sitting);
  if (name && await openEdit(sitting, "Edit robot")) {
    sitting.note(name);
    await sitting.playground.inspector.getByRole("button", { name: "Delete robot" }).click();
    const starts = (words) => words.includes(`start of ${name},`) || words.endsWith(`start of ${name}`);
    await eventually(`${name} to be gone`, () => look(sitting.page), ({ cells }) => !cells.some(starts));
  }
}

/** A battery, another colour or another name. */
async function editsRobot(sitting) {
  await home(sitting);
  const name = await selectRobot(sitting);
  if (!name || !await openEdit(sitting, "Edit robot")) {
    return;
  }
  const { dice, playground } = sitting;
  const what = dice.pick(["name", "colour", "battery"]);
  sitting.note(`the ${what} of ${name}`);
  if (what === "name") {
    await type(sitting, "Name", `R${dice.roll(1000)}`);
  } else if (what === "colour") {
    const colours = playground.inspector.getByRole("radiogroup", { name: "Colour" }).getByRole("radio");
    await colours.nth(dice.roll(await colours.count())).check({ force: true });
  } else {
    await playground.inspector.getByRole("button", { name: dice.pick(["Battery", "No battery limit"]), exact: true }).click();
  }
}

async function beginsScene(sitting) {
  const { dice, playground, page } = sitting;
  const name = `room ${dice.roll(1000)}`;
  sitting.note(name);
  await playground.act("New");
  const dialog = page.getByRole("dialog", { name: "New scene" });
  await dialog.getByLabel("Name").fill(name);
  await dialog.getByLabel("Columns").fill(String(2 + dice.roll(8)));
  await dialog.getByLabel("Rows").fill(String(2 + dice.roll(6)));
  await dialog.getByRole("button", { name: "Create" }).click();
  await playground.shows(name);
}

async function opensExample(sitting) {
  const [title] = sitting.dice.pick(EXAMPLES);
  sitting.note(title);
  await openExample(sitting.playground, title);
}

/** Another name, another size, robots and obstacles by chance, or an empty floor. */
async function editsScene(sitting) {
  await home(sitting);
  const { dice, playground } = sitting;
  if (!await openEdit(sitting, "Edit scene")) {
    return;
  }
  const what = dice.pick(["Random scene", "Random scene", "Clear", "Width, cells", "Height, cells", "Name"]);
  sitting.note(what);
  if (what === "Random scene") {
    await type(sitting, "Robots", 1 + dice.roll(4));
    await type(sitting, "Obstacles, %", dice.roll(25));
    await type(sitting, "Seed", dice.roll(1000));
  }
  if (what === "Random scene" || what === "Clear") {
    await playground.inspector.getByRole("button", { name: what, exact: true }).click();
  } else {
    await type(sitting, what, what === "Name" ? `scene ${dice.roll(1000)}` : 2 + dice.roll(9));
    await resizes(sitting);
  }
}

/** Where a smaller floor would lose something, the page asks what becomes of it. */
async function resizes({ dice, playground }) {
  const { inspector } = playground;
  const make = inspector.getByRole("button", { name: /^Make it \d/ });
  if (!await make.isVisible()) {
    return;
  }
  const ways = inspector.getByRole("radio");
  const count = await ways.count();
  if (count > 0) {
    await ways.nth(dice.roll(count)).check();
  }
  await pressIf(dice.oneIn(4) ? inspector.getByRole("button", { name: "Cancel", exact: true }) : make);
}

/** The objective, a rule, or a limit, in the settings. */
async function setsRules(sitting) {
  const { dice, playground } = sitting;
  const { settings } = playground;
  await home(sitting);
  await playground.openSettings();
  const what = dice.pick(["goal", "floor", "horizon", "objective", "objective"]);
  sitting.note(what);
  if (what === "goal") {
    await settings.getByRole("button", { name: dice.pick(["stays", "leaves the map"]) }).click();
  } else if (what === "floor") {
    await playground.set("Battery floor", dice.roll(4));
  } else if (what === "horizon") {
    await playground.set("Horizon, steps", dice.pick(["", 3 + dice.roll(20)]));
  } else {
    await pressIf(settings.getByRole("button", { name: dice.pick([/^Raise/, /^Lower/, /^Add/, /^Remove/]) }));
  }
  await playground.closeSettings();
}

export const editing = [
  [1, deletesRobot],
  [2, editsRobot],
  [1, beginsScene],
  [3, opensExample],
  [3, editsScene],
  [2, setsRules],
];
