// The editor of lessons, as a teacher finds it.

import { eventually } from "./wait.mjs";

/** Two robots that meet in a corridor with a way around. */
export const SCENE = {
  giveway: 1,
  name: "two ways",
  map: ["...", ".#.", "..."],
  agents: [{ name: "A1", start: [0, 0], goal: [2, 0] }, { name: "A2", start: [2, 2], goal: [0, 2] }],
};

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

/** Drops a file onto what is on top. */
export function drop(page, name, value) {
  return page.evaluate(([name, text]) => {
    const data = new DataTransfer();
    data.items.add(new File([text], name));
    const place = document.querySelector("dialog[open]") ?? document.body;
    for (const kind of ["dragover", "drop"]) {
      place.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
    }
  }, [name, typeof value === "string" ? value : JSON.stringify(value)]);
}

/** Fills all that the browser has room for. */
export function fill() {
  let text = "x".repeat(1 << 20);
  for (let part = 0; text.length > 0; part += 1) {
    try {
      localStorage.setItem(`full-${part}`, text);
    } catch {
      text = text.slice(0, text.length >> 1);
    }
  }
}
