// Somebody who takes a lesson, with the keyboard alone or with a finger, and does what a file of solutions says.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";

import { Course } from "./course.mjs";
import { root } from "./dist.mjs";
import { eventually, still } from "./wait.mjs";

/** The tool that paints a cell of a map. */
const TOOLS = { "#": "Obstacle", "+": "Charger", "~": "Slow zone", ".": "Erase" };
const TOOL_KEYS = { Obstacle: "o", Charger: "c", "Slow zone": "s", Erase: "e", Robot: "a" };
const MOVE_KEYS = { "1,0": "ArrowRight", "-1,0": "ArrowLeft", "0,1": "ArrowDown", "0,-1": "ArrowUp", "0,0": "w" };

/** Two taps within this time, in milliseconds, are a double one, the second of which goes to no other step. */
const DOUBLE_MS = 500;

/** A phrase, wherever it stands. */
const phrase = (text) => new RegExp(text.replaceAll(/[.*+?^${}()|[\]\\]/g, "\\$&"));

const read = (...path) => JSON.parse(readFileSync(join(root, ...path), "utf8"));

/** The lessons of the course, in their order: what they are, and what solves each of their tasks. */
export const LESSONS = read("static/course/index.json").chapters.flatMap((chapter) => chapter.lessons).map(({ lesson: id }) => ({
  id,
  lesson: read("static/course", `${id}.json`),
  solutions: read("crates/giveway-course/tests/solutions", `${id}.json`),
}));

/** Where a robot is: it stays where its path ends. */
const at = (path, time) => path[Math.min(time, path.length - 1)];

/** English words as they are. */
const asWritten = (text) => text;

/** One of some texts, and nothing else. */
const exactly = (...texts) => new RegExp(`^(${texts.map((text) => phrase(text).source).join("|")})$`);

/** What a learner does; how is told by who extends it. In another language, `words` gives its words for English ones. */
class Learner extends Course {
  constructor(playground, words = asWritten) {
    super(playground);
    const { page } = playground;
    this.words = words;
    this.solvedWord = phrase(words("Solved", "a verdict"));
    this.onward = exactly(words("Next", "a step"), words("Finish", "a lesson"));
    this.contents = page.getByRole("dialog", { name: words("Course") });
    this.lesson = page.getByRole("complementary", { name: words("Lesson") });
    this.next = this.lesson.getByRole("button", { name: this.onward });
    playground.board = page.getByRole("grid", { name: words("Board") });
    playground.tools = page.getByRole("toolbar", { name: words("Tools") });
  }

  /** A task is solved, and the focus is on the way on. */
  async solved() {
    await this.says(this.solvedWord);
    await eventually("the focus on the way on", () => this.focused(), (name) => this.onward.test(name));
  }

  /** Solves the task of a step; before that, tries what does not, where there is a second try. */
  async takes(step, { solved, refused }, isCareful) {
    await this.stands();
    const [first] = refused;
    if (isCareful && first.did.guess === undefined) {
      await this.does(step, first.did);
      await this.says(phrase(first.says));
      await this.stands();
      await this.takesBack();
    }
    await this.does(step, solved);
    await this.solved();
  }

  /** The task is not solved. */
  async stands() {
    assert.doesNotMatch(await this.lesson.innerText(), this.solvedWord);
  }

  /** Takes back all that was done, where something can be taken back. */
  async takesBack() {
    const back = this.lesson.getByRole("button", { name: "Take it back" });
    for (let press = 0; press < 50 && await back.count() > 0; press += 1) {
      // It may go between the look and the press.
      await back.press("Enter", { timeout: 5000 }).catch(() => undefined);
    }
    assert.equal(await back.count(), 0, "what was done cannot be taken back");
  }

  /** Does something for the task of a step. */
  async does(step, did) {
    if (did.paint) {
      await this.paints(step, did.paint);
    } else if (did.lead) {
      await this.leads(step.task, did.lead);
    } else if (did.marks) {
      await this.marks(step.plan, did.marks);
    } else if (did.order) {
      await this.orders(did.order);
    } else if (did["no-order"]) {
      await this.enter(/^No order works$/);
    } else if (did.went) {
      const [first, ...rest] = did.went.replace("=", " ");
      await this.enter(new RegExp(`^${first.toUpperCase()}${rest.join("")}(?!n)`));
    } else if (did.choose !== undefined) {
      await this.answers(did.choose);
    } else {
      await this.guesses(step, did.guess);
    }
  }

  /** Says a value: picks it, presses its cell, or types it. */
  async guesses({ task, scene }, guess) {
    const place = (task.answers ?? []).findIndex((answer) => JSON.stringify(answer.value) === JSON.stringify(guess));
    if (place >= 0) {
      return this.answers(place);
    }
    if (Array.isArray(guess)) {
      return this.presses(guess);
    }
    if (typeof guess === "string") {
      return this.answers(scene.agents.findIndex((agent) => agent.name === guess));
    }
    if (typeof guess === "object") {
      return this.answers(guess.rule);
    }
    await this.lesson.getByRole("textbox").focus();
    await this.page.keyboard.type(String(guess));
    return this.playground.key("Enter");
  }

