// The editor of lessons, as a teacher finds it.

import { eventually } from "./wait.mjs";

/** What a teacher does in the editor. */
export class Author {
  constructor(playground) {
    const { page } = playground;
    this.playground = playground;
    this.page = page;
    this.desk = page.getByRole("dialog", { name: "Write a lesson" });
    this.preview = this.desk.getByRole("region", { name: "As the learner sees it" });
    this.steps = this.desk.getByRole("navigation", { name: "Steps" });
    this.refused = page.getByRole("dialog", { name: "This lesson cannot be opened" });
  }

  /** Opens it from the contents of the course. */
  async open(course) {
    await course.open();
    await course.contents.getByRole("button", { name: "Write your own" }).click();
    await this.desk.waitFor();
  }

  /** The field of this name. */
  field(name) {
    return this.desk.getByLabel(name, { exact: true }).and(this.desk.locator("input, textarea, select"));
  }

  fill(name, text) {
    return this.field(name).fill(text);
  }

  choose(name, label) {
    return this.field(name).selectOption({ label });
  }

  press(name) {
    return this.desk.getByRole("button", { name, exact: true }).click();
  }

  /** Waits until the foot says something. */
  says(pattern) {
    return eventually(`the editor to say ${pattern}`, () => this.desk.locator("footer").getByRole("status").innerText(), (text) => pattern.test(text));
  }

  /** Waits until something is written in the editor. */
  tells(pattern) {
    return eventually(`the editor to tell ${pattern}`, () => this.desk.innerText(), (text) => pattern.test(text.replaceAll(/\s+/g, " ")));
  }

  /** The link that was copied. */
  async copied() {
    await this.says(/^Link copied\./);
    return this.page.evaluate(() => navigator.clipboard.readText());
  }
}
