// `./x serve` as somebody uses it who changes the page: it builds, solves, and shows what
// was changed; what does not compile leaves the page as it was. Takes minutes.

import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { after, before, test } from "node:test";

import { assertQuiet, launch, open } from "../../e2e/browser.mjs";
import { Playground } from "../../e2e/page.mjs";

let source;
let server;
let told = "";
let browser;

/** Waits until the server has told this, after what it told before. */
async function tells(pattern, before = 0) {
  for (;;) {
    const found = told.slice(before).match(pattern);
    if (found) {
      return found;
    }
    assert.equal(server.exitCode, null, told);
    await new Promise((done) => setTimeout(done, 100));
  }
}

function edit(path, from, to) {
  const file = join(source, path);
  const text = readFileSync(file, "utf8");
  assert.ok(text.includes(from), `${path} has no ${from}`);
  writeFileSync(file, text.replace(from, () => to));
}

before(async () => {
  source = mkdtempSync(join(tmpdir(), "giveway-source-"));
  execFileSync("sh", ["-c", `git ls-files -z | tar --null -T - -cf - | tar -xf - -C "${source}"`]);
  const env = { ...process.env, CARGO_TARGET_DIR: resolve("target/serve-test") };
  server = spawn(process.execPath, [join(source, "scripts/serve/main.mjs"), "--port", "0"], { env });
  for (const stream of [server.stdout, server.stderr]) {
    stream.on("data", (text) => { told += text; });
  }
  browser = await launch();
});

after(async () => {
  await browser?.close();
  server.kill();
  rmSync(source, { recursive: true });
});

test("it is built, served, and shows what changes", { timeout: 1_200_000 }, async () => {
  const [, url] = await tells(/The playground is at (\S+)/);
  const { page, complaints } = await open(browser);
  const playground = new Playground(page, (title) => `target/e2e/serve-${title}.png`);
  await playground.goto(url);
  await playground.example("Crossing");
  await playground.says(/^Optimal/);
  await playground.picture("first");

  let before = told.length;
  edit("static/css/base.css", "body", "html { --changed-here: 7px; }\nbody");
  await tells(/Built in/, before);
  await page.waitForFunction(() => getComputedStyle(document.documentElement).getPropertyValue("--changed-here").trim() === "7px");

  before = told.length;
  edit("web/src/main.rs", "fn main() {", "fn main() { this does not compile");
  await tells(/the page stays as it was/, before);
  await playground.board.waitFor();

  before = told.length;
  edit("web/src/main.rs", "fn main() { this does not compile", "fn main() { gloo::utils::document_element().set_id(\"changed\");");
  await tells(/Built in/, before);
  await page.locator("html#changed").waitFor();
  await playground.board.waitFor();
  assertQuiet(complaints);
});
