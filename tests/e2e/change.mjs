// A world that changes, as far as flows have it in common.

import { readFileSync } from "node:fs";

import { sample } from "./flow.mjs";

/** The example of the literature with the paper's plan, at time 1. */
export async function running(playground) {
  const file = (name) => ({ name: `${name}.json`, bytes: readFileSync(sample(`seed/dynamic-3x3${name}.json`)) });
  await playground.open(file(""), file(".plan"));
  await playground.says(/^(Best so far|Optimal): makespan 4/);
  await playground.press("Step forward");
  await playground.reaches(1);
}

/** The world changes at the time shown. */
export async function begin(playground) {
  await playground.page.getByRole("button", { name: /^Change (the world )?here/ }).first().click();
  await playground.says(/^The world changes at time/);
}

/** A3 joins by the tool, from one cell to another. */
export async function join(playground, from, to) {
  await playground.pick("Robot");
  await playground.cell(...from).waitFor();
  await playground.stroke(from, to);
}

/** Asks the methods how to go on. */
export async function adapt(playground) {
  await playground.press("Find new plans");
  await playground.says(/^At time \d+: /);
}
