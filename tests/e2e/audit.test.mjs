// An automated audit in every state of the page, light and dark: no violation.

import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { adapt, begin, join, running } from "./change.mjs";
import { flows, LOOKS, sample } from "./flow.mjs";
import { lead, rows, steps } from "./steer.mjs";

const OPENING = /^Optimal: makespan 18/;
/** Takes the solver longer than any audit. */
const HARD = sample("mmapf/A17_mm_20x20_o15_a30.json");

describe("the audit finds nothing", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    // Nothing fades while it is looked at: colours are judged as they stay.
    const options = { theme, screens, reducedMotion: "reduce" };

    flow(`playing, planned, with a selection, stale, and in dialogs, ${theme}`, async (playground) => {
      await playground.says(OPENING);
      await audit(playground, "playing");
      await playground.pause();
      await audit(playground, "planned");
      await playground.press("To start");
      await playground.showTab("Inspector");
      for (const [x, y] of [[0, 0], [3, 1]]) {
        await playground.cell(x, y).click();
        await audit(playground, `selected ${x}, ${y}`);
      }
      await playground.showTab("Plan");
      await audit(playground, "the plan table");
      await playground.pick("Obstacle");
      await playground.cell(0, 1).click();
      await playground.says(/^The scene has changed since this plan/);
      await audit(playground, "editing");
      await playground.pick("Robot");
      await playground.cell(0, 2).click();
      await playground.says(/Now choose its goal/);
      await audit(playground, "placing an agent");
      await playground.key("Escape");

      for (const [name, opens] of [["Examples", "Examples"], ["Share", "Share"]]) {
        await playground.act(opens);
        await playground.page.getByRole("dialog", { name }).waitFor();
        await audit(playground, name);
        await playground.key("Escape");
      }
      await playground.key("?");
      await playground.page.getByRole("dialog", { name: "Keys" }).waitFor();
      await audit(playground, "the keys");
      await playground.key("Escape");
      await playground.openSettings();
      await audit(playground, "the settings");
      await playground.closeSettings();
      await playground.press(playground.isPhone() ? "More" : "Save");
      await audit(playground, "a menu");
    }, options);

    flow(`none, asking, and answered, ${theme}`, async (playground) => {
      await playground.example("No way past");
      await playground.says(/^No plan exists, no matter how many steps you allow/);
      await audit(playground, "none");
      await ask(playground, /^Why is there no plan\?/);
      await playground.inspector.getByRole("heading", { name: "What would help" }).waitFor({ timeout: 60_000 });
      await audit(playground, "why there is none");
      await playground.example("Who waits?");
      await playground.says(/^Optimal: makespan 4/);
      await playground.showTab("Inspector");
      await playground.inspector.getByRole("button", { name: /^A2\b/ }).first().click();
      await playground.press("To start");
      await ask(playground, /^Why does A2 wait at \(3, 1\)\?/);
      await playground.button("Show the other plan").waitFor({ timeout: 60_000 });
      await playground.answered();
      await audit(playground, "answered");
    }, options);

    flow(`changing, comparing, and adopted, ${theme}`, async (playground) => {
      await running(playground);
      await begin(playground);
      await playground.showTab("Inspector");
      await audit(playground, "nothing changed yet");
      await join(playground, [2, 2], [1, 0]);
      await playground.says(/1 change listed/);
      await audit(playground, "changing");
      await adapt(playground);
      await audit(playground, "comparing");
      await playground.page.getByRole("button", { name: /^Use this plan/ }).first().click();
      await playground.says(/^The world changed at time 1/);
      await audit(playground, "adopted");
    }, options);

    flow(`steering, and a plan of one's own that is checked, ${theme}`, async (playground) => {
      await rows(playground);
      await lead(playground, "A1", 0, 0);
      await audit(playground, "steering");
      await steps(playground, "Down", "Right");
      await playground.says(/both at \(1, 1\)/);
      await audit(playground, "a collision");
      await playground.press("Check my plan");
      await playground.inspector.getByRole("heading", { name: "What is against the rules" }).waitFor();
      await audit(playground, "checked");
    }, options);

    flow(`solving, stopped, and asking, ${theme}`, async (playground) => {
      await playground.openSettings();
      await playground.set("Time limit, s", 60);
      await playground.closeSettings();
      await playground.open(HARD);
      await playground.says(/^No plan yet/);
      await playground.press("Solve");
      await playground.button("Cancel").waitFor();
      await audit(playground, "solving");
      await playground.button("Cancel").waitFor();
      await playground.press("Cancel");
      await playground.openSettings();
      await playground.set("Time limit, s", 3);
      await playground.closeSettings();
      await playground.press("Go on");
      await playground.button("Go on").waitFor({ timeout: 60_000 });
      await playground.says(/^Best so far/);
      await audit(playground, "stopped");
      await playground.openSettings();
      await playground.set("Time limit, s", 60);
      await playground.closeSettings();
      await ask(playground, /^Why does it take this long\?/);
      await playground.button("Cancel").waitFor();
      await audit(playground, "asking");
      await playground.button("Cancel").waitFor();
      await playground.press("Cancel");
    }, options);
  }
});

async function ask(playground, question) {
  if (await playground.page.getByRole("tab").count()) {
    await playground.showTab("Inspector");
  }
  await playground.inspector.getByRole("button", { name: question }).first().click();
}
