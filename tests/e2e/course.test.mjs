// The course: its contents, lessons judged by the solver, progress that is kept.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { Course } from "./course.mjs";
import { BOTH, LOOKS, MOVING, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

/** The course's own program. */
const PROGRAM = /\/course[-_]/;
const WASM = "**/course-*_bg.wasm";

describe("the course", () => {
  const flow = flows();

  flow("comes when it is opened, and keeps how far one got", async (playground, { page }) => {
    const asked = [];
    page.on("request", (request) => asked.push(request.url()));
    await playground.example("Who waits?");
    await playground.says(/^Optimal: /);
    assert.deepEqual(asked.filter((url) => PROGRAM.test(url)), [], "loaded before it was opened");
    const course = new Course(playground);
    await course.open();
    assert.equal(await course.contents.getByRole("listitem").count(), 21);
    await course.contents.getByRole("button", { name: "Start: Two robots, one cell" }).click();
    await course.at("Robots take steps");
    await course.next.click();
    await course.at("Two in one cell");
    await page.keyboard.press("Tab");
    await course.lesson.getByRole("button", { name: "Leave the lesson" }).click();
    await course.lesson.waitFor({ state: "detached" });
    await playground.shows("scenario 1");

    await playground.reload();
    await course.open();
    const onward = course.contents.getByRole("button", { name: "Go on: Two robots, one cell" });
    await course.contents.getByText("Step 2 of 4").waitFor();
    await onward.click();
    await course.at("Two in one cell");
    await course.lesson.getByRole("button", { name: "Course" }).click();
    await course.contents.getByRole("button", { name: "Forget my progress" }).click();
    // It asks first; the same button keeps it.
    await course.contents.getByRole("button", { name: "Keep it" }).click();
    await course.contents.getByText("Step 2 of 4").waitFor();
    await course.contents.getByRole("button", { name: "Forget my progress" }).click();
    await course.contents.getByRole("button", { name: "Reset progress" }).click();
    await course.contents.getByRole("button", { name: "Start: Two robots, one cell" }).waitFor();
    await page.keyboard.press("Escape");
    await course.contents.waitFor({ state: "detached" });
  }, { screens: BOTH });

  flow("takes a guess without answers to pick from, and shows it beside what is proved", async (playground, { page }) => {
    const course = new Course(playground);
    await course.open();
    await course.contents.getByRole("button", { name: /^Rules of the road/ }).click();
    await course.at("A zone");
    await course.next.click();
    await course.at("What does a limit cost?");
    const field = course.lesson.getByRole("textbox");
    await field.fill("one");
    await course.says(/Type a whole number, such as 12\./);
    await field.fill("1");
    await page.keyboard.press("Enter");
    await course.says(/your guess 9 ?proved 10 ?The rule costs 2\. ?A1 waits 2 steps until A2 is out/);
    await playground.picture("course-price");

    await page.evaluate(() => { location.hash = "lesson=pick-then-drop.3"; });
    await course.at("Three rules, no plan");
    await playground.picture("course-rules");
    await course.lesson.getByRole("button", { name: "A1 arrives by 9" }).click();
    await course.says(/A1 arrives by 9 ?your guess A1 is at \(5, 1\) before A2 is at \(1, 1\) ?proved/);
    await playground.picture("course-rule-found");
  }, { screens: BOTH });

  flow("shows what a lesson is about: its board plays while somebody points at it", async (playground, { page }) => {
    const course = new Course(playground);
    await course.open();
    await page.mouse.move(5, 5);
    const card = course.contents.getByRole("button", { name: /^Room to pass/ });
    const board = () => card.locator("svg").first().innerHTML();
    const still = await board();
    await card.hover();
    await eventually("the board to play", board, (now) => now !== still);
    await page.mouse.move(5, 5);
    await eventually("the board to stand still", board, (now) => now === still);
  }, MOVING);

  flow("that does not arrive is told, and tried again", async (playground, { context }) => {
    const course = new Course(playground);
    await playground.act("Course");
    await playground.warns(/The course could not be loaded\. Try again when the network is back\./);
    await context.unroute(WASM);
    await course.open();
    await playground.key("Escape");
  }, { complains: true, before: (context) => context.route(WASM, (route) => route.fulfill({ status: 404 })) });

  flow("its first lesson, by keys alone", async (playground, { page }) => {
    const course = new Course(playground);
    await course.tabTo(/^Course$/);
    await playground.key("Enter");
    await course.contents.waitFor();
    await course.tabTo(/^Start:/);
    await playground.key("Enter");
    await course.at("Robots take steps");
    await eventually("the focus on the title", () => course.focused(), (name) => name === "Robots take steps");
    await course.tabTo(/^Next$/);
    await playground.key("Enter");

    // Both robots are in the middle at time 2.
    await course.at("Two in one cell");
    const at = async (time, x, y) => {
      await playground.time.focus();
      await playground.key("Home", ...Array(time).fill("ArrowRight"));
      await playground.reaches(time);
      await playground.board.focus();
      await playground.key("Control+Home", ...Array(x).fill("ArrowRight"), ...Array(y).fill("ArrowDown"), "Enter");
    };
    await at(1, 2, 3);
    await course.says(/who else\?/);
    await at(2, 2, 2);
    await course.solved();
    await playground.picture("course-spotted");
    await playground.key("Enter");

    await course.at("Through each other");
    await at(1, 1, 0);
    await at(1, 2, 0);
    await course.says(/1 conflict found\. There are more\./);
    await at(2, 2, 0);
    await course.solved();
    await playground.key("Enter");

    // It waits once, then goes up four times.
    await course.at("Mend it");
    await playground.board.focus();
    await playground.key("ArrowUp", "ArrowUp", "ArrowUp", "ArrowUp");
    await course.says(/Not (yet|like this)/);
    await course.tabTo(/^Start afresh$/);
    await playground.key("Enter");
    await playground.board.focus();
    await playground.key("w", "ArrowUp", "ArrowUp", "ArrowUp", "ArrowUp");
    await course.solved();
    await playground.key("Enter");

    await course.contents.getByText("Done", { exact: true }).waitFor();
    await course.contents.getByRole("button", { name: "Go on: Room to pass" }).waitFor();
    await playground.picture("course-done");
    await playground.reload();
    await course.open();
    await course.contents.getByText("Done", { exact: true }).waitFor();
    await page.keyboard.press("Escape");
  });

  for (const { theme, screens } of LOOKS) {
    flow(`a lesson with a guess, a choice and a scene to paint (${theme})`, async (playground, { page }) => {
      const course = new Course(playground);
      await course.open();
      await audit(playground, "the contents");
      await playground.picture(`course-contents-${theme}`);
      await course.contents.getByRole("button", { name: /^Room to pass/ }).click();
      await course.at("A corridor and a bay");
      await course.next.click();

      await course.at("How long will they need?");
      await course.lesson.getByRole("button", { name: "makespan", exact: true }).click();
      const card = page.getByRole("dialog", { name: "Makespan" });
      await card.waitFor();
      await audit(playground, "a term");
      await playground.key("Escape");
      await card.waitFor({ state: "detached" });
      await playground.key("2");
      await course.says(/your guess.*proved/);
      await course.says(/8 is not enough/);
      await audit(playground, "an answer");
      await playground.picture(`course-guessed-${theme}`);
      await course.next.click();

      await course.at("Who gives way?");
      await playground.key("1");
      await course.says(/comes to the bay one step later/);
      await playground.key("2");
      await course.solved();
      await playground.key("Enter");

      await course.at("Block one cell");
      await playground.pick("Obstacle");
      await playground.stroke([4, 0]);
      await course.says(/Not yet: there is still a plan, makespan 9\. You blocked \(4, 0\)\./);
      await audit(playground, "a task");
      await playground.picture(`course-not-yet-${theme}`);
      await course.lesson.getByRole("button", { name: "Take it back" }).click();
      await course.lesson.getByRole("button", { name: "Hint", exact: true }).click();
      await course.lesson.getByRole("list", { name: "Hints" }).waitFor();
      await playground.stroke([3, 1]);
      await course.solved();
      await playground.picture(`course-solved-${theme}`);
      await audit(playground, "a task that is solved");
    }, { theme, screens, reducedMotion: "reduce" });
  }

  for (const { theme, screens } of LOOKS) {
    flow(`a proof is checked, and refused with another byte (${theme})`, async (playground) => {
      const course = new Course(playground);
      await course.open();
      await course.contents.getByRole("button", { name: /^No plan is better/ }).click();
      for (const title of ["A bound for nothing", "Raise it", "Meet it"]) {
        await course.at(title);
        await course.next.click();
      }
      await course.at("Check it");
      const proof = course.lesson.getByRole("region", { name: "The proof" });
      await proof.getByRole("button", { name: "Check the proof" }).click();
      await course.says(/Accepted: the proof shows that no plan is better\. \d+ bytes, each as it was written\./);
      await proof.getByRole("button", { name: "Change one byte" }).click();
      await course.says(/Refused: this proof shows nothing\. Byte \d+ of [a-z-]+\.drat was \d, and is \d now\./);
      await audit(playground, "a proof that is refused");
      await playground.picture(`course-proof-${theme}`);
      await proof.getByRole("button", { name: "Change it back" }).click();
      await course.says(/Accepted: /);
      await playground.key("2");
      await course.solved();
    }, { theme, screens, reducedMotion: "reduce" });
  }

  flow("a question that nobody wants to guess, an order, and a way on after a change", async (playground, { page }) => {
    const course = new Course(playground);
    const lessons = async (title, step) => {
      await course.contents.getByRole("button", { name: title }).click();
      await course.lesson.getByRole("button", { name: step }).click();
    };
    await course.open();
    await lessons(/^Room to pass/, "Step 2: How long will they need?");
    await course.lesson.getByRole("button", { name: "Show me the answer" }).click();
    await course.says(/At 9.*proved/);

    await course.lesson.getByRole("button", { name: "Course" }).click();
    await lessons(/^One after the other/, "Step 2: An order that works");
    // A3 before A1: that one is stuck.
    const earlier = course.lesson.getByRole("button", { name: "A3 earlier" });
    await earlier.click();
    await earlier.click();
    await course.lesson.getByRole("button", { name: "Try this order" }).click();
    await course.says(/finds no way around/);
    await course.lesson.getByRole("button", { name: "A3 later" }).click();
    await course.lesson.getByRole("button", { name: "Try this order" }).click();
    await course.solved();

    await course.lesson.getByRole("button", { name: "Course" }).click();
    await lessons(/^When the world changes/, "Step 3: Disturb nobody");
    await course.lesson.getByRole("button", { name: /^Replan/ }).click();
    await course.says(/Not yet: replanning keeps 1 robot as planned/);
    await course.lesson.getByRole("button", { name: /^Revise/ }).click();
    await course.solved();

    await course.lesson.getByRole("button", { name: "Course" }).click();
    await course.contents.getByRole("button", { name: "Glossary" }).click();
    const glossary = page.getByRole("dialog", { name: "Glossary" });
    await glossary.getByRole("searchbox", { name: "Find a term" }).fill("pibt");
    await glossary.getByRole("term").filter({ hasText: "PIBT" }).waitFor();
    await audit(playground, "the glossary");
    await playground.picture("course-glossary");
  });
});
