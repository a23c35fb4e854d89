// A lesson of one's own: written in the page, tried, shared as a link and as a file, opened.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { Author, SCENE, drop } from "./author.mjs";
import { Course } from "./course.mjs";
import { BOTH, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const MINE = { permissions: ["clipboard-read", "clipboard-write"] };

const file = (name, value) => ({ name, bytes: typeof value === "string" ? value : JSON.stringify(value) });

/** Writes a lesson of two steps on the scene that is on the page. */
async function write(author, playground) {
  await author.fill("Title", "A ring");
  await author.fill("What it is about, in one sentence", "Two robots go around.");
  await author.fill("Title of the step", "Look");
  await author.fill("Text", "[A1](robot:A1) goes along the top.\n\nThere is a *second* way.");
  await author.press("Take the board as it is now");
  await author.says(/^Board copied into this step\./);
  await author.preview.getByText("second").waitFor();
  await playground.picture("author-first");
  await author.press("Add a step");
  await author.fill("Title of the step", "Shut it");
  await author.fill("Text", "Now it is your turn.");
  await author.choose("What there is to do", "Edit the scene");
  await author.fill("What it asks", "Leave no plan with one obstacle.");
  await author.choose("Done when", "no plan exists");
  await author.press("Obstacle");
  await author.fill("The most edits", "one");
  await author.tells(/Write a whole number here\./);
  await author.fill("The most edits", "1");
  await author.fill("First hint", "Think of a flag.");
  await author.fill("Said once it is solved: why it is so", "Nobody stands on an obstacle.");
  await author.says(/^Ready to share\./);
  assert.equal(await author.steps.getByRole("listitem").count(), 2);
  await playground.picture("author");
}

/** Solves the second step: the ring becomes a corridor, in which A2 stands in the way of A1. */
async function solve(playground, course) {
  await course.at("Shut it");
  await playground.showTab("Tools").catch(() => undefined);
  await playground.pick("Obstacle");
  await playground.stroke([1, 0]);
  await course.solved();
}

describe("a lesson of one's own", () => {
  const flow = flows();

  flow("is written from nothing, tried, shared by a link, opened and solved elsewhere", async (playground, { page, host }) => {
    const course = new Course(playground);
    const author = new Author(playground);
    await playground.open(file("ways.json", SCENE));
    await playground.shows("two ways");
    await author.open(course);
    await author.press("Try it");
    await author.says(/Something is still missing/);
    await author.tells(/Write something here\./);
    await write(author, playground);
    await audit(playground, "the editor");

    // Tried, and back with nothing lost.
    await author.press("Try it");
    await course.at("Shut it");
    await course.lesson.getByRole("button", { name: "Hint" }).click();
    await course.lesson.getByText("Think of a flag.").waitFor();
    await course.lesson.getByRole("button", { name: "Go on writing" }).click();
    await author.desk.waitFor();
    assert.equal(await author.field("Title of the step").inputValue(), "Shut it");

    await author.press("Copy link");
    const link = await author.copied();
    assert.match(link, /#lesson=~[\w-]+$/);
    assert.ok(link.length < 2000, `${link.length} characters`);
    await page.keyboard.press("Escape");
    await author.desk.waitFor({ state: "detached" });
    await playground.shows("two ways");

    // Kept by the browser.
    await playground.reload();
    await author.open(course);
    assert.equal(await author.field("Title").inputValue(), "A ring");
    await page.keyboard.press("Escape");

    // Somebody else follows it.
    await page.evaluate(() => localStorage.clear());
    await page.goto("about:blank");
    await playground.goto(link);
    await course.at("Look");
    await page.waitForURL(`${link}.1`);
    await course.next.click();
    await solve(playground, course);
    await playground.picture("author-solved");
    await page.goto("about:blank");
    await playground.goto(`${link}.2`);
    await course.at("Shut it");
  }, { screens: BOTH, ...MINE });

  flow("begins as a copy of one of the course, and takes the board that is seen", async (playground) => {
    const course = new Course(playground);
    const author = new Author(playground);
    await course.open();
    await course.contents.getByRole("button", { name: /^Room to pass/ }).click();
    await course.at("A corridor and a bay");
    await course.lesson.getByRole("button", { name: "Change it" }).click();
    await author.says(/^This is a copy of \u{201c}Room to pass\u{201d}\./u);
    assert.equal(await author.field("Title").inputValue(), "Room to pass");
    assert.equal(await author.steps.getByRole("listitem").count(), 4);
    await author.fill("Title", "Room for two");
    await author.press("Try it");
    await course.at("A corridor and a bay");
    await course.lesson.getByRole("button", { name: "Go on writing" }).click();
    await playground.picture("author-copy");
    await author.desk.press("Escape");
    await author.desk.waitFor({ state: "detached" });

    // Another lesson is on the board: that board is taken.
    await course.open();
    await course.contents.getByRole("button", { name: /^Two robots, one cell/ }).click();
    await course.lesson.getByRole("button", { name: "Course" }).click();
    await course.contents.getByRole("button", { name: "Write your own" }).click();
    await author.desk.waitFor();
    assert.equal(await author.field("Title").inputValue(), "Room for two");
    const before = await author.desk.getByText(/: 2 robots$/).innerText();
    await author.press("Take the board as it is now");
    await author.says(/^Board copied into this step\./);
    assert.notEqual(await author.desk.getByText(/: \d robots$/).innerText(), before);
  });

  flow("is saved as a file that opens when it is dropped, and goes on being written", async (playground, { page }) => {
    const course = new Course(playground);
    const author = new Author(playground);
    await playground.open(file("ways.json", SCENE));
    await playground.shows("two ways");
    // From the menu of what is shared, too.
    await playground.act("Share");
    await playground.press("Make a lesson");
    await author.desk.waitFor();
    await write(author, playground);
    const saving = page.waitForEvent("download");
    await author.press("Save as a file");
    const saved = await saving;
    assert.equal(saved.suggestedFilename(), "a-ring.json");
    const text = readFileSync(await saved.path(), "utf8");
    assert.equal(JSON.parse(text).steps.length, 2);

    // A step is removed, and comes back.
    await author.press("Remove the step");
    assert.equal(await author.steps.getByRole("listitem").count(), 1);
    await author.press("Undo");
    assert.equal(await author.steps.getByRole("listitem").count(), 2);
    // Moved by keys.
    await author.steps.getByRole("button", { name: /Shut it/ }).focus();
    await page.keyboard.press("Alt+ArrowUp");
    await eventually("the step to be the first", () => author.steps.getByRole("listitem").first().innerText(), (text) => text.includes("Shut it"));
    await page.keyboard.press("Escape");

    await drop(page, "a-ring.json", text);
    await course.at("Look");
    await course.lesson.getByRole("button", { name: "Leave the lesson" }).click();
    await playground.shows("two ways");
  }, MINE);

  flow("takes a plan along, also a faulty one, and can hide its answers", async (playground, { page }) => {
    const course = new Course(playground);
    const author = new Author(playground);
    await playground.open(file("ways.json", SCENE));
    await playground.shows("two ways");
    await playground.press("Solve");
    await playground.says(/^Optimal: /);
    await author.open(course);
    await author.fill("Title of the step", "Look");
    await author.fill("Text", "Where do they meet?");
    await author.press("Take the board as it is now");
    await author.says(/^Board copied into this step\./);
    assert.equal(await author.field("Plan").inputValue(), "given");
    await author.choose("What there is to do", "Find the conflicts");
    await author.fill("What it asks", "Find all.");
    await author.tells(/This plan breaks no rule\. Take a plan with conflicts\./);
    await page.keyboard.press("Escape");

    const paths = { A1: [[0, 0], [1, 0], [2, 0]], A2: [[2, 2], [2, 1], [2, 0], [1, 0], [0, 0], [0, 1], [0, 2]] };
    await playground.open(file("faulty-plan.json", { giveway: 1, paths }));
    await page.getByRole("button", { name: /are both at|swap|and A/ }).first().waitFor();
    await author.open(course);
    await author.press("Take the board as it is now");
    await author.says(/^Board copied into this step\./);
    assert.equal(await author.field("Plan").inputValue(), "given");

    await author.choose("What there is to do", "Pick an answer");
    await author.fill("What it asks", "Who goes first?");
    const answer = async (number, text, reply) => {
      const one = author.desk.getByRole("group", { name: `Answer ${number}`, exact: true });
      await one.getByLabel("Answer", { exact: true }).fill(text);
      await one.getByLabel("Reply", { exact: true }).fill(reply);
      return one;
    };
    await answer(1, "A1", "A1 has the longer way.");
    const right = await answer(2, "A2", "It does.");
    await right.getByRole("checkbox", { name: "It is right" }).check();
    await author.fill("First hint", "Not A1.");
    await author.fill("Said once it is solved: why it is so", "It is so.");
    await author.desk.getByRole("checkbox", { name: "Hide the hints and the answers" }).check();
    await author.press("Try it");
    await course.at("Look");
    assert.equal(await course.lesson.getByRole("button", { name: "Hint" }).count(), 0);
    await page.keyboard.press("1");
    const said = await course.says(/this is not it\. Look again\./);
    assert.doesNotMatch(said, /longer way/);
    await page.keyboard.press("2");
    await course.solved();
    await course.lesson.getByRole("button", { name: "Go on writing" }).click();
    await author.desk.waitFor();
    await page.keyboard.press("Escape");
  });

  flow("that is faulty says so beside the field and in a list, in the words of the form", async (playground, { page }) => {
    const author = new Author(playground);
    await playground.open(file("ways.json", SCENE));
    await playground.shows("two ways");
    await author.open(new Course(playground));
    await author.fill("Title of the step", "Look");
    await author.press("Take the board as it is now");
    await author.says(/^Board copied into this step\./);
    await author.choose("What there is to do", "Edit the scene");
    await author.fill("What it asks", "Leave no plan.");
    await author.fill("Text", "See [A9](robot:A9).");
    const wrong = () => author.field("Text").evaluate((field) => document.getElementById(field.getAttribute("aria-describedby"))?.innerText);
    await eventually("the fault at its field", wrong, (said) => said === "The board of this step has no robot A9.");
    const tools = author.desk.getByRole("group", { name: "Tools", exact: true });
    await tools.getByText("Choose at least one tool: without one, nothing can be edited.").waitFor();
    assert.doesNotMatch(await author.desk.innerText(), /steps\[|"paint"|task\./);

    // The list names the step and the label, and leads there.
    await author.press("Add a step");
    await author.desk.getByText(/^\d+ things are still to do\.$/).click();
    const line = author.desk.getByRole("button", { name: "Step 1, Text: The board of this step has no robot A9." });
    await line.waitFor();
    await playground.picture("author-to-do");
    await line.click();
    await eventually("the focus in the text of the first step", () => page.evaluate(() => document.activeElement.id), (id) => id === "step-text");
    assert.equal(await author.field("Title of the step").inputValue(), "Look");
    await author.fill("Text", "See [A1](robot:A1).");
    await line.waitFor({ state: "detached" });
    await page.keyboard.press("Escape");
  }, { screens: BOTH });

  flow("that is faulty tells its fault, and the page stays as it is", async (playground, { page }) => {
    const author = new Author(playground);
    await playground.open(file("ways.json", SCENE));
    await playground.shows("two ways");
    const lesson = { giveway: 1, title: "T", minutes: 4, about: "A sentence.", steps: [{ title: "One", text: ["See [A9](robot:A9)."], scene: SCENE }] };
    await drop(page, "faulty.json", lesson);
    await author.refused.getByText(/steps\[0\]\.text\[0\]: found a link to the robot "A9", expected a robot of the scene/).waitFor();
    await page.keyboard.press("Escape");
    await author.refused.waitFor({ state: "detached" });
    await page.evaluate(() => { location.hash = "lesson=~cut-off"; });
    const isCut = author.refused.getByText(/found a link that was cut or changed/);
    await isCut.waitFor();
    // The next one comes before the browser has told that this one was closed.
    await page.evaluate(() => {
      document.querySelector("dialog[open]").close();
      location.hash = "lesson=~cut-off-again";
    });
    await isCut.waitFor();
    await page.keyboard.press("Escape");
    await author.refused.waitFor({ state: "detached" });
    await playground.shows("two ways");
  });
});
