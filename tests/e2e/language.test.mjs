// Languages: the page follows the browser's, turns to the one that is chosen, and keeps the choice.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows } from "./flow.mjs";
import { choose, english } from "./language.mjs";
import { eventually } from "./wait.mjs";

const GERMAN = { locale: "de-DE" };
const SOLVED = /^Optimal: Makespan 18, Summe der Kosten 35, 3 Ladevorgänge\.$/;

describe("languages", () => {
  const flow = flows();

  flow("are the browser's", async (playground) => {
    await german(playground);
    await playground.picture("german");
    assert.equal(await playground.page.getAttribute("html", "lang"), "de");
    assert.match(await playground.page.title(), /bewiesen/);
    await playground.press("Lösen");
    await playground.says(SOLVED);
    assert.deepEqual(await english(playground), []);
  }, { ...GERMAN, screens: BOTH });

  flow("reword what is on the screen, and are kept", async (playground) => {
    await playground.says(/^Optimal: makespan 18/);
    await choose(playground, "Deutsch");
    await playground.says(SOLVED);
    await playground.page.reload();
    await german(playground);
    await choose(playground, "Wie der Browser");
    await playground.says(/^Optimal: makespan 18, sum of costs 35, 3 charges\.$/);
    assert.equal(await playground.page.getAttribute("html", "lang"), "en");
  });

  flow("can be English for a German browser", async (playground) => {
    await german(playground);
    await choose(playground, "English");
    await playground.says(/^Optimal: makespan 18/);
    await playground.reload();
    await playground.says(/^Optimal: makespan 18/);
  }, GERMAN);

  flow("say answers, too", async (playground) => {
    await german(playground);
    await playground.page.getByRole("complementary", { name: "Details" }).getByRole("button", { name: /^A1\b/ }).first().click();
    await playground.page.getByRole("button", { name: /^Warum kommt A1 nicht früher an\?/ }).first().click();
    const details = playground.page.getByRole("complementary", { name: "Details" });
    await details.getByText("Notwendig", { exact: true }).or(details.getByText("Teurer", { exact: true })).first().waitFor();
    await eventually("all of the answer", () => details.innerText(), (text) => !/wird gesucht|werden gesucht/.test(text));
    await playground.picture("german-answer");
    assert.deepEqual(await english(playground), []);
  }, GERMAN);

  flow("say why there is no plan", async (playground) => {
    await german(playground);
    await playground.press("Beispiele");
    await playground.page.getByRole("dialog").getByRole("button", { name: /^Kein Vorbeikommen/ }).click();
    await playground.says(/^Kein Plan existiert, egal wie viele Schritte erlaubt sind: \w+ und \w+ können nicht beide ankommen\.$/);
    assert.deepEqual(await english(playground), []);
    await choose(playground, "English");
    await playground.says(/^No plan exists, no matter how many steps you allow: \w+ and \w+ cannot both arrive\.$/);
  }, GERMAN);

  const wrong = [
    ["of a scene, which the reader reads", "szene.json", '{"giveway": 1, "map": [".x"], "agents": []}',
      'szene.json, Zeile 1, Spalte 26: map[0][1]: gefunden: "x"; erwartet: eines von . # ~ + *'],
    ["of a map, which the page reads", "karte.map", "type octile\nheight 1\nwidth 3\nmap\n..\n",
      "karte.map, Zeile 5, Spalte 3: gefunden: eine Zeile mit 2 Zellen; erwartet: 3, die Breite im Kopf"],
  ];
  for (const [what, name, bytes, told] of wrong) {
    flow(`say the faults ${what}`, async (playground) => {
      await german(playground);
      await drop(playground.page, name, bytes);
      const notice = await playground.warns(/lässt sich nicht öffnen/);
      assert.ok(notice.includes(told), notice);
      assert.deepEqual(await english(playground), []);
    }, GERMAN);
  }

  flow("turn by one press, and nothing is lost", async (playground, { page, screen }) => {
    await playground.says(/^Optimal: makespan 18/);
    await playground.pause();
    const time = await playground.now();
    const german = playground.button("DE: Deutsch");
    assert.equal(await german.getAttribute("lang"), "de");
    assert.equal((await german.innerText()).trim(), "DE");
    if (screen === "desktop") {
      // What is typed and not yet taken is taken.
      await playground.openSettings();
      await playground.settings.getByLabel("Time limit, s").fill("41");
    }
    await german.click();
    await playground.says(SOLVED);
    const back = playground.button("EN: English");
    await back.waitFor();
    assert.equal(await back.evaluate((button) => document.activeElement === button), true, "the focus is lost");
    assert.equal(Number(await page.getByRole("slider", { name: "Zeit" }).first().getAttribute("aria-valuenow")), time);
    if (screen === "desktop") {
      // The card of the settings closes by any press outside of it.
      await page.getByRole("button", { name: /^Einstellungen:/ }).click();
      assert.equal(await page.getByLabel("Zeitlimit, s").inputValue(), "41");
      await playground.key("Escape");
    }
    await playground.picture("language-pressed");
    await back.focus();
    await playground.key("Enter");
    await playground.says(/^Optimal: makespan 18/);
    await playground.reload();
    await playground.says(/^Optimal: makespan 18/);
  }, { screens: BOTH });

  flow("that cannot be fetched leave the page in English", async (playground, { context }) => {
    await context.route(/languages\/de\.po/, (route) => route.fulfill({ status: 404 }));
    await playground.says(/^Optimal: makespan 18/);
    await choose(playground, "Deutsch");
    await playground.warns(/^The language did not arrive/);
    await playground.says(/^Optimal: makespan 18/);
  }, { complains: true });
});

/** Waits until the page speaks German. */
async function german(playground) {
  await playground.says(SOLVED);
}

/** Drops a file onto the page. */
function drop(page, name, text) {
  return page.evaluate(([name, text]) => {
    const data = new DataTransfer();
    data.items.add(new File([text], name));
    for (const kind of ["dragover", "drop"]) {
      document.body.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
    }
  }, [name, text]);
}
