// The report of a plan: on the page, printed, and as the command writes it.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { flows, sample } from "./flow.mjs";
import { choose } from "./language.mjs";
import { onPages, pagesOf } from "./paper.mjs";
import { eventually } from "./wait.mjs";

const LANGUAGES = [
  { name: "English", save: "Save", plan: "Save plan", report: "Report of the plan", close: "Close", csv: "Save the plan (CSV)", html: "Save the report (HTML)", group: /,/g },
  { name: "Deutsch", save: "Speichern", plan: "Plan speichern", report: "Bericht zum Plan", close: "Schließen", csv: "Plan speichern (CSV)", html: "Bericht speichern (HTML)", group: /[.\u202f\u00a0]/g },
];
/** How many robots there are, and how many pages of A4 that may be. */
const SIZES = [
  { robots: 2, pages: [1, 2] },
  { robots: 16, pages: [2, 4] },
  { robots: 200, pages: [4, 12] },
];
/** What is printed on of a sheet of A4, in pixels: 178 by 263 millimetres. */
const PAPER = { width: 673, height: 994 };
/** The most busy cells that are told. */
const BUSIEST = 8;

describe("the report", () => {
  const flow = flows();

  for (const language of LANGUAGES) {
    for (const { robots, pages } of SIZES) {
      flow(`of ${robots} robots has every figure of the plan, on the page and on paper (${language.name})`, async (playground, { page }) => {
        await open(playground, robots);
        if (language !== LANGUAGES[0]) {
          await choose(playground, language.name);
          await page.getByRole("button", { name: language.save, exact: true }).waitFor();
        }
        const plan = JSON.parse(await saved(page, language, () => item(page, language, language.plan)));
        await item(page, language, language.report);
        const sheet = page.locator("dialog .report");
        await sheet.waitFor();
        await page.getByRole("button", { name: language.html, disabled: false }).waitFor();
        const told = await rows(sheet);
        figures(told, plan, robots, language);
        await playground.picture(`report-${robots}-${language.name}`);

        const csv = await saved(page, language, () => page.getByRole("button", { name: language.csv }).click());
        const lines = csv.replace("\uFEFF", "").trim().split("\r\n");
        const times = Object.values(plan.paths).reduce((sum, path) => sum + path.length, 0);
        assert.equal(lines.length, times + 1, "a line for each robot and time");
        const html = await saved(page, language, () => page.getByRole("button", { name: language.html }).click());
        assert.equal(await articleOf(page, html), await printed(page), "the file has what is printed");

        const cut = await onPaper(page);
        assert.deepEqual(cut, { clipped: [], beyond: [], breaks: [], rows: robots });
        const paper = await pagesOf(await page.pdf({ format: "A4", printBackground: true }));
        assert.ok(paper.length >= pages[0] && paper.length <= pages[1], `${paper.length} pages`);
        assert.deepEqual(paper.flatMap(({ outside }) => outside), [], "nothing outside of the margins");
        for (const rows of [told.costs, told.robots, told.busiest]) {
          const heads = rows === told.robots ? told.heads : [];
          assert.deepEqual(onPages(paper, { heads, rows }), { split: [], headless: [] });
        }
        await page.getByRole("button", { name: language.close }).last().click();
        await sheet.waitFor({ state: "detached" });
      }, { screens: ["desktop"] });
    }
  }

  for (const scene of ["warehouse", "rows-16", "rows-200"]) {
    flow(`tells what the command tells of ${scene}`, (playground, { page }) => asCommand(playground, page, scene), { screens: ["desktop"] });
  }
});

/** The report of a scene on the page and from the command: `crates/giveway-cli/tests/command/report.rs` writes it. */
async function asCommand(playground, page, scene) {
  const [language] = LANGUAGES;
  await playground.says(/^Optimal/);
  await playground.open(sample(`report/${scene}.json`));
  await playground.shows(scene.replace(/-.*/, ""));
  await playground.press("Solve");
  await playground.says(/^Optimal/);
  await item(page, language, language.report);
  await page.locator("dialog .report").waitFor();
  await page.locator("dialog .report").getByRole("heading", { name: "Who is last, and why" }).waitFor();
  const html = await saved(page, language, () => page.getByRole("button", { name: language.html }).click());
  const command = readFileSync(sample(`report/${scene}.html`), "utf8");
  // The command knows neither the day nor an address of a page.
  const date = /(<p class="brand">Giveway<\/p>)<p>([^<]*)<\/p>/;
  assert.ok(html.match(date)[2].includes(String(new Date().getFullYear())), "the day on which it is made");
  const link = /<p class="report-link">[^]*?<\/p>\n/;
  // What 200 robots drive is too long for an address.
  const address = html.match(link)?.[0] ?? "";
  assert.match(address, scene === "rows-200" ? /^$/ : /<a href="http[^"]*#giveway=1&amp;check=/);
  assert.equal(await articleOf(page, html.replace(link, "").replace(date, "$1")), await articleOf(page, command));
  await page.getByRole("button", { name: language.close }).last().click();
}

