// What the page tells a person, read from the page itself: two pages that tell the same
// hold the same document.

import assert from "node:assert/strict";

import { eventually } from "../wait.mjs";

/** How long something that was pressed may take to be seen, in milliseconds. */
const PATIENCE = 30_000;

/**
 * What is to be read on the page now.
 * @returns {Promise<object>} `name` and `size` of the scene, the `status`, the `time`, the words on all `cells`, the text
 *   of the `inspector`, the `notice` and what the `slot` says; whether the page `isThere`, `works`, `plays`, or `broke` down
 */
export function look(page) {
  return page.evaluate(() => {
    const text = (element) => (element?.innerText ?? "").replaceAll(/\s+/g, " ").trim();
    const named = (role, name) => document.querySelector(`${role}[aria-label="${name}"]`);
    const buttons = [...document.querySelectorAll("button")];
    const has = (name) => buttons.some((button) => text(button) === name && button.checkVisibility());
    const inspector = named("aside", "Inspector");
    // What can be edited is folded away or not, as the person likes.
    const folds = [...(inspector?.querySelectorAll("details > :not(summary)") ?? [])].map(text).filter((words) => words !== "");
    const board = named("[role=grid]", "Board");
    const status = named("section", "Status");
    return {
      name: text(document.querySelector("h1 button")),
      size: text(document.querySelector("h1 small")),
      status: text(status?.querySelector("p")),
      time: document.querySelector("[role=slider][aria-label=Time]")?.getAttribute("aria-valuenow") ?? "",
      isThere: board !== null,
      cells: [...(board?.querySelectorAll("[role=gridcell]") ?? [])].map((cell) => cell.ariaLabel).filter((words) => !words.endsWith(": free")),
      inspector: folds.reduce((words, fold) => words.replace(` ${fold}`, ""), text(inspector)),
      notice: text([...document.querySelectorAll(".notices")].at(-1)),
      slot: text(document.querySelector("main section[aria-label] h2")?.closest("main section[aria-label]")),
      // What is being made has a Cancel of its own, and stays until a person says what becomes of it.
      works: buttons.some((button) => text(button) === "Cancel" && button.checkVisibility() && !button.closest(".making")),
      plays: has("Pause"),
      broke: document.querySelector("[role=alertdialog]") !== null,
    };
  });
}

/** What two looks must have in common where nothing was lost; why a robot that is led did not go on is said once. */
export function told({ name, size, status, time, cells, inspector }) {
  return { name, size, status: status.replace(/^(Steering .*? at time \d+\.).*/, "$1"), time, cells, inspector };
}

/** Fails unless the page comes to tell this again. */
export async function tellsAgain(page, what, before, known = told) {
  const expected = known(before);
  let found;
  try {
    await eventually(what, async () => {
      found = known(await look(page));
      return JSON.stringify(found);
    }, (text) => text === JSON.stringify(expected), PATIENCE);
  } catch {
    assert.deepEqual(found, expected, `${what}: the page tells something else`);
  }
}

/**
 * The document as the page shares it: the scene with its settings and, where there is one, its plan. The time shown and an
 * open question, which a link also holds, are no part of it.
 */
export async function shared(playground) {
  await playground.act("Share");
  const dialog = playground.page.getByRole("dialog", { name: "Share" });
  const link = await dialog.getByLabel("Link").inputValue();
  await playground.key("Escape");
  await dialog.waitFor({ state: "detached" });
  const parts = link.slice(link.indexOf("#") + 1).split("&");
  return parts.filter((part) => !/^(check|time|ask)=/.test(part)).join("&");
}

/** What a person made of a shared document: all of it but the plan. */
export function made(document) {
  return document.split("&").filter((part) => !/^(plan|changes)=/.test(part)).join("&");
}

/** The name of the scene of a shared document. */
export function nameOf(document) {
  return decodeURIComponent(document.match(/&name=([^&]*)/)?.[1] ?? "Untitled");
}
