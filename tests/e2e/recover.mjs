// What the flows about what is kept, and what comes and goes, have in common.

import { readFileSync } from "node:fs";

import { Playground } from "./page.mjs";
import { eventually } from "./wait.mjs";

export const OPENING = /^Optimal: makespan 18/;
export const LINK = "giveway=1&check=63.fa1ec4ab&map=3.9f&name=sent&rules=0.0&costs=0&agents=A.0.0.2.2&plan=2r2d";
export const NEWER = "giveway-kept=3\nnobody knows what this is\n";

/** A picture of what is said, once it stands still. */
export async function look(playground, title) {
  await playground.page.evaluate(() => Promise.all([...document.querySelectorAll(".slot")].flatMap((slot) => slot.getAnimations()).map((motion) => motion.finished)));
  await playground.picture(title);
}

/** Closes a cell of the opening scene. */
export async function edit(playground) {
  await playground.says(OPENING);
  await stroke(playground, "Obstacle", [0, 1]);
  await playground.cellTells(0, 1, /^obstacle/);
}

/** Applies a tool to a cell. */
export async function stroke(playground, tool, cell) {
  await playground.pick(tool);
  await playground.stroke(cell);
}

/** Opens a link in the page that is there. */
export async function follow(page, link) {
  await page.evaluate((link) => {
    location.hash = link;
  }, link);
}

/** Opens the dialog of the scenes that are kept. */
export function scenes(playground) {
  return playground.sceneName.getByRole("button").click();
}

/** Another tab of the same browser, with the page in it. */
export async function tab(playground, context, host, before, given) {
  const page = await context.newPage();
  if (before) {
    await page.addInitScript(before, given);
  }
  const other = new Playground(page, (title) => playground.pathOf(title));
  await other.goto(host.url);
  return other;
}

/** Pages hear of other tabs only where they are told to. */
export function deafen(context) {
  return context.addInitScript(() => {
    addEventListener("storage", (event) => window.hears || event.stopImmediatePropagation(), true);
  });
}

/** Waits until a page has kept what it opened, which it does once it is calm. */
export function opened({ page }) {
  const mark = () => page.evaluate(() => sessionStorage.getItem("giveway.opening"));
  return eventually("the page to have kept what it opened", mark, (mark) => mark === null);
}

/** Opens another tab, and edits in both before either hears of the other. */
export async function goApart(playground, context, host) {
  await edit(playground);
  await eventually("the edit to be kept", () => playground.keeps(), (text) => text.includes("touched"));
  const other = await tab(playground, context, host);
  await other.cellTells(0, 1, /^obstacle/);
  const before = await playground.keeps();
  await stroke(playground, "Obstacle", [9, 1]);
  await eventually("the one to be kept", () => playground.keeps(), (text) => text !== before);
  await playground.page.evaluate(() => {
    window.hears = true;
  });
  await stroke(other, "Charger", [8, 0]);
  return other;
}

/** Under how many names a text is kept. */
export function planted(page, text) {
  return page.evaluate((text) => {
    const ofTabs = Object.entries({ ...localStorage }).filter(([name]) => name.startsWith("giveway.tab."));
    return ofTabs.filter(([, kept]) => kept === text).length;
  }, text);
}

/** Lets the page find that the browser makes no more pictures, which it relies on. */
export async function breakDown(playground) {
  await playground.page.evaluate(() => {
    Document.prototype.createElementNS = () => {
      throw new Error("out of order");
    };
  });
  await (playground.isPhone() ? playground.press("More") : playground.press("Open"));
}

/** Drops files onto the page. */
export async function drop(page, ...files) {
  await page.evaluate((files) => {
    const data = new DataTransfer();
    for (const { name, text } of files) {
      data.items.add(new File([text], name));
    }
    for (const kind of ["dragover", "drop"]) {
      document.body.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
    }
  }, files);
}

/** What is saved under an item of the menu `Save`. */
export async function save(playground, item) {
  const download = playground.page.waitForEvent("download");
  await playground.press("Save");
  await playground.press(item);
  return readFileSync(await (await download).path(), "utf8");
}
