// Each lesson of the course from its first step to its end, with the keyboard alone and by touch: what solves a task is
// taken by the real worker, the start is not, and a wrong answer has the reply that fits.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { flows } from "./flow.mjs";
import { ByKeys, ByTouch, LESSONS } from "./learner.mjs";
import { words } from "./po.mjs";

/** Walks through a lesson; who is careful tries something wrong first. */
async function walk(learner, { id, lesson, solutions }, isCareful) {
  await learner.opens();
  await learner.contents.getByRole("heading", { name: learner.words("Why"), exact: true }).waitFor();
  await learner.enter(new RegExp(`^${learner.words(lesson.title).replaceAll("?", "\\?")}`));
  for (const [index, step] of lesson.steps.entries()) {
    await learner.at(learner.words(step.title));
    const solution = solutions[index];
    assert.equal(Boolean(solution), Boolean(step.task), `${id}, step ${index}`);
    if (solution) {
      // A step without a scene goes on with the one before it.
      const { scene, plan } = lesson.steps.slice(0, index + 1).findLast((earlier) => earlier.scene);
      await learner.takes({ scene, plan, ...step }, solution, isCareful);
    }
    await learner.enter(learner.onward);
  }
  await learner.contents.getByText(learner.words("Done", "of a lesson"), { exact: true }).waitFor();
}

describe("a lesson by the keyboard alone", () => {
  const flow = flows();
  for (const lesson of LESSONS) {
    const walks = (playground) => walk(new ByKeys(playground), lesson, !playground.isPhone());
    flow(lesson.lesson.title, walks);
  }
});

describe("a lesson by touch", () => {
  const flow = flows();
  for (const lesson of LESSONS) {
    flow(lesson.lesson.title, (playground) => walk(new ByTouch(playground), lesson, true), { screens: ["phone"] });
  }
});

describe("a lesson about rules in German", () => {
  const flow = flows();
  const german = words("de");
  const options = { locale: "de-DE" };
  for (const lesson of LESSONS.filter(({ lesson }) => lesson.steps.some(({ scene, task }) => scene?.constraints || task?.what?.is === "delay"))) {
    flow(`${lesson.lesson.title}, by keys`, (playground) => walk(new ByKeys(playground, german), lesson, false), options);
    flow(`${lesson.lesson.title}, by touch`, (playground) => walk(new ByTouch(playground, german), lesson, false), { ...options, screens: ["phone"] });
  }
});
