// The built folder on a plain static host: at any path, under its policy, without a
// network, and when a new version is put in its place.

import assert from "node:assert/strict";
import { cp, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";

import { assertQuiet, launch, open } from "./browser.mjs";
import { dist } from "./dist.mjs";
import { Playground } from "./page.mjs";
import { serve } from "./server.mjs";

describe("the built folder on a static host", () => {
  let browser;
  before(async () => {
    browser = await launch();
  });
  after(() => browser.close());

  for (const base of ["/", "/some/where/"]) {
    test(`works under ${base}`, async (t) => {
      const { host, page, complaints } = await visit(t, browser, base);
      await new Playground(page).goto(host.url);
      assert.deepEqual(host.missing, []);
      assertQuiet(complaints);
    });
  }

  test("has a policy that lets nothing in from outside", async (t) => {
    const { host, page, complaints } = await visit(t, browser);
    await new Playground(page).goto(host.url);
    assertQuiet(complaints);
    const policy = await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute("content");
    assert.match(policy, /^default-src 'none'; script-src 'self' 'wasm-unsafe-eval';/);
    assert.doesNotMatch(policy, /nonce|unsafe-inline|'unsafe-eval'/);
    const ran = await page.evaluate(() => {
      const script = document.createElement("script");
      script.textContent = "window.intruder = true";
      document.body.append(script);
      return window.intruder === true;
    });
    assert.equal(ran, false, "an inline script ran");
    assert.match(complaints.join(), /Content Security Policy/);
  });

  test("works without a network after the first visit", async (t) => {
    const { host, page, complaints } = await visit(t, browser);
    const playground = new Playground(page);
    await playground.goto(host.url);
    await playground.kept();
    await host.close();
    await playground.reload();
    assertQuiet(complaints);
    const worker = await page.locator('meta[name="giveway-worker"]').getAttribute("content");
    assert.equal(await fetched(page, worker), 200);
  });

  test("takes a new version at the next visit, and leaves an open page its own", async (t) => {
    const newer = await mkdtemp(join(tmpdir(), "giveway-"));
    t.after(() => rm(newer, { recursive: true }));
    await cp(dist, newer, { recursive: true });
    await change(join(newer, "index.html"), /<title>/, "<title>New: ");
    await change(join(newer, "service-worker.js"), /VERSION = "/, '$&new-');
    const worker = await moveWorker(newer);

    const { host, page, complaints } = await visit(t, browser);
    const playground = new Playground(page);
    await playground.goto(host.url);
    await playground.kept();
    const old = await page.locator('meta[name="giveway-worker"]').getAttribute("content");

    host.folder = newer;
    // The visit that finds the new version still shows the one that is there.
    await playground.reload();
    assert.doesNotMatch(await page.title(), /^New: /);
    await page.evaluate(async () => {
      const registration = await navigator.serviceWorker.ready;
      await registration.update();
    });
    await page.waitForFunction(async () => (await caches.keys()).length === 2);
    await page.waitForFunction(async () => {
      const registration = await navigator.serviceWorker.ready;
      return !registration.installing && !registration.waiting && registration.active.state === "activated";
    });
    assert.equal(await fetched(page, old), 200, "the open page lost its worker");

    await playground.reload();
    assert.match(await page.title(), /^New: /);
    assert.equal(await page.locator('meta[name="giveway-worker"]').getAttribute("content"), worker);
    assertQuiet(complaints);
    assert.deepEqual(host.missing, []);
  });
});

/** The built folder on a host, and a page that is not there yet. */
async function visit(t, browser, base) {
  const host = await serve(dist, base);
  t.after(() => host.close());
  const opened = await open(browser);
  t.after(() => opened.context.close());
  return { host, ...opened };
}

async function change(file, pattern, replacement) {
  const text = await readFile(file, "utf8");
  assert.match(text, pattern, file);
  await writeFile(file, text.replace(pattern, replacement));
}

/** Gives the worker of a copied page another path, as one that has changed would have. */
async function moveWorker(folder) {
  const page = await readFile(join(folder, "index.html"), "utf8");
  const [, path] = page.match(/(worker-[0-9a-f]+)\/worker_loader\.js/);
  const moved = `worker-${"0123456789abcdef"}`;
  await cp(join(folder, path), join(folder, moved), { recursive: true });
  await rm(join(folder, path), { recursive: true });
  await change(join(folder, "index.html"), new RegExp(path, "g"), moved);
  await change(join(folder, "service-worker.js"), new RegExp(path, "g"), moved);
  return `./${moved}/worker_loader.js`;
}

function fetched(page, path) {
  return page.evaluate((address) => fetch(address).then((response) => response.status), path);
}
