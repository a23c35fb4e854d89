// What the browser keeps of the course: the progress that tabs share, the lesson that is open,
// lessons that came as a file; and what happens when a file of the course does not arrive.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { Author, SCENE, drop, fill } from "./author.mjs";
import { Course } from "./course.mjs";
import { BOTH, flows } from "./flow.mjs";
import { deafen, tab } from "./recover.mjs";
import { eventually } from "./wait.mjs";

/** A teacher's lesson of two steps. */
const MINE = {
  giveway: 1,
  title: "A ring",
  minutes: 4,
  about: "Two robots go around.",
  steps: [{ title: "Look", text: ["A sentence."], scene: SCENE }, { title: "Think", text: ["Another one."] }],
};

/** Follows a link to a lesson. */
const follow = (page, place) => page.evaluate((place) => { location.hash = `lesson=${place}`; }, place);

/** Waits until the browser keeps of the lessons what is wanted. */
const keeps = (page, wanted) => eventually("the progress to be kept", async () => JSON.parse(await page.evaluate(() => localStorage.getItem("giveway.course")) ?? "{}").lessons ?? {}, wanted);

/** Presses twice, fast, where something is. */
async function pressTwice(page, locator) {
  const { x, y, width, height } = await locator.boundingBox();
  await page.mouse.dblclick(x + width / 2, y + height / 2, { delay: 30 });
}

