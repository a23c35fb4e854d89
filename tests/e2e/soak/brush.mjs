// Editing on the board: brushes, robots, what is dragged from cell to cell.

import { cellOf, changes, draw, home, take } from "./hands.mjs";

const GROUNDS = ["Obstacle", "Charger", "Slow zone"];

/** A brush on a free cell, or on a stroke from it. */
async function paints(sitting) {
  const { dice, playground } = sitting;
  const tool = dice.pick(GROUNDS);
  await take(sitting, tool);
  const cell = await cellOf(sitting, (words) => words === "free");
  if (!cell) {
    return;
  }
  sitting.note(`${tool} at ${cell}`);
  const to = dice.oneIn(3) ? await cellOf(sitting, () => true) : cell;
  await draw(sitting, cell, to);
  await changes(sitting, cell, "free");
  await playground.says(/./);
}

async function erases(sitting) {
  await take(sitting, "Erase");
  const cell = await cellOf(sitting, (words) => /^(obstacle|charger|slow zone)$/.test(words));
  if (cell) {
    sitting.note(`at ${cell}`);
    const words = await sitting.playground.onCell(...cell);
    await draw(sitting, cell);
    await changes(sitting, cell, words);
  }
}

/** A new robot, from one cell to another. */
async function addsRobot(sitting) {
  await take(sitting, "Robot");
  const from = await cellOf(sitting, (words) => words === "free");
  const to = await cellOf(sitting, (words) => words === "free" || words === "charger");
  if (from && to && String(from) !== String(to)) {
    sitting.note(`from ${from} to ${to}`);
    await draw(sitting, from, to);
    await changes(sitting, from, "free");
  }
}

/** What is on a cell goes to another one. */
async function drags(sitting) {
  await home(sitting);
  const { playground } = sitting;
  if (await playground.time.count() > 0 && await playground.button("To start").isEnabled()) {
    await playground.press("To start");
    await playground.reaches(0);
  }
  const from = await cellOf(sitting, (words) => /start of|goal of|^obstacle|^charger|waypoint of/.test(words));
  const to = await cellOf(sitting, (words) => words === "free");
  if (from && to) {
    sitting.note(`${await playground.onCell(...from)} at ${from} to ${to}`);
    await draw(sitting, from, to);
    await changes(sitting, to, "free");
  }
}

export const painting = [
  [8, paints],
  [3, erases],
  [3, addsRobot],
  [3, drags],
];
