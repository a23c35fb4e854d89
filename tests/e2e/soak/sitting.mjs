// A sitting: a person at the page who does one thing after the other by chance, and looks
// after each of them whether all that was there is still there or comes back by Undo.

import assert from "node:assert/strict";

import { eventually } from "../wait.mjs";
import { complaintsOf } from "../browser.mjs";
import { Playground } from "../page.mjs";
import { Dice } from "./dice.mjs";
import { look, shared, tellsAgain } from "./told.mjs";

/** What one thing that is pressed may take, in milliseconds. */
const PRESS = 60_000;
/** How long one action may take with all that is looked at after it, in milliseconds. */
const DEADLINE = 300_000;
/** How long the page may work: its time limit is a fraction of it. */
const WORK = 120_000;
/** The most steps that one action takes. */
const STEPS = 60;
/** So many actions are told where one fails. */
const LATEST = 12;

export class Sitting {
  /** What was done, in words. */
  log = [];
  /** Links to documents of this sitting. */
  links = [];
  /** The documents of scenes that were kept by name. */
  kept = new Map();
  /** Whether the browser refuses to keep anything from now on. */
  isRefused = false;
  /** Whether the action that is done went through the history itself: what was before need not be in it. */
  hasMoved = false;

  /** @param surroundings `playground`, `context`, `host`, `complaints`, and the `seed` */
  constructor({ seed, ...surroundings }) {
    Object.assign(this, surroundings);
    this.seed = seed;
    this.page = this.playground.page;
    this.page.setDefaultTimeout(PRESS);
    this.dice = new Dice(seed);
    this.count = 0;
  }

  /** Does so many actions of those that `next` gives. */
  async run(count, next) {
    this.document = await shared(this.playground);
    for (const end = this.count + count; this.count < end; this.count += 1) {
      const action = next(this);
      this.log.push(action.name);
      try {
        await this.#within(DEADLINE, () => this.#one(action));
      } catch (error) {
        const latest = this.log.slice(-LATEST).join("; ");
        throw new Error(`action ${this.count} of seed ${this.seed}, after: ${latest}\n${error.message}`, { cause: error });
      }
    }
  }

  /** One action, and what has to hold after it. */
  async #one(action) {
    const before = this.document;
    this.hasMoved = false;
    await action(this);
    await this.calm();
    this.document = await shared(this.playground);
    await this.#goesBackAndForth(this.hasMoved ? this.document : before);
    assert.deepEqual(this.complaints, [], "the page complained");
  }

  /** Undo brings back what was there before, and Redo what is there now. */
  async #goesBackAndForth(before) {
    const now = await this.#settled();
    let steps = 0;
    while (await this.#step("Undo")) {
      steps += 1;
      if (this.document === before || await shared(this.playground) === before) {
        break;
      }
      assert.ok(steps < STEPS, "Undo does not bring back the document of before");
    }
    if (this.document !== before) {
      assert.equal(await shared(this.playground), before, "Undo brings back another document than the one of before");
    }
    for (let step = 0; step < steps; step += 1) {
      assert.ok(await this.#step("Redo"), `Redo goes ${step} steps forth, Undo went ${steps} back`);
    }
    await tellsAgain(this.page, "after Undo and Redo", now);
  }

  /**
   * What the page tells once it is calm. While a robot is led or the world changes, Undo and Redo come back to the
   * time that this is about, wherever the person has looked in between.
   */
  async #settled() {
    const now = await this.calm();
    if (!/^(Steering|Changing)/.test(now.status)) {
      return now;
    }
    await this.#step("Undo");
    await this.#step("Redo");
    await tellsAgain(this.page, "after Undo and Redo", now, ({ name, size, status }) => ({ name, size, status }));
    return look(this.page);
  }

  async #step(name) {
    const button = this.playground.button(name);
    if (await button.isDisabled()) {
      return false;
    }
    await button.click();
    return true;
  }

  /** Takes all back, and does all again. */
  async allTheWay() {
    const now = await this.#settled();
    let steps = 0;
    while (await this.#step("Undo")) {
      steps += 1;
    }
    // There may have been steps to redo before, which stay undone.
    for (let step = 0; step < steps; step += 1) {
      assert.ok(await this.#step("Redo"), "as many steps forth as back");
    }
    await tellsAgain(this.page, "after all was undone and redone", now);
  }

  /** Waits until the page neither works nor plays, and gives what it tells: a plan that played is then at its start. */
  async calm() {
    const found = await eventually("the page to be calm", () => look(this.page), (found) => !found.works, WORK);
    assert.ok(!found.broke, "the page broke down");
    assert.doesNotMatch(found.notice, /broke off|could not be started/, "the solver broke down");
    assert.ok(found.status !== "" && found.isThere, "the page tells nothing");
    if (!found.plays) {
      return found;
    }
    return eventually("the plan to stand still at its start", async () => {
      // At once, since it may end by itself just now.
      await this.page.evaluate(() => ["Pause", "To start"].forEach((name) => {
        [...document.querySelectorAll("button")].find((button) => button.innerText.trim() === name)?.click();
      }));
      return look(this.page);
    }, (found) => !found.plays && !found.works && found.time === "0", WORK);
  }

  /** Loads the page anew. */
  async reload() {
    await this.page.reload();
    await this.#isThere(this.page);
  }

  /** Where ways to go on are compared, the board is there and out of sight. */
  async #isThere(page) {
    await eventually("the page to be there", () => look(page), ({ isThere, status, works }) => isThere && status !== "" && !works);
  }

  /** Opens the page in another tab, whose complaints count, too. */
  async tab() {
    const page = await this.context.newPage();
    page.setDefaultTimeout(PRESS);
    complaintsOf(page, this.complaints);
    const other = new Playground(page, this.playground.pathOf);
    await page.goto(this.host.url);
    await this.#isThere(page);
    return other;
  }

  /** Closes another tab as a person does: it keeps what there is. */
  async close(other) {
    await other.page.close({ runBeforeUnload: true });
    await eventually("the tab to be closed", () => other.page.isClosed());
  }

  /** Notes what an action did, for whoever has to find a fault. */
  note(words) {
    this.log[this.log.length - 1] += ` ${words}`;
  }

  async #within(milliseconds, act) {
    let timer;
    const late = new Promise((_, reject) => {
      timer = setTimeout(() => reject(new Error(`it takes longer than ${milliseconds} ms`)), milliseconds);
    });
    try {
      await Promise.race([act(), late]);
    } finally {
      clearTimeout(timer);
    }
  }
}
