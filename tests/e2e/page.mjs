// The playground as a person finds it: by roles and names, never by classes.

import assert from "node:assert/strict";

import { eventually } from "./wait.mjs";

/** The page's places and the things a person does there. */
export class Playground {
  /**
   * @param page of the browser
   * @param pathOf where the picture of a title goes
   */
  constructor(page, pathOf) {
    this.page = page;
    this.pathOf = pathOf;
    this.board = page.getByRole("grid", { name: "Board" });
    this.other = page.getByRole("grid", { name: "Other plan" });
    this.sceneName = page.getByRole("heading", { level: 1 });
    // Before and after the slot, which has both roles, too.
    this.status = page.getByRole("status").first();
    this.notice = page.locator(".notices");
    this.slot = page.locator("main").getByRole("status").or(page.locator("main").getByRole("alert"));
    this.time = page.getByRole("slider", { name: "Time" });
    this.plan = page.getByRole("table", { name: "Plan" });
    this.tools = page.getByRole("toolbar", { name: "Tools" });
    this.inspector = page.getByRole("complementary", { name: "Inspector" });
    this.settings = page.getByRole("group", { name: "Settings" });
  }

  /** Opens the address and waits until the application has taken the page over. */
  async goto(url) {
    await this.page.goto(url);
    await this.#isThere();
  }

  async reload() {
    await this.page.reload();
    await this.#isThere();
  }

