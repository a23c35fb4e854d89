// The built folder on a plain static host: at any path, under its policy, without a
// network, and when a new version is put in its place.

import assert from "node:assert/strict";
import { cp, mkdtemp, readFile, rename, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";

import { assertQuiet, launch, open } from "./browser.mjs";
import { dist } from "./dist.mjs";
import { HALL, LATE, own, plan } from "./elsewhere.mjs";
import { Playground } from "./page.mjs";
import { serve } from "./server.mjs";
import { eventually } from "./wait.mjs";

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
    assert.equal(await fetched(page, await workerOf(page)), 200);
  });

  // A first visit does not need that, so its program is in the later part.
  test("works without a network on what a person was in the middle of", async (t) => {
    const { host, page, complaints } = await visit(t, browser);
    const playground = new Playground(page);
    await playground.goto(host.url);
    await playground.kept();
    await playground.open(own("hall.json", HALL), plan("hall-plan.json", LATE));
    await playground.shows("hall");
    await playground.button("How good is this plan?").click();
    await playground.says(/^This plan keeps every rule\./);
    await host.close();
    await playground.reload();
    await playground.says(/^This plan keeps every rule\./);
    assertQuiet(complaints);
  });

  test("shows a new version at the next visit, and leaves an open page its own", async (t) => {
    const { host, page, complaints } = await visit(t, browser);
    const playground = new Playground(page);
    await playground.goto(host.url);
    await playground.kept();
    const old = await workerOf(page);

    const deployed = await newVersion(t);
    host.folder = deployed.folder;
    assert.equal(await fetched(page, old), 200, "the open page lost its worker");
    await playground.reload();
    assert.match(await page.title(), /^New: /);
    assert.equal(await workerOf(page), deployed.worker);
    assert.equal(await fetched(page, deployed.worker), 200);
    assertQuiet(complaints);
    assert.deepEqual(host.missing, []);
  });

  test("keeps a new version once no page of the old one is open", async (t) => {
    const { host, context, page, complaints } = await visit(t, browser);
    const playground = new Playground(page);
    await playground.goto(host.url);
    await playground.kept();

    host.folder = (await newVersion(t)).folder;
    assert.equal(await update(page), "installed");
    await page.close();
    // What was kept before goes as soon as the new keeper takes over.
    let next;
    await eventually("only the new version to be kept", async () => {
      await next?.close();
      next = await context.newPage();
      // One that is opened in the very moment in which the keepers change is opened again.
      const isThere = await next.goto(host.url, { timeout: 10_000 }).catch(() => null);
      if (!isThere) {
        return false;
      }
      const versions = await next.evaluate(() => caches.keys());
      return versions.length === 1 && versions[0].includes(" new-");
    });
    await host.close();
    await new Playground(next).reload();
    assert.match(await next.title(), /^New: /);
    assertQuiet(complaints);
  });
});

describe("a network that is slow, or gone", () => {
  let browser;
  before(async () => {
    browser = await launch();
  });
  after(() => browser.close());

  test("a page may arrive slowly", async (t) => {
    const { host, page, complaints, playground } = await kept(t, browser);
    host.folder = (await newVersion(t)).folder;
    host.slow.set("", { end: 4500 });
    await playground.reload();
    assert.match(await page.title(), /^New: /);
    assertQuiet(complaints);
  });

  test("a network that does not answer is not waited for", async (t) => {
    const { host, page, complaints, playground } = await kept(t, browser);
    host.folder = (await newVersion(t)).folder;
    host.slow.set("", { headers: 60_000 });
    await playground.reload();
    assert.match(await page.title(), /^Giveway: /);
    assertQuiet(complaints);
  });

  test("a browser without AbortSignal.timeout shows the newest page, too", async (t) => {
    const { folder } = await newVersion(t, (script) => `delete AbortSignal.timeout;\n${script}`);
    const { host, page, complaints, playground } = await kept(t, browser, folder);
    host.folder = dist;
    await playground.reload();
    assert.match(await page.title(), /^Giveway: /);
    assertQuiet(complaints);
  });

  test("the newest page that is kept is shown, while an older one is open", async (t) => {
    const { host, page, complaints, playground } = await kept(t, browser);
    const deployed = await newVersion(t);
    host.folder = deployed.folder;
    assert.equal(await update(page), "installed");
    await host.close();
    await playground.reload();
    assert.match(await page.title(), /^New: /);
    assert.equal(await fetched(page, deployed.worker), 200);
    assertQuiet(complaints);
  });

  test("a page that is not kept whole is not shown", async (t) => {
    const { host, page, complaints, playground } = await kept(t, browser);
    host.folder = (await newVersion(t, (script) => script.replace('"./",', '"./", "missing-0123456789abcdef.js",'))).folder;
    assert.equal(await update(page), "redundant");
    await host.close();
    await playground.reload();
    assert.match(await page.title(), /^Giveway: /);
    assertQuiet(complaints);
  });
});

/** A page that is kept, of the built folder or of another one. */
async function kept(t, browser, folder = dist) {
  const { host, ...opened } = await visit(t, browser);
  host.folder = folder;
  const playground = new Playground(opened.page);
  await playground.goto(host.url);
  await playground.kept();
  return { host, playground, ...opened };
}

/** Lets the browser look for a new keeper; gives the state in which that waits or ends. */
function update(page) {
  return page.evaluate(async () => {
    const registration = await navigator.serviceWorker.ready;
    const found = new Promise((resolve) => registration.addEventListener("updatefound", () => resolve(registration.installing), { once: true }));
    await registration.update();
    const keeper = registration.installing ?? registration.waiting ?? await found;
    while (keeper.state === "installing") {
      await new Promise((resolve) => keeper.addEventListener("statechange", resolve, { once: true }));
    }
    return keeper.state;
  });
}

/** The built folder on a host, and a page that is not there yet. */
async function visit(t, browser, base) {
  const host = await serve(dist, base);
  t.after(() => host.close());
  const opened = await open(browser);
  t.after(() => opened.context.close());
  return { host, ...opened };
}

/** A copy of the built folder in which page, worker and version are other ones; the keeper's script may be changed, too. */
async function newVersion(t, keeper = (script) => script) {
  const folder = await mkdtemp(join(tmpdir(), "giveway-"));
  t.after(() => rm(folder, { recursive: true }));
  await cp(dist, folder, { recursive: true });
  await change(join(folder, "index.html"), /<title>/, "<title>New: ");
  await change(join(folder, "service-worker.js"), /VERSION = "/, "$&new-");
  const page = await readFile(join(folder, "index.html"), "utf8");
  const [path] = page.match(/worker-[0-9a-f]+\.js/);
  const moved = "worker-0123456789abcdef.js";
  await rename(join(folder, path), join(folder, moved));
  await change(join(folder, "index.html"), new RegExp(path, "g"), moved);
  await change(join(folder, "service-worker.js"), new RegExp(path, "g"), moved);
  await change(join(folder, "service-worker.js"), /^[^]*$/, keeper);
  return { folder, worker: `./${moved}` };
}

async function change(file, pattern, replacement) {
  const text = await readFile(file, "utf8");
  assert.match(text, pattern, file);
  await writeFile(file, text.replace(pattern, replacement));
}

function workerOf(page) {
  return page.locator('meta[name="giveway-solver-worker"]').getAttribute("content");
}

function fetched(page, path) {
  return page.evaluate((address) => fetch(address).then((response) => response.status), path);
}
