// Every state of the page on every kind of screen, light and dark, in a narrow and in a
// wide font: nothing lies over anything else, nothing is cut off, nothing is too small.
// Pictures of all of it are left in target/e2e/geometry, to be looked at.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { describe } from "node:test";

import { adapt, begin, join as joins, running } from "./change.mjs";
import { Course } from "./course.mjs";
import { root } from "./dist.mjs";
import { flows, isLong } from "./flow.mjs";
import { geometry } from "./geometry.mjs";
import { PILLARS, look } from "./inside.mjs";
import { choose } from "./language.mjs";
import { lead, rows, steps } from "./steer.mjs";

const PICTURES = join(root, "target/e2e/geometry");
mkdirSync(PICTURES, { recursive: true });

const OPENING = /^Optimal: makespan 18/;

const SCREENS = [[390, 664], [390, 844], [844, 390], [768, 1024], [1280, 720], [1440, 900], [2560, 1440]];

/** Narrower and wider than what any system has: of the same letters everywhere. */
const FONTS = [
  { name: "own", family: "", spacing: "" },
  { name: "narrow", family: "", spacing: "-0.4px" },
  { name: "wide", family: '"DejaVu Sans", system-ui, sans-serif', spacing: "0.6px" },
];

/** Themes move nothing but colours: each screen is looked at in both, each font on it in one, but for the long run. */
const THEMES = ["light", "dark"];

/** The form that is made for fingers: as in the style sheets. */
const isTouch = ([width, height]) => width <= 720 || height <= 480;

