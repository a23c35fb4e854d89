// The course as a person finds it: its contents, the lesson that is open.

import { eventually } from "./wait.mjs";

/** What a person does with the course. */
export class Course {
  constructor(playground) {
    const { page } = playground;
    this.playground = playground;
    this.page = page;
    this.contents = page.getByRole("dialog", { name: "Course" });
    this.lesson = page.getByRole("complementary", { name: "Lesson" });
    this.next = this.lesson.getByRole("button", { name: /^(Next|Finish)$/ });
  }

  /** Opens the contents. */
  async open() {
    await this.playground.act("Course");
    await this.contents.getByRole("heading", { name: "Why", exact: true }).waitFor();
  }

  /** Waits for a step, by its title. */
  async at(title) {
    await this.lesson.getByRole("heading", { name: title, level: 2 }).waitFor();
  }

  /** Waits until the lesson says something, and gives all of it. */
  says(pattern) {
    return eventually(`the lesson to say ${pattern}`, async () => (await this.lesson.innerText()).replaceAll(/\s+/g, " "), (text) => pattern.test(text));
  }

  /** Waits until a task is solved, and the focus is on the way on. */
  async solved() {
    await this.says(/\bSolved\b/);
    await eventually("the focus on the way on", () => this.focused(), (name) => /^(Next|Finish)$/.test(name));
  }

  /** The words of what has the focus. */
  focused() {
    return this.page.evaluate(() => document.activeElement?.textContent?.trim() ?? "");
  }

  /** Goes to a control with the Tab key alone. */
  async tabTo(pattern) {
    for (let press = 0; press < 80; press += 1) {
      if (pattern.test(await this.focused())) {
        return;
      }
      await this.page.keyboard.press("Tab");
    }
    throw new Error(`no Tab comes to ${pattern}`);
  }
}
