// The tour as a person finds it: a card that points at a thing of the page.

import assert from "node:assert/strict";

import { eventually } from "./wait.mjs";

/** What a person does with the tour. */
export class Tour {
  /** What its steps are called. */
  static TITLES = [
    "Play the plan", "Click a robot that waits", "Ask why it waits", "Change the scene", "Solve it again", "Add a rule",
    "Go on with the course",
  ];

  constructor(playground) {
    const { page } = playground;
    this.playground = playground;
    this.page = page;
    this.card = page.getByRole("dialog").filter({ has: page.getByRole("button", { name: "End tour" }) });
  }

  /** Begins it by way of the help. */
  async fromHelp() {
    await this.playground.act("Help");
    await this.page.getByRole("dialog", { name: "Keys" }).getByRole("button", { name: "Take the tour" }).click();
    await this.card.waitFor();
  }

  /** Waits for a step, by its title. */
  at(title) {
    return this.card.getByRole("heading", { name: title, exact: true }).waitFor();
  }

  press(name) {
    return this.card.getByRole("button", { name, exact: true }).click();
  }

  isOver() {
    return this.card.waitFor({ state: "detached" });
  }

  hasFocus() {
    return this.card.evaluate((card) => card === document.activeElement);
  }

  /** Waits until the ring is around a thing, and the card beside it and on the screen. */
  async pointsAt(thing) {
    const ring = this.page.locator(".coach-ring");
    const [, card, at] = await eventually(`the ring around ${thing}`, () => Promise.all([ring, this.card, thing].map((it) => it.boundingBox())), ([ring, , at]) => ring && at
      && Math.abs(ring.x + ring.width / 2 - at.x - at.width / 2) < 3
      && Math.abs(ring.y + ring.height / 2 - at.y - at.height / 2) < 3
      && ring.width >= at.width - 2);
    const isApart = card.x >= at.x + at.width || at.x >= card.x + card.width || card.y >= at.y + at.height || at.y >= card.y + card.height;
    assert.ok(isApart, "the card covers what it points at");
    const { width, height } = this.page.viewportSize();
    if (width <= 720 && width < height) {
      const board = await this.playground.board.boundingBox();
      assert.ok(card.y >= board.y + board.height, "the card covers the board");
    }
    assert.ok(card.x >= 0 && card.y >= 0 && card.x + card.width <= width && card.y + card.height <= height, "the card is not on the screen");
  }
}