describe("the course keeps", () => {
  const flow = flows();

  for (const [how, before] of [["and hear of each other", undefined], ["which are deaf", deafen]]) {
    flow(`what two tabs do, ${how}`, async (playground, { page, context, host }) => {
      const other = await tab(playground, context, host);
      const [one, two] = [new Course(playground), new Course(other)];
      await two.open();
      await other.key("Escape");
      await follow(page, "room-to-pass.2");
      await one.at("How long will they need?");
      await playground.key("2");
      await one.says(/your guess/);
      await keeps(page, (lessons) => "room-to-pass" in lessons);
      await two.open();
      if (!before) {
        await two.contents.getByText("Step 2 of 4").waitFor();
      }
      await two.contents.getByRole("button", { name: /^Two robots, one cell/ }).click();
      await two.at("Robots take steps");
      await keeps(page, (lessons) => "room-to-pass" in lessons && "two-robots-one-cell" in lessons);

      // What is forgotten in one is forgotten in the other, and the open lesson goes on being kept.
      await two.lesson.getByRole("button", { name: "Course" }).click();
      await two.contents.getByRole("button", { name: "Forget my progress" }).click();
      await two.contents.getByRole("button", { name: "Reset progress" }).click();
      await eventually("the focus on the way on", () => two.focused(), (name) => /^Start: /.test(name));
      await keeps(page, (lessons) => Object.keys(lessons).length === 0);
      await one.next.click();
      await one.at("Who gives way?");
      await keeps(page, (lessons) => Object.keys(lessons).join() === "room-to-pass");
      await other.page.close();
    }, { before });
  }

  flow("what is solved after all was forgotten, or just before going on", async (playground, { page }) => {
    const course = new Course(playground);
    await follow(page, "room-to-pass.4");
    await course.at("Block one cell");
    await course.lesson.getByRole("button", { name: "Course" }).click();
    await course.contents.getByRole("button", { name: "Forget my progress" }).click();
    await course.contents.getByRole("button", { name: "Reset progress" }).click();
    await playground.key("Escape");
    await playground.pick("Obstacle");
    const { x, y } = await playground.middleOf(3, 1);
    await page.mouse.click(x, y);
    await page.evaluate(() => [...document.querySelectorAll("button")].find((button) => button.textContent === "Finish").click());
    await course.contents.waitFor();
    await keeps(page, (lessons) => lessons["room-to-pass"]?.seen && lessons["room-to-pass"].solved.includes(3));
    await course.contents.getByText("1 of 3 tasks").waitFor();
    await playground.key("Escape");
  });

  flow("the lesson that is open, at its step, and a person's own scene beside it", async (playground, { page, host }) => {
    const course = new Course(playground);
    await playground.open({ name: "ways.json", bytes: JSON.stringify(SCENE) });
    await playground.shows("two ways");
    await playground.pick("Obstacle");
    await playground.stroke([1, 0]);
    await playground.cellTells(1, 0, /^obstacle/);
    await follow(page, "room-to-pass");
    await course.at("A corridor and a bay");
    await course.next.click();
    await course.at("How long will they need?");
    assert.equal(page.url(), `${host.url}#lesson=room-to-pass.2`);
    await playground.reload();
    await course.at("How long will they need?");
    await course.lesson.getByRole("button", { name: "Leave the lesson" }).click();
    await course.lesson.waitFor({ state: "detached" });
    await eventually("the focus on the course", () => course.focused(), (name) => name === "Course");
    assert.equal(page.url(), host.url);
    await playground.shows("two ways");
    await playground.cellTells(1, 0, /^obstacle/);
    await playground.press("Undo");
    await playground.cellTells(1, 0, /^(?!obstacle)/);
    await playground.reload();
    await playground.shows("two ways");
    assert.equal(await course.lesson.count(), 0);
  });

  flow("lessons that came as a file", async (playground, { page, host }) => {
    const course = new Course(playground);
    await drop(page, "ring.json", MINE);
    await course.at("Look");
    await course.next.click();
    await course.at("Think");
    // Loaded anew, it opens again.
    assert.match(page.url(), /#lesson=~[\w-]+\.2$/);
    await playground.reload();
    await course.at("Think");
    await course.lesson.getByRole("button", { name: "Leave the lesson" }).click();
    await course.lesson.waitFor({ state: "detached" });
    assert.equal(page.url(), host.url);
    // Later it is in the contents.
    await playground.reload();
    await course.open();
    const card = course.contents.getByRole("button", { name: /^A ring/ });
    await card.scrollIntoViewIfNeeded();
    await course.contents.getByText("Step 2 of 2").waitFor();
    await playground.picture("course-own");
    await card.click();
    await course.at("Think");
    await course.lesson.getByRole("button", { name: "Course" }).click();
    await course.contents.getByRole("button", { name: "Remove A ring" }).click();
    await course.contents.getByText("A ring is removed.").waitFor();
    await playground.picture("course-own-removed");
    await eventually("the focus on the way back", () => course.focused(), (name) => name === "Undo");
    await course.contents.getByRole("button", { name: "Undo" }).click();
    await card.waitFor();
    await course.contents.getByRole("button", { name: "Remove A ring" }).click();
    await playground.key("Escape");
    await playground.reload();
    await course.at("Think");
    await course.lesson.getByRole("button", { name: "Leave the lesson" }).click();
  }, { screens: BOTH });

  flow("nothing where the storage is full, and goes on", async (playground, { page }) => {
    const course = new Course(playground);
    await course.open();
    await playground.key("Escape");
    await page.evaluate(fill);
    await drop(page, "ring.json", MINE);
    await course.at("Look");
    await course.next.click();
    await course.at("Think");
    await course.lesson.getByRole("button", { name: "Course" }).click();
    await course.contents.waitFor();
    await page.evaluate(() => localStorage.clear());
  });

  flow("asking for what did not arrive", async (playground, { page, context }) => {
    const course = new Course(playground);
    await playground.act("Course");
    const missing = course.contents.getByRole("alert");
    await eventually("it to be told", () => missing.innerText(), (text) => text === "The course could not be loaded. Try again when the network is back.");
    await playground.picture("course-missing");
    await context.unroute("**/static/course/index.json");
    await playground.key("Escape");
    await course.open();
    assert.equal(await missing.count(), 0);
    await context.route("**/static/course/room-to-pass.json", (route) => route.abort());
    const card = course.contents.getByRole("button", { name: /^Room to pass/ });
    await card.click();
    await eventually("it to be told", () => missing.innerText(), (text) => text === "The lesson could not be loaded. Try again when the network is back.");
    await context.unroute("**/static/course/room-to-pass.json");
    await playground.key("Escape");
    await course.open();
    assert.equal(await missing.count(), 0);
    await card.click();
    await course.at("A corridor and a bay");
  }, { complains: true, before: (context) => context.route("**/static/course/index.json", (route) => route.abort()) });

  flow("to one press of two", async (playground, { page }) => {
    const course = new Course(playground);
    const button = playground.isPhone() ? undefined : playground.button("Course");
    if (button) {
      await pressTwice(page, button);
      await course.contents.getByRole("heading", { name: "Why", exact: true }).waitFor();
      await playground.key("Escape");
    }
    await follow(page, "two-robots-one-cell.1");
    await course.at("Robots take steps");
    await pressTwice(page, course.next);
    await course.at("Two in one cell");
    await follow(page, "two-robots-one-cell.4");
    await course.at("Mend it");
    await pressTwice(page, course.next);
    await course.contents.waitFor();
    await course.lesson.waitFor({ state: "detached" });
    await page.waitForTimeout(300);
    assert.equal(await course.contents.count(), 1);
    assert.equal(await new Author(playground).desk.count(), 0);
    // What had the focus is gone: it comes back to what opens the course, or stays where the second
    // press went, when that came before the contents covered the tools. It is never lost.
    await playground.key("Escape");
    const hasFocus = () => page.evaluate(() => document.activeElement.matches("button, a") && document.activeElement.checkVisibility());
    await eventually("the focus on something that can be pressed", hasFocus, Boolean);
  }, { screens: BOTH });

  flow("the focus where something goes away", async (playground, { page }) => {
    const course = new Course(playground);
    const press = (name) => course.lesson.getByRole("button", { name, exact: true }).press("Enter");
    const isOn = (pattern) => eventually(`the focus on ${pattern}`, () => course.focused(), (name) => pattern.test(name));
    await follow(page, "room-to-pass.2");
    await course.at("How long will they need?");
    await press("Show me the answer");
    await course.says(/proved/);
    await isOn(/^Next$/);

    await follow(page, "room-to-pass.4");
    await course.at("Block one cell");
    await playground.pick("Obstacle");
    await playground.stroke([4, 0]);
    await course.says(/Not yet/);
    await press("Take it back");
    await isOn(/^Hint$/);
    await playground.stroke([4, 0]);
    await course.says(/Not yet/);
    await press("Start afresh");
    await isOn(/^Hint$/);
    for (const name of ["Hint", "Next hint", "Show me how"]) {
      const hint = course.lesson.getByRole("button", { name, exact: true });
      if (await hint.count() > 0) {
        await hint.press("Enter");
      }
    }
    await isOn(/^Finish$/);

    await follow(page, "no-plan-is-better.4");
    await course.at("Check it");
    await press("Check the proof");
    await course.says(/Accepted/);
    await isOn(/^Change one byte$/);
    await press("Leave the lesson");
    await isOn(/^Course$/);

    const author = new Author(playground);
    await author.open(course);
    await eventually("the focus on the title", () => author.field("Title").evaluate((field) => field === document.activeElement), Boolean);
    await playground.key("Escape");
  });
});