describe("the geometry", () => {
  const flow = flows();

  /** Prepares a state once, then looks at it on all screens. */
  const state = (name, prepare, { tabs = ["Inspector"], screens = SCREENS } = {}) => {
    flow(`of ${name}`, async (playground) => {
      await playground.says(/^(Optimal|Solving)/);
      await prepare(playground);
      assert.deepEqual(await everywhere(playground, name, tabs, screens), []);
    }, { screens: ["desktop"], reducedMotion: "reduce" });
  };

  state("a plan", opening, { tabs: ["Inspector", "Timeline", "Plan"] });
  state("an agent selected", async (playground) => {
    await opening(playground);
    await playground.inspector.getByRole("button", { name: /^A1\b/ }).first().click();
  }, { tabs: ["Inspector", "Timeline"] });
  state("a cell selected", async (playground) => {
    await opening(playground);
    await playground.stroke([0, 1]);
    await playground.inspector.getByRole("heading", { name: /0, 1/ }).first().waitFor();
  });
  state("editing", async (playground) => {
    await opening(playground);
    await playground.pick("Obstacle");
    await playground.stroke([0, 1]);
    await playground.says(/^The scene has changed since this plan/);
  });
  state("problems", async (playground) => {
    await playground.open(scene("walled in", ["..#.", "..#.", "..#."], { goal: [3, 2], battery: { capacity: 2, initial: 1 } }));
    await playground.shows("walled in");
  });
  state("solving", async (playground) => {
    await playground.example("Thirty robots");
    await playground.button("Cancel").waitFor();
  });
  state("no plan", none);
  state("a stopped search", async (playground) => {
    await playground.openSettings();
    await playground.set("Time limit, s", 1);
    await playground.closeSettings();
    await playground.example("Thirty robots");
    await playground.button("Go on").waitFor();
  }, { tabs: ["Timeline"] });
  state("what must be so", async (playground) => {
    await opening(playground);
    await playground.board.focus();
    await playground.key("m");
    await playground.inspector.getByText(/^This plan|^In it robots are elsewhere/).waitFor();
  }, { tabs: ["Inspector", "Timeline"] });
  state("another plan as good", async (playground) => {
    await opening(playground);
    await playground.board.focus();
    await playground.key("m");
    await playground.press("Show it beside this one");
    await playground.other.waitFor();
  }, { tabs: ["Inspector"] });
  state("a cell that is closed", async (playground) => {
    await opening(playground);
    await playground.board.focus();
    await playground.key("m");
    await playground.inspector.getByRole("button", { name: /^Close .*makespan/ }).first().click();
    await playground.says(/^Optimal: makespan (?!18)/);
  }, { tabs: ["Inspector"] });
  state("rules and their prices", async (playground) => {
    await marked(playground);
    await playground.press("Add the rule");
    await playground.inspector.getByRole("button", { name: /^What do the rules cost/ }).click();
    await playground.inspector.getByRole("group", { name: /^At most 1 robot in zone 1, ./ }).waitFor();
    await playground.inspector.getByRole("button", { name: /: show and open$/ }).click();
  });
  state("a rule that is written", async (playground) => {
    await marked(playground);
    await playground.inspector.getByRole("button", { name: "when: always" }).click();
    await playground.press("From, to");
  }, { tabs: [""] });
  state("an answer", answered, { tabs: ["Inspector", "Timeline"] });
  state("why there is no plan", why);
  state("a world that changes", async (playground) => {
    await running(playground);
    await begin(playground);
    await joins(playground, [2, 2], [1, 0]);
    await playground.key("Escape");
  });
  state("ways to go on", compared, { tabs: ["Inspector", "Timeline"] });
  state("no way to go on", stuck);
  state("an agent led by hand", async (playground) => {
    await rows(playground);
    await lead(playground, "A1", 0, 0);
    await steps(playground, "Down", "Right");
    await playground.says(/both at \(1, 1\)/);
  });
  state("settings", async (playground) => {
    await opening(playground);
    await playground.openSettings();
  });
  for (const [title, button] of [["Examples", "Examples"], ["Scenes", "warehouse"], ["Share", "Share"], ["Keys", "Help"]]) {
    state(`the dialog ${title}`, async (playground) => {
      await opening(playground);
      await playground.press(button);
      await playground.page.getByRole("dialog").waitFor();
    });
  }
  state("the contents of the course", async (playground) => {
    await opening(playground);
    await new Course(playground).open();
  });
  state("the glossary", async (playground) => {
    await opening(playground);
    await new Course(playground).open();
    await playground.press("Glossary");
    await playground.page.getByRole("searchbox", { name: "Find a term" }).waitFor();
  });
  state("a guess in a lesson", (playground) => taught(playground, /^Room to pass/, "Step 2: How long will they need?"), { tabs: [] });
  state("a price in a lesson", (playground) => taught(playground, /^Rules of the road/, "Step 2: What does a limit cost?"), { tabs: [] });
  state("a rule to pick in a lesson", (playground) => taught(playground, /^Pick, then drop/, "Step 3: Three rules, no plan"), { tabs: [] });
  state("a task of a lesson", (playground) => taught(playground, /^One after the other/, "Step 2: An order that works"), { tabs: [] });
  state("a robot led in a lesson", (playground) => taught(playground, /^Two robots, one cell/, "Step 4: Mend it"), { tabs: [] });
  state("the menu", async (playground) => {
    await opening(playground);
    await playground.page.setViewportSize({ width: 390, height: 664 });
    await playground.press("More");
  }, { screens: SCREENS.filter(isTouch) });
  state("a notice", async (playground) => {
    await opening(playground);
    await playground.open({ name: "no.json", bytes: Buffer.from("{") });
    await playground.notice.getByRole("button", { name: "Dismiss" }).waitFor();
  });
  state("a step of the proof", async (playground) => {
    await look(playground, PILLARS, "Bounds");
    await playground.page.getByRole("button", { name: /cannot both be on time/ }).first().click();
    await playground.inspector.getByText(/^To be on time/).first().waitFor();
  }, { tabs: ["Step", "How it was proved"] });
  state("the conflict tree", (playground) => look(playground, PILLARS, "Conflict tree"), { tabs: ["Node", "How it was proved"] });
  state("orders of robots", async (playground) => {
    await playground.example("Last in, first out");
    await playground.says(/^Optimal: makespan 10/);
    await look(playground, undefined, "One by one");
    await playground.inspector.getByRole("button", { name: /stuck$/ }).last().click();
  }, { tabs: ["Order", "How it was proved"] });
  // German is longer than English.
  const german = (name, prepare, tabs = ["Details"]) => state(`${name} in German`, async (playground) => {
    await prepare(playground);
    await choose(playground, "Deutsch");
    await playground.page.locator("html[lang=de]").waitFor();
  }, { tabs, screens: SCREENS.filter((screen) => isLong || screen[0] <= 844 || screen[0] === 1280) });
  german("a plan", opening, ["Details", "Zeitleiste", "Plan"]);
  german("an agent selected", async (playground) => {
    await opening(playground);
    await playground.inspector.getByRole("button", { name: /^A1\b/ }).first().click();
  });
  german("editing", async (playground) => {
    await opening(playground);
    await playground.pick("Obstacle");
    await playground.stroke([0, 1]);
    await playground.says(/^The scene has changed since this plan/);
  });
  german("an answer", answered);
  german("why there is no plan", why);
  german("what must be so", async (playground) => {
    await opening(playground);
    await playground.board.focus();
    await playground.key("m");
    await playground.inspector.getByText(/^This plan|^In it robots are elsewhere/).waitFor();
  });
  german("ways to go on", compared);
  german("a step of the proof", (playground) => look(playground, PILLARS, "Bounds"), ["Schritt", "Beweisgang"]);
  state("settings in German", async (playground) => {
    await opening(playground);
    await choose(playground, "Deutsch");
    await playground.page.getByRole("button", { name: /^Einstellungen:/ }).click();
  }, { tabs: ["Details"] });
  state("the page inside another", async (playground) => {
    await opening(playground);
    const link = await share(playground);
    await playground.page.goto("about:blank");
    await playground.page.goto(link.replace("#", "?embed#"));
    await playground.says(/^(Best|Optimal)/);
  }, { screens: [[320, 480], [640, 480], ...SCREENS] });
});

