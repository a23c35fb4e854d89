// Links to a lesson and to a step of it.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { Course } from "./course.mjs";
import { flows } from "./flow.mjs";

describe("a link to a lesson", () => {
  const flow = flows();

  flow("opens it, or a step of it, and tells in the address which one is open", async (playground, { page, host }) => {
    const course = new Course(playground);
    await page.evaluate(() => { location.hash = "lesson=two-robots-one-cell.2"; });
    await course.at("Two in one cell");
    await course.lesson.getByRole("button", { name: "Back" }).click();
    await course.at("Robots take steps");
    await page.waitForURL(`${host.url}#lesson=two-robots-one-cell.1`);
    // In a page that is loaded with it, too.
    await page.goto("about:blank");
    await playground.goto(`${host.url}#lesson=two-robots-one-cell.3`);
    await course.at("Through each other");
    // One that there is not opens the contents, which say so.
    for (const name of ["nobody-wrote-this", "Nonsense!!1"]) {
      await page.evaluate((name) => { location.hash = `lesson=${name}`; }, name);
      await course.contents.getByRole("alert").getByText(/There is no lesson named .* here/).waitFor();
      await page.keyboard.press("Escape");
      await course.contents.waitFor({ state: "detached" });
    }
    await page.evaluate(() => { location.hash = "lesson="; });
    await course.contents.waitFor();
    assert.equal(await course.contents.getByRole("alert").count(), 0, "nothing was asked for by name");
    await page.keyboard.press("Escape");
    await course.lesson.getByRole("button", { name: "Leave the lesson" }).click();
    await page.waitForURL(host.url);
  });
});
