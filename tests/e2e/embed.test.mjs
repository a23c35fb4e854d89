// The page inside another page: a plan to be watched, and nothing else.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { audit } from "./audit.mjs";
import { flows, LOOKS, MOVING } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const OPENING = /^Optimal: makespan 18/;
const CLIPBOARD = { permissions: ["clipboard-read", "clipboard-write"] };
/** Keys that mean something on the page itself, or to the browser. */
const OTHERS = ["o", "x", "?", "a", "Control+z", "Control+Enter", "ArrowDown", "PageDown"];

describe("inside another page", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`shows the plan, plays, and keeps nothing, ${theme}`, async (playground, { context, host, page, screen }) => {
      await playground.says(OPENING);
      await playground.pause();
      await playground.press("To start");
      await playground.press("Step forward");
      await playground.reaches(1);
      const code = await embedCode(playground);
      assert.ok(code.includes(` src="${host.url}?embed#giveway=1&amp;check=`), code);
      assert.match(code, / title="Giveway: warehouse" /);
      await playground.example("No way past");
      await playground.shows("scenario 6");
      const before = () => page.evaluate(() => ({ ...localStorage }));
      await eventually("the page to be kept", before, (kept) => ofTabs(kept).includes("name=scenario"));
      const kept = await before();

      // The narrowest phone, or what the code says.
      const frame = await show(page, host, screen === "phone" ? code.replace("640", "320") : code);
      await eventually("the sentence", () => frame.getByRole("status").first().textContent(), (text) => /^Optimal: makespan 18, sum of costs 35, 3 charges\.$/.test(text));
      const time = frame.getByRole("slider", { name: "Time" });
      const now = async () => Number(await time.inputValue());
      assert.equal(await now(), 1);
      await frame.getByRole("gridcell", { name: /^1, 0: .*A1/ }).waitFor({ state: "attached" });
      await page.screenshot({ path: playground.pathOf(`embed-${theme}`) });
      await audit({ page: frame }, "embedded");
      const sizes = await frame.evaluate(() => [document.documentElement.scrollWidth, innerWidth, document.documentElement.scrollHeight, innerHeight]);
      assert.ok(sizes[0] <= sizes[1] && sizes[2] <= sizes[3], `it scrolls: ${sizes}`);

      await time.fill("7");
      const link = frame.getByRole("link", { name: "Open in Giveway" });
      await eventually("the link of time 7", () => link.getAttribute("href"), (href) => href.endsWith("&time=7"));
      await frame.getByRole("button", { name: "Play", exact: true }).click();
      await eventually("it to play", now, (time) => time > 8);
      await frame.getByRole("button", { name: "Pause", exact: true }).click();
      await frame.getByRole("button", { name: "To end", exact: true }).click();
      await eventually("the end", now, (time) => time === 18);

      await leavesKeys(frame, page);
      assert.equal(await frame.getByRole("dialog").count(), 0);
      const names = await frame.getByRole("button").evaluateAll((all) => all.map((button) => button.innerText.trim()));
      assert.deepEqual(names, ["To start", "Step back", "Play", "Step forward", "To end"]);
      await frame.getByRole("gridcell", { name: /^0, 0: / }).click({ force: true });

      const opens = context.waitForEvent("page");
      await link.click();
      const opened = await opens;
      await opened.getByRole("heading", { level: 1, name: /^warehouse/ }).waitFor();
      assert.equal(await opened.evaluate(() => window.opener), null);
      await opened.close();
      assert.deepEqual(await frame.evaluate(() => window.touched), [], "it touched the storage");
      assert.deepEqual(await frame.evaluate(() => caches.keys()), []);
      assert.ok(ofTabs(kept).includes("name=scenario"));
    }, { theme, screens, ...CLIPBOARD, before: watchStorage, ...MOVING });
  }

  flow("shows the same after it is loaded anew, and refuses a broken link with a sentence", async (playground, { host, page }) => {
    const scene = "giveway=1&map=3.9f&name=mine&rules=0.0&costs=0&agents=A.0.0.2.2&plan=2r2d";
    const frame = await show(page, host, `<iframe title="mine" width="600" height="400" src="${host.url}?from=notes&amp;embed#${scene}"></iframe>`);
    await frame.getByRole("heading", { name: "mine" }).waitFor();
    await frame.getByRole("link", { name: "Open in Giveway" }).waitFor();
    await reload(frame);
    await frame.getByRole("heading", { name: "mine" }).waitFor();
    const broken = await show(page, host, `<iframe title="broken" width="600" height="400" src="${host.url}?embed#giveway=3"></iframe>`, "alert");
    await eventually("a notice", () => broken.getByRole("alert").first().innerText(), (text) => /cannot be shown.*version 3/s.test(text));
    assert.equal(await broken.getByRole("grid").count(), 0, "nothing else is shown");
    assert.equal(await broken.getByRole("link", { name: "Open Giveway" }).count(), 1);
    await page.screenshot({ path: playground.pathOf("embed-refused") });
    const cut = await show(page, host, `<iframe title="cut" width="600" height="400" src="${host.url}?embed#giveway%3D1%26map%3D3.3f"></iframe>`, "alert");
    await eventually("a notice", () => cut.getByRole("alert").first().innerText(), (text) => /This link was cut/.test(text));
  }, { screens: ["desktop"] });
});

