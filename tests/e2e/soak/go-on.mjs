// A plan that runs: the world changes, a robot is led by hand, somebody else's plan is judged.

import { save, drop } from "../recover.mjs";
import { eventually } from "../wait.mjs";
import { cellOf, draw, planned, pressIf, selectRobot, take, type, worker } from "./hands.mjs";
import { look } from "./told.mjs";

/** Goes to some time of the plan. */
async function seeks(sitting) {
  await sitting.playground.time.focus();
  await sitting.playground.key(sitting.dice.pick(["Home", "Home", "End"]));
  for (let steps = sitting.dice.roll(4); steps > 0; steps -= 1) {
    await sitting.playground.key(sitting.dice.pick([".", "."]));
  }
}

/** Lets the world change, finds plans, uses one, or leaves it as it is or for good. */
async function changesWorld(sitting) {
  const { dice, playground, page } = sitting;
  await planned(sitting);
  await seeks(sitting);
  if (!await pressIf(page.getByRole("button", { name: /^Change (the world )?here/ }))) {
    return;
  }
  await playground.says(/^The world changes at time/);
  for (let count = dice.roll(3); count >= 0; count -= 1) {
    await changesSomething(sitting);
  }
  if (dice.oneIn(5)) {
    return;
  }
  await pressIf(worker(sitting));
  if (dice.oneIn(6)) {
    sitting.note("cancelled");
    await playground.button("Cancel").click({ timeout: 200 }).catch(() => undefined);
  }
  await sitting.calm();
  const next = dice.pick(["Use this plan", "Use this plan", "Preview", "Discard", "stay"]);
  sitting.note(`and ${next}`);
  const buttons = page.getByRole("button", { name: new RegExp(`^${next}`) });
  const count = await buttons.count();
  if (count > 0) {
    await pressIf(buttons.nth(dice.roll(count)));
  }
}

async function changesSomething(sitting) {
  const { dice, playground } = sitting;
  const what = dice.pick(["Obstacle", "Charger", "Slow zone", "Robot", "Erase", "delay", "Remove"]);
  sitting.note(what);
  if (what === "delay" || what === "Remove") {
    await playground.pick("Select");
    const cell = await cellOf(sitting, (words) => /is here|start of/.test(words));
    if (cell) {
      await draw(sitting, cell);
    }
    const robot = playground.inspector.getByRole("region", { name: "Change this robot" });
    if (await robot.count() > 0) {
      await (what === "delay" ? breaksDown(sitting) : robot.getByRole("button", { name: /^Remove (?!waypoint)/ }).click());
    }
    return;
  }
  await take(sitting, what);
  const from = await cellOf(sitting, (words) => (what === "Erase" ? /^(obstacle|charger|slow zone)$/.test(words) : words === "free"));
  const to = what === "Robot" ? await cellOf(sitting, (words) => words === "free") : from;
  if (from && to) {
    await draw(sitting, from, to);
  }
}

/** The robot that is selected breaks down for some steps, or for good. */
async function breaksDown(sitting) {
  const { dice, page, playground } = sitting;
  await pressIf(playground.inspector.getByRole("button", { name: /^Breaks down here/ }));
  const card = page.getByRole("group", { name: "Breaks down here" });
  if (await card.count() === 0) {
    // Two breakdowns of a robot at once are refused.
    return;
  }
  await pressIf(card.getByRole("button", { name: /^How long: / }));
  const delay = card.getByLabel("Delay, steps", { exact: true });
  if (dice.oneIn(3)) {
    await pressIf(card.getByRole("button", { name: /^for good$/i }));
  } else if (await delay.count() > 0) {
    await type(sitting, "Delay, steps", 1 + dice.roll(4));
  }
}

/** Leads a robot by hand, lets the plan be checked, and takes a better one, stays, or leaves. */
async function leads(sitting) {
  const { dice, playground, page } = sitting;
  const { inspector } = playground;
  await planned(sitting);
  await seeks(sitting);
  const name = await selectRobot(sitting);
  if (!name || !await pressIf(inspector.getByRole("button", { name: /^Lead .* by hand$/ }))) {
    return;
  }
  await playground.says(new RegExp(`^${name} is at `));
  for (let steps = 1 + dice.roll(5); steps > 0; steps -= 1) {
    await pressIf(inspector.getByRole("button", { name: dice.pick(["Up", "Down", "Left", "Right", "Wait", "Back"]), exact: true }));
  }
  const next = dice.pick(["check", "check", "check", "Discard", "stay"]);
  sitting.note(`${name} and ${next}`);
  if (next === "check") {
    await playground.press("Check my plan");
    if (dice.oneIn(5)) {
      await playground.key("Escape");
    }
    await sitting.calm();
    if (dice.oneIn(2)) {
      await pressIf(playground.button("Show the other plan"));
      await pressIf(playground.button("Take the other plan"));
    }
  } else if (next === "Discard") {
    await pressIf(page.getByRole("button", { name: "Discard", exact: true }));
  }
}

/** Drops the plan of the scene, as it is or with one robot gone astray. */
async function dropsPlan(sitting) {
  const { dice, page, playground } = sitting;
  await planned(sitting);
  await playground.press("Save");
  const has = await playground.button("Save plan").count() > 0 && await playground.button("Save changes").count() === 0;
  await playground.press("Save");
  if (!has) {
    return;
  }
  const saved = await save(playground, "Save plan");
  const plan = JSON.parse(saved);
  const [name] = Object.keys(plan.paths);
  const wrong = dice.oneIn(2) && name !== undefined;
  if (wrong) {
    plan.paths[name] = plan.paths[name].map(() => [0, 0]);
  }
  sitting.note(wrong ? "that is wrong" : "that is right");
  await playground.key("Escape");
  await drop(page, { name: "plan.json", text: JSON.stringify(plan) });
  if (wrong) {
    await eventually("what is wrong with the plan", () => look(page), ({ notice, status, inspector }) => notice !== "" || /rule|not all right/.test(status + inspector));
  }
  await sitting.calm();
}

export const goingOn = [
  [3, changesWorld],
  [3, leads],
  [2, dropsPlan],
];
