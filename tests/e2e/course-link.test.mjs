// Links to a lesson and to a step of it.

import { describe } from "node:test";

import { Course } from "./course.mjs";
import { flows } from "./flow.mjs";

describe("a link to a lesson", () => {
  const flow = flows();

  flow("opens it, or a step of it, and is gone from the address then", async (playground, { page, host }) => {
    const course = new Course(playground);
    await page.evaluate(() => { location.hash = "lesson=two-robots-one-cell.2"; });
    await course.at("Two in one cell");
    await page.waitForURL(host.url);
    // In a page that is loaded with it, too.
    await page.goto("about:blank");
    await playground.goto(`${host.url}#lesson=two-robots-one-cell.1`);
    await course.at("Robots take steps");
    // One that there is not opens the contents.
    await page.evaluate(() => { location.hash = "lesson=nobody-wrote-this"; });
    await course.contents.waitFor();
  });
});
