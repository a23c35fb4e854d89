// Each lesson of the course from its first step to its end, with the keyboard alone: what solves a task is taken
// by the real worker, the start is not, and a wrong answer has the reply that fits.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows } from "./flow.mjs";
import { LESSONS, Learner } from "./learner.mjs";

describe("each lesson by the keyboard alone", () => {
  const flow = flows();

  for (const { id, lesson, solutions } of LESSONS) {
    flow(lesson.title, async (playground) => {
      const learner = new Learner(playground);
      await learner.tabTo(playground.isPhone() ? /^More$/ : /^Course$/);
      await playground.key("Enter");
      if (playground.isPhone()) {
        await learner.enter(/^Course$/);
      }
      await learner.contents.getByRole("heading", { name: "Why", exact: true }).waitFor();
      await learner.enter(new RegExp(`^${lesson.title}`));
      for (const [index, step] of lesson.steps.entries()) {
        await learner.at(step.title);
        const solution = solutions[index];
        assert.equal(Boolean(solution), Boolean(step.task), `${id}, step ${index}`);
        if (solution) {
          const { scene, plan } = lesson.steps.slice(0, index + 1).findLast((earlier) => earlier.scene);
          await learner.takes({ scene, plan, ...step }, solution, !playground.isPhone());
        }
        await learner.enter(/^(Next|Finish)$/);
      }
      await learner.contents.getByText("Done", { exact: true }).waitFor();
    }, { screens: BOTH });
  }
});
