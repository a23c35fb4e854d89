// The stage itself: a page that is used again knows nothing of the flow before, and a page
// with which something went wrong is not used again.

import assert from "node:assert/strict";
import { after, describe, test } from "node:test";

import { Stage } from "./stage.mjs";
import { eventually } from "./wait.mjs";

const SCREEN = { width: 1000, height: 700 };

describe("a page that is used again", () => {
  const stage = new Stage();
  after(() => stage.close());

  test("has nothing that was kept, and is as it is told to be", async () => {
    const first = await stage.visit({ ...SCREEN, theme: "dark" });
    await first.page.goto(first.host.url);
    await first.page.evaluate(keep);
    await first.page.setViewportSize({ width: 400, height: 400 });
    await first.page.emulateMedia({ colorScheme: "light", reducedMotion: "reduce" });
    await first.context.route("**/*.css", (route) => route.abort());
    await first.context.newPage();
    await first.end(true);

    const second = await stage.visit({ ...SCREEN, theme: "dark" });
    assert.equal(second.page, first.page, "it is not used again");
    await second.page.goto(second.host.url);
    assert.deepEqual(await second.page.evaluate(kept), {
      local: 0,
      session: 0,
      caches: [],
      databases: [],
      sheets: true,
      size: [1000, 700],
      dark: true,
      still: false,
    });
    assert.equal(second.context.pages().length, 1);
    await second.end(true);
  });

  test("has complaints of its own", async () => {
    const complain = (page, text) => page.evaluate((text) => console.error(text), text);
    const heard = ({ complaints }) => eventually("a complaint", () => complaints.length);
    const first = await stage.visit(SCREEN);
    await first.page.goto(first.host.url);
    await complain(first.page, "one");
    await heard(first);
    await first.end(true);

    const second = await stage.visit(SCREEN);
    assert.equal(second.page, first.page);
    assert.deepEqual(second.complaints, []);
    await second.page.goto(second.host.url);
    await complain(second.page, "two");
    await heard(second);
    await second.end(true);
    for (const [{ complaints }, text] of [[first, "one"], [second, "two"]]) {
      assert.equal(complaints.length, 1, complaints.join());
      assert.ok(complaints[0].startsWith(`console: ${text}`), complaints[0]);
    }
  });

  test("is another one after a flow that failed, and for one that wants it fresh", async () => {
    const first = await stage.visit(SCREEN);
    await first.end(false);
    assert.ok(first.page.isClosed());
    const second = await stage.visit(SCREEN);
    const fresh = await stage.visit({ ...SCREEN, fresh: true });
    assert.notEqual(fresh.context, second.context);
    await fresh.end(true);
    assert.ok(fresh.page.isClosed());
    await second.end(true);
    assert.ok(!second.page.isClosed());
  });
});

/** Runs in the page: keeps something in every place that there is. */
async function keep() {
  localStorage.setItem("one", "1");
  sessionStorage.setItem("one", "1");
  await caches.open("one");
  await new Promise((resolve, reject) => {
    const request = indexedDB.open("one");
    request.onsuccess = resolve;
    request.onerror = reject;
  });
}

/** Runs in the page: what is kept there from before, and what the page is like. */
async function kept() {
  return {
    local: Object.keys(localStorage).filter((name) => name === "one").length,
    session: Object.keys(sessionStorage).filter((name) => name === "one").length,
    caches: await caches.keys(),
    databases: (await indexedDB.databases()).map(({ name }) => name),
    sheets: document.styleSheets.length > 0,
    size: [innerWidth, innerHeight],
    dark: matchMedia("(prefers-color-scheme: dark)").matches,
    still: matchMedia("(prefers-reduced-motion: reduce)").matches,
  };
}
