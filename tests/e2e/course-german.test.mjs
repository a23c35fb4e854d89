// The course in German: its contents, a lesson, its glossary, and another language chosen meanwhile.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { Course } from "./course.mjs";
import { BOTH, flows } from "./flow.mjs";
import { choose, english } from "./language.mjs";
import { eventually } from "./wait.mjs";

const GERMAN = { locale: "de-DE" };
const SOLVED = /^Optimal: Makespan 18, Summe der Kosten 35, 3 Ladevorgänge\.$/;

/** The course by its German names. */
class Kurs extends Course {
  constructor(playground) {
    super(playground);
    const { page } = playground;
    this.contents = page.getByRole("dialog", { name: "Kurs" });
    this.lesson = page.getByRole("complementary", { name: "Lektion" });
    this.next = this.lesson.getByRole("button", { name: /^(Weiter|Abschließen)$/ });
  }

  /** Opens the contents once the page speaks German. */
  async open() {
    await this.playground.says(SOLVED);
    await this.playground.act("Kurs");
    await this.contents.getByRole("heading", { name: "Warum", exact: true }).waitFor();
  }
}

describe("the course in German", () => {
  const flow = flows();

  flow("its contents and its glossary", async (playground, { page }) => {
    const course = new Kurs(playground);
    await course.open();
    assert.equal(await course.contents.getByRole("listitem").count(), 16);
    await course.contents.getByText("16 kurze Lektionen").waitFor();
    assert.deepEqual(await english(playground), []);
    await playground.picture("course-german-contents");

    await course.contents.getByRole("button", { name: "Glossar" }).click();
    const glossary = page.getByRole("dialog", { name: "Glossar" });
    const terms = glossary.getByRole("term");
    const names = await terms.allInnerTexts();
    assert.equal(names.length, 41);
    assert.deepEqual(names, names.toSorted(new Intl.Collator("de").compare), "not in the order of the language");
    await playground.picture("course-german-glossary");
    const find = glossary.getByRole("searchbox", { name: "Begriff suchen" });
    const searched = async (text, expected) => {
      await find.fill(text);
      await eventually(`the terms with ${text}`, () => terms.allInnerTexts(), (found) => found.join() === expected);
    };
    await searched("LÜCKE", "Lücke");
    await searched("zwei roboter tauschen", "Tauschkonflikt");
    await searched("CBS", "Konfliktbasierte Suche");
    await searched("swap", "");
    await glossary.getByText("In keinem Begriff kommt das vor.").waitFor();
    await searched("Nachrücken", "Nachrücken");
    await glossary.getByRole("button", { name: "Lektion 3: Alle fahren zugleich" }).click();
    await course.at("Keine einzige freie Zelle");
  }, { ...GERMAN, screens: BOTH });

  flow("its first lesson, solved", async (playground) => {
    const course = new Kurs(playground);
    const [board, time] = [playground.page.getByRole("grid", { name: "Spielfeld" }), playground.page.getByRole("slider", { name: "Zeit" })];
    await course.open();
    await course.contents.getByRole("button", { name: "Beginnen: Zwei Roboter, eine Zelle" }).click();
    await course.at("Roboter machen Schritte");
    assert.deepEqual(await english(playground), []);
    await course.next.click();

    await course.at("Zwei in einer Zelle");
    const at = async (when, x, y) => {
      await time.focus();
      await playground.key("Home", ...Array(when).fill("ArrowRight"));
      await board.focus();
      await playground.key("Control+Home", ...Array(x).fill("ArrowRight"), ...Array(y).fill("ArrowDown"), "Enter");
    };
    await at(1, 2, 3);
    await course.says(/zur Zeit 1, und wer noch\?/);
    await at(2, 2, 2);
    await course.says(/Gelöst .*In keinem gültigen Plan ist das so\./);
    assert.deepEqual(await english(playground), []);
    await playground.picture("course-german-solved");
    await course.next.click();

    await course.at("Durcheinander hindurch");
    await at(1, 1, 0);
    await at(1, 2, 0);
    await course.says(/Noch nicht: 1 Konflikt gefunden\. Es gibt noch mehr\./);
    await at(2, 2, 0);
    await course.says(/Gelöst/);
    await course.next.click();

    await course.at("Besser machen");
    await board.focus();
    await playground.key("ArrowUp", "ArrowUp", "ArrowUp", "ArrowUp");
    await course.says(/(Noch nicht|So nicht): /);
    assert.deepEqual(await english(playground), []);
    await course.lesson.getByRole("button", { name: "Von vorn beginnen" }).click();
    await board.focus();
    await playground.key("w", "ArrowUp", "ArrowUp", "ArrowUp", "ArrowUp");
    await course.says(/Gelöst/);
    await course.next.click();
    await course.contents.getByText("Fertig", { exact: true }).waitFor();
    await course.contents.getByRole("button", { name: "Weiter: Platz zum Ausweichen" }).waitFor();
  }, GERMAN);

  flow("follows the page while a lesson is open", async (playground) => {
    const course = new Course(playground);
    const kurs = new Kurs(playground);
    await playground.says(/^Optimal: makespan 18/);
    await course.open();
    await course.contents.getByRole("button", { name: /^Room to pass/ }).click();
    await course.at("A corridor and a bay");
    await course.lesson.getByRole("button", { name: "Step 4: Block one cell" }).click();
    await course.at("Block one cell");
    await playground.pick("Obstacle");
    await playground.stroke([4, 0]);
    await course.says(/Not yet: there is still a plan, makespan 9\. You blocked \(4, 0\)\./);
    await course.lesson.getByRole("button", { name: "Hint", exact: true }).click();

    await choose(playground, "Deutsch");
    await kurs.at("Eine Zelle sperren");
    await kurs.says(/Noch nicht: Es gibt noch einen Plan, Makespan 9\. Geändert: \(4, 0\) gesperrt\./);
    await kurs.says(/Der Gang muss offen bleiben/);
    assert.deepEqual(await english(playground), []);
    await playground.picture("course-turned-german");
    await kurs.lesson.getByRole("button", { name: "Zurücknehmen" }).click();
    await playground.page.getByRole("toolbar", { name: "Werkzeuge" }).getByRole("button", { name: "Hindernis", exact: true }).click();

    await choose(playground, "English");
    await course.at("Block one cell");
    await playground.stroke([3, 1]);
    await course.solved();
    await choose(playground, "Deutsch");
    await kurs.says(/Gelöst .*Ohne \(3, 1\) ist kein Platz zum Ausweichen/);
  });

  flow("stays in English where its catalogue does not arrive", async (playground, { context }) => {
    await context.route(/languages\/course\/de\.po/, (route) => route.fulfill({ status: 404 }));
    const course = new Course(playground);
    await playground.says(SOLVED);
    await playground.act("Kurs");
    await course.contents.getByRole("heading", { name: "Why", exact: true }).waitFor();
  }, { ...GERMAN, complains: true });
});
