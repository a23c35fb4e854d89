// Solving, cancelling, going on; asking why, with going away in the middle.

import { sample } from "../flow.mjs";
import { planned, pressIf, worker } from "./hands.mjs";

/** Too hard for the time limit of a sitting. */
const HARD = sample("mmapf/A17_mm_20x20_o15_a30.json");

/** Does what is due, whatever the mode is. */
async function works(sitting) {
  if (await pressIf(worker(sitting))) {
    await sitting.calm();
  }
}

/** Begins what is due, and cancels it at once or soon. */
async function cancels(sitting) {
  const { dice, playground } = sitting;
  await pressIf(worker(sitting));
  await new Promise((resolve) => setTimeout(resolve, dice.roll(150)));
  // It may be over before.
  await playground.button("Cancel").click({ timeout: 200 }).catch(() => undefined);
  await sitting.calm();
}

/** Solves what is too hard, cancels or waits for the time limit, and goes on. */
async function goesOn(sitting) {
  const { dice, playground } = sitting;
  await playground.open(HARD);
  await playground.shows("A17");
  await worker(sitting).click();
  if (dice.oneIn(2)) {
    await new Promise((resolve) => setTimeout(resolve, 200 + dice.roll(800)));
    await playground.button("Cancel").click({ timeout: 500 }).catch(() => undefined);
  }
  await sitting.calm();
  if (await pressIf(playground.button("Go on"))) {
    sitting.note("again");
    await sitting.calm();
  }
}

/** Looks for the Pareto front, and shows one of its plans. */
async function findsFront(sitting) {
  const { dice, playground } = sitting;
  await planned(sitting);
  const turns = async () => {
    await playground.openSettings();
    await playground.settings.getByText("Pareto front of two or three costs").click();
    await playground.closeSettings();
  };
  await turns();
  await pressIf(worker(sitting));
  await sitting.calm();
  await turns();
  const plans = playground.inspector.getByRole("list", { name: "Pareto front" }).getByRole("button");
  const count = await plans.count();
  sitting.note(`of ${count}`);
  if (count > 0) {
    await plans.nth(dice.roll(count)).click();
  }
}

/** Asks what is offered; waits for the answer, or goes away from it in between. */
async function asks(sitting) {
  const { dice, playground, page } = sitting;
  const { inspector } = playground;
  let questions = inspector.getByRole("button", { name: /^Why / });
  if (await questions.count() === 0 || dice.oneIn(3)) {
    await planned(sitting);
    questions = inspector.getByRole("button", { name: /^Why / });
  }
  const robots = inspector.getByRole("button", { name: /\(\d+, ?\d+\) to \(\d+, ?\d+\)/ });
  const count = await robots.count();
  if (count > 0 && dice.oneIn(2)) {
    await robots.nth(dice.roll(count)).click();
  }
  const offered = await questions.count();
  if (offered === 0) {
    return;
  }
  const question = questions.nth(dice.roll(offered));
  sitting.note((await question.innerText()).split("\n")[0]);
  await question.click();
  // "Why not a plan in which ...?" takes a sentence first.
  if (await inspector.getByRole("button", { name: "Make it a rule" }).isVisible()) {
    await pressIf(inspector.getByRole("button", { name: dice.pick(["Ask", "Ask", "Make it a rule", "Cancel"]), exact: true }));
  }
  const next = dice.pick(["wait", "wait", "take", "take", "repair", "prove", "Escape", "Cancel", "Back", "Undo"]);
  sitting.note(`and ${next}`);
  if (["Escape", "Cancel", "Back", "Undo"].includes(next)) {
    await new Promise((resolve) => setTimeout(resolve, dice.roll(300)));
    sitting.hasMoved = next === "Undo";
    await (next === "Escape" ? playground.key(next) : pressIf(page.getByRole("button", { name: next, exact: true })));
    return;
  }
  await sitting.calm();
  if (next === "take") {
    await pressIf(playground.button("Show the other plan"));
    await pressIf(playground.button("Take the other plan"));
  } else if (next === "repair") {
    await pressIf(inspector.getByRole("listitem").filter({ hasText: /makespan \d+/ }).getByRole("button"));
  } else if (next === "prove") {
    await pressIf(playground.button("Check the proof"));
  }
  await sitting.calm();
}

/** Lets the proof of the plan be checked. */
async function proves(sitting) {
  await planned(sitting);
  await pressIf(sitting.playground.button("Check the proof"));
  await sitting.calm();
}

export const solving = [
  [5, works],
  [3, cancels],
  [1, goesOn],
  [7, asks],
  [1, proves],
  [1, findsFront],
];
