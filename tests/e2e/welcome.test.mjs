// The first visit: the welcome, which is never in the way and never comes again, and the
// tour of the page.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { Course } from "./course.mjs";
import { BOTH, flows, LOOKS, MOVING } from "./flow.mjs";
import { geometry } from "./geometry.mjs";
import { edit, LINK, look, OPENING } from "./recover.mjs";
import { Tour } from "./tour.mjs";
import { eventually } from "./wait.mjs";

const welcome = true;
const TITLE = "Robots share a floor. Who gives way?";

/** The card of a first visit. */
function card({ page }) {
  return page.getByRole("region", { name: TITLE });
}

/** It is gone, and does not come again. */
async function isGone(playground) {
  await card(playground).waitFor({ state: "detached" });
  await playground.reload();
  await playground.says(OPENING);
  assert.equal(await card(playground).count(), 0, "it came again");
}

/** Whether two boxes on the screen have something in common. */
function meet(one, two) {
  return one.x < two.x + two.width && two.x < one.x + one.width && one.y < two.y + two.height && two.y < one.y + one.height;
}

describe("the welcome", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`covers neither board nor transport, ${theme}`, async (playground, { page, screen }) => {
      await card(playground).waitFor();
      await playground.says(OPENING);
      await look(playground, `welcome-${theme}`);
      const boxes = await Promise.all([card(playground), playground.board, page.locator(".transport .keys")].map((it) => it.boundingBox()));
      assert.ok(!meet(boxes[0], boxes[1]), "it covers the board");
      assert.ok(!meet(boxes[0], boxes[2]), "it covers the transport");
      assert.equal(await page.evaluate(() => document.activeElement === document.body), true, "it took the focus");
      assert.deepEqual(await page.locator(".btn.primary:visible, .playb:visible").evaluateAll((all) => {
        const page = getComputedStyle(document.querySelector(".primary")).backgroundColor;
        return all.filter((one) => getComputedStyle(one).backgroundColor === page).map((one) => one.innerText.trim());
      }), ["Take the tour\n2 min"], "one button is dark");
      if (screen === "desktop") {
        // On a phone it lies over the tabs and the tools on purpose.
        assert.deepEqual(await geometry(page), []);
      }
      await audit({ page }, `welcome ${theme}`);
    }, { welcome, theme, screens });
  }

  flow("stays while the plan plays and a person looks around", async (playground) => {
    await card(playground).waitFor();
    const from = await playground.now();
    await eventually("the plan to play", () => playground.now(), (now) => now !== from);
    await playground.pause();
    await playground.stroke([9, 2]);
    await card(playground).waitFor();
  }, { welcome, screens: BOTH, ...MOVING });

  for (const name of ["Just play", "Close"]) {
    flow(`goes for good by ${name}`, async (playground) => {
      await card(playground).getByRole("button", { name }).click();
      await isGone(playground);
    }, { welcome, screens: BOTH });
  }

  flow("goes for good by Escape", async (playground) => {
    await card(playground).waitFor();
    await playground.key("Escape");
    await isGone(playground);
  }, { welcome });

  flow("goes for good with the first edit", async (playground, { page }) => {
    await card(playground).waitFor();
    await edit(playground);
    await card(playground).waitFor({ state: "detached" });
    await eventually("the edit to be kept", () => playground.keeps(), (text) => text.includes("touched"));
    await playground.reload();
    await playground.cellTells(0, 1, /^obstacle/);
    assert.equal(await card(playground).count(), 0, "it came again");
    // Nor does it come where only the work is there.
    await page.evaluate(() => localStorage.removeItem("giveway.welcome"));
    await playground.reload();
    await playground.cellTells(0, 1, /^obstacle/);
    assert.equal(await card(playground).count(), 0, "it came over somebody's work");
  }, { welcome });

  flow("stays where nobody has answered it", async (playground) => {
    await card(playground).waitFor();
    await playground.reload();
    await card(playground).waitFor();
  }, { welcome });

  flow("leads to the course, and is gone then", async (playground) => {
    const course = new Course(playground);
    await card(playground).getByRole("button", { name: "Start the course" }).click();
    await course.at("Robots take steps");
    assert.equal(await course.contents.count(), 0, "the first lesson, not the contents");
    await isGone(playground);
  }, { welcome, screens: BOTH });

  flow("is not for who comes by a link, to a lesson, or inside another page", async (playground, { page, host }) => {
    await card(playground).waitFor();
    const without = async (address) => {
      await page.goto("about:blank");
      await playground.goto(address);
      assert.equal(await card(playground).count(), 0, address);
    };
    await without(`${host.url}#lesson=two-robots-one-cell.1`);
    await new Course(playground).at("Robots take steps");
    assert.equal(await card(playground).count(), 0);
    await page.goto("about:blank");
    await page.goto(`${host.url}?embed#${LINK}`);
    await page.getByRole("slider", { name: "Time" }).waitFor();
    assert.equal(await card(playground).count(), 0);
    await without(`${host.url}#${LINK}`);
    await playground.shows("sent");
  }, { welcome });
});

