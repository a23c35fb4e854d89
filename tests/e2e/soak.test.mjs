// A long sitting: whatever a person does, in an order of chance, nothing is lost, nothing is
// said on the console, and the memory of the tab does not grow without end.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { Tab } from "../measure/process.mjs";
import { flows } from "./flow.mjs";
import { painting } from "./soak/brush.mjs";
import { comingBack } from "./soak/come-back.mjs";
import { editing } from "./soak/edit.mjs";
import { flooring } from "./soak/floor.mjs";
import { goingOn } from "./soak/go-on.mjs";
import { refusesStorage } from "./soak/refused.mjs";
import { Sitting } from "./soak/sitting.mjs";
import { solving } from "./soak/solve.mjs";
import { elsewhere } from "./soak/tabs.mjs";
import { looking } from "./soak/view.mjs";

/** Actions in all, divided among the seeds. */
const ACTIONS = Number(process.env.GIVEWAY_SOAK ?? 40);
/** How many seeds, a sitting each. */
const SEEDS = Number(process.env.GIVEWAY_SOAK_SEEDS ?? 5);
/** The first of them. */
const SEED = Number(process.env.GIVEWAY_SOAK_SEED ?? 1);
/** What the tab may have grown by in the second half, in bytes: what a browser keeps, and a page may not. */
const GROWTH = 150e6;

const KINDS = [[6, painting], [4, editing], [4, flooring], [6, solving], [5, goingOn], [3, looking], [4, comingBack], [1, elsewhere]];

/** In every fifth sitting the browser keeps nothing from some moment on. */
const REFUSING = 5;

function next({ seed, count, dice, isRefused }) {
  if (seed % REFUSING === 0 && !isRefused && count >= REFUSING) {
    return refusesStorage;
  }
  return dice.weighed(dice.weighed(KINDS));
}

describe("a long sitting", () => {
  const flow = flows();
  const count = Math.ceil(ACTIONS / SEEDS);

  for (let seed = SEED; seed < SEED + SEEDS; seed += 1) {
    flow(`of seed ${seed} loses nothing, says nothing, and does not grow`, async (playground, { context, page, host, complaints }) => {
      await playground.says(/^Optimal/);
      await playground.openSettings();
      await playground.set("Time limit, s", 2);
      await playground.closeSettings();
      const sitting = new Sitting({ seed, playground, context, host, complaints });
      await sitting.run(Math.ceil(count / 2), next);
      const half = await memory(context, page);
      await sitting.run(Math.floor(count / 2), next);
      await sitting.allTheWay();
      const grown = await memory(context, page) - half;
      assert.ok(grown < GROWTH, `the tab grew by ${Math.round(grown / 1e6)} MB in the second half`);
    }, { screens: ["desktop"], fresh: true, reducedMotion: "reduce", timeout: 1_800_000 });
  }
});

/** What the tab takes once what is not needed is collected, in bytes. */
async function memory(context, page) {
  const session = await context.newCDPSession(page);
  await session.send("HeapProfiler.collectGarbage");
  await session.detach();
  return (await Tab.of(context.browser())).bytes();
}
