// Older browsers, and hosts without https, where a browser lacks what it has elsewhere: Chromium
// with each of these things taken away. What a person does goes on; what is not possible
// is told in a sentence.

import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { extname, join } from "node:path";
import { after, before, describe, test } from "node:test";

import { plainTokens } from "../../scripts/plain-tokens.mjs";
import { assertQuiet, launch, open } from "./browser.mjs";
import { dist, root } from "./dist.mjs";
import { flows, MOVING } from "./flow.mjs";
import { Playground } from "./page.mjs";
import { serve } from "./server.mjs";

/** A name of this machine that no browser takes for safe. */
const INSECURE = "giveway.test";

const screens = ["desktop"];

/** Takes the mouse from cell to cell, with every tool that a person first tries. */
async function works(playground) {
  await playground.says(/\b18\b/);
  await playground.pause();
  await playground.pick("Obstacle");
  await playground.stroke([0, 1], [0, 2]);
  await playground.cellTells(0, 1, /^obstacle$/);
  await playground.cellTells(0, 2, /^obstacle$/);
  // A second stroke: the first one left nothing locked.
  await playground.stroke([8, 0], [8, 0]);
  await playground.cellTells(8, 0, /^obstacle$/);
  await playground.press("Undo");
  await playground.press("Undo");
  await playground.cellTells(0, 1, /^free$/);
}

describe("what older browsers lack", () => {
  const flow = flows();

  flow("the places between two frames (Safari before 18.2)", works, {
    screens,
    ...MOVING,
    before: (context) => context.addInitScript(() => {
      delete PointerEvent.prototype.getCoalescedEvents;
    }),
  });

  flow("time limits, copies and what else is new", works, {
    screens,
    ...MOVING,
    before: (context) => context.addInitScript(() => {
      delete AbortSignal.timeout;
      delete AbortSignal.any;
      delete Object.hasOwn;
      delete Object.groupBy;
      delete Promise.withResolvers;
      delete window.structuredClone;
      delete window.OffscreenCanvas;
      delete window.scheduler;
      delete window.FinalizationRegistry;
      delete window.requestIdleCallback;
      delete Element.prototype.checkVisibility;
      for (const name of ["at", "findLast", "findLastIndex", "toReversed", "toSorted", "toSpliced", "with"]) {
        delete Array.prototype[name];
      }
    }),
  });

  flow("a canvas for the picture (Safari before 16.4)", async (playground) => {
    await playground.says(/\b18\b/);
    await playground.act("Save");
    await playground.press("Save picture (PNG)");
    await playground.warns(/could not make the picture/);
    await playground.act("Save");
    await playground.press("Save moving picture (GIF)");
    await playground.warns(/moving picture could not be made/);
  }, {
    screens,
    before: (context) => context.addInitScript(() => {
      delete window.OffscreenCanvas;
    }),
  });

  flow("a browser's function that throws once does not lock the board", async (playground, { page, complaints }) => {
    await playground.says(/\b18\b/);
    await playground.pause();
    await playground.pick("Obstacle");
    const { x, y } = await playground.middleOf(0, 1);
    await page.mouse.move(x, y);
    await page.evaluate(() => {
      const measure = SVGElement.prototype.getBoundingClientRect;
      SVGElement.prototype.getBoundingClientRect = () => {
        delete SVGElement.prototype.getBoundingClientRect;
        throw new Error("for once");
      };
      assertInherited(measure);
      function assertInherited(found) {
        if (found !== Element.prototype.getBoundingClientRect) {
          throw new Error("SVG elements have a function of their own");
        }
      }
    });
    await page.mouse.down();
    await page.mouse.up();
    assert.equal(complaints.length, 1, complaints.join("\n"));
    assert.match(complaints[0], /for once/);
    await playground.stroke([0, 1], [0, 2]);
    await playground.cellTells(0, 2, /^obstacle$/);
    assert.equal(complaints.length, 1, complaints.join("\n"));
  }, { screens, complains: true });

  flow("a clipboard that cannot be read (Firefox before 125)", async (playground) => {
    await playground.says(/\b18\b/);
    await playground.act("Open");
    await playground.press("Paste");
    await playground.warns(/Ctrl V/);
  }, {
    screens,
    before: (context) => context.addInitScript(() => {
      delete Clipboard.prototype.readText;
    }),
  });
});

describe("a host without https", () => {
  let host;
  let browser;
  before(async () => {
    host = await serve(dist);
    browser = await launch([`--host-resolver-rules=MAP ${INSECURE} 127.0.0.1`]);
  });
  after(async () => {
    await browser?.close();
    await host?.close();
  });

  async function visit(t) {
    const opened = await open(browser);
    t.after(() => opened.context.close());
    const playground = new Playground(opened.page, (title) => join(root, "target/e2e", `${title}.png`));
    await playground.goto(host.url.replace("127.0.0.1", INSECURE));
    assert.equal(await opened.page.evaluate(() => isSecureContext), false);
    return { playground, ...opened };
  }

  test("what a person does goes on", async (t) => {
    const { playground, page, complaints } = await visit(t);
    await works(playground);
    await page.reload();
    await playground.board.waitFor();
    assertQuiet(complaints);
  });

  test("what needs https says so", async (t) => {
    const { playground, complaints } = await visit(t);
    await playground.says(/\b18\b/);
    await playground.act("Share");
    await playground.press("Copy link");
    await playground.warns(/https/);
    await playground.key("Escape");
    await playground.press("Dismiss");
    await playground.act("Open");
    await playground.press("Paste");
    await playground.warns(/Ctrl V/);
    assertQuiet(complaints);
  });
});

