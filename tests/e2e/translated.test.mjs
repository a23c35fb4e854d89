// A page whose text something else replaces, as a browser's translator does: what is shown stays true.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { assertQuiet } from "./browser.mjs";
import { Course } from "./course.mjs";
import { BOTH, flows } from "./flow.mjs";
import { OPENING, stroke } from "./recover.mjs";

/** Puts every text of the page into an element of its own, the text's node aside, as translators do. */
function translate({ page }) {
  return page.evaluate(() => {
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const all = [];
    while (walker.nextNode()) {
      const { currentNode: node } = walker;
      if (node.data.trim() && !node.parentNode.closest("script, style, font, svg")) {
        all.push(node);
      }
    }
    for (const node of all) {
      const outer = document.createElement("font");
      const inner = document.createElement("font");
      inner.textContent = node.data;
      outer.append(inner);
      node.replaceWith(outer);
    }
  });
}

/** Adds a part of the translation beside each text, whose node stays. */
function translateBeside({ page }) {
  return page.evaluate(() => {
    for (const element of document.querySelectorAll(".status *")) {
      const text = [...element.childNodes].find((node) => node.nodeType === Node.TEXT_NODE && node.data.trim());
      text?.after(`${text.data} `);
    }
  });
}

describe("a translated page", () => {
  const flow = flows();

  flow("asks not to be", async ({ page }) => {
    assert.equal(await page.getAttribute("html", "translate"), "no");
  });

  flow("shows another scene, not the one before", async (playground, { page, complaints }) => {
    await playground.says(OPENING);
    await translate(playground);
    await playground.example("No way past");
    await playground.says(/^No plan exists/);
    await playground.shows("scenario 6");
    assert.doesNotMatch(await page.locator("body").innerText(), /Proved\b.*Optimal|makespan 18|warehouse/s);
    assert.equal(await page.locator("font").count(), 0);
    assertQuiet(complaints);
  }, { complains: true, screens: BOTH });

  flow("is edited, translated again, and the edit undone", async (playground, { page, complaints }) => {
    await playground.says(OPENING);
    await translate(playground);
    await stroke(playground, "Obstacle", [9, 1]);
    await playground.says(/The scene has changed since this plan/);
    await translate(playground);
    await playground.press("Undo");
    await playground.says(OPENING);
    await playground.cellTells(9, 1, /^(?!obstacle)/);
    assert.equal(await page.getByRole("alertdialog").count(), 0);
    await translate(playground);
    await playground.press("Redo");
    await playground.says(/The scene has changed since this plan/);
    assertQuiet(complaints);
  }, { complains: true });

  flow("has no text beside the page's own once that has changed", async (playground, { complaints }) => {
    await playground.says(OPENING);
    await translateBeside(playground);
    await stroke(playground, "Obstacle", [9, 1]);
    await playground.says(/The scene has changed since this plan/);
    assert.doesNotMatch(await playground.page.locator(".status").innerText(), /makespan 18/);
    assertQuiet(complaints);
  }, { complains: true });

  flow("goes on in a lesson", async (playground, { page, complaints }) => {
    const course = new Course(playground);
    await course.open();
    await translate(playground);
    await course.contents.getByRole("button", { name: "Start: Two robots, one cell" }).click();
    await course.at("Robots take steps");
    await translate(playground);
    for (const title of ["Two in one cell", "Through each other", "Mend it"]) {
      // The second press of two at one place is not heeded.
      await course.next.press("Enter");
      await course.at(title);
      await translate(playground);
    }
    // The one text of the step before that Yew writes over.
    assert.equal(await course.next.innerText(), "Finish");
    await course.lesson.getByRole("button", { name: "Back" }).click();
    await course.at("Through each other");
    assert.equal(await course.next.innerText(), "Next");
    await translate(playground);
    await course.lesson.getByRole("button", { name: "Leave the lesson" }).click();
    await course.lesson.waitFor({ state: "detached" });
    await playground.shows("warehouse");
    await playground.says(OPENING);
    assert.equal(await page.getByRole("alertdialog").count(), 0);
    assertQuiet(complaints);
  }, { complains: true });
});
