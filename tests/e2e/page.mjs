// The playground as a person finds it: by roles and names, never by classes.

/** The page's places and the things a person does there. */
export class Playground {
  constructor(page) {
    this.page = page;
    this.board = page.getByRole("grid", { name: "Board" });
    this.status = page.getByRole("status");
    this.solveButton = page.getByRole("button", { name: "Solve", exact: true });
    this.cancelButton = page.getByRole("button", { name: "Cancel", exact: true });
    this.playButton = page.getByRole("button", { name: "Play", exact: true });
    this.pauseButton = page.getByRole("button", { name: "Pause", exact: true });
    this.time = page.getByRole("slider", { name: "Time" });
    this.plan = page.getByRole("table", { name: "Plan" });
    this.tools = page.getByRole("toolbar", { name: "Tools" });
  }

  /** Opens the address and waits until the application has taken the page over. */
  async goto(url) {
    await this.page.goto(url);
    await this.board.waitFor();
  }

  async reload() {
    await this.page.reload();
    await this.board.waitFor();
  }

  /** Waits until the page is kept for times without a network. */
  async kept() {
    await this.page.evaluate(() => navigator.serviceWorker.ready.then(() => undefined));
    await this.page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  }
}
