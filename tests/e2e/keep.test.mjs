// Nothing is lost: the page comes back after a reload, scenes are kept by name, and a link
// holds the scene with its plan.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const OPENING = /^Optimal: makespan 18/;
const WITH_TIME = { reducedMotion: "reduce" };

describe("what is kept", () => {
  const flow = flows();

  flow("comes back after a reload: scene, plan, time, settings", async (playground) => {
    await playground.says(OPENING);
    await playground.pick("Obstacle");
    await playground.stroke([0, 1]);
    await playground.press("Solve");
    await playground.says(/^Optimal: makespan 23/);
    await playground.pause();
    await playground.press("To start");
    await playground.press("Step forward");
    await playground.reaches(1);
    await playground.reload();
    await playground.says(/^Optimal: makespan 23, sum of costs 40, 3 charges\.$/);
    await playground.reaches(1);
    await playground.cellTells(0, 1, /^obstacle/);
    await playground.picture("restored");
    // An edit right before leaving, too.
    await playground.pick("Obstacle");
    await playground.stroke([9, 1]);
    await playground.cellTells(9, 1, /^obstacle/);
    await playground.reload();
    await playground.cellTells(9, 1, /^obstacle/);
    await playground.says(/^The scene has changed since this plan/);
  }, WITH_TIME);

  flow("keeps the theme", async (playground) => {
    const scheme = () => playground.page.evaluate(() => document.documentElement.dataset.theme);
    await playground.press("Theme");
    assert.equal(await scheme(), "dark");
    await playground.reload();
    await eventually("the dark theme", scheme, (theme) => theme === "dark");
  }, { screens: ["desktop"] });

  flow("keeps scenes by name, opens and forgets them", async (playground, { page }) => {
    await playground.says(OPENING);
    await playground.example("No way past");
    await playground.shows("scenario 6");
    await scenes(playground);
    const dialog = page.getByRole("dialog", { name: "Scenes" });
    await playground.picture("scenes-empty");
    await dialog.getByRole("button", { name: /^Keep/ }).click();
    await dialog.getByRole("button", { name: "scenario 6", exact: true }).waitFor();
    await dialog.getByRole("button", { name: "Restore the example" }).click();
    await playground.shows("warehouse");
    await playground.press("Undo");
    await playground.shows("scenario 6");
    await playground.press("Redo");
    await playground.shows("warehouse");
    await playground.reload();
    await scenes(playground);
    await dialog.getByRole("button", { name: /^Keep/ }).click();
    await dialog.getByRole("button", { name: "warehouse", exact: true }).waitFor();
    await playground.picture("scenes");
    await dialog.getByRole("button", { name: "scenario 6", exact: true }).click();
    await playground.shows("scenario 6");
    await scenes(playground);
    await dialog.getByRole("button", { name: "Forget scenario 6" }).click();
    await dialog.getByRole("button", { name: "scenario 6", exact: true }).waitFor({ state: "detached" });
  }, { screens: BOTH });
});

