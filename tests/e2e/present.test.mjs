// The page before a room: keys, a clicker, a question, a lesson, a phone; a lesson on paper.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { Course } from "./course.mjs";
import { flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const OPENING = /^Optimal: makespan 18, sum of costs 35, 3 charges\.$/;

/** What a person sees of a presentation. */
class Presentation {
  constructor(playground) {
    const { page } = playground;
    this.playground = playground;
    this.page = page;
    this.end = page.getByRole("button", { name: "End the presentation" });
    this.said = page.locator(".third:visible");
    this.headline = page.locator(".present-head .say");
    this.tools = page.getByRole("toolbar", { name: "Tools" });
  }

  /** Waits until it has begun, with its style sheet. */
  async begun() {
    await this.end.waitFor();
    await eventually("large buttons", async () => (await this.playground.button("Play").or(this.playground.button("Pause")).boundingBox())?.width ?? 0, (width) => width >= 56);
  }

  /** Waits until the lower third says something. */
  says(pattern) {
    return eventually(`the lower third to say ${pattern}`, async () => (await this.said.allInnerTexts()).join(" ").replaceAll(/\s+/g, " "), (text) => pattern.test(text));
  }

  /** Waits until a time is shown. */
  shows(time) {
    return eventually(`time ${time}`, () => this.page.getByRole("slider", { name: "Time" }).inputValue(), (now) => Number(now) === time);
  }

  /** Everything that is shown lies within the window, and nothing of it over the board. */
  async lies() {
    const window = this.page.viewportSize();
    const places = await Promise.all([this.playground.board, this.end, this.page.locator(".large"), this.page.locator(".steps")].map((it) => it.boundingBox()));
    for (const { x, y, width, height } of places) {
      assert.ok(x >= 0 && y >= 0 && x + width <= window.width + 0.5 && y + height <= window.height + 0.5, JSON.stringify({ x, y, width, height }));
    }
    const [board, , large] = places;
    assert.ok(board.y + board.height <= large.y + 1, "what plays lies over the board");
  }
}

describe("a presentation", () => {
  const flow = flows();

  flow("by keys: times, questions, what is said hidden, and its end", async (playground, { page }) => {
    await playground.says(OPENING);
    await playground.pause();
    await playground.press("To start");
    await page.mouse.click(5, 5);
    await playground.key("p");
    const presentation = new Presentation(playground);
    await presentation.begun();
    assert.equal(await presentation.tools.count(), 0);
    assert.equal(await playground.inspector.count(), 0);
    await presentation.lies();
    await playground.key("ArrowRight", "ArrowRight", "ArrowLeft");
    await presentation.shows(1);
    await playground.key("PageDown", "PageDown", "PageUp");
    await presentation.shows(2);

    await playground.key("ArrowDown");
    await presentation.says(/^Why does it take this long\?/);
    await presentation.says(/(It must|It would cost more|There is a better way)\. /);
    await presentation.lies();
    await playground.picture("present-question");
    await audit(playground, "a presentation");
    const first = (await presentation.said.innerText()).split("\n")[0];
    await playground.key("PageDown");
    await eventually("another question", async () => (await presentation.said.innerText()).split("\n")[0], (text) => text !== first);
    // The list of keys closes by its key, or by Escape, which ends nothing else then.
    for (const close of ["?", "Escape"]) {
      await playground.key("?");
      const keys = page.locator("dialog[open] .keylist").first();
      await keys.waitFor();
      await playground.key(close);
      await keys.waitFor({ state: "detached" });
      await presentation.end.waitFor();
    }
    await playground.key("PageUp", "h");
    await presentation.said.waitFor({ state: "detached" });
    await presentation.headline.waitFor({ state: "detached" });
    await playground.key("h");
    await presentation.says(/^Why does it take this long\?/);
    await presentation.headline.waitFor();
    await playground.key("ArrowUp");
    await presentation.says(/^$/);
    await playground.picture("present");

    // What was pressed by hand does not keep the keys.
    await playground.press("Play");
    await playground.button("Pause").waitFor();
    await playground.key("Space");
    await playground.button("Play").waitFor();
    await playground.key("Escape");
    await presentation.end.waitFor({ state: "detached" });
    await presentation.tools.waitFor();
    assert.equal(await page.evaluate(() => document.fullscreenElement), null);
  });

  flow("from the top bar; its buttons fade, what ends it does not", async (playground, { page }) => {
    await playground.says(OPENING);
    await playground.press("Present");
    const presentation = new Presentation(playground);
    await presentation.begun();
    const seen = () => page.evaluate(() => getComputedStyle(document.querySelector(".large .btn")).opacity);
    await page.mouse.move(400, 300);
    await eventually("buttons", seen, (opacity) => opacity === "1");
    await eventually("buttons that fade", seen, (opacity) => opacity === "0");
    assert.equal(await presentation.end.evaluate((it) => getComputedStyle(it).opacity), "1");
    await page.mouse.move(500, 300);
    await eventually("buttons", seen, (opacity) => opacity === "1");
    await presentation.end.click();
    await playground.tools.waitFor();
  });

  flow("of a lesson, with a clicker", async (playground, { page }) => {
    const course = new Course(playground);
    await course.open();
    await course.contents.getByRole("button", { name: /^Room to pass/ }).click();
    await course.at("A corridor and a bay");
    await course.lesson.getByRole("button", { name: "Present" }).click();
    const presentation = new Presentation(playground);
    await presentation.end.waitFor();
    await presentation.says(/^A corridor and a bay /);
    await playground.picture("present-lesson");
    await playground.key("PageDown");
    await presentation.says(/^How long will they need\? 2 of 4 When does the last robot arrive/);
    await playground.picture("present-task");
    await playground.key("3");
    await presentation.says(/Solved\. /);
    // Hidden from the room: what is judged, not what is asked.
    const judged = presentation.said.locator(".judged");
    await playground.key("h");
    await judged.waitFor({ state: "hidden" });
    await presentation.says(/^How long will they need\?/);
    await playground.key("h");
    await judged.waitFor();
    await playground.key("PageDown");
    await presentation.says(/^Who gives way\?/);
    // What was solved before is asked anew, by a key and by a press.
    await playground.key("PageUp");
    await presentation.says(/^How long will they need\? 2 of 4/);
    await judged.waitFor({ state: "detached" });
    await playground.key("3");
    await presentation.says(/Solved\. /);
    await playground.key("PageDown", "PageUp");
    await judged.waitFor({ state: "detached" });
    await presentation.said.getByRole("button", { name: /^3 / }).click();
    await presentation.says(/Solved\. /);
    await playground.key("PageDown");
    await presentation.says(/^Who gives way\?/);
    await playground.key("PageDown");
    await presentation.says(/^Block one cell /);
    // It does not end with the last step, and goes back.
    await playground.key("PageDown", "PageUp");
    await presentation.says(/^Who gives way\?/);
    await playground.key("Escape");
    await course.at("Who gives way?");
  });

  for (const [name, viewport] of [["upright", { width: 390, height: 844 }], ["lying", { width: 844, height: 390 }]]) {
    flow(`on a phone (${name})`, async (playground, { page }) => {
      await playground.says(OPENING);
      await page.setViewportSize(viewport);
      await playground.pause();
      await playground.key("p");
      const presentation = new Presentation(playground);
      await presentation.begun();
      await playground.key("ArrowDown");
      await presentation.says(/^Why does it take this long\? It /);
      await presentation.lies();
      await playground.picture(`present-${name}`);
    }, { screens: ["phone"] });
  }
});

describe("a sheet to print", () => {
  const flow = flows();

  flow("a lesson: its boards, its tasks, its answers apart", async (playground, { page }) => {
    // The browser's own dialog waits for a person.
    await page.evaluate(() => { window.print = () => { window.printed = true; }; });
    // Two formats are made of one sheet: it is told only afterwards that it was printed.
    await page.evaluate(() => addEventListener("afterprint", (event) => window.isDone || event.stopImmediatePropagation()));
    const course = new Course(playground);
    await course.open();
    await course.contents.getByRole("button", { name: /^Room to pass/ }).click();
    await course.at("A corridor and a bay");
    await course.lesson.getByRole("button", { name: "Print" }).click();
    await page.waitForFunction(() => window.printed);
    await page.emulateMedia({ media: "print" });
    const sheet = page.locator("#print");
    assert.equal(await course.lesson.isVisible(), false);
    const titles = await sheet.getByRole("heading").allInnerTexts();
    assert.deepEqual(titles, ["Room to pass", "1 A corridor and a bay", "2 How long will they need?", "3 Who gives way?", "4 Block one cell", "Answers"]);
    const boards = await sheet.getByRole("img").evaluateAll((all) => all.map((it) => [it.naturalWidth > 0, it.src.startsWith("data:image/svg+xml,")]));
    assert.ok(boards.length > 0 && boards.every(([isDrawn, isVector]) => isDrawn && isVector), JSON.stringify(boards));
    const answers = await sheet.locator(".answers").innerText();
    assert.match(answers, /No\. That plan would cost more\./);
    const before = (await sheet.innerText()).replace(answers, "");
    assert.ok(!before.includes("Yes: without A1"), "an answer stands beside its task");
    for (const format of ["A4", "Letter"]) {
      const pdf = await page.pdf({ format });
      const pages = pdf.toString("latin1").match(/\/Type\s*\/Page\b/g)?.length ?? 0;
      assert.ok(pages >= 2 && pages <= 5, `${pages} pages of ${format}`);
    }
    await page.screenshot({ path: playground.pathOf("print"), fullPage: true });
    await page.emulateMedia({ media: "screen" });
    assert.equal(await sheet.isVisible(), false);
    await page.evaluate(() => { window.isDone = true; dispatchEvent(new Event("afterprint")); });
    await sheet.waitFor({ state: "detached" });
  });
});
