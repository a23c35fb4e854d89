// Handing in a lesson, and what a lecturer sees of a class's hand-ins.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { SCENE } from "./author.mjs";
import { Course } from "./course.mjs";
import { BOTH, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

/** A lesson of one's own, of one task. */
const RING = {
  giveway: 1,
  title: "A ring",
  minutes: 4,
  about: "Two robots go around.",
  steps: [
    {
      title: "Guess", text: ["A sentence."], scene: SCENE, hints: ["Count."], reason: "Both go around.",
      task: { kind: "predict", say: "How long do they need?", what: { is: "cost", cost: "makespan" } },
    },
  ],
};

/** Follows a link of the page. */
const follow = (page, hash) => page.evaluate((hash) => { location.hash = hash; }, hash);

/** Drops files onto the page, a minute of change between them. */
function drop(page, files) {
  return page.evaluate((files) => {
    const data = new DataTransfer();
    for (const [index, [name, text]] of files.entries()) {
      data.items.add(new File([text], name, { lastModified: 1_700_000_000_000 + index * 60_000 }));
    }
    for (const kind of ["dragover", "drop"]) {
      document.body.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
    }
  }, files);
}

/** What is downloaded by a press. */
async function saved(page, press) {
  const download = page.waitForEvent("download");
  await press();
  const file = await download;
  return { name: file.suggestedFilename(), text: readFileSync(await file.path(), "utf8") };
}

/** Hands in the lesson about room to pass with its first task answered: the third answer is right. */
async function handIn(playground, answer, name) {
  const { page } = playground;
  const course = new Course(playground);
  await follow(page, "lesson=room-to-pass.2");
  await course.at("How long will they need?");
  await course.lesson.locator(".opt").nth(answer - 1).click();
  await course.says(/your guess|proved/);
  await course.lesson.getByRole("button", { name: "Hand in" }).click();
  await course.at("Hand in your work");
  await course.lesson.getByLabel("Your name, as your lecturer knows you").fill(name);
  return course;
}

describe("a lesson is handed in", () => {
  const flow = flows();

  flow("as a file that a mail survives, and as a link", async (playground, { page, context }) => {
    await context.grantPermissions(["clipboard-read", "clipboard-write"]).catch(() => {});
    const course = await handIn(playground, 3, "Ada L.");
    await course.says(/Nothing is sent\./);
    await course.says(/room-to-pass-ada-l\.json/);
    await course.says(/1 How long will they need\? solved, 1 try/);
    await course.says(/not tried/);
    await playground.picture("hand-in");
    const file = await saved(page, () => course.lesson.getByRole("button", { name: "Save file" }).click());
    assert.equal(file.name, "room-to-pass-ada-l.json");
    assert.match(file.text, /^[\n\r\x20-\x7e]*$/, "ASCII alone");
    assert.ok(file.text.split("\n").every((line) => line.length <= 72), "lines of at most 72 letters");
    await course.says(/Saved\. Give the file to your lecturer\./);
    await course.lesson.getByRole("button", { name: "Copy link" }).click();
    await course.says(/Copied\. Give the link to your lecturer\./);
    const link = await page.evaluate(() => navigator.clipboard.readText());
    assert.match(link, /#hand-in=~[\w-]+$/);

    // A card leads back to its step.
    await course.lesson.getByRole("button", { name: /^1 How long will they need\?/ }).click();
    await course.at("How long will they need?");

    // A link alone opens the same table.
    await follow(page, link.slice(link.indexOf("#") + 1));
    await page.getByRole("dialog", { name: "1 hand-in" }).getByRole("row", { name: /Ada L\./ }).waitFor();
  }, { screens: BOTH });

  flow("in one's own language", async (playground, { page }) => {
    await playground.press("DE: Deutsch");
    await follow(page, "lesson=room-to-pass.2");
    await page.getByRole("complementary", { name: "Lektion" }).getByRole("button", { name: "Abgeben" }).click();
    await page.getByRole("heading", { name: "Arbeit abgeben" }).waitFor();
    await page.getByText("Es wird nichts gesendet.").waitFor();
  });
});

describe("the hand-ins of a class", () => {
  const flow = flows();

  flow("are judged anew, whatever they claim", async (playground, { page }) => {
    const save = async (answer, name) => {
      const course = await handIn(playground, answer, name);
      const file = await saved(page, () => course.lesson.getByRole("button", { name: "Save file" }).click());
      await course.lesson.getByRole("button", { name: "Room to pass" }).click();
      return file;
    };
    const right = await save(3, "Ada");
    // What is in it, with something else.
    const changed = (change) => JSON.stringify({ ...JSON.parse(right.text.replaceAll("\n", "")), ...change }, null, 1);
    const wrong = (solved) => [{ step: 2, answer: { is: "value", value: 7 }, solved, tries: 1 }];
    const claimed = changed({ name: "Bob", tasks: wrong(true) });
    await drop(page, [
      ["ada.json", right.text],
      ["bob.json", `> ${claimed.replaceAll("\n", "\r\n> ")}`],
      ["cyd-1.json", changed({ name: "Cyd" })],
      ["cyd-2.json", changed({ name: "Cyd", tasks: wrong(false) })],
      ["homework.pdf", "%PDF-1.7 no hand-in"],
      ["cut.json", right.text.slice(0, 200)],
    ]);
    const table = page.getByRole("dialog", { name: "3 hand-ins" });
    await table.getByText("1 task is said to be solved, and is not.").waitFor();
    const rows = await table.locator("tbody tr").allInnerTexts();
    assert.deepEqual(rows.map((row) => row.trim().split(/\s/)[0]), ["Bob", "Cyd", "Ada"], "whom to look at first");
    await table.getByRole("row", { name: /^Cyd the latest of 2 files/ }).waitFor();
    await table.getByRole("button", { name: "says solved, is not, 1 try" }).waitFor();
    const unread = await table.locator(".unr li").allInnerTexts();
    assert.deepEqual(unread.map((line) => line.split("\n")[0]), ["homework.pdf", "cut.json"]);
    // Each task has its column, tried or not.
    const lefts = await table.locator("tbody tr").first().evaluate((row) => [...row.cells].map((cell) => cell.getBoundingClientRect().left));
    assert.ok(lefts.every((left, at) => at === 0 || left > lefts[at - 1]), lefts.join(" "));
    await playground.picture("class");

    const csv = await saved(page, () => table.getByRole("button", { name: "Save as CSV" }).click());
    assert.match(csv.text, /Bob,Room to pass,.*not solved,solved,1,/);

    // The work on the board, and on by keys.
    await table.getByRole("button", { name: "says solved, is not, 1 try" }).click();
    const work = page.getByRole("complementary", { name: "A student's work" });
    await work.getByRole("heading", { name: "Bob" }).waitFor();
    await work.getByText("The file says that it is solved.").waitFor();
    await work.getByText(/^When does the last robot arrive/).waitFor();
    await work.getByRole("button", { name: "Copy for the student" }).click();
    await work.getByText("Copied, to be sent to the student.").waitFor();
    assert.match(await page.evaluate(() => navigator.clipboard.readText()), /^Bob: Room to pass\n1 How long will they need\?: not solved\. Your answer: .*7/);
    await playground.picture("class-work");
    await work.getByRole("button", { name: "Next to look at (1 of 2)" }).click();
    await work.getByRole("heading", { name: "Cyd" }).waitFor();
    await work.getByRole("button", { name: "Class" }).click();
    await table.waitFor();
    await eventually("the focus on the cell that was looked at", () => page.evaluate(() => document.activeElement?.getAttribute("data-at")), (at) => at === "1.0");
    await table.getByRole("button", { name: /^not solved, 1 try/ }).focus();
    await page.keyboard.press("ArrowDown");
    await eventually("the focus one row below", () => page.evaluate(() => document.activeElement?.getAttribute("data-at")), (at) => at === "2.0");

    // A person's own scene was put aside, and the class stays until it is forgotten.
    await page.keyboard.press("Escape");
    await table.waitFor({ state: "detached" });
    await playground.says(/^Optimal: /);
    const course = new Course(playground);
    await course.open();
    await course.contents.getByRole("button", { name: "Hand-ins" }).click();
    await table.getByRole("button", { name: "Forget them" }).click();
    await page.getByRole("dialog", { name: "Hand-ins of a class" }).waitFor();
  }, { screens: BOTH, permissions: ["clipboard-read", "clipboard-write"] });

  flow("of a lesson of one's own are judged once it is dropped, too", async (playground, { page, host }) => {
    const course = new Course(playground);
    await drop(page, [["ring.json", JSON.stringify(RING)]]);
    await course.at("Guess");
    await course.lesson.getByRole("textbox").fill("99");
    await course.lesson.getByRole("button", { name: "Say it" }).click();
    await course.says(/99 your guess \d+ proved/);
    await course.lesson.getByRole("button", { name: "Hand in" }).click();
    await course.lesson.getByLabel("Your name, as your lecturer knows you").fill("Ada");
    const file = await saved(page, () => course.lesson.getByRole("button", { name: "Save file" }).click());
    assert.equal(JSON.parse(file.text).name, "Ada", "a program can read it, too");

    // On the lecturer's machine, which does not have the lesson yet.
    await page.evaluate(() => localStorage.clear());
    await page.goto("about:blank");
    await playground.goto(host.url);
    await drop(page, [[file.name, file.text]]);
    const table = page.getByRole("dialog", { name: /hand-in/i });
    await table.getByText(/give that lesson, too/).waitFor();
    await drop(page, [["ring.json", JSON.stringify(RING)]]);
    await table.getByRole("row", { name: /^Ada/ }).waitFor();
    await table.getByRole("button", { name: "not solved, 1 try" }).waitFor();
    assert.equal(await course.lesson.count(), 0, "the lesson itself is not opened");
  });
});