async function embedCode(playground) {
  await playground.act("Share");
  await playground.press("Copy embed code");
  const dialog = playground.page.getByRole("dialog", { name: "Share" });
  await dialog.getByText("Embed code copied.").waitFor();
  await playground.picture("share-embed");
  const code = await playground.page.evaluate(() => navigator.clipboard.readText());
  await playground.key("Escape");
  return code;
}

/** Opens a page of the same host, whose storage is the playground's own, with this HTML in it. */
async function show(page, host, html, shown = "board") {
  const address = `${host.url}notes.html`;
  await page.unroute(address);
  const body = `<!doctype html><html lang="en"><meta name="viewport" content="width=device-width"><title>Notes</title><h1>Notes</h1>${html}`;
  await page.route(address, (route) => route.fulfill({ contentType: "text/html", body }));
  await page.goto("about:blank");
  await page.goto(address);
  const frame = await (await page.waitForSelector("iframe")).contentFrame();
  await (shown === "board" ? frame.getByRole("grid", { name: "Board" }) : frame.getByRole("alert").first()).waitFor();
  return frame;
}

/** Loads the frame anew. It is done where the document of before is no more: that one has the same address and text. */
async function reload(frame) {
  await frame.evaluate(() => {
    window.isOfBefore = true;
    location.reload();
  });
  const read = () => frame.evaluate(() => document.readyState === "complete" && !window.isOfBefore).catch(() => false);
  await eventually("the frame to be loaded anew", read);
}

/** Remembers every use of what a browser keeps. */
function watchStorage(context) {
  return context.addInitScript(() => {
    window.touched = [];
    for (const name of ["getItem", "setItem", "removeItem", "key"]) {
      const own = Storage.prototype[name];
      Storage.prototype[name] = function (...words) {
        window.touched.push([name, ...words].join(" "));
        return own.apply(this, words);
      };
    }
  });
}

/** That keys which play nothing are left to the browser and the page around. */
async function leavesKeys(frame, page) {
  await frame.evaluate(() => {
    window.taken = [];
    window.addEventListener("keydown", (event) => {
      setTimeout(() => event.defaultPrevented && window.taken.push(event.key));
    });
  });
  await frame.getByRole("link", { name: "Open in Giveway" }).focus();
  for (const key of OTHERS) {
    await page.keyboard.press(key);
  }
  await page.keyboard.press("Home");
  await eventually("the start", () => frame.getByRole("slider", { name: "Time" }).inputValue(), (time) => time === "0");
  // It is told after the key was heard, and so perhaps after what the key did is seen.
  const taken = await eventually("Home to be taken", () => frame.evaluate(() => window.taken), (keys) => keys.length > 0);
  assert.deepEqual(taken, ["Home"]);
}

/** What is kept of all tabs, as one text. */
function ofTabs(kept) {
  return Object.keys(kept).filter((name) => name.startsWith("giveway.tab.")).map((name) => kept[name]).join();
}