describe("the tour", () => {
  const flow = flows();

  flow("is walked through by doing what it says", async (playground, { page }) => {
    const [tour, course] = [new Tour(playground), new Course(playground)];
    await card(playground).getByRole("button", { name: "Take the tour" }).click();
    await tour.at("Play the plan");
    await card(playground).waitFor({ state: "detached" });
    await playground.shows("side bay");
    await playground.says(/^Optimal: makespan 6/);
    await tour.pointsAt(playground.button("Play"));
    assert.deepEqual(await geometry(page, { touch: playground.isPhone() }), []);
    await audit({ page }, "tour");
    await playground.press("Play");
    await tour.at("Click a robot that waits");
    if (!playground.isPhone()) {
      // There, the lanes are behind a tab.
      await playground.reaches(0);
    }
    await tour.pointsAt(playground.cell(4, 0));
    await playground.picture("tour-robot");
    await playground.stroke([4, 0]);
    await tour.at("Ask why it waits");
    const question = playground.inspector.getByRole("button", { name: /^Why does A1 give way to A2/ });
    await tour.pointsAt(question);
    await playground.picture("tour-question");
    await question.click();
    await tour.at("Change the scene");
    if (playground.isPhone()) {
      // The tools are folded away until the answer is left.
      const back = playground.inspector.getByRole("button", { name: "Back" });
      await tour.pointsAt(back);
      await back.click();
    }
    await tour.pointsAt(playground.tools.getByRole("button", { name: "Obstacle" }));
    await playground.picture("tour-tool");
    await playground.pick("Obstacle");
    await tour.pointsAt(playground.cell(6, 1));
    await playground.stroke([6, 1]);
    await tour.at("Solve it again");
    await tour.pointsAt(playground.solver);
    await playground.picture("tour-solve");
    await playground.press("Solve");
    await tour.at("Add a rule");
    await playground.says(/^Optimal: makespan 8/);
    await tour.pointsAt(playground.tools.getByRole("button", { name: "Zone", exact: true }));
    await playground.pick("Zone");
    await tour.pointsAt(playground.cell(3, 1));
    await playground.stroke([3, 1], [4, 1]);
    const add = playground.inspector.getByRole("button", { name: "Add the rule" });
    await tour.pointsAt(add);
    await playground.picture("tour-rule");
    await add.click();
    const price = playground.inspector.getByRole("button", { name: "What do the rules cost?" });
    await tour.pointsAt(price);
    await price.click();
    await tour.at("Go on with the course");
    await playground.inspector.getByRole("group", { name: /At most 1 robot in zone 1, / }).waitFor();
    await tour.pointsAt(playground.button(playground.isPhone() ? "More" : "Course"));
    await playground.picture("tour-course");
    await playground.act("Course");
    await course.contents.waitFor();
    await tour.isOver();
    await playground.key("Escape");
    await playground.shows("warehouse");
    await playground.reload();
    await playground.shows("warehouse");
    assert.equal(await card(playground).count(), 0);
  }, { welcome, screens: BOTH });

  flow("shows each step to who wants it shown", async (playground) => {
    const [tour, course] = [new Tour(playground), new Course(playground)];
    await tour.fromHelp();
    for (const [index, title] of Tour.TITLES.entries()) {
      await tour.at(title);
      await tour.card.getByText(`${index + 1} of 7`).waitFor();
      await tour.press("Show me");
    }
    await course.contents.waitFor();
    await tour.isOver();
  }, { screens: BOTH });

  flow("is walked through by keys alone", async (playground) => {
    const [tour, course] = [new Tour(playground), new Course(playground)];
    await playground.key("?");
    await course.tabTo(/^Take the tour$/);
    await playground.key("Enter");
    await tour.at("Play the plan");
    assert.ok(await tour.hasFocus(), "the focus is not on the card");
    await playground.says(/^Optimal: makespan 6/);
    await playground.key("Space");
    await tour.at("Click a robot that waits");
    await playground.board.focus();
    await playground.key("Control+Home", ...Array(4).fill("ArrowRight"), "Enter");
    await tour.at("Ask why it waits");
    await course.tabTo(/^Why does A1 give way to A2/);
    await playground.key("Enter");
    await tour.at("Change the scene");
    await playground.board.focus();
    await playground.key("o", "Control+Home", ...Array(6).fill("ArrowRight"), "ArrowDown", "Enter");
    await tour.at("Solve it again");
    await playground.key("Control+Enter");
    await tour.at("Add a rule");
    await playground.board.focus();
    await playground.key("z", "Control+Home", ...Array(3).fill("ArrowRight"), "ArrowDown", "Space");
    await course.tabTo(/^Add the rule$/);
    await playground.key("Enter");
    await course.tabTo(/^What do the rules cost\?$/);
    await playground.key("Enter");
    await tour.at("Go on with the course");
    if (playground.isPhone()) {
      await course.tabTo(/^More$/);
      await playground.key("Enter");
    }
    await course.tabTo(/^Course$/);
    await playground.key("Enter");
    await course.contents.waitFor();
    await tour.isOver();
  });

  flow("leaves one's own work as it was, and gives the focus back", async (playground, { page }) => {
    const tour = new Tour(playground);
    await edit(playground);
    await tour.fromHelp();
    await tour.at("Play the plan");
    await playground.shows("side bay");
    await playground.pick("Obstacle");
    await playground.stroke([2, 1]);
    await tour.press("End tour");
    await tour.isOver();
    await playground.cellTells(0, 1, /^obstacle/);
    await eventually("the focus to be back", () => page.evaluate(() => document.activeElement.title), (title) => title === "Help (?)");
    await playground.press("Undo");
    await playground.cellTells(0, 1, /^(?!obstacle)/);

    await tour.fromHelp();
    await tour.at("Play the plan");
    await page.reload();
    await playground.board.waitFor();
    await playground.shows("warehouse");
    await tour.isOver();

    await tour.fromHelp();
    await tour.at("Play the plan");
    await playground.key("Escape");
    await tour.isOver();
    await playground.shows("warehouse");
  });

  flow("goes with what it points at", async (playground, { page }) => {
    const tour = new Tour(playground);
    await tour.fromHelp();
    await playground.says(/^Optimal: makespan 6/);
    for (const [width, height] of [[1440, 900], [1024, 768], [760, 600], [1280, 720]]) {
      await page.setViewportSize({ width, height });
      await tour.pointsAt(playground.button("Play"));
    }
    await tour.press("Show me");
    await tour.at("Click a robot that waits");
    await tour.pointsAt(playground.cell(4, 0));
    await playground.press("Zoom in");
    await tour.pointsAt(playground.cell(4, 0));
  });
});
