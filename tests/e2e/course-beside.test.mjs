// A lesson beside what else goes on in the page: a search, the tour, a file that cannot be read.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { SCENE, drop } from "./author.mjs";
import { Course } from "./course.mjs";
import { flows, sample } from "./flow.mjs";
import { Tour } from "./tour.mjs";

/** Nobody solves it within a second. */
const HARD = "mmapf/A17_mm_20x20_o15_a30.json";

/** A lesson of which the second step asks for a number. */
const MINE = {
  giveway: 1,
  title: "A ring",
  minutes: 4,
  about: "Two robots go around.",
  steps: [
    {
      title: "Block one", text: ["A sentence."], scene: SCENE, tools: ["obstacle"], edits: 3, hints: ["Both ways."], reason: "No way is left.",
      task: { kind: "paint", say: "Block it.", until: { is: "impossible" } },
    },
    {
      title: "Guess", text: ["Another one."], scene: SCENE, hints: ["Count."], reason: "Both go around.",
      task: { kind: "predict", say: "How long do they need?", what: { is: "cost", cost: "makespan" } },
    },
  ],
};

describe("a lesson", () => {
  const flow = flows();

  flow("lets a search go on when it ends", async (playground, { page }) => {
    const course = new Course(playground);
    await playground.open(sample(HARD));
    await playground.solver.click();
    await playground.says(/makespan/);
    await page.evaluate(() => { location.hash = "lesson=room-to-pass"; });
    await course.at("A corridor and a bay");
    await course.lesson.getByRole("button", { name: "Leave the lesson" }).click();
    await page.getByRole("button", { name: "Cancel" }).click();
    await playground.says(/You stopped the search/);
  });

  flow("stays as it is where a file cannot be read", async (playground, { page }) => {
    const course = new Course(playground);
    await page.evaluate(() => { location.hash = "lesson=room-to-pass.4"; });
    await course.at("Block one cell");
    await playground.pick("Obstacle");
    const { x, y } = await playground.middleOf(4, 0);
    await page.mouse.click(x, y);
    await course.says(/there is still a plan/);
    await drop(page, "bad.json", "{ not json");
    await playground.warns(/bad\.json/);
    await course.says(/there is still a plan/);
    // One that can be read takes its place.
    await drop(page, "ways.json", SCENE);
    await playground.shows("two ways");
    await course.lesson.waitFor({ state: "detached" });
  });

  flow("takes the place of the tour, and is judged", async (playground, { page }) => {
    const [course, tour] = [new Course(playground), new Tour(playground)];
    await tour.fromHelp();
    await drop(page, "ring.json", MINE);
    await course.at("Block one");
    await tour.card.waitFor({ state: "detached" });
    await playground.pick("Obstacle");
    const { x, y } = await playground.middleOf(1, 0);
    await page.mouse.click(x, y);
    await course.says(/Solved No plan exists/);
    // There is no room for another tour meanwhile.
    await playground.act("Help");
    const keys = page.getByRole("dialog", { name: "Keys" });
    await keys.waitFor();
    assert.equal(await keys.getByRole("button", { name: "Take the tour" }).count(), 0);
    await playground.key("Escape");

    await course.next.click();
    await course.at("Guess");
    const field = course.lesson.getByRole("textbox");
    await field.fill("soon");
    await course.says(/Type a whole number/);
    await field.fill("99");
    await playground.key("Enter");
    await course.says(/99 your guess \d+ proved Both go around\./i);
  });
});