// What Safari 16.4 and Firefox 128 know. Where a browser ignores what it does not know and the page
// is as good, it may be there.
test("nothing is written that the oldest browsers cannot read", () => {
  const unknown = {
    css: [
      [/[{;]\s*&|^\s*&/m, "nested rules"],
      [/@(scope|starting-style|function|position-try)\b/, "a newer rule"],
      [/:(popover-open|state|open)\b/, "a newer state"],
      [/\b(anchor|anchor-size|if|sibling-index|rgb|hsl|oklch|lab|lch|oklab)\((from\b|--|style\()/, "a newer function"],
      [/\b(interpolate-size|position-anchor|position-area)\s*:/, "a newer property"],
    ],
    js: [
      [/AbortSignal\.(timeout|any)|Promise\.(withResolvers|try)|Array\.fromAsync|Object\.groupBy/, "a newer function"],
      [/\.(toSorted|toReversed|toSpliced)\(|Iterator\.|new Set\([^)]*\)\.(union|difference)/, "a newer method"],
      [/\bimport\b[^;]*\bwith\s*\{|^\s*using\s/m, "newer syntax"],
    ],
  };
  const found = [];
  for (const path of readdirSync(join(root, "static"), { recursive: true })) {
    const patterns = unknown[extname(path).slice(1)] ?? [];
    const text = patterns.length > 0 ? readFileSync(join(root, "static", path), "utf8") : "";
    for (const [pattern, what] of patterns) {
      const at = text.replaceAll(/\/\*.*?\*\//gs, "").match(pattern);
      if (at) {
        found.push(`${path}: ${what}: ${at[0].trim()}`);
      }
    }
  }
  assert.deepEqual(found, []);
});

describe("colours without light-dark()", () => {
  const flow = flows();
  const sheet = (name) => readFileSync(join(root, "static", name), "utf8");

  /** As an older browser reads style sheets: to it the function is none that it knows. */
  const forget = (context) => context.route("**/*.css", async (route) => {
    const response = await route.fetch();
    const body = (await response.text()).replaceAll("light-dark(", "unknown-light-dark(");
    await route.fulfill({ response, body });
  });

  test("are those of the tokens: run scripts/plain-tokens.mjs", () => {
    assert.equal(sheet("tokens-plain.css"), plainTokens(sheet("tokens.css")));
  });

  test("nothing else depends on it", () => {
    const sheets = readFileSync(join(root, "index.html"), "utf8").matchAll(/href="static\/(css\/[\w-]+\.css)"/g);
    for (const [, name] of sheets) {
      for (const rule of sheet(name).match(/[^{}]*\{[^{}]*light-dark\([^{}]*\}/g) ?? []) {
        assert.match(rule, /background: rgb\([^;]*\); background: light-dark/, `${name}: no colour stands before it`);
      }
    }
  });

  for (const theme of ["light", "dark"]) {
    let expected;
    flow(`a ${theme} system with it`, async (playground) => {
      expected = await colours(playground.page);
      assert.ok(expected.length > 180, `found ${expected.length} of them`);
    }, { screens, theme });
    flow(`a ${theme} system without it`, async (playground) => {
      assert.deepEqual(await colours(playground.page), expected);
      await playground.says(/\b18\b/);
      await playground.picture(`plain-${theme}`);
    }, { screens, theme, before: forget });
  }

  /** What each token is for, as the browser understands it: by the system's theme, then by one that was chosen. */
  function colours(page) {
    const names = [...new Set(sheet("tokens.css").match(/--[\w-]+(?=:)/g))];
    return page.evaluate((all) => {
      const root = document.documentElement;
      const probe = document.body.appendChild(document.createElement("i"));
      const found = [];
      for (const chosen of [undefined, "light", "dark"]) {
        if (chosen) {
          root.dataset.theme = chosen;
        }
        for (const name of all) {
          for (const property of ["color", "box-shadow"]) {
            probe.style.setProperty(property, "inherit");
            const before = getComputedStyle(probe)[property];
            probe.style.setProperty(property, `var(${name})`);
            const value = getComputedStyle(probe)[property];
            if (value !== before && CSS.supports(property, value)) {
              found.push(`${chosen ?? "system"}: ${name} as ${property}: ${value}`);
            }
          }
        }
      }
      probe.remove();
      delete root.dataset.theme;
      return found;
    }, names);
  }
});
