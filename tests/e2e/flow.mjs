// A flow: what a person does on a fresh page, on the screens named, without one
// complaint of the page.

import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";

import { assertQuiet, launch, open } from "./browser.mjs";
import { dist, root } from "./dist.mjs";
import { Playground } from "./page.mjs";
import { serve } from "./server.mjs";

/** Where pictures are left, to be looked at. */
const PICTURES = join(root, "target/e2e");

/** What one flow may take on a machine that does other things too, in milliseconds. */
const PATIENCE = 120_000;

const SCREENS = {
  desktop: { width: 1440, height: 900 },
  phone: { width: 390, height: 844, hasTouch: true, isMobile: true, deviceScaleFactor: 2 },
};

/** A file of the project's test data, as the file chooser takes it. */
export function sample(path) {
  return join(root, "tests/data", path);
}

/** The scene in such a file. */
export function scene(path) {
  return JSON.parse(readFileSync(sample(path), "utf8"));
}

/**
 * Gives the function that declares flows; they share a browser and a host.
 * @returns {(name: string, act: (playground: Playground, surroundings: object) => Promise<void>, options?: object) => void}
 *   `options.screens` are those of a desktop and a phone unless told, `timeout` is in milliseconds; what else is in
 *   `options` is for the browser's context. With `complains` the page may complain, which
 *   `act` judges. `before` is called before the page is opened.
 */
export function flows() {
  let host;
  let browser;
  before(async () => {
    mkdirSync(PICTURES, { recursive: true });
    host = await serve(dist);
    browser = await launch();
  });
  after(async () => {
    await browser?.close();
    await host?.close();
  });

  return (name, act, { screens = Object.keys(SCREENS), complains = false, before: prepare, timeout = PATIENCE, ...options } = {}) => {
    for (const screen of screens) {
      test(`${name} (${screen})`, { timeout }, async () => {
        // What a service worker fetches cannot be changed on its way.
        const opened = await open(browser, { serviceWorkers: "block", ...SCREENS[screen], ...options });
        const { context, page, complaints } = opened;
        const playground = new Playground(page, (title) => join(PICTURES, `${title}-${screen}.png`));
        try {
          await prepare?.(context);
          await playground.goto(host.url);
          await act(playground, { ...opened, host, screen });
          if (!complains) {
            assertQuiet(complaints);
          }
          await playground.fits();
        } catch (error) {
          await playground.picture(`failed-${name.replaceAll(/\W+/g, "-")}`).catch(() => undefined);
          throw error;
        } finally {
          await context.unrouteAll({ behavior: "ignoreErrors" });
          await context.close();
        }
      });
    }
  };
}
