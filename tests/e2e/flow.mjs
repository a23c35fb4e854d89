// A flow: what a person does on a fresh page, on the screens named, without one
// complaint of the page.

import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";

import { assertQuiet } from "./browser.mjs";
import { root } from "./dist.mjs";
import { Playground } from "./page.mjs";
import { Stage } from "./stage.mjs";

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

/** Whether all is run, also what takes long. */
export const isLong = Boolean(process.env.GIVEWAY_LONG);

/** Both forms of the page. */
export const BOTH = Object.keys(SCREENS);

/** Each theme in one form of the page: what depends on both together is rare, and found where all is run. */
export const LOOKS = [
  { theme: "light", screens: isLong ? BOTH : ["desktop"] },
  { theme: "dark", screens: isLong ? BOTH : ["phone"] },
];

/** For flows about what moves: the others do without, since drawing each frame takes half a processor, but where all is run. */
export const MOVING = { reducedMotion: "no-preference" };
const STILL = { reducedMotion: "reduce" };

const stage = new Stage();
after(() => stage.close());

/**
 * Gives the function that declares flows.
 * @returns {(name: string, act: (playground: Playground, surroundings: object) => Promise<void>, options?: object) => void}
 *   `options.screens` is a desktop unless told, and both forms where all is run; `timeout` is in milliseconds; what
 *   else is in `options` is for `Stage.visit`. With `complains` the page may complain, which `act` judges. `before`
 *   is called before the page is opened; what it adds to every page is taken away by the `dispose` of what it gives.
 */
export function flows() {
  return (name, act, { screens = isLong ? BOTH : ["desktop"], complains = false, before: prepare, timeout = PATIENCE, ...options } = {}) => {
    for (const screen of screens) {
      test(`${name} (${screen})`, { timeout }, async () => {
        mkdirSync(PICTURES, { recursive: true });
        const visit = await stage.visit({ ...SCREENS[screen], ...(isLong ? MOVING : STILL), ...options });
        const { context, page, host, complaints } = visit;
        const playground = new Playground(page, (title) => join(PICTURES, `${title}-${screen}.png`));
        let isWell = false;
        try {
          const added = await prepare?.(context);
          await playground.goto(host.url);
          await act(playground, { context, page, host, complaints, screen });
          if (!complains) {
            assertQuiet(complaints);
            assert.equal(await playground.rebuilt(), 0, "nothing else has changed the page, but it was built anew");
          }
          await playground.fits();
          await added?.dispose();
          isWell = true;
        } catch (error) {
          await playground.picture(`failed-${name.replaceAll(/\W+/g, "-")}`).catch(() => undefined);
          throw error;
        } finally {
          await visit.end(isWell);
        }
      });
    }
  };
}
