// Places where a browser does not let the page start, or work: from disk, inside a page that
// takes its origin away, without workers, without storage. It says so within seconds, with a
// way on, and no error is left uncaught.

import assert from "node:assert/strict";
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, describe, test } from "node:test";

import { launch } from "./browser.mjs";
import { dist } from "./dist.mjs";
import { eventually } from "./wait.mjs";

/** How long a person waits at most. */
const SOON = 5000;
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".svg": "image/svg+xml", ".json": "application/json" };
const SCENE = "giveway=1&map=3.3f&name=line&rules=0.0&costs=0&agents=A.0.0.2.0&plan=2r";

/** A scene in the project's own JSON, which the reader reads. */
const OWN = JSON.stringify({ giveway: 1, map: [".."], agents: [{ name: "A1", start: [0, 0], goal: [1, 0] }] });

describe("where it cannot start or work", () => {
  let browser;
  const hosts = [];

  before(async () => {
    browser = await launch();
  });
  after(async () => {
    await browser.close();
    hosts.forEach((host) => host.close());
  });

  /** A host, which may let any page read its files. */
  async function host(sharesFiles) {
    const server = createServer(async (request, response) => {
      const path = new URL(request.url, "http://host").pathname;
      if (path === "/around.html") {
        const src = new URL(request.url, "http://host").searchParams.get("src");
        response.writeHead(200, { "Content-Type": "text/html" });
        response.end(`<!doctype html><title>around</title><iframe sandbox="allow-scripts" width="640" height="400" src="${src.replaceAll("&", "&amp;")}"></iframe>`);
        return;
      }
      const name = path === "/" ? "index.html" : path.slice(1);
      const body = await readFile(join(dist, name)).catch(() => undefined);
      const shares = sharesFiles ? { "Access-Control-Allow-Origin": "*" } : {};
      response.writeHead(body ? 200 : 404, { "Content-Type": TYPES[extname(name)] ?? "text/plain", ...shares });
      response.end(body);
    });
    await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
    hosts.push(server);
    return `http://127.0.0.1:${server.address().port}/`;
  }

  /** Opens an address; gives the page and what was not caught in it. */
  async function visit(address, prepare) {
    const context = await browser.newContext();
    await context.addInitScript(() => {
      try {
        localStorage.setItem("giveway.welcome", "seen");
      } catch {
        // There is no storage.
      }
    });
    if (prepare) {
      await context.addInitScript(prepare);
    }
    const page = await context.newPage();
    const uncaught = [];
    page.on("pageerror", (error) => uncaught.push(error.message));
    await page.goto(address);
    return { context, page, uncaught };
  }

  /** The sentence that stands in the place of the page, with its link. */
  async function note(frame, pattern) {
    const start = performance.now();
    const text = await eventually(`a note of ${pattern}`, () => frame.locator("#boot-note").innerText(), (text) => pattern.test(text));
    assert.ok(performance.now() - start < SOON, "it took too long");
    const href = await frame.locator("#boot-note a").getAttribute("href");
    assert.match(href, /^https?:\/\//);
    return { text, href };
  }

  test("a file on disk says so", async () => {
    const { context, page, uncaught } = await visit(`${pathToFileURL(join(dist, "index.html"))}#${SCENE}`);
    await note(page, /cannot start from a file on disk/);
    assert.deepEqual(uncaught, []);
    await context.close();
  });

  test("a sandbox without an origin says so", async () => {
    const home = await host(false);
    const inner = `${home}?embed&lang=de#${SCENE}`;
    const { context, page, uncaught } = await visit(`${home}around.html?src=${encodeURIComponent(inner)}`);
    const frame = page.frames()[1];
    const { href } = await note(frame, /ohne Herkunft \(sandbox\)/);
    assert.equal(href, `${home}?lang=de#${SCENE}`, "the whole page, with the scene");
    assert.deepEqual(uncaught, []);
    await context.close();
  });

  test("a sandbox whose host shares its files shows the scene, and says what is not possible", async () => {
    const home = await host(true);
    const inner = `${home}?embed#${SCENE}`;
    const { context, page, uncaught } = await visit(`${home}around.html?src=${encodeURIComponent(inner)}`);
    const frame = page.frames()[1];
    await frame.getByRole("grid", { name: "Board" }).waitFor();
    await frame.getByText("nothing can be solved").waitFor({ timeout: SOON });
    assert.equal(await frame.getByRole("alert").getByRole("link").getAttribute("href"), `${home}#${SCENE}`);
    assert.deepEqual(uncaught, []);
    await context.close();
  });

  for (const [what, prepare] of [
    ["that are refused", () => { window.Worker = class { constructor() { throw new DOMException("refused", "SecurityError"); } }; }],
    ["that the browser does not have", () => { delete window.Worker; }],
  ]) {
    test(`without workers, ${what}, plans are looked at`, async () => {
      const home = await host(false);
      const { context, page, uncaught } = await visit(`${home}#${SCENE}`, prepare);
      await page.getByText("nothing can be solved").waitFor({ timeout: SOON });
      assert.match(await page.getByRole("alert").last().getByRole("link").getAttribute("href"), /^http/);
      await page.getByRole("button", { name: "Dismiss" }).click();
      // What is asked of a worker is said not to be possible here, and never that one broke off.
      const chooser = page.waitForEvent("filechooser");
      await page.getByRole("button", { name: "Open", exact: true }).click();
      await page.getByRole("button", { name: "Choose a file" }).click();
      await (await chooser).setFiles([{ name: "a.json", mimeType: "application/json", buffer: Buffer.from(OWN) }]);
      await page.getByText(/The file cannot be read here: the reader did not start/).waitFor({ timeout: SOON });
      assert.match(await page.getByRole("alert").last().getByRole("link").getAttribute("href"), /^http/);
      assert.equal(await page.getByText(/broke off/).count(), 0);
      await page.getByRole("button", { name: "Dismiss" }).click();
      await page.getByRole("button", { name: "Next step" }).first().click().catch(() => undefined);
      assert.deepEqual(uncaught, []);
      await context.close();
    });
  }

  test("without storage it works, and says that nothing is kept once there is something", async () => {
    const home = await host(false);
    const { context, page, uncaught } = await visit(home, () => {
      for (const name of ["localStorage", "sessionStorage", "indexedDB"]) {
        Object.defineProperty(window, name, { get() { throw new DOMException("refused", "SecurityError"); } });
      }
    });
    await page.getByRole("grid", { name: "Board" }).waitFor();
    await page.getByRole("button", { name: "Obstacle" }).click();
    await page.getByRole("grid", { name: "Board" }).focus();
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Enter");
    await page.getByText(/does not let the page keep anything/).waitFor({ timeout: 10_000 });
    assert.deepEqual(uncaught, []);
    await context.close();
  });
});
