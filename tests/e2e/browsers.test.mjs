// What a person does first, in Firefox and in WebKit, with and without what their older
// versions lack. Where a browser is not installed, its tests are skipped, which the runner
// tells; old-browsers.test.mjs has the same things in Chromium.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { writeFile } from "node:fs/promises";
import { join } from "node:path";
import { describe, test } from "node:test";

import { root } from "./dist.mjs";
import * as firefox from "./driver/firefox.mjs";
import { Person } from "./driver/person.mjs";
import { variant } from "./driver/variant.mjs";
import * as webkit from "./driver/webkit.mjs";
import { serve } from "./server.mjs";
import { eventually } from "./wait.mjs";

const PICTURES = join(root, "target/e2e");

/** A name that no browser takes for safe. */
const INSECURE = "giveway.test";

/** What one flow may take on a machine that does other things too, in milliseconds. */
const timeout = 120_000;

const size = { width: 1280, height: 800 };

for (const browser of [firefox, webkit]) {
  describe(browser.name, { skip: browser.missing }, () => {
    test("plays, paints, solves, answers, undoes, keeps", { timeout }, async (t) => {
      await mainFlow(await visit(t, browser, {}));
    });

    test("the same over plain http", { timeout }, async (t) => {
      await mainFlow(await visit(t, browser, { insecure: true }));
    });

    test("the same as an older version, dark", { timeout }, async (t) => {
      await mainFlow(await visit(t, browser, {
        dark: true,
        before: () => {
          delete PointerEvent.prototype.getCoalescedEvents;
          delete AbortSignal.timeout;
          delete window.OffscreenCanvas;
        },
        sheet: (text) => text.replaceAll("light-dark(", "unknown-light-dark("),
      }));
    });
  });
}

/** Opens the page in a browser of its own; `insecure` is over plain http, from another machine as it seems. */
async function visit(t, browser, { dark = false, insecure = false, ...changes }) {
  mkdirSync(PICTURES, { recursive: true });
  const host = await serve(await variant(t, changes));
  t.after(() => host.close());
  const { port } = new URL(host.url);
  const window = await browser.launch({ ...size, dark, proxy: insecure ? Number(port) : undefined });
  t.after(() => window.close());
  const person = new Person(window);
  await person.goto(insecure ? host.url.replace(/127.0.0.1:\d+/, INSECURE) : host.url);
  assert.equal(await window.run(() => isSecureContext), !insecure);
  const picture = async (title) => {
    const path = join(PICTURES, `${browser.name}-${title}-${dark ? "dark" : "light"}.png`);
    await writeFile(path, await window.picture());
  };
  return { person, window, dark, picture };
}

async function mainFlow({ person, window, dark, picture }) {
  await person.says(/\b18\b/);
  const from = await person.now();
  await eventually("the time to pass", () => person.now(), (now) => now !== from);
  await person.press("button", /^Pause$/);
  await person.find("button", /^Play$/);
  await looksRight(window, dark);
  await picture("opened");

  await person.press("button", /^Obstacle$/);
  await person.stroke([0, 1], [0, 2]);
  await person.cellTells([0, 1], /obstacle/);
  await person.cellTells([0, 2], /obstacle/);
  await person.press("button", /^Undo$/);
  await person.cellTells([0, 1], /free/);
  await person.stroke([4, 0], [4, 0]);
  await person.cellTells([4, 0], /obstacle/);
  await person.press("button", /^Solve$/);
  await person.says(/\b(1\d|2\d)\b/);
  await person.press("button", /^Select/);
  await person.press("button", /^Why does it take this long\?/);
  await person.find("heading", /^Why does it take this long\?/);
  await eventually("an answer", () => window.run(
    () => document.querySelector("[aria-label=Inspector] [aria-live=polite]")?.textContent,
  ));
  await picture("answered");
  await person.key("Escape");

  await quiet(window);
  await person.reload();
  await person.cellTells([4, 0], /obstacle/);
  await quiet(window);
}

/** The colours are there, and those of the theme: nothing black on a white page. */
async function looksRight(window, dark) {
  const look = await window.run(() => {
    const style = (selector) => getComputedStyle(document.querySelector(selector));
    return {
      page: style("body").backgroundColor,
      floor: style("[aria-label=Board] .floor").fill,
      obstacle: style("[aria-label=Board] .obst").fill,
      text: style("body").color,
    };
  });
  assert.deepEqual(look, dark
    ? { page: "rgb(18, 20, 23)", floor: "rgb(35, 39, 45)", obstacle: "rgb(12, 14, 16)", text: "rgb(236, 238, 241)" }
    : { page: "rgb(244, 245, 243)", floor: "rgb(255, 255, 255)", obstacle: "rgb(43, 49, 59)", text: "rgb(24, 29, 38)" });
}

async function quiet(window) {
  assert.deepEqual(await window.run(() => window.complaints), [], "the page complained");
}