describe("links", () => {
  const flow = flows();

  flow("hold the scene, its plan and the time", async (playground, { context, host, page }) => {
    await playground.says(OPENING);
    await playground.pause();
    await playground.press("To start");
    await playground.press("Step forward");
    await playground.reaches(1);
    await playground.act("Share");
    const dialog = page.getByRole("dialog", { name: "Share" });
    const link = await dialog.getByLabel("Link").inputValue();
    assert.ok(link.startsWith(`${host.url}#giveway=1&`), link);
    assert.ok(link.length < 500, `it has ${link.length} characters`);
    await playground.picture("share");
    await playground.key("Escape");
    await playground.example("No way past");
    await playground.shows("scenario 6");

    await page.evaluate((link) => {
      location.href = link;
    }, link);
    await playground.shows("warehouse");
    // So small a scene is solved at once.
    await playground.says(/^Optimal: makespan 18, sum of costs 35, 3 charges\.$/);
    await playground.reaches(1);
    await playground.picture("linked");
    assert.equal(await page.evaluate(() => location.hash), "", "a reload would open it again");
    await playground.press("Undo");
    await playground.shows("scenario 6");

    // What the other tab begins with is what this one has kept once it was calm: the first name is that of the scene
    // that is shown, those behind it are of its past.
    await eventually("the scene to be kept", () => playground.keeps(), (text) => /=name=(\S*)/.exec(text)?.[1].startsWith("scenario"));
    const other = await context.newPage();
    await other.goto(link);
    await other.getByRole("heading", { level: 1, name: "warehouse" }).waitFor();
    await eventually("the address without the link", () => other.evaluate(() => location.hash), (hash) => hash === "");
    await other.getByRole("button", { name: "Undo", exact: true }).click();
    await other.getByRole("heading", { level: 1, name: "scenario 6" }).waitFor();
    await other.close();
  }, { screens: BOTH, ...WITH_TIME });

  flow("hold the question, which is asked again", async (playground, { context, page }) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4/);
    // The questions go with the time shown.
    await playground.reaches(4);
    await playground.press("To start");
    await playground.reaches(0);
    await playground.showTab("Inspector");
    await playground.inspector.getByRole("button", { name: /^A2\b/ }).first().click();
    await playground.inspector.getByRole("button", { name: /^Why does A2 wait at \(3, 1\)\?/ }).first().click();
    await playground.button("Show the other plan").waitFor();
    await playground.act("Share");
    const link = await page.getByRole("dialog", { name: "Share" }).getByLabel("Link").inputValue();
    assert.match(link, /&ask=wait;A2!at\.3\.1/);
    const other = await context.newPage();
    await other.goto(link);
    await other.getByRole("heading", { level: 1, name: /^scenario 1/ }).waitFor();
    await other.getByRole("button", { name: "Show the other plan", exact: true }).waitFor();
    await other.screenshot({ path: playground.pathOf("linked-question") });
    await other.close();
  });

  flow("about what has no plan solve it first, and then ask why", async (playground, { host, page }) => {
    await playground.example("No way past");
    await playground.says(/^No plan exists, no matter how many steps you allow/);
    await playground.showTab("Inspector");
    await playground.inspector.getByRole("button", { name: /^Why is there no plan\?/ }).first().click();
    await playground.inspector.getByRole("heading", { name: "What would help" }).waitFor();
    await playground.act("Share");
    const link = await page.getByRole("dialog", { name: "Share" }).getByLabel("Link").inputValue();
    await page.goto("about:blank");
    await page.goto(link);
    await playground.inspector.getByRole("heading", { name: "What would help" }).waitFor();
    assert.ok(link.startsWith(`${host.url}#`));
  }, { screens: ["desktop"] });

  for (const [what, hash, told] of [
    ["another version", "giveway=2&map=1.f", /version 2; this page reads version 1/],
    ["a version that is markup", "giveway=<script>alert(1)</script>&map=1.f", /version %3Cscript/],
    ["a map of many cells", "giveway=1&map=256.9999999999f&rules=0.0&costs=0&agents=", /broken/],
    ["a ragged map", "giveway=1&map=5.7f&rules=0.0&costs=0&agents=", /cannot be drawn/],
    ["an encoded beginning", "giveway%3D1%26map%3D3.3f", /This link was cut/],
    ["half of it", "giveway=1&check=62.00000000&map=3.3f&name=x", /This link was cut: 15 of its 62 characters arrived/],
    ["its first letters", "giv", /This link was cut/],
    ["a changed letter", "giveway=1&check=7.c549acf1&map=2.f", /changed or cut on its way/],
    ["a plan through a wall", "giveway=1&map=3.fof&rules=0.0&costs=0&agents=A.0.0.2.0&plan=2r", /breaks a rule/],
  ]) {
    flow(`with ${what} are refused, and the scene stays`, async (playground, { page }) => {
      await playground.says(OPENING);
      await page.evaluate((hash) => {
        location.hash = hash;
      }, hash);
      await playground.warns(/The link cannot be opened/);
      await playground.warns(told);
      await playground.shows("warehouse");
      await playground.says(OPENING);
    }, { screens: ["desktop"] });
  }

  flow("with a program in their names show it as text", async (playground, { page }) => {
    await playground.says(OPENING);
    const name = encodeURIComponent("<img src=x onerror=alert(1)>");
    await page.evaluate((name) => {
      location.hash = `giveway=1&map=3.3f&name=${name}&rules=0.0&costs=0&agents=${name}.0.0.2.0`;
    }, name);
    await playground.shows("<img src=x onerror=alert(1)>");
    await playground.cellTells(0, 0, /start of <img src=x onerror=alert\(1\)>/);
  }, { screens: ["desktop"] });
});

function scenes(playground) {
  return playground.sceneName.getByRole("button").click();
}
