// Waits on a real floor are asked about: how soon each layer of the answer is there.

import { join } from "node:path";

import { root } from "../e2e/dist.mjs";
import { save } from "../e2e/recover.mjs";
import { eventually } from "../e2e/wait.mjs";
import { SOLVED, figure, inPage } from "./figure.mjs";

const DEPOT = join(root, "tests/data/depot/depot.json");
/** So many robots are asked about: each about its first wait, or its arrival where it has none. */
const QUESTIONS = 10;
/** How long an answer is watched, and how long the plan may need, in milliseconds. */
const PATIENCE = 30_000;
const PLAN = 300_000;
/** Seconds within which each layer is to be there. */
const HERE = 0.1;
const NEAR = 1;
const VERDICT = 3;

/** The share of questions about the depot's proved plan that each layer answers in time. */
export function asking(url) {
  return inPage(url, async (playground) => {
    const { page } = playground;
    await playground.says(SOLVED);
    await playground.open(DEPOT);
    await playground.shows("Depot North");
    if (!(await playground.button("Cancel").isVisible())) {
      await playground.press("Solve");
    }
    await eventually("the proof", () => goneOn(playground), (text) => SOLVED.test(text), PLAN);
    await playground.pause();
    const { paths } = JSON.parse(await save(playground, "Save plan"));
    const asked = Object.entries(paths).slice(0, QUESTIONS).map(([name, path]) => ({ name, ...asksAbout(name, path) }));
    const answers = [];
    for (const { name, question: words, time } of asked) {
      await page.locator(".clock input").fill(String(time));
      await playground.key("Enter");
      await playground.reaches(time);
      await playground.inspector.getByRole("button", { name: new RegExp(`^${name}\\b`) }).first().click();
      await playground.inspector.getByRole("heading", { name, level: 2 }).waitFor();
      const question = playground.inspector.getByRole("button", { name: words }).first();
      await question.waitFor();
      answers.push(await question.evaluate(untilAnswered, PATIENCE));
      // The answer is closed, then the robot let go.
      await playground.inspector.getByRole("button", { name: "Back", exact: true }).click();
      await playground.key("Escape");
    }
    const share = (what, least, isSo) => figure(what, (100 * answers.filter(isSo).length) / answers.length, "%", { least });
    return [
      share(`${answers.length} questions about the depot, what the plan shows within ${HERE} s`, 95, ({ here }) => here <= HERE),
      share(`the same, small variations within ${NEAR} s more`, 95, ({ here, near }) => near - here <= NEAR),
      share(`the same, the verdict within ${VERDICT} s more`, 90, ({ near, verdict }) => verdict - near <= VERDICT),
      share(`the same, a verdict within ${PATIENCE / 1000} s`, 100, ({ verdict }) => verdict < PATIENCE / 1000),
    ];
  });
}

/** What is said of the plan; where the time limit was reached, the search goes on. */
async function goneOn(playground) {
  const said = await playground.status.textContent();
  if (!SOLVED.test(said) && (await playground.button("Go on").isVisible())) {
    await playground.press("Go on");
  }
  return said;
}

/** What a robot is asked about, and at which time. A slow move has no cell in its middle. */
function asksAbout(name, path) {
  const is = (one, other) => one && other && one[0] === other[0] && one[1] === other[1];
  const arrival = path.findLastIndex((cell) => !is(cell, path.at(-1))) + 1;
  const time = path.findIndex((cell, at) => at < arrival && is(cell, path[at + 1]));
  return time < 0
    ? { question: `Why does ${name} not arrive sooner?`, time: 0 }
    : { question: `Why does ${name} wait at (${path[time].join(", ")})`, time };
}

/** Presses a question: the seconds until its first layers and its verdict are drawn. */
function untilAnswered(button, patience) {
  return new Promise((resolve) => {
    const begin = performance.now();
    const seen = {};
    const note = (layer, isThere, now) => {
      if (isThere) {
        seen[layer] ??= (now - begin) / 1000;
      }
    };
    button.click();
    const look = (now) => {
      // The layers are no longer told once all of them stand.
      const layers = [...document.querySelectorAll(".coming li")].map((layer) => layer.className);
      const verdict = document.querySelector(".verdict-at .verdict")?.textContent;
      const isWhole = verdict !== undefined && layers.length === 0;
      note("here", isWhole || layers[0] === "done", now);
      note("near", isWhole || layers[1] === "done", now);
      note("verdict", isWhole || (layers[1] === "done" && verdict !== undefined && !verdict.includes("so far")), now);
      if (seen.verdict !== undefined || now - begin > patience) {
        resolve({ here: Infinity, near: Infinity, verdict: Infinity, ...seen });
      } else {
        requestAnimationFrame(look);
      }
    };
    requestAnimationFrame(look);
  });
}
