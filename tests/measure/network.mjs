// The first visit over a slow network: what comes when.

import { launch, open } from "../e2e/browser.mjs";
import { dist } from "../e2e/dist.mjs";
import { serve } from "../e2e/server.mjs";
import { eventually } from "../e2e/wait.mjs";
import { figure, middle } from "./figure.mjs";
import { solveAtOnce, watch } from "./watch.mjs";

/** A phone far from its mast, as tools for measuring pages have it. */
const SLOW = { offline: false, latency: 150, downloadThroughput: 1_600_000 / 8, uploadThroughput: 750_000 / 8 };
const NETWORK = "1.6 Mbit/s, 150 ms";
const TIMES = 5;

/** Nothing cached; the host compresses by brotli. */
export async function network() {
  const host = await serve(dist, "/", { compress: true });
  await fill(host);
  const seen = [];
  for (let time = 0; time < TIMES; time += 1) {
    seen.push(await visit(host.url));
  }
  await host.close();
  const at = (what) => middle(seen.map((times) => times[what]));
  return [
    figure(`first paint at ${NETWORK}`, at("painted"), "ms", { most: 1000 }),
    figure(`until a robot moves at ${NETWORK}`, at("moving"), "ms", { most: 2500 }),
    figure(`until the application is there at ${NETWORK}`, at("running"), "ms", { most: 4500 }),
    figure(`until Solve, pressed at once, is answered at ${NETWORK}`, at("solved"), "ms", { most: 4500 }),
  ];
}

/** One visit without a slow network, so that the host has compressed all. */
async function fill(host) {
  const browser = await launch();
  const { page } = await open(browser, { serviceWorkers: "block" });
  await page.addInitScript(watch);
  await page.addInitScript(solveAtOnce);
  await page.goto(host.url);
  await eventually("an answer", () => page.evaluate(() => window.seen.solved), Boolean, 60_000);
  await browser.close();
}

/** It holds for the page, not for its workers: they fetch some 3 kB of their own, and have what they run from the page. */
export async function slowDown(context, page) {
  const session = await context.newCDPSession(page);
  await session.send("Network.enable");
  await session.send("Network.emulateNetworkConditions", SLOW);
}

/** Gives the solver's worker a clock that runs so many times faster: what it tells of its time is that of a slower machine. */
export function slowSolver(page, times) {
  return page.route(/\/worker(-[0-9a-f]+)?\.js$/, async (route) => {
    const response = await route.fetch();
    const clock = `{ const now = performance.now.bind(performance); performance.now = () => ${times} * now(); }\n`;
    await route.fulfill({ response, body: clock + await response.text() });
  });
}

async function visit(url) {
  const browser = await launch();
  try {
    const { context, page } = await open(browser, { serviceWorkers: "block" });
    await slowDown(context, page);
    await page.addInitScript(watch);
    await page.addInitScript(solveAtOnce);
    await page.goto(url, { waitUntil: "commit" });
    const seen = await eventually("an answer", () => page.evaluate(() => window.seen), ({ solved }) => solved, 60_000);
    const painted = await page.evaluate(() => performance.getEntriesByName("first-contentful-paint")[0].startTime);
    return { ...seen, painted };
  } finally {
    await browser.close();
  }
}
