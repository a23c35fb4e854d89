// A long sitting: edits, solves, cancels, questions, changes, undos and reloads in an order
// of chance, from a seed. No edit is lost, nothing is said on the console, and the memory of
// the tab does not grow without end.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { adapt, begin } from "./change.mjs";
import { Tab } from "../measure/process.mjs";
import { flows } from "./flow.mjs";

/** Things done: GIVEWAY_SOAK sets another number, GIVEWAY_SOAK_SEED another order. */
const ACTIONS = Number(process.env.GIVEWAY_SOAK ?? 200);
const SEED = Number(process.env.GIVEWAY_SOAK_SEED ?? 1);
/** What the tab may have grown by in the second half, in bytes: what a browser keeps, and a page may not. */
const GROWTH = 150e6;

const SCENE = {
  giveway: 1,
  name: "soak",
  map: ["........", "..##....", "........", "....##..", "........", "........"],
  agents: [
    { name: "A1", start: [0, 0], goal: [7, 5] },
    { name: "A2", start: [7, 0], goal: [0, 5] },
    { name: "A3", start: [0, 3], goal: [7, 3] },
  ],
};
const OVER = /^(Optimal|No plan exists|No plan within|Best so far|You stopped|The time limit)/;
/** The most steps of undo that lie between two edits. */
const MOST = 40;
const KINDS = ["obstacle", "charger", "slow"];

/** Numbers of chance (Park and Miller 1988). */
function dice(seed) {
  let state = seed;
  return (below) => {
    state = (state * 48_271) % 2_147_483_647;
    return state % below;
  };
}

/** A person at the page, who remembers what was painted where. */
class Sitting {
  constructor(playground, seed) {
    this.playground = playground;
    this.roll = dice(seed);
    this.painted = new Map();
    this.done = [];
    this.undone = [];
  }

  async kindOf([x, y]) {
    const words = await this.playground.onCell(x, y);
    return KINDS.find((kind) => words.includes(kind)) ?? "free";
  }

  tells([x, y], kind) {
    return this.playground.cellTells(x, y, kind === "free" ? /^(?!.*(obstacle|charger|slow))/ : new RegExp(kind));
  }

  /** A cell where no agent starts, ends, or is just now. */
  async cell() {
    for (;;) {
      const cell = [this.roll(SCENE.map[0].length), this.roll(SCENE.map.length)];
      if (!/A\d/.test(await this.playground.onCell(...cell))) {
        return cell;
      }
    }
  }

  async edits() {
    const cell = await this.cell();
    const before = await this.kindOf(cell);
    const tool = before === "free" ? ["Obstacle", "Charger", "Slow zone"][this.roll(3)] : "Erase";
    await this.playground.pick(tool);
    await this.playground.stroke(cell);
    const after = tool === "Erase" ? "free" : tool.split(" ")[0].toLowerCase();
    await this.tells(cell, after);
    this.painted.set(String(cell), after);
    this.done.push({ cell, before, after });
    this.undone = [];
  }

  undoes() {
    return this.#steps("Undo", this.done, this.undone, "before");
  }

  redoes() {
    return this.#steps("Redo", this.undone, this.done, "after");
  }

  /** Solving is a step of its own, and so is what came between: as many as it takes. */
  async #steps(button, from, to, side) {
    const edit = from.pop();
    if (!edit) {
      return;
    }
    for (let steps = 0; steps < MOST && (await this.kindOf(edit.cell)) !== edit[side]; steps += 1) {
      await this.playground.act(button);
    }
    await this.tells(edit.cell, edit[side]);
    this.painted.set(String(edit.cell), edit[side]);
    to.push(edit);
  }

  async solves() {
    await this.playground.solver.click();
    await this.playground.says(OVER);
    await this.playground.solver.waitFor();
  }

  async cancels() {
    await this.playground.solver.click();
    // It may be over before.
    await this.playground.button("Cancel").click({ timeout: 200 }).catch(() => undefined);
    await this.playground.solver.waitFor();
  }

  /** Asks what can be asked, and waits for the answer or goes away from it. */
  async asks() {
    await this.solves();
    const { inspector } = this.playground;
    await this.playground.key("Escape", "Escape");
    const questions = inspector.getByRole("button", { name: /^Why / });
    const count = await questions.count();
    if (count > 0) {
      await questions.nth(this.roll(count)).click();
      if (this.roll(2) === 0) {
        await inspector.getByRole("heading", { level: 2, name: /^Why / }).waitFor();
        await inspector.getByText(/^(Needless|Improvable|Costly|Necessary|Impossible|Not known)/).first().waitFor({ timeout: 60_000 });
      }
    }
    await this.playground.key("Escape", "Escape");
  }

  /** Lets the world change, and takes it all back. */
  async changes() {
    await this.solves();
    if (!(await this.playground.page.getByRole("button", { name: /^Change the world here/ }).isVisible())) {
      return; // no plan to change
    }
    await begin(this.playground);
    await this.playground.pick("Charger");
    const cell = await this.cell();
    if ((await this.kindOf(cell)) === "free") {
      await this.playground.stroke(cell);
      await this.tells(cell, "charger");
      await adapt(this.playground);
      const adopt = this.playground.page.getByRole("button", { name: /^Use this plan/ }).first();
      await adopt.waitFor();
      if (this.roll(2) === 0) {
        await adopt.click();
        await this.playground.says(/^The world changed at time/);
        await this.playground.act("Undo");
        await this.playground.says(/^At time/);
      }
    }
    await this.playground.inspector.getByRole("button", { name: "Discard" }).click();
    await this.playground.says(OVER);
    // What is undone next may be of the changes.
    this.done = [];
    this.undone = [];
  }

  async plays() {
    await this.playground.key(["Home", ",", ".", "End"][this.roll(4)]);
  }

  /** Comes back, and finds all that was painted. */
  async reloads() {
    await this.playground.reload();
    for (const [place, kind] of this.painted) {
      await this.tells(place.split(",").map(Number), kind);
    }
    this.done = [];
    this.undone = [];
  }

  next() {
    const often = [this.edits, this.edits, this.edits, this.edits, this.undoes, this.undoes, this.redoes];
    const all = [...often, this.solves, this.cancels, this.asks, this.changes, this.plays, this.reloads];
    return all[this.roll(all.length)];
  }
}

describe("a long sitting", () => {
  const flow = flows();

  flow("loses no edit, says nothing, and does not grow", async (playground, { context, page }) => {
    await playground.says(/^Optimal/);
    await playground.open({ name: "soak.json", bytes: JSON.stringify(SCENE) });
    await playground.shows("soak");
    const sitting = new Sitting(playground, SEED);
    const collect = async () => {
      const session = await context.newCDPSession(page);
      await session.send("HeapProfiler.collectGarbage");
      await session.detach();
      return (await Tab.of(context.browser())).bytes();
    };
    const told = [];
    let half = 0;
    for (let index = 0; index < ACTIONS; index += 1) {
      const act = sitting.next();
      told.push(act.name);
      try {
        await act.call(sitting);
      } catch (error) {
        throw new Error(`after ${told.slice(-6).join(", ")}, the action ${index} of seed ${SEED}`, { cause: error });
      }
      if (index === Math.floor(ACTIONS / 2)) {
        half = await collect();
      }
    }
    await sitting.reloads();
    const grown = (await collect()) - half;
    assert.ok(grown < GROWTH, `the tab grew by ${Math.round(grown / 1e6)} MB in the second half`);
  }, { screens: ["desktop"], reducedMotion: "reduce", timeout: 600_000 });
});
