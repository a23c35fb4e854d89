// What is shared: a link or an embed without the answer, and in a language.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { BOTH, flows } from "./flow.mjs";
import { geometry } from "./geometry.mjs";
import { eventually } from "./wait.mjs";

const OPENING = /^Optimal: makespan 18/;
const GERMAN = /^Optimal: Makespan 18/;
const HIDDEN = "Scene only: the answer stays hidden";
const CLIPBOARD = { permissions: ["clipboard-read", "clipboard-write"] };

/** The parts of a link that tell of an answer. */
const OF_ANSWER = /[#&](plan|knows|slept|changes|audit|time|ask|claim|steps|front|report)=/;

describe("what is shared", () => {
  const flow = flows();

  flow("can be the scene alone: a fresh page shows no answer, and finds it when it is asked to", async (playground, { page, screen }) => {
    await playground.says(OPENING);
    await playground.pause();
    const whole = await share(playground);
    assert.match(whole, OF_ANSWER);
    const link = await share(playground, { hidden: true });
    assert.doesNotMatch(link, OF_ANSWER);
    assert.match(link, /#giveway=1&check=\d+\.[0-9a-f]{8}&map=.*&name=warehouse&.*agents=/);

    const fresh = await elsewhere(page, link);
    await fresh.getByRole("heading", { level: 1, name: /^warehouse/ }).waitFor();
    const solve = fresh.getByRole("button", { name: "Solve", exact: true });
    await solve.waitFor();
    await fresh.waitForTimeout(1500);
    const text = await fresh.locator("body").innerText();
    assert.doesNotMatch(text, /Optimal|makespan 18|sum of costs 35|Proved/);
    await fresh.screenshot({ path: playground.pathOf(`share-hidden`) });
    assert.equal(screen === "desktop" && await fresh.getByRole("slider", { name: "Time" }).count(), screen === "desktop" && 0);
    await solve.click();
    await eventually("the answer", () => fresh.getByRole("status").first().textContent(), (text) => OPENING.test(text));
    await fresh.context().close();
  }, { screens: BOTH });

  flow("shows the same when it is embedded, in the language of the link", async (playground, { page, host }) => {
    await playground.says(OPENING);
    await playground.act("Share");
    const dialog = page.getByRole("dialog", { name: "Share" });
    await dialog.getByLabel("What it shows").selectOption(HIDDEN);
    await dialog.getByLabel("Language").selectOption("Deutsch");
    assert.deepEqual(await geometry(page), []);
    await playground.picture("share-choices");
    await playground.press("Copy embed code");
    await dialog.getByText("Embed code copied.").waitFor();
    const code = await page.evaluate(() => navigator.clipboard.readText());
    assert.ok(code.includes(` src="${host.url}?embed&amp;lang=de#giveway=1&amp;check=`), code);
    assert.doesNotMatch(code.replaceAll("&amp;", "&"), OF_ANSWER);

    const fresh = await elsewhere(page, code.match(/src="([^"]*)"/)[1].replaceAll("&amp;", "&"));
    const way = fresh.getByRole("link", { name: "In Giveway öffnen" });
    await way.waitFor();
    assert.match(await way.getAttribute("href"), /\/\?lang=de#giveway=1&check=/);
    assert.doesNotMatch(await way.getAttribute("href"), OF_ANSWER);
    assert.equal(await fresh.getByRole("slider").count(), 0);
    await fresh.screenshot({ path: playground.pathOf("share-hidden-embed") });
    await fresh.context().close();
  }, CLIPBOARD);

  flow("opens in the language of its link, which is not kept", async (playground, { page, host }) => {
    await playground.says(OPENING);
    const link = await share(playground, { language: "Deutsch" });
    assert.ok(link.startsWith(`${host.url}?lang=de#giveway=1&`), link);
    await playground.goto(link);
    await playground.says(GERMAN);
    await playground.reload();
    await playground.says(GERMAN);
    await playground.goto(host.url);
    await playground.says(OPENING);

    // A person's own choice holds, on this page and after a reload.
    await playground.goto(`${host.url}?lang=de`);
    await playground.says(GERMAN);
    await playground.press("EN: English");
    await playground.says(OPENING);
    assert.equal(page.url(), host.url);
    await playground.reload();
    await playground.says(OPENING);
  });

  flow("is in the reader's own language where its link names one that the page does not speak", async (playground, { host }) => {
    for (const tag of ["tlh", "", "%3Cb%3E", "de;x"]) {
      await playground.goto(`${host.url}?lang=${tag}`);
      await playground.says(OPENING);
    }
    await playground.goto(`${host.url}?lang=DE-at`);
    await playground.says(GERMAN);
  });

  flow("is a lesson in the language of its link, too", async (playground, { page, host }) => {
    await playground.goto(`${host.url}?lang=de#lesson=two-robots-one-cell.2`);
    await page.getByRole("heading", { name: "Zwei in einer Zelle" }).waitFor();
    assert.equal(page.url(), `${host.url}?lang=de#lesson=two-robots-one-cell.2`);
  });
});

/** The link that the dialog shows for these choices. */
async function share(playground, { hidden = false, language } = {}) {
  await playground.act("Share");
  const dialog = playground.page.getByRole("dialog", { name: "Share" });
  if (hidden) {
    await dialog.getByLabel("What it shows").selectOption(HIDDEN);
    await dialog.getByText(/sees the scene alone/).waitFor();
  }
  if (language) {
    await dialog.getByLabel("Language").selectOption(language);
  }
  const link = await dialog.getByLabel("Link", { exact: true }).inputValue();
  await playground.key("Escape");
  return link;
}

/** Opens a link in a browser that knows nothing of this one. */
async function elsewhere(page, link) {
  const context = await page.context().browser().newContext({ viewport: page.viewportSize(), serviceWorkers: "block" });
  const fresh = await context.newPage();
  await fresh.goto(link);
  await fresh.getByRole("grid").first().waitFor();
  return fresh;
}
