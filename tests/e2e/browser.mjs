// Chromium without a window, and pages in it that tell of every complaint.

import { createRequire } from "node:module";
import assert from "node:assert/strict";

// Not `import`, which does not look where NODE_PATH points: `./x` keeps the packages
// outside of the clone.
const { chromium } = createRequire(import.meta.url)("playwright-core");

const FLAGS = [
  "--headless",
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** The system's own Chromium. */
export function launch(flags = []) {
  const executablePath = process.env.GIVEWAY_CHROMIUM ?? "/usr/bin/chromium";
  return chromium.launch({ executablePath, args: [...FLAGS, ...flags] });
}

/**
 * A page in a browser context of its own: nothing is kept from one test to the next.
 * @param browser what `launch` gave
 * @param options `width`, `height`, `theme` ("light" or "dark"), `welcome` for a person who was never here, and what
 *   a context takes
 * @param heard where complaints go
 */
export async function open(browser, { width = 1440, height = 900, theme = "light", welcome = false, ...options } = {}, heard = []) {
  const context = await browser.newContext({
    viewport: { width, height },
    colorScheme: theme,
    ...options,
  });
  if (!welcome) {
    await context.addInitScript(() => {
      try {
        localStorage.setItem("giveway.welcome", "seen");
      } catch {
        // Where nothing can be kept it is there.
      }
    });
  }
  const page = await context.newPage();
  return { context, page, complaints: complaintsOf(page, heard) };
}

/** Every error on the console, uncaught or printed; violations of the policy are among them. They join others, if there are. */
export function complaintsOf(page, complaints = []) {
  page.on("pageerror", (error) => complaints.push(`uncaught: ${error.stack ?? error.message}`));
  page.on("crash", () => complaints.push("the page crashed"));
  page.on("console", (message) => {
    if (message.type() === "error") {
      complaints.push(`console: ${message.text()} (${message.location().url})`);
    }
  });
  return complaints;
}

/** Fails when the page complained. */
export function assertQuiet(complaints) {
  assert.deepEqual(complaints, [], "the page complained");
}
