// What a person does in a browser that only knows WebDriver: finds things by role and name,
// and uses a mouse and keys. A small relative of `Playground` (page.mjs).

import { eventually } from "../wait.mjs";

/** Keys that are no letters, as WebDriver writes them. */
const KEYS = { Escape: "\uE00C", Enter: "\uE007" };

export class Person {
  /** @param window of a browser */
  constructor(window) {
    this.window = window;
  }

  /** Opens the page, and waits until the application has taken it over. */
  async goto(url) {
    await this.window.goto(url);
    await this.find("grid", /^Board$/);
  }

  async reload() {
    await this.window.reload();
    await this.find("grid", /^Board$/);
  }

  /** Waits for what has this role and a name that matches; gives its middle and its attributes. */
  find(role, pattern) {
    return eventually(`the ${role} ${pattern}`, () => this.window.run(find, role, pattern.source));
  }

  /** Clicks on what has this role and name. */
  async press(role, pattern) {
    await this.#mouse([await this.find(role, pattern)]);
  }

  /** Draws through the middles of cells, in one stroke. */
  async stroke(...cells) {
    const at = [];
    for (const cell of cells) {
      at.push(await this.cell(cell));
    }
    await this.#mouse(at);
  }

  cell([x, y]) {
    return this.find("gridcell", new RegExp(`^${x}, ${y}: `));
  }

  /** Waits until a cell tells this of itself. */
  async cellTells(cell, pattern) {
    await eventually(`cell ${cell} to be ${pattern}`, () => this.cell(cell), ({ name }) => pattern.test(name));
  }

  /** Waits for a sentence of the status. */
  says(pattern) {
    return eventually(`the status to say ${pattern}`, () => this.window.run(
      () => [...document.querySelectorAll("[role=status]")].map((it) => it.textContent).join(" "),
    ), (text) => pattern.test(text));
  }

  /** The time shown, in steps. */
  async now() {
    const { now } = await this.find("slider", /^Time$/);
    return Number(now);
  }

  async key(name) {
    const value = KEYS[name] ?? name;
    await this.window.input([{
      type: "key",
      id: "keyboard",
      actions: [{ type: "keyDown", value }, { type: "keyUp", value }],
    }]);
  }

  async #mouse([first, ...rest]) {
    const move = ({ x, y }) => ({ type: "pointerMove", x, y, duration: 60, origin: "viewport" });
    await this.window.input([{
      type: "pointer",
      id: "mouse",
      parameters: { pointerType: "mouse" },
      actions: [
        { ...move(first), duration: 0 },
        { type: "pointerDown", button: 0 },
        ...rest.map(move),
        { type: "pointerUp", button: 0 },
      ],
    }]);
  }
}

/** Runs in the page: what is seen there with this role and a name that matches. */
function find(role, source) {
  const own = { button: "button, ", tab: "", grid: "", gridcell: "", slider: "", heading: "h1, h2, h3, " };
  const pattern = new RegExp(source);
  for (const element of document.querySelectorAll(`${own[role] ?? ""}[role=${role}]`)) {
    const name = (element.getAttribute("aria-label") ?? element.textContent).trim();
    if (pattern.test(name) && element.getClientRects().length > 0 && !element.disabled) {
      element.scrollIntoView({ block: "nearest" });
      const { left, right, top, bottom } = element.getBoundingClientRect();
      return {
        name,
        x: Math.round((left + right) / 2),
        y: Math.round((top + bottom) / 2),
        now: element.getAttribute("aria-valuenow"),
      };
    }
  }
  return undefined;
}
