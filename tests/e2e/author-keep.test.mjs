// What a teacher writes is not lost: to another tab, to a storage that is full, to a new lesson.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { Author, SCENE, drop, fill } from "./author.mjs";
import { Course } from "./course.mjs";
import { flows } from "./flow.mjs";
import { tab } from "./recover.mjs";
import { eventually } from "./wait.mjs";

describe("a lesson that is written", () => {
  const flow = flows();
  const title = (author) => author.field("Title").inputValue();
  const isTitled = (author, wanted) => eventually(`the title ${wanted}`, () => title(author), (title) => title === wanted);
  const NOTE = /also changed in another tab/;

  /** Another tab, and in both the course and the editor. */
  const beside = async (playground, context, host) => {
    const other = await tab(playground, context, host);
    return {
      other, one: new Course(playground), two: new Course(other), mine: new Author(playground), theirs: new Author(other),
    };
  };

  flow("in two tabs is told of, and each can take the other's and go back", async (playground, { context, host }) => {
    const { other, one, two, mine, theirs } = await beside(playground, context, host);
    await mine.open(one);
    await mine.fill("Title", "First");
    await mine.fill("Title of the step", "One");
    await mine.fill("Text", "Mine.");
    await mine.press("Take the board as it is now");
    await mine.says(/^Board copied into this step\./);
    await mine.press("Try it");
    await one.at("One");
    // While it is tried here, it is written anew there.
    await theirs.open(two);
    await isTitled(theirs, "First");
    await theirs.fill("Title", "Second");
    await one.lesson.getByRole("button", { name: "Go on writing" }).click();
    await mine.tells(NOTE);
    await isTitled(mine, "First");
    // What is written here now does not take away what was written there.
    await mine.fill("Title", "First again");
    await mine.desk.getByRole("button", { name: "Take what is written there" }).click();
    await isTitled(mine, "Second");
    await mine.press("Undo");
    await isTitled(mine, "First again");
    await mine.press("Undo");
    await isTitled(mine, "Second");
    await other.page.close();
  });

  flow("in a tab that is closed since can come back", async (playground, { context, host }) => {
    const { other, one, two, mine, theirs } = await beside(playground, context, host);
    await mine.open(one);
    await mine.fill("Title", "Mine");
    await theirs.open(two);
    await theirs.fill("Title", "Theirs");
    await mine.tells(NOTE);
    await other.page.close();
    await mine.fill("Title", "Mine again");
    await playground.reload();
    await mine.open(one);
    await isTitled(mine, "Mine again");
    await mine.press("Undo");
    await isTitled(mine, "Theirs");
  });

  flow("stays where the storage is full", async (playground, { page }) => {
    const course = new Course(playground);
    const author = new Author(playground);
    await author.open(course);
    await author.fill("Title", "Old");
    await page.evaluate(fill);
    await author.fill("Text", "A precious paragraph. ".repeat(50));
    await author.tells(/This browser does not keep what you write/);
    await playground.key("Escape");
    await author.open(course);
    assert.match(await author.field("Text").inputValue(), /^A precious paragraph\./);
    await author.tells(/This browser does not keep what you write/);
    await playground.key("Escape");
    // Once there is room, it is kept when the editor is opened.
    await page.evaluate(() => Object.keys(localStorage).filter((name) => name.startsWith("full-")).forEach((name) => localStorage.removeItem(name)));
    await author.open(course);
    await author.tells(/Kept in this browser while you write/);
    await playground.reload();
    await author.open(course);
    assert.match(await author.field("Text").inputValue(), /^A precious paragraph\./);
  });

  flow("comes back after a new one was begun, also in a page that is loaded anew", async (playground, { page }) => {
    const course = new Course(playground);
    const author = new Author(playground);
    await author.open(course);
    await author.fill("Title", "Precious");
    await author.press("New lesson");
    await isTitled(author, "");
    await playground.reload();
    await author.open(course);
    await isTitled(author, "");
    await author.fill("Title", "New");
    await author.press("Undo");
    await isTitled(author, "Precious");
    await author.press("Undo");
    await isTitled(author, "New");

    // A file that is dropped takes its place, too, with the same way back.
    const steps = [{ title: "Look", text: ["A sentence."], scene: SCENE }];
    await drop(page, "file.json", { giveway: 1, title: "Dropped", minutes: 4, about: "A sentence.", steps });
    await isTitled(author, "Dropped");
    assert.equal(await course.lesson.count(), 0);
    await author.press("Undo");
    await isTitled(author, "New");
  });
});