/** A zone is marked, and its first rule is being written. */
async function marked(playground) {
  await opening(playground);
  await playground.pick("Zone");
  await playground.stroke([0, 0], [0, 2]);
  await playground.inspector.getByRole("heading", { name: "A new rule" }).waitFor();
}

async function opening(playground) {
  await playground.says(OPENING);
  await playground.pause();
}

async function none(playground) {
  await playground.example("No way past");
  await playground.says(/^No plan/);
}

async function why(playground) {
  await none(playground);
  await playground.inspector.getByRole("button", { name: /^Why is there no plan\?/ }).click();
  await playground.inspector.getByRole("listitem").filter({ hasText: "makespan 6, sum of costs 8" }).first().waitFor();
  await playground.answered();
}

async function answered(playground) {
  await playground.example("Who waits?");
  await playground.says(/^Optimal: makespan 4, sum of costs 7/);
  await playground.press("To start");
  await playground.reaches(0);
  await playground.inspector.getByRole("button", { name: /^A2\b/ }).first().click();
  await playground.inspector.getByRole("button", { name: /^Why does A2 wait at \(3, 1\)\?/ }).first().click();
  await playground.button("Show the other plan").waitFor();
  await playground.answered();
  await playground.press("Step forward");
  await playground.reaches(1);
}

async function compared(playground) {
  await running(playground);
  await begin(playground);
  await joins(playground, [2, 2], [1, 0]);
  await playground.key("Escape");
  await adapt(playground);
}

async function stuck(playground) {
  await playground.example("Siding");
  await playground.says(/^Optimal/);
  await playground.press("To start");
  await playground.press("Step forward");
  await playground.press("Step forward");
  await playground.reaches(2);
  await begin(playground);
  await playground.pick("Obstacle");
  await playground.stroke([4, 0]);
  await adapt(playground);
}

/** The link that `Share` offers. */
async function share(playground) {
  await playground.press("Share");
  return playground.page.getByRole("dialog").getByRole("textbox").first().inputValue();
}

function scene(name, map, agent) {
  const text = JSON.stringify({ giveway: 1, name, map, agents: [{ name: "A1", start: [0, 0], ...agent }] });
  return { name: `${name}.json`, bytes: Buffer.from(text) };
}

/** All that is wrong with a state, on whichever screens; where all is run, pictures of it are left. */
async function everywhere(playground, name, tabs, screens) {
  const { page } = playground;
  const found = new Map();
  for (const [s, screen] of screens.entries()) {
    const [width, height] = screen;
    await page.setViewportSize({ width, height });
    await settled(page);
    const list = page.getByRole("tablist", { name: /^(Below the board|Unter dem Spielfeld)$/ }).getByRole("tab");
    const some = await list.count() > 0 ? tabs : [""];
    for (const [t, tab] of some.entries()) {
      if (tab) {
        await list.filter({ hasText: tab }).evaluate((button) => button.click());
      }
      // The page's own font on each screen, and in turn a narrower or a wider one.
      const fonts = FONTS.filter((_, f) => isLong || f === 0 || f === 1 + (s + t) % 2);
      for (const [f, font] of fonts.entries()) {
        await put(page, font);
        for (const theme of isLong ? THEMES : [THEMES[(s + t + f) % THEMES.length]]) {
          await page.emulateMedia({ colorScheme: theme });
          const where = [`${width}x${height}`, tab, theme, font.name].filter(Boolean).join(" ");
          for (const line of await geometry(page, { touch: isTouch(screen) })) {
            found.set(line, [...found.get(line) ?? [], where]);
          }
          if (isLong && font.name === "own") {
            const file = [name, tab, `${width}x${height}`, theme].filter(Boolean).join("-").replaceAll(" ", "-").toLowerCase();
            await page.screenshot({ path: join(PICTURES, `${file}.jpg`), type: "jpeg", quality: 85 });
          }
        }
      }
    }
  }
  return [...found].map(([line, where]) => `${line} (${where.slice(0, 3).join("; ")}${where.length > 3 ? ` and ${where.length - 3} more` : ""})`);
}

async function put(page, { family, spacing }) {
  await page.evaluate(([family, spacing]) => {
    const { style } = document.documentElement;
    style.setProperty("--font", family);
    style.letterSpacing = spacing;
  }, [family, spacing]);
  await settled(page);
}

/** Waits until what was measured is drawn. */
function settled(page) {
  return page.evaluate(() => new Promise((resolve) => {
    let frames = 3;
    const next = () => {
      frames -= 1;
      if (frames > 0) {
        requestAnimationFrame(next);
      } else {
        resolve();
      }
    };
    next();
  }));
}

/** A step of a lesson, opened from the contents. */
async function taught(playground, title, step) {
  await opening(playground);
  const course = new Course(playground);
  await course.open();
  await course.contents.getByRole("button", { name: title }).click();
  await course.lesson.getByRole("button", { name: step }).click();
  await course.at(step.replace(/^Step \d: /, ""));
}