  /** Waits for the board, whatever its name is in the language of the page. */
  #isThere() {
    return this.page.getByRole("grid").first().waitFor();
  }

  /** Waits until the page is kept for times without a network. */
  async kept() {
    await this.page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
    await this.page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  }

  /** How often the page was built anew since it was opened, because something else had changed its elements. */
  rebuilt() {
    return this.page.evaluate(() => performance.getEntriesByName("giveway-foreign").length);
  }

  /** Leaves a picture of the page as it is. */
  picture(title) {
    return this.page.screenshot({ path: this.pathOf(title) });
  }

  button(name) {
    return this.page.getByRole("button", { name, exact: true });
  }

  /** Waits until nothing more of an answer is looked for. */
  async answered() {
    await this.inspector.getByRole("button", { name: "Cancel", exact: true }).waitFor({ state: "detached", timeout: 60_000 });
  }

  /** Presses the button of this name. */
  press(name) {
    return this.button(name).click();
  }

  /** Presses a key where the focus is. */
  key(...keys) {
    return keys.reduce((before, key) => before.then(() => this.page.keyboard.press(key)), Promise.resolve());
  }

  /** What solves the scene: it goes on where a search was cut off. */
  get solver() {
    return this.page.getByRole("button", { name: /^(Solve|Go on)$/ });
  }

  /** Waits for a sentence of the status, and gives it. */
  says(pattern) {
    return eventually(`the status to say ${pattern}`, () => this.status.textContent(), (text) => pattern.test(text));
  }

  /** Waits for a sentence in the notice, and gives all of it. */
  warns(pattern) {
    return eventually(`a notice of ${pattern}`, () => this.notice.innerText(), (text) => pattern.test(text));
  }

  /** Waits until the scene of this name is on the board. */
  shows(name) {
    return eventually(`the scene ${name}`, () => this.sceneName.innerText(), (text) => text.startsWith(name));
  }

  /** Waits for a sentence in the slot, and gives all of it. */
  tells(pattern) {
    return eventually(`the slot to tell ${pattern}`, async () => (await this.slot.allInnerTexts()).join(""), (text) => pattern.test(text));
  }

  /** Leaves the page, and this in the place of what it keeps then; comes back. */
  async reloadOn(text, more = {}) {
    await this.page.evaluate(([text, more]) => {
      // Leaving the page would write over it: first as it goes, then as it is hidden.
      const plant = () => {
        localStorage.setItem(`giveway.tab.${sessionStorage.getItem("giveway.tab")}`, text);
        Object.entries(more).forEach(([name, text]) => localStorage.setItem(name, text));
      };
      addEventListener("pagehide", plant);
      document.addEventListener("visibilitychange", plant);
    }, [text, more]);
    await this.reload();
  }

  /** What this browser keeps for the tab that kept something last. */
  keeps() {
    return this.page.evaluate(() => {
      const [last] = (localStorage.getItem("giveway.tabs") ?? "").split(" ");
      return localStorage.getItem(`giveway.tab.${last}`) ?? "";
    });
  }

  /** The time shown, in steps. */
  async now() {
    return Number(await this.time.getAttribute("aria-valuenow"));
  }

  /** Waits until this time is shown, or one that is accepted. */
  reaches(time, accept = (now) => now === time) {
    return eventually(`time ${time}`, () => this.now(), accept);
  }

  /** Stops playing, and gives the time where it stands still. */
  async pause() {
    await this.press("Pause");
    await this.button("Play").waitFor();
    // It goes on to the end of its step.
    let before = -1;
    return eventually("the time to stand still", () => this.#afterFrames(), (now) => {
      const stands = now === before;
      before = now;
      return stands;
    });
  }

  async #afterFrames() {
    await this.page.evaluate(() => new Promise((resolve) => {
      requestAnimationFrame(() => requestAnimationFrame(resolve));
    }));
    return this.now();
  }

  /** A cell of the board, by column and row; or of another grid. */
  cell(x, y, grid = this.board) {
    return grid.getByRole("gridcell", { name: new RegExp(`^${x}, ${y}: `) });
  }

  /** What is on a cell, in words. */
  async onCell(x, y, grid) {
    const name = await this.cell(x, y, grid).getAttribute("aria-label");
    return name.slice(name.indexOf(": ") + 2);
  }

  /** Waits until a cell tells this of itself. */
  cellTells(x, y, pattern, grid) {
    return eventually(`cell ${x}, ${y} to be ${pattern}`, () => this.onCell(x, y, grid), (words) => pattern.test(words));
  }

  /** The middle of a cell on the screen, in pixels. */
  async middleOf(x, y) {
    // While the page is built anew the cell is not there for a moment.
    const cell = this.cell(x, y);
    const box = await eventually(`cell ${x}, ${y} to have a place`, () => cell.boundingBox(), (box) => box !== null);
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  }

  /** The page as a whole never scrolls: a stroke or a focus could move it away from its window. */
  async fits() {
    const [found, window] = await this.page.evaluate(() => [document.documentElement.scrollHeight, innerHeight]);
    assert.ok(found <= window, `the page is ${found} high, its window ${window}`);
  }

  /** Picks a tool. */
  pick(tool) {
    return this.tools.getByRole("button", { name: tool, exact: true }).click();
  }

  /** Draws with the mouse through the middles of cells, in one stroke. */
  async stroke(...cells) {
    const [first, ...rest] = await Promise.all(cells.map(([x, y]) => this.middleOf(x, y)));
    const { mouse } = this.page;
    await mouse.move(first.x, first.y);
    await mouse.down();
    for (const { x, y } of rest) {
      await mouse.move(x, y, { steps: 4 });
    }
    await mouse.up();
  }

  /** The rows of the plan table: its cells' texts, the name first. */
  async planRows() {
    await this.showTab("Plan");
    const rows = this.plan.getByRole("row");
    const texts = await rows.evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.innerText.trim())));
    await this.showTab("Timeline");
    return texts;
  }

  /** Whether the page has the form of a phone. */
  isPhone() {
    const { width, height } = this.page.viewportSize();
    return width <= 720 || height <= 480;
  }

  /** Shows one of the places that a phone has in turn. */
  async showTab(name) {
    if (this.isPhone()) {
      await this.page.getByRole("tab", { name, exact: true }).click();
    }
  }

  /** Presses what is in the top bar, or in the menu of a phone. */
  async act(name) {
    if (this.isPhone()) {
      await this.press("More");
    }
    await this.press(name);
  }

  async openSettings() {
    if (this.isPhone()) {
      await this.act("Settings");
    } else {
      await this.page.getByRole("button", { name: /^Settings: / }).click();
    }
    await this.settings.waitFor();
  }

  async closeSettings() {
    await this.settings.getByRole("button", { name: "Close", exact: true }).click();
    await this.settings.waitFor({ state: "detached" });
  }

  /** Types a number into a field of the settings. */
  async set(label, value) {
    const field = this.settings.getByLabel(label, { exact: true });
    await field.fill(String(value));
    await field.press("Tab");
  }

  /** Chooses files in the dialog of `Open`: paths, or names with their bytes. */
  async open(...files) {
    const chooser = this.page.waitForEvent("filechooser");
    await this.act("Open");
    if (!this.isPhone()) {
      await this.press("Choose a file");
    }
    const chosen = files.map((file) => typeof file === "string"
      ? file
      : { name: file.name, mimeType: "application/octet-stream", buffer: Buffer.from(file.bytes) });
    const before = await this.#seen();
    await (await chooser).setFiles(chosen);
    await this.#taken(before);
  }

  /** Scene, status and what the page has to say, in a text. */
  async #seen() {
    const [name, status, said] = await Promise.all([
      this.sceneName.innerText(), this.status.innerText(), this.page.getByRole("alert").allInnerTexts(),
    ]);
    return [name, status, ...said].join("\n");
  }

  /** Waits until a file has come to something: a worker reads it. The same scene again looks as before. */
  async #taken(before) {
    for (let tries = 0; tries < 40; tries += 1) {
      const now = await this.#seen();
      if (now !== before && !/Reading/.test(now)) {
        return;
      }
      await this.page.waitForTimeout(50);
    }
  }

  /** The button of an example in the dialog: other lines may hold its title, too. */
  static pick(dialog, title) {
    const heading = dialog.page().getByText(title, { exact: true });
    return dialog.getByRole("button").filter({ has: heading });
  }

  /** Opens an example by its title; it is solved at once. The scene before it has gone then. */
  async example(title) {
    const before = await this.#name();
    await this.act("Examples");
    const dialog = this.page.getByRole("dialog", { name: "Examples" });
    await Playground.pick(dialog, title).click();
    await dialog.waitFor({ state: "detached" });
    // The same one again, and one that does not arrive, leave the name as it is.
    for (let tries = 0; tries < 60 && await this.#name() === before; tries += 1) {
      await this.page.waitForTimeout(50);
    }
  }

  /** The name of the scene. */
  #name() {
    return this.page.evaluate(() => document.querySelector("h1.scene")?.textContent);
  }
}
