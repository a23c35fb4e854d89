// What a first visit runs of the page's programs: `./x visit` writes scripts/page/later/, whenever much of the page has
// changed. What is not listed there comes with the first part. A new function in a listed path comes later, though: where a first
// visit runs it, tests/e2e/later.test.mjs fails, and the lists are to be written anew.

import { createRequire } from "node:module";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";

import { launch, open } from "../tests/e2e/browser.mjs";
import { root } from "../tests/e2e/dist.mjs";
import { leaveAndComeBack } from "../tests/e2e/leaving.mjs";
import { serve } from "../tests/e2e/server.mjs";
import { slowDown, slowSolver } from "../tests/measure/network.mjs";
import { assemble } from "./page/assemble.mjs";
import { compile } from "./page/compile.mjs";
import { listOf } from "./page/later.mjs";

const { devices } = createRequire(import.meta.url)("playwright-core");

/** How long a step of a visit may take, in milliseconds: the programs are whole, and note what they do. */
const WAITING = 120_000;
const PROGRAMS = ["app", "solver"];
/** How much slower a machine may be. */
const SLOW = 8;
/** How much slower its solver: what a search of some milliseconds took is told in seconds, too. */
const SLOWER_SOLVER = 100;
/** From how many bytes on a function is listed by its own name. */
const LARGE = 80;
/** The number of one of several copies of a function, which every build gives anew. */
const COPY = /\.\d+$/;
/** The paths of the project's crates in the name of a function, those that giveway-bind finds, too. */
const PATHS = /(?<![\p{L}\p{N}_])giveway_[\p{L}\p{N}_:]+/gu;

const folder = join(process.env.CARGO_TARGET_DIR ?? join(root, "target"), "visit");
rmSync(folder, { recursive: true, force: true });
await compile(root, folder, "visit");
assemble(root, folder);
const host = await serve(folder, "/", { compress: true });
const browser = await launch();
const ran = Object.fromEntries(PROGRAMS.map((name) => [name, new Set()]));
for (const options of [{}, { welcome: true, theme: "dark" }, { ...devices["Pixel 7"], width: 390, height: 844 }, { locale: "de-DE" }]) {
  await visit(options);
  await visit(options, { atOnce: true });
  await visit(options, { rate: SLOW });
  await visit(options, { rate: SLOW, slower: SLOWER_SOLVER });
}
await breakDown();
await browser.close();
await host.close();
for (const name of PROGRAMS) {
  const functions = readFileSync(join(folder, `${name}.functions`), "utf8").trimEnd().split("\n").map((line, number) => {
    const space = line.indexOf(" ");
    return { bytes: Number(line.slice(0, space)), name: line.slice(space + 1), ran: ran[name].has(number) };
  });
  const lines = later(functions);
  writeFileSync(listOf(root, name), `# What a first visit does not run of ${name}: \`./x visit\` writes this file.\n${lines.join("\n")}\n`);
  console.log(`${name}: ${functions.filter((one) => one.ran).length} of ${functions.length} functions ran, ${lines.length} lines`);
}

/**
 * The playground is opened, plays, solves, and is looked at; `atOnce`: on a slow network, where nobody waits for it; `rate`:
 * on a machine that is so many times slower, where each piece of what a search tells on its way is shown; `slower`: so are the
 * times that the solver tells.
 */
async function visit(options, { atOnce = false, rate = 1, slower = 1 } = {}) {
  const { context, page } = await open(browser, { serviceWorkers: "block", ...options });
  await (await context.newCDPSession(page)).send("Emulation.setCPUThrottlingRate", { rate });
  if (rate > 1) {
    await page.addInitScript(slowDownWorkers);
    await slowSolver(page, slower);
  }
  if (atOnce) {
    await slowDown(context, page);
    await page.addInitScript(pressAtOnce);
  }
  await page.goto(host.url);
  const solve = page.locator(".status .solve > .btn").first();
  await solve.waitFor({ timeout: WAITING });
  if (!atOnce) {
    await page.waitForTimeout(3000);
    await note("app", page);
    await solve.click();
  }
  // The makespan of the opening scene, in any language.
  const isSolved = () => /\b1\d\b/.test(document.querySelector(".status-line .say")?.textContent ?? "");
  await page.waitForFunction(isSolved, undefined, { timeout: WAITING });
  await page.waitForTimeout(3000);
  await note("app", page);
  for (const worker of page.workers()) {
    await note("solver", worker);
  }
  await page.locator("[role=grid]").first().hover();
  await page.waitForTimeout(500);
  await leaveAndComeBack(page);
  await note("app", page);
  await context.close();
}

