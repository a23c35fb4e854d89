// Waits on real floors are asked about: how soon each layer of the answer is there.
//
// The depot; and with GIVEWAY_FLOORS, the path of target/floors.json of `./x bench --floor`, each of
// its floors whose plan was proved best there.

import { readFileSync } from "node:fs";
import { join } from "node:path";

import { root } from "../e2e/dist.mjs";
import { save } from "../e2e/recover.mjs";
import { SOLVED, figure, inPage } from "./figure.mjs";

const DEPOT = join(root, "tests/data/depot/depot.json");
/** So many robots are asked about: each about its first wait, or its arrival where it has none. */
const QUESTIONS = 10;
/** How long an answer is watched, and how long the plan may need, in milliseconds. */
const PATIENCE = 30_000;
const PLAN = 300_000;
/** How often it is looked whether the plan is proved, in milliseconds. */
const LOOK = 500;
/** Seconds within which each layer is to be there. */
const HERE = 0.1;
const NEAR = 1;
const VERDICT = 3;

/** The share of questions about proved plans that each layer answers in time. */
export function asking(url) {
  return inPage(url, async (playground) => {
    await playground.says(SOLVED);
    const answers = [];
    for (const { name, file } of floors()) {
      const ofFloor = await askedAbout(playground, name, file);
      answers.push(...ofFloor);
    }
    const share = (what, least, isSo) => figure(what, (100 * answers.filter(isSo).length) / answers.length, "%", { least });
    const where = process.env.GIVEWAY_FLOORS ? "floors" : "the depot";
    return [
      share(`${answers.length} questions about ${where}, what the plan shows within ${HERE} s`, 95, ({ here }) => here <= HERE),
      share(`the same, small variations within ${NEAR} s more`, 95, ({ here, near }) => near - here <= NEAR),
      share(`the same, the verdict within ${VERDICT} s more`, 90, ({ near, verdict }) => verdict - near <= VERDICT),
      share(`the same, a verdict within ${PATIENCE / 1000} s`, 100, ({ verdict }) => verdict < PATIENCE / 1000),
    ];
  });
}

/** The depot, and the floors of a file that have a proved plan, each with its name on the page. */
function floors() {
  const from = process.env.GIVEWAY_FLOORS;
  const others = from ? JSON.parse(readFileSync(from, "utf8")).filter(({ best, name }) => best && name !== "depot") : [];
  const asFile = ({ name, scene }) => ({ name, file: { name: `${name}.json`, bytes: JSON.stringify({ ...scene, name }) } });
  return [{ name: "Depot North", file: DEPOT }, ...others.map(asFile)];
}

/** How soon each layer of each answer about one floor is there, in seconds. */
async function askedAbout(playground, floor, file) {
  const { page } = playground;
  await playground.open(file);
  await playground.shows(floor);
  if (!(await playground.button("Cancel").isVisible()) && !SOLVED.test(await playground.status.textContent())) {
    await playground.press("Solve");
  }
  const end = Date.now() + PLAN;
  while (!SOLVED.test(await goneOn(playground))) {
    if (Date.now() > end) {
      console.log(`# ${floor}: not proved in ${PLAN / 1000} s`);
      return [];
    }
    await page.waitForTimeout(LOOK);
  }
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
    const answer = await question.evaluate(untilAnswered, PATIENCE);
    const seconds = ({ here, near, verdict }) => [here, near, verdict].map((value) => value?.toFixed(2)).join(" ");
    console.log(`# ${floor}: ${words} ${seconds(answer)}`);
    answers.push(answer);
    // The answer is closed, then the robot let go.
    await playground.inspector.getByRole("button", { name: "Back", exact: true }).click();
    await playground.key("Escape");
  }
  return answers;
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
