// A lesson is checked by the solver before its link is copied.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { Author, SCENE, drop } from "./author.mjs";
import { Course } from "./course.mjs";
import { BOTH, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const MINE = { permissions: ["clipboard-read", "clipboard-write"] };

const file = (name, value) => ({ name, bytes: JSON.stringify(value) });

describe("a lesson that is written", () => {
  const flow = flows();

  flow("is not shared before the solver agrees with it", async (playground, { page }) => {
    const author = new Author(playground);
    await playground.open(file("ways.json", SCENE));
    await playground.shows("two ways");
    await author.open(new Course(playground));
    await author.fill("Title", "A ring");
    await author.fill("What it is about, in one sentence", "Two robots go around.");
    await author.fill("Title of the step", "Look");
    await author.fill("Text", "Two robots go around.");
    await author.press("Take the board as it is now");
    await author.says(/^Board copied into this step\./);
    await author.choose("What there is to do", "Predict something");
    await author.fill("What it asks", "How long do they take?");
    const answer = (number) => author.desk.getByRole("group", { name: `Answer ${number}`, exact: true });
    for (const [number, value] of [[1, "3"], [2, "4"]]) {
      await author.press("Add an answer");
      await answer(number).getByLabel("Number", { exact: true }).fill(value);
      await answer(number).getByLabel("In words", { exact: true }).fill(`So many: ${value}`);
      await answer(number).getByLabel("Reply", { exact: true }).fill("Look again.");
    }
    await author.fill("First hint", "Count.");
    await author.fill("Said once it is solved: why it is so", "It is so.");
    await author.says(/^Ready to share\./);

    // No answer that is offered is the right one.
    const clipboard = () => page.evaluate(() => navigator.clipboard.readText());
    await page.evaluate(() => navigator.clipboard.writeText("Nothing yet"));
    await author.press("Copy link");
    await author.says(/^Not shared yet\. Step 1: None of these answers is right/);
    const wrong = "None of these answers is right: the solver has proved 2.";
    await author.desk.getByRole("region", { name: "Task" }).getByText(wrong).waitFor();
    await author.desk.getByText(/^1 thing is still to do\.$/).click();
    await author.desk.getByRole("button", { name: `Step 1: ${wrong}` }).click();
    await eventually("the focus on the task", () => page.evaluate(() => document.activeElement.id), (id) => id === "step-task.kind");
    await playground.picture("author-checked");
    assert.equal(await clipboard(), "Nothing yet");
    const saving = page.waitForEvent("download");
    await author.press("Save as a file");
    await saving;
    await author.says(/The solver has not tried all of its tasks; Copy link has it try them\.$/);

    await answer(1).getByLabel("Number", { exact: true }).fill("2");
    await author.desk.getByText(wrong).first().waitFor({ state: "detached" });
    await author.press("Copy link");
    assert.match(await author.copied(), /#lesson=~[\w-]+$/);
    await page.keyboard.press("Escape");
  }, { screens: BOTH, ...MINE });

  flow("is shared when its author has solved what the solver could not", async (playground, { page }) => {
    const course = new Course(playground);
    const author = new Author(playground);
    await playground.open(file("ways.json", SCENE));
    await playground.shows("two ways");
    await author.open(course);
    // A2 goes as the plan has it, which is not how the solver would have it go.
    const paths = { A1: [[0, 0]], A2: [[2, 2], [2, 2], [1, 2], [0, 2]] };
    const task = { kind: "lead", say: "Bring A1 home.", robots: ["A1"], aim: { is: "legal" } };
    const step = { title: "Lead", text: ["It is your turn."], scene: SCENE, plan: { giveway: 1, paths }, task, hints: ["Go right."], reason: "It is so." };
    await drop(page, "lead.json", { giveway: 1, title: "T", minutes: 4, about: "A sentence.", steps: [step] });
    await author.says(/^Ready to share\./);
    await author.press("Copy link");
    await author.says(/^Not shared yet\. Step 1: The solver could not solve this task by itself\./);
    await author.press("Try it");
    await course.at("Lead");
    await playground.board.focus();
    await playground.key("ArrowRight", "ArrowRight");
    await course.solved();
    await course.lesson.getByRole("button", { name: "Go on writing" }).click();
    await author.desk.waitFor();
    await author.says(/^Ready to share\./);
    // Words are no part of the check.
    await author.fill("Title of the step", "Lead it");
    await author.press("Copy link");
    assert.match(await author.copied(), /#lesson=~[\w-]+$/);
    await page.keyboard.press("Escape");
  }, MINE);
});