/** A scene with so many robots, with a plan. */
async function open(playground, robots) {
  await playground.says(/^Optimal/);
  if (robots === 2) {
    return;
  }
  await playground.open(robots === 16
    ? sample("depot/depot.json")
    : sample("report/rows-200.json"));
  await playground.says(/^No plan yet/);
  await playground.press("Solve");
  await eventually("a plan", () => playground.status.textContent(), (text) => /^(Optimal|Best)/.test(text), 60_000);
}

async function item(page, language, name) {
  await page.getByRole("button", { name: language.save, exact: true }).click();
  await page.getByRole("button", { name, exact: true }).click();
}

async function saved(page, _, act) {
  const saving = page.waitForEvent("download");
  await act();
  return readFileSync(await (await saving).path(), "utf8");
}

/** The texts of each table, row by row. */
function rows(sheet) {
  return sheet.evaluate((sheet) => {
    const table = (name) => [...sheet.querySelectorAll(`.report-${name} tbody:not(.total) tr`)].map((row) => [...row.children].map((cell) => cell.textContent));
    const heads = (name) => [...sheet.querySelectorAll(`.report-${name} thead tr > *`)].map((cell) => cell.textContent);
    const total = [...sheet.querySelectorAll(".report-robots .total td")].map((cell) => cell.textContent);
    return { total, costs: table("costs"), robots: table("robots"), busiest: table("busiest"), heads: heads("robots"), text: sheet.textContent };
  });
}

/** Every figure, counted from the plan. */
function figures(told, { paths, charges = {} }, robots, language) {
  const number = (text) => Number(text.replaceAll(language.group, ""));
  const names = Object.keys(paths);
  assert.equal(told.robots.length, robots);
  const arrivals = Object.values(paths).map((path) => path.length - 1);
  const waits = (path) => path.filter((cell, at) => at > 0 && cell && path[at - 1] && String(cell) === String(path[at - 1])).length;
  const sum = (numbers) => numbers.reduce((sum, n) => sum + n, 0);
  const expected = [
    Math.max(...arrivals),
    sum(arrivals),
    sum(Object.values(charges).map((times) => times.length)),
  ];
  const [, arrived, ...others] = told.total;
  assert.equal(number(arrived), sum(arrivals), "the sum of arrivals");
  assert.equal(number(others.filter(Boolean).at(-1)), sum(Object.values(paths).map(waits)), "the sum of waits");
  assert.deepEqual(told.costs.slice(0, 3).map(([, value]) => number(value)), expected);
  const arrives = told.heads.length - 1 - [...told.heads].reverse().findIndex((head) => /^(Arrives|Ankunft|Kommt an)/.test(head));
  for (const row of told.robots) {
    const path = paths[row[0]];
    assert.ok(names.includes(row[0]), row[0]);
    assert.equal(number(row[arrives]), path.length - 1, `arrival of ${row[0]}`);
    const waited = row[told.heads.findIndex((head) => /^(Waits|Wartet|Wartezeit|Warten)/.test(head))];
    assert.equal(Number(waited || 0), waits(path), `waits of ${row[0]}`);
  }
  const uses = new Map();
  for (const path of Object.values(paths)) {
    let last;
    for (const cell of path.filter(Boolean).map((cell) => cell.join(", "))) {
      if (cell !== last) {
        uses.set(cell, (uses.get(cell) ?? 0) + 1);
      }
      last = cell;
    }
  }
  const most = [...uses.values()].filter((n) => n > 1).sort((a, b) => b - a).slice(0, BUSIEST);
  assert.deepEqual(told.busiest.map(([, , passes]) => Number(passes)), most);
  for (const [, cell, passes] of told.busiest) {
    assert.equal(uses.get(cell), Number(passes), cell);
  }
}

/** What is printed of the report, as its HTML. */
async function printed(page) {
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  const html = await page.locator(".paper-report .report").evaluate((report) => report.outerHTML);
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  return html;
}

/** The report in a file, as the browser writes its HTML. */
function articleOf(page, html) {
  // The page's policy complains of the style in the file's head.
  const [article] = html.match(/<article[^]*<\/article>/);
  return page.evaluate((html) => new DOMParser().parseFromString(html, "text/html").querySelector(".report").outerHTML, article);
}

/** What is cut on paper, and rows that a page may end in. */
async function onPaper(page) {
  const screen = page.viewportSize();
  await page.setViewportSize(PAPER);
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await page.emulateMedia({ media: "print" });
  await page.locator(".paper-report .report").waitFor();
  const told = await page.evaluate(() => {
    const all = [...document.querySelectorAll(".paper-report *")].filter((element) => !element.closest("svg") && element.getBoundingClientRect().width > 1);
    const brief = (element) => element.outerHTML.slice(0, 80);
    const trs = [...document.querySelectorAll(".paper-report tr")];
    return {
      clipped: all.filter((element) => element.scrollWidth > element.clientWidth + 1 && getComputedStyle(element).overflowX !== "visible").map(brief),
      beyond: all.filter((element) => element.getBoundingClientRect().right > innerWidth + 1).map(brief),
      breaks: trs.filter((row) => getComputedStyle(row).breakInside !== "avoid").map(brief),
      rows: document.querySelectorAll(".paper-report .report-robots tbody:not(.total) tr").length,
    };
  });
  await page.emulateMedia({ media: null });
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  await page.setViewportSize(screen);
  return told;
}