  async paints(step, { set = [], robots = [], gone = [] }) {
    for (const [x, y, ground] of set) {
      // Where nothing can be erased, the tool that paints something takes it away, too.
      const isFree = ground === "." && !step.tools.includes("erase");
      await this.picks(TOOLS[isFree ? step.scene.map[y][x] : ground]);
      await this.presses([x, y]);
    }
    for (const { start, goal } of robots) {
      await this.picks("Robot");
      await this.presses(start);
      await this.presses(goal);
    }
    for (const name of gone) {
      await this.picks("Erase");
      await this.presses(step.scene.agents.find((agent) => agent.name === name).start);
    }
  }

  async leads(task, paths) {
    for (const name of task.robots) {
      if (task.robots.length > 1) {
        await this.answers(task.robots.indexOf(name));
        await this.lesson.getByRole("button", { name, exact: true, pressed: true }).waitFor();
      }
      await this.goesAlong(paths[name]);
    }
  }

  async marks(plan, marks) {
    const paths = Object.values(plan.paths);
    for (const { time, robots } of marks) {
      // A cell with two robots is a mark by itself: it comes second.
      const held = (name) => paths.filter((path) => String(at(path, time)) === String(at(plan.paths[name], time))).length;
      const one = robots.length === 2 && held(robots[0]) === 1 ? 0 : 1;
      await this.goesTo(time);
      for (const name of [robots[one], robots[1 - one]]) {
        await this.presses(at(plan.paths[name], time));
      }
    }
  }

  /** Brings each robot to its place, from the first on. */
  async orders(order) {
    const queue = this.lesson.getByRole("list", { name: "Order of planning" });
    for (const [place, name] of order.entries()) {
      const now = (await queue.getByRole("listitem").allInnerTexts()).map((text) => /A\d+/.exec(text)[0]);
      for (let left = now.indexOf(name); left > place; left -= 1) {
        await this.enter(new RegExp(`^${name} earlier$`));
      }
    }
    await this.enter(/^Try this order$/);
  }
}

/** With the keyboard alone. */
export class ByKeys extends Learner {
  /** Opens the contents of the course. */
  async opens() {
    const course = exactly(this.words("Course"));
    await this.tabTo(this.playground.isPhone() ? exactly(this.words("More")) : course);
    await this.playground.key("Enter");
    if (this.playground.isPhone()) {
      await this.enter(course);
    }
  }

  /** Presses the button of this name, which the Tab key comes to. */
  async enter(pattern) {
    // A heading may have the same words.
    if (!await this.page.evaluate(() => document.activeElement instanceof HTMLButtonElement)) {
      await this.playground.key("Tab");
    }
    await this.tabTo(pattern);
    await this.playground.key("Enter");
  }

  /** Picks an answer or a robot, from 0. */
  answers(place) {
    return this.playground.key(String(place + 1));
  }

  picks(tool) {
    return this.playground.key(TOOL_KEYS[tool]);
  }

  /** Puts the cursor of the board on a cell, and presses Enter there. */
  async presses([x, y]) {
    await this.playground.board.focus();
    await this.playground.key("Control+Home", ...Array(x).fill("ArrowRight"), ...Array(y).fill("ArrowDown"), "Enter");
  }

  async goesAlong(path) {
    await this.playground.board.focus();
    await this.playground.key(...path.slice(1).map(([x, y], i) => MOVE_KEYS[[x - path[i][0], y - path[i][1]]]));
  }

  async goesTo(time) {
    await this.next.focus();
    await this.playground.key("Home", ...Array(time).fill("."));
  }
}

/** With a finger, by the names of what it presses. */
export class ByTouch extends Learner {
  /** When a button was pressed last. */
  #entered = 0;

  async opens() {
    await this.playground.button(this.words("More")).tap();
    await this.playground.button(this.words("Course")).tap();
  }

  async enter(pattern) {
    const soon = this.#entered + DOUBLE_MS - Date.now();
    if (soon > 0) {
      await this.page.waitForTimeout(soon);
    }
    await this.page.getByRole("button", { name: pattern }).last().tap();
    this.#entered = Date.now();
  }

  /** The lesson may still scroll to what was said before: a tap waits until the answer stands still. */
  async answers(place) {
    const answer = this.lesson.getByTitle(this.words("Key {number}").replace("{number}", place + 1), { exact: true });
    await still("the answer", async () => (await answer.boundingBox())?.y);
    await answer.tap();
  }

  picks(tool) {
    return this.playground.tools.getByRole("button", { name: this.words(tool), exact: true }).tap();
  }

  async presses([x, y]) {
    const middle = await this.playground.middleOf(x, y);
    await this.page.touchscreen.tap(middle.x, middle.y);
  }

  async goesAlong(path) {
    for (const [i, cell] of path.slice(1).entries()) {
      await (String(cell) === String(path[i]) ? this.enter(exactly(this.words("Wait a step"))) : this.presses(cell));
    }
  }

  async goesTo(time) {
    const start = this.playground.button(this.words("To start"));
    if (await start.isEnabled()) {
      await start.tap();
    }
    for (let step = 0; step < time; step += 1) {
      await this.playground.button(this.words("Step forward")).tap();
    }
  }
}
