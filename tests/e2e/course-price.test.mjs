// What a rule costs, in lessons: guessed, shown on a line and by both plans, guessed again.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { Course } from "./course.mjs";
import { BOTH, flows } from "./flow.mjs";

/** Opens a step of a lesson. */
async function opens(playground, step, title) {
  const course = new Course(playground);
  await playground.page.evaluate((step) => { location.hash = `lesson=${step}`; }, step);
  await course.at(title);
  return course;
}

/** Types a number as the guess. */
async function guesses(course, number) {
  await course.lesson.getByRole("textbox").fill(`${number}`);
  await course.lesson.getByRole("button", { name: "Say it" }).click();
}

describe("the price of a rule in a lesson", () => {
  const flow = flows();

  flow("stands on a line between the best plans without it and with it", async (playground, { page }) => {
    const course = await opens(playground, "rules-of-the-road.2", "What does a limit cost?");
    await course.says(/Rule 1 At most 1 robot in 'Zone 1'/);
    await guesses(course, 1);
    await course.says(/The rule costs 2\./);
    const line = course.lesson.getByRole("figure");
    const points = (await line.getByRole("listitem").allInnerTexts()).map((text) => text.replaceAll(/\s+/g, " ").trim());
    assert.deepEqual(points, ["without the rule 8", "your guess 9", "proved 10"]);
    await playground.says(/^The best plan: makespan 10\b/);
    for (const title of ["With the rule", "Without the rule"]) {
      await page.getByText(title, { exact: true }).waitFor({ state: "attached" });
    }
    await audit(playground, "a price");
    await playground.picture("price");

    // A right guess is the proved one.
    await course.lesson.getByRole("button", { name: "Guess again" }).click();
    await guesses(course, 2);
    await course.solved();
    assert.equal(await line.getByRole("listitem").count(), 2);
    assert.equal(await course.lesson.getByRole("button", { name: "Guess again" }).count(), 0);

    // Who comes back sees what was answered last.
    await page.reload();
    await course.says(/Solved.*Your last answer: 2/);
  }, { screens: BOTH });

  flow("is guessed before a room", async (playground, { page }) => {
    await opens(playground, "rules-of-the-road.2", "What does a limit cost?");
    await playground.key("p");
    const third = page.locator(".third:visible");
    await third.getByRole("textbox").fill("1");
    await third.getByRole("button", { name: "Say it" }).click();
    await third.getByRole("button", { name: "Guess again" }).click();
    await third.getByRole("textbox").fill("2");
    await third.getByRole("button", { name: "Say it" }).click();
    await third.getByText("Solved").waitFor();
    assert.equal(await third.getByRole("textbox").count(), 0);
    await playground.picture("price-before-a-room");
  }, { screens: BOTH });

  flow("is shown by the plan without it where no plan keeps it", async (playground) => {
    const course = await opens(playground, "pick-then-drop.3", "Three rules, no plan");
    await course.lesson.getByRole("button", { name: "A1 arrives by 9" }).click();
    await course.says(/The order asks for the opposite/);
    await playground.says(/^Without rule \d there is a plan: makespan \d+\b/);
    await audit(playground, "the plan without a rule");
    await playground.picture("without-a-rule");
  }, { screens: BOTH });
});
