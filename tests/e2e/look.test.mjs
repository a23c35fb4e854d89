// What the page looks like: themes, sizes, dialogs; pictures are left in target/e2e.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe } from "node:test";

import { root } from "./dist.mjs";
import { BOTH, flows, LOOKS } from "./flow.mjs";
import { Playground } from "./page.mjs";
import { lead, rows, steps } from "./steer.mjs";

const OPENING = /^Optimal: makespan 18/;
const EXAMPLES = JSON.parse(readFileSync(join(root, "static/examples/index.json"), "utf8"));

describe("the look", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`follows a ${theme} system, until another theme is chosen`, async (playground) => {
      await playground.says(OPENING);
      await playground.pause();
      const system = await isDark(playground);
      assert.equal(system, theme === "dark");
      await playground.picture(`theme-${theme}`);
      await turnTheme(playground);
      assert.equal(await isDark(playground), !system, "the first press changes what is seen");
      await turnTheme(playground);
      assert.equal(await isDark(playground), system);
      await playground.page.emulateMedia({ colorScheme: theme === "dark" ? "light" : "dark" });
      assert.equal(await isDark(playground), system, "what was chosen stays");
      await turnTheme(playground);
      assert.equal(await isDark(playground), !system, "the system decides again");
    }, { theme, screens });

    flow(`shows its dialogs, ${theme}`, async (playground) => {
      await playground.act("Examples");
      const dialog = playground.page.getByRole("dialog", { name: "Examples" });
      await dialog.getByRole("listitem").nth(EXAMPLES.length - 1).waitFor();
      for (const { title } of EXAMPLES) {
        await Playground.pick(dialog, title).waitFor();
      }
      await playground.picture(`examples-${theme}`);
      await playground.key("Escape");
      await dialog.waitFor({ state: "detached" });
      await playground.key("?");
      await playground.page.getByRole("dialog", { name: "Keys" }).waitFor();
      await playground.picture(`keys-${theme}`);
      await playground.key("Escape");
      await playground.act(playground.isPhone() ? "Settings" : "Save");
      await playground.picture(`menu-${theme}`);
    }, { theme, screens });
  }

  for (const { theme, screens } of LOOKS) {
    flow(`shows an agent that is led by hand into another, ${theme}`, async (playground) => {
      await rows(playground);
      await lead(playground, "A1", 0, 0);
      await playground.picture(`steering-${theme}`);
      await steps(playground, "Down", "Right");
      await playground.says(/both at \(1, 1\)/);
      await playground.picture(`steering-collision-${theme}`);
      await playground.press("Check my plan");
      await playground.inspector.getByRole("heading", { name: "What is against the rules" }).waitFor();
      await playground.picture(`steering-checked-${theme}`);
    }, { theme, screens, reducedMotion: "reduce" });
  }

  // docs/playground.png is a copy of this picture.
  flow("shows a robot that charges while another is in the slow zone", async (playground) => {
    await playground.says(OPENING);
    await playground.pause();
    await playground.time.focus();
    await playground.key("Home", ...Array(9).fill("ArrowRight"));
    await playground.reaches(9);
    await playground.cellTells(6, 2, /^charger, A1 is here$/);
    await playground.page.evaluate(() => document.activeElement.blur());
    await playground.picture("readme");
  }, { screens: ["desktop"], reducedMotion: "reduce" });

  flow("opens every example", async (playground) => {
    for (const { title, file } of EXAMPLES) {
      await playground.example(title);
      const { name } = JSON.parse(readFileSync(join(root, "static/examples", file), "utf8"));
      await playground.shows(name);
      await playground.says(/^(Solving|Optimal|No plan exists)/);
      await playground.picture(`example-${file.replace(".json", "")}`);
    }
  });

  for (const width of [320, 390, 600, 721, 768, 1024, 1280, 1920, 2560]) {
    flow(`fits into ${width} pixels`, async (playground) => {
      await playground.says(OPENING);
      await playground.pause();
      const wide = await playground.page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(wide <= width, `it is ${wide} pixels wide`);
      await playground.board.waitFor();
      await playground.button("Solve").waitFor();
      await playground.picture(`width-${width}`);
    }, { screens: ["desktop"], width, height: width < 700 ? 844 : Math.max(768, Math.min(1440, width * 0.625)) });
  }

  flow("gives everything that can be pressed a name", async (playground, { context, page }) => {
    await playground.says(OPENING);
    const session = await context.newCDPSession(page);
    const { nodes } = await session.send("Accessibility.getFullAXTree");
    const roles = ["button", "slider", "textbox", "checkbox", "switch", "tab", "grid", "table", "dialog", "toolbar", "complementary", "link"];
    const seen = nodes.filter((node) => !node.ignored && roles.includes(node.role?.value));
    assert.ok(seen.length > 20, `found ${seen.length} of them`);
    assert.deepEqual(seen.filter((node) => !node.name?.value?.trim()), [], "without a name");
  }, { screens: BOTH });
});

async function turnTheme(playground) {
  if (playground.isPhone()) {
    await playground.press("More");
    await playground.page.getByRole("button", { name: /^Theme: / }).click();
    // The menu of a phone stays open while the theme is chosen.
    await playground.key("Escape");
  } else {
    await playground.press("Theme");
  }
}

function isDark(playground) {
  return playground.page.evaluate(() => {
    const [red] = getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number);
    return red < 128;
  });
}
