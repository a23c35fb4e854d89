// The package for JavaScript: whole, small, typed, and its examples run.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { brotliCompress } from "node:zlib";

import { settings } from "../../scripts/release/settings.mjs";
import { assertQuiet, launch, open } from "../e2e/browser.mjs";
import { serve } from "../e2e/server.mjs";
import { eventually } from "../e2e/wait.mjs";
import { expectFile } from "../release/house.mjs";

const brotli = promisify(brotliCompress);
const root = fileURLToPath(new URL("../..", import.meta.url));
const folder = process.env.GIVEWAY_PACKAGE ?? join(root, "target/package");
const examples = join(root, "crates/giveway-wasm/examples");
const read = (path) => readFileSync(join(folder, path), "utf8");
const seed = (name) => join(root, "tests/data/seed", name);

/** What a page loads of the package. */
const LOADED = ["web/giveway_wasm_bg.wasm", "web/giveway_wasm.js", "worker/client.js", "worker/solver.js"];
/** What that may be, compressed by brotli, bytes. */
const LIMIT = 946_000;

/** A folder in which the package is installed, with the examples. */
let site;
/** The sizes of what a page loads: compressing takes seconds, and goes on beside the other tests. */
let compressed;

before(() => {
  compressed = Promise.all(LOADED.map(async (path) => (await brotli(readFileSync(join(folder, path)))).length));
  site = mkdtempSync(join(tmpdir(), "giveway-package-"));
  mkdirSync(join(site, "node_modules"));
  symlinkSync(folder, join(site, "node_modules/giveway"));
  symlinkSync(folder, join(site, "giveway"));
  cpSync(examples, site, { recursive: true });
});

after(() => rmSync(site, { recursive: true, force: true }));

