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
    if (this.playground.isPhone()) {
      await this.playground.press("Mehr");
    }
    await this.playground.press("Kurs");
    await this.contents.getByRole("heading", { name: "Warum", exact: true }).waitFor();
  }
}

/** Tells the course another language, as the page does when one is chosen. */
function tell(playground, tag) {
  return playground.page.evaluate(async (tag) => {
    const po = tag && await (await fetch(`static/languages/${tag}.po`)).text();
    const detail = tag && `${tag}\n${po}`;
    document.querySelector("#course").dispatchEvent(new CustomEvent("giveway-language", { detail }));
  }, tag);
}

describe("the course in German", () => {
  const flow = flows();

  flow("its contents and its glossary", async (playground, { page }) => {
    const course = new Kurs(playground);
    await course.open();
    assert.equal(await course.contents.getByRole("listitem").count(), 21);
    await course.contents.getByText("21 kurze Lektionen").waitFor();
    assert.deepEqual(await english(playground), []);
    await playground.picture("course-german-contents");

    await course.contents.getByRole("button", { name: "Glossar" }).click();
    const glossary = page.getByRole("dialog", { name: "Glossar" });
    const terms = glossary.getByRole("term");
    const names = await terms.allInnerTexts();
    assert.equal(names.length, 49);
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
    await course.lesson.getByRole("button", { name: "Neu beginnen" }).click();
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
    await course.next.click();
    await course.at("How long will they need?");
    await playground.key("2");
    await course.says(/your guess.*proved.*8 is not enough/);

    await tell(playground, "de");
    await kurs.at("Wie lange brauchen sie?");
    await kurs.says(/Wer im Gang wartet, lässt niemanden vorbei\..*Der Solver hat bewiesen, dass 8 nicht genügen\./);
    await playground.picture("course-turned-german");
    await kurs.next.click();
    await kurs.at("Wer weicht aus?");

    await tell(playground, "");
    await course.at("Who gives way?");
    await playground.key("2");
    await course.says(/Solved/);
    await tell(playground, "de");
    await kurs.says(/Gelöst .*Die Bucht liegt näher bei A1/);
  });

  flow("turns with the page, and keeps how far one got", async (playground) => {
    const course = new Course(playground);
    const kurs = new Kurs(playground);
    await playground.says(/^Optimal: makespan 18/);
    await course.open();
    await course.contents.getByRole("button", { name: /^Room to pass/ }).click();
    await course.at("A corridor and a bay");
    await course.next.click();
    await course.at("How long will they need?");
    await course.lesson.getByRole("button", { name: "Leave the lesson" }).click();
    await course.lesson.waitFor({ state: "detached" });

    await choose(playground, "Deutsch");
    await kurs.open();
    await kurs.contents.getByText("Schritt 2 von 4").waitFor();
    assert.deepEqual(await english(playground), []);
    await kurs.contents.getByRole("button", { name: "Weiter: Platz zum Ausweichen" }).click();
    await kurs.at("Wie lange brauchen sie?");
    await playground.key("3");
    await kurs.says(/Gelöst .*Der Solver hat bewiesen, dass 8 nicht genügen\./);
    // The name of the scene is that of the file.
    assert.deepEqual(await english(playground), ["room to pass"]);
    await kurs.lesson.getByRole("button", { name: "Lektion verlassen" }).click();
    await choose(playground, "English");
    await course.open();
    await course.contents.getByRole("button", { name: "Go on: Room to pass" }).waitFor();
  });

  flow("turns by one press, in a lesson and over the contents", async (playground, { page }) => {
    const course = new Course(playground);
    const kurs = new Kurs(playground);
    await playground.says(/^Optimal: makespan 18/);
    await course.open();
    await course.contents.getByRole("button", { name: /^Room to pass/ }).click();
    await course.at("A corridor and a bay");
    await course.next.click();
    await course.at("How long will they need?");
    await playground.key("2");
    await course.says(/your guess.*proved/);
    await playground.press("DE: Deutsch");
    await kurs.at("Wie lange brauchen sie?");
    await kurs.says(/Der Solver hat bewiesen, dass 8 nicht genügen\./);
    await playground.picture("course-pressed-german");

    // The contents lie over the top bar, and have a button of their own.
    await kurs.lesson.getByRole("button", { name: "Kurs", exact: true }).click();
    await kurs.contents.getByRole("button", { name: "Glossar" }).click();
    const glossary = page.getByRole("dialog", { name: /^(Glossar|Glossary)$/ });
    await glossary.getByRole("searchbox").fill("CBS");
    await glossary.getByRole("button", { name: "EN: English" }).click();
    await page.getByRole("dialog", { name: "Glossary" }).waitFor();
    assert.equal(await glossary.getByRole("searchbox").inputValue(), "CBS", "what was typed is lost");
    const button = glossary.getByRole("button", { name: "DE: Deutsch" });
    assert.equal(await button.evaluate((button) => document.activeElement === button), true, "the focus is lost");
    await playground.picture("course-pressed-glossary");
    await playground.key("Escape");
    await course.at("How long will they need?");
    await course.says(/your guess.*proved/);
  }, { screens: BOTH });

  flow("stays in English where its catalogue does not arrive", async (playground, { context }) => {
    await context.route(/languages\/course\/de\.po/, (route) => route.fulfill({ status: 404 }));
    const course = new Course(playground);
    await playground.says(SOLVED);
    await playground.act("Kurs");
    await course.contents.getByRole("heading", { name: "Why", exact: true }).waitFor();
  }, { ...GERMAN, complains: true });
});
