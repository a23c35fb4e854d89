// What all figures have in common: a page to measure, and what a figure is.

import { launch, open } from "../e2e/browser.mjs";
import { Playground } from "../e2e/page.mjs";
import { Tab } from "./process.mjs";
import { frames, watch } from "./watch.mjs";

/** What the page says once it has proved a plan. */
export const SOLVED = /^Optimal: /;

/** How long playing is watched, in seconds. */
const PLAYING = 5;

/** A browser of its own for every figure, so that nothing is warm but what should be. */
export async function inPage(url, act) {
  const browser = await launch();
  try {
    const { context, page } = await open(browser, { serviceWorkers: "block" });
    await context.addInitScript(watch);
    const playground = new Playground(page);
    await playground.goto(url);
    return await act(playground, browser);
  } finally {
    await browser.close();
  }
}

/** One figure with what it should be: `most`, `least`, or `below`, for what is not told when it is less. */
export function figure(what, value, unit, { digits = 0, ...target }) {
  return { what, value, unit, digits, ...target };
}

export function middle(values) {
  return values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)];
}

/** Frames a second while a plan plays, of which there should be `least`, and what each costs. */
export async function smoothness({ page }, browser, what, least) {
  const tab = await Tab.of(browser);
  const cpu = tab.mainSeconds();
  const times = await page.evaluate(frames, PLAYING);
  const busy = tab.mainSeconds() - cpu;
  const count = times.length - 1;
  const seconds = (times.at(-1) - times[0]) / 1000;
  return [
    figure(`frames per second, ${what}`, count / seconds, "", { least }),
    figure("main thread per frame of these", (busy * 1000) / count, "ms of CPU", { most: 1000 / Math.min(least + 2, 60), digits: 1 }),
  ];
}