describe("the package", () => {
  test("has all that its exports name, types, licences and three examples", () => {
    const { exports, files, license } = JSON.parse(read("package.json"));
    const paths = Object.values(exports).flatMap((to) => (typeof to === "string" ? [to] : Object.values(to)));
    for (const path of [...paths, ...files]) {
      assert.ok(existsSync(join(folder, path)), `${path} is not there`);
    }
    assert.equal(license, "MIT OR Apache-2.0");
    assert.equal(read("README.md").match(/^```(js|html)$/gm).length, 3);
    assert.match(read("README.md"), /\d+ kB, compressed by brotli/);
  });

  test("holds what is listed, under the version of the workspace", () => {
    const [packed] = JSON.parse(execFileSync("npm", ["pack", "--dry-run", "--json", "--ignore-scripts"], { cwd: folder, encoding: "utf8" }));
    assert.equal(`${packed.name} ${packed.version}`, `giveway ${settings().version}`);
    expectFile("tests/release/contents/npm.txt", `${packed.files.map(({ path }) => path).sort().join("\n")}\n`);
  });

  test("has types without any", () => {
    for (const name of ["types", "web", "worker"]) {
      const code = read(`types/${name}.d.ts`).replace(/\/\*\*[^]*?\*\//g, "");
      assert.doesNotMatch(code, /\bany\b/, name);
    }
  });

  test("type-checks in strict mode in the examples, and refuses what is wrong", () => {
    // Of Node's own types the example needs these only.
    writeFileSync(join(site, "node.d.ts"), `declare module "node:fs" {
  export function readFileSync(path: string, encoding: "utf8"): string;
}
declare const process: { argv: string[] };
`);
    const options = ["--strict", "--noEmit", "--allowJs", "--checkJs", "--target", "es2022",
      "--lib", "es2022,dom", "--module", "nodenext", "--moduleResolution", "nodenext"];
    const tsc = createRequire(import.meta.url).resolve("typescript/bin/tsc");
    writeFileSync(join(site, "wrong.mts"), `import { solve } from "giveway";
solve({ scene: { giveway: 1, map: [".."], agents: [{ name: "a", start: [0], goal: [1, 0] }] } });
const right = solve({ scene: { giveway: 1, map: [".."], agents: [] } });
right.plan.paths;
`);
    // In one run: it spends most of its time on the libraries.
    const files = ["node.d.ts", "node.mjs", "typed.mts", "wrong.mts"];
    const { stdout, stderr } = spawnSync(process.execPath, [tsc, ...options, ...files], { cwd: site, encoding: "utf8" });
    const complaints = [...stdout.matchAll(/^(\S.*?)(?:\((\d+),\d+\))?: error (TS\d+)/gm)].map(([, file, line, code]) => `${file} ${line} ${code}`);
    assert.deepEqual(complaints, ["wrong.mts 2 TS2769", "wrong.mts 4 TS18047"], `${stdout}${stderr}`);
  });

  test("runs in Node", () => {
    const args = ["node.mjs", seed("warehouse.json"), seed("scenario-6.json")];
    const said = execFileSync(process.execPath, args, { cwd: site, encoding: "utf8" });
    assert.match(said, /: optimal\n {2}the judge: valid, makespan 18, sum of costs 35\n {2}why not sooner\? necessary/);
    assert.match(said, /: impossible\n/);
    const [, first] = /^```js\n([^]*?)^```$/m.exec(read("README.md"));
    writeFileSync(join(site, "readme.mjs"), first);
    const told = execFileSync(process.execPath, ["readme.mjs"], { cwd: site, encoding: "utf8" });
    assert.match(told, /^optimal 3\nnecessary /);
  });

  test("does not grow", async (t) => {
    const sizes = await compressed;
    const total = sizes.reduce((a, b) => a + b);
    sizes.forEach((size, i) => t.diagnostic(`${(size / 1000).toFixed(1)} kB  ${LOADED[i]}`));
    t.diagnostic(`${(total / 1000).toFixed(1)} kB in all, of ${LIMIT / 1000} kB`);
    assert.ok(total <= LIMIT, `${total} bytes are more than ${LIMIT}`);
  });
});

describe("the package in Chromium", () => {
  let browser;
  let host;

  before(async () => {
    browser = await launch();
    host = await serve(site, "/lessons/");
  });

  after(async () => {
    await browser?.close();
    await host?.close();
  });

  async function visit(path, look) {
    const { context, page, complaints } = await open(browser);
    await page.goto(`${host.url}${path}`);
    try {
      await look(page);
      assertQuiet(complaints);
    } finally {
      await context.close();
    }
  }

  test("the example page is short, solves, and stops at once", () => visit("page.html", async (page) => {
    assert.ok(readFileSync(join(examples, "page.html"), "utf8").split("\n").length <= 60);
    const status = page.getByRole("status");
    const says = (pattern) => eventually(`to say ${pattern}`, () => status.textContent(), (text) => pattern.test(text));
    await page.getByRole("button", { name: "Solve" }).click();
    await says(/^optimal: makespan \d+/);
    const plan = await page.locator("#plan").textContent();
    assert.match(plan, /^a {2}\(0,0\) .*\(4,2\)\nb {2}\(0,2\) .*\(4,0\)$/);
    await page.getByRole("textbox").fill("aA.\nbB");
    await page.getByRole("button", { name: "Solve" }).click();
    await says(/map/);
    const letters = [..."abcdefghijklmnopqrstuvwxyz"];
    const rows = [letters.join(""), ".".repeat(26), letters.reverse().join("").toUpperCase()];
    await page.getByRole("textbox").fill(rows.join("\n"));
    await page.getByRole("button", { name: "Solve" }).click();
    await page.getByRole("button", { name: "Stop" }).click();
    await says(/^Stopped\.$/);
    await page.getByRole("textbox").fill("a.A");
    await page.getByRole("button", { name: "Solve" }).click();
    await says(/^optimal: makespan 2/);
  }));

  test("the notebook runs from top to bottom, and anew from a cell", () => visit("notebook.html", async (page) => {
    await page.locator("body[data-done]").waitFor({ timeout: 60_000 });
    const results = () => page.locator(".result").allTextContents();
    const [map, answer, why, report] = await results();
    assert.equal(map, "....\n#.##");
    assert.match(answer, /"status": "optimal"/);
    assert.ok(why.length > 20, why);
    assert.match(report, /^(proof|search): There is no plan/);
    await page.locator(".code").first().fill('scene = { giveway: 1, map: ["..."], agents: [{ name: "a", start: [0, 0], goal: [2, 0] }] }; return 1;');
    await page.getByRole("button", { name: "Run" }).first().click();
    await eventually("the next cell to follow", async () => (await results())[1], (text) => /"makespan": 2/.test(text));
  }));

  test("a worker keeps its order, is ended by a signal, and goes on after an error", () => visit("page.html", async (page) => {
    const hard = JSON.parse(readFileSync(join(root, "tests/data/mmapf/A17_mm_20x20_o15_a30.json"), "utf8"));
    const easy = JSON.parse(readFileSync(seed("scenario-1.json"), "utf8"));
    const came = await page.evaluate(async ({ hard, easy }) => {
      const { Giveway } = await import(new URL("./giveway/worker/client.js", location.href).href);
      const giveway = new Giveway();
      const stop = new AbortController();
      const told = [];
      const outcome = (promise) => promise.then(({ status, valid }) => status ?? valid, ({ name, code, place }) => ({ name, code, place }));
      const jobs = [
        giveway.solve({ scene: hard }, { signal: stop.signal, onProgress: (event) => { told.push(event.event); stop.abort(); } }),
        giveway.solve({ scene: easy }),
        giveway.solve({ scene: { ...easy, agents: [{ name: "x", start: [99, 0], goal: [0, 0] }] } }),
        giveway.check({ scene: easy, plan: { giveway: 1, paths: {} } }),
        giveway.solve({ scene: hard, limits: { seconds: 0.3 } }),
        giveway.solve({ scene: () => 1 }),
        giveway.solve({ scene: easy }, { signal: AbortSignal.abort() }),
      ].map(outcome);
      const first = await Promise.all(jobs);
      const waiting = outcome(giveway.solve({ scene: hard }));
      giveway.close();
      return { first, closed: await waiting, told: told.length, again: await outcome(giveway.solve({ scene: easy })) };
    }, { hard, easy });
    const [aborted, solved, bad, broken, short, uncopied, early] = came.first;
    assert.equal(aborted.name, "AbortError");
    assert.ok(came.told >= 1);
    assert.equal(solved, "optimal");
    assert.deepEqual(bad, { name: "GivewayError", code: "bad-scene", place: "scene.agents[0].start" });
    assert.equal(broken, false);
    assert.match(short, /^(feasible|unknown)$/);
    assert.equal(uncopied.name, "DataCloneError");
    assert.equal(early.name, "AbortError");
    assert.equal(came.closed.name, "AbortError");
    assert.equal(came.again, "optimal");
  }));
});