/**
 * A page breaks down: what then tells it, and saves the work, must not be missing. Whoever has made something has the later
 * part already, since edits are in it.
 */
async function breakDown() {
  const { context, page } = await open(browser, { serviceWorkers: "block" });
  await page.goto(host.url);
  await page.locator(".status .solve > .btn").first().waitFor();
  await page.waitForTimeout(2000);
  await page.evaluate(() => dispatchEvent(new ErrorEvent("error", { error: new WebAssembly.RuntimeError("a visit") })));
  await page.getByRole("alertdialog").waitFor();
  await note("app", page);
  await context.close();
}

/** What a worker tells comes piece by piece, so that each piece is shown; runs inside of the page. */
function slowDownWorkers() {
  const waiting = [];
  let ticking;
  const hand = () => {
    const next = waiting.shift();
    if (next) {
      next();
    } else {
      ticking = clearInterval(ticking);
    }
  };
  const slow = (listener) => function (event) {
    waiting.push(() => listener.call(this, event));
    ticking ??= setInterval(hand, 300);
  };
  const { prototype } = Worker;
  const own = Object.getOwnPropertyDescriptor(prototype, "onmessage");
  Object.defineProperty(prototype, "onmessage", {
    ...own,
    set(listener) {
      own.set.call(this, listener && slow(listener));
    },
  });
  prototype.addEventListener = function (type, listener, ...rest) {
    const heard = type === "message" ? slow(listener) : listener;
    EventTarget.prototype.addEventListener.call(this, type, heard, ...rest);
  };
}

/** Presses the button that solves as soon as it is there; runs inside of the page. */
function pressAtOnce() {
  const look = () => {
    const button = document.querySelector(".status .solve > .btn");
    button?.click();
    if (!button) {
      requestAnimationFrame(look);
    }
  };
  requestAnimationFrame(look);
}

/** Notes what ran so far, where the program is there. */
async function note(program, place) {
  const numbers = await place.evaluate(() => Object.entries(globalThis.givewayProgram ?? {})
    .filter(([name, global]) => name.startsWith("ran") && global.value === 1)
    .map(([name]) => Number(name.slice("ran".length))));
  for (const number of numbers) {
    ran[program].add(number);
  }
}

/** The paths of which nothing ran, none within another, and large functions of no such path. */
function later(functions) {
  const paths = new Map();
  for (const { name, ran } of functions) {
    for (const path of pathsOf(name)) {
      paths.set(path, ran || paths.get(path) === true);
    }
  }
  const listed = [...paths].filter(([path, ran]) => !ran && paths.get(parent(path)) !== false).map(([path]) => path);
  const isListed = new Set(listed);
  const names = new Map();
  for (const { bytes, name, ran } of functions) {
    const before = names.get(name) ?? { bytes: 0, ran: false };
    names.set(name, { bytes: Math.max(bytes, before.bytes), ran: ran || before.ran });
  }
  // Which of its copies a name means may be another one in the next build.
  const copies = new Map();
  for (const { name } of functions) {
    const of = name.replace(COPY, "");
    copies.set(of, (copies.get(of) ?? 0) + 1);
  }
  const isAlone = (name) => !COPY.test(name) && copies.get(name.replace(COPY, "")) === 1 && ![...pathsOf(name)].some((path) => isListed.has(path));
  const alone = [...names].filter(([name, { bytes, ran }]) => !ran && bytes >= LARGE && isAlone(name));
  return [...listed.sort(), ...alone.map(([name]) => `= ${name}`).sort()];
}

/** Each path in a name, with those that it is in, without the crates alone. */
function* pathsOf(name) {
  for (const [found] of name.matchAll(PATHS)) {
    const parts = found.replace(/:+$/, "").split("::");
    for (let length = 2; length <= parts.length; length += 1) {
      yield parts.slice(0, length).join("::");
    }
  }
}

function parent(path) {
  return path.slice(0, path.lastIndexOf("::"));
}
