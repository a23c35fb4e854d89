// The board as a picture that stands by itself: SVG and PNG.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { flows, LOOKS } from "./flow.mjs";

const OPENING = /^Optimal: makespan 18/;
/** The side of a cell and the space around the map in an SVG, in pixels. */
const CELL = 64;
const SPACE = 54;

describe("pictures of the board", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`stand by themselves, ${theme}`, async (playground, { context, screen }) => {
      await at(playground, 4);
      const svg = await save(playground, "Save picture (SVG)", "warehouse-4.svg");
      await standsByItself(playground.page, svg.toString());
      // Names and coordinates by the size of a cell in the picture, not on a small screen.
      const words = [...svg.toString().matchAll(/<text[^>]*>([^<]*)</g)].map(([, word]) => word);
      for (const word of ["A1", "A2", "0", "9"]) {
        assert.ok(words.includes(word), `${word} among ${words.join(" ")} on a ${screen}`);
      }
      const png = await save(playground, "Save picture (PNG)", "warehouse-4.png");

      // On a page of its own nothing but the file gives it its look.
      const alone = await context.newPage();
      const size = await alone.evaluate(measure, { type: "image/svg+xml", base64: svg.toString("base64") });
      const fine = await alone.evaluate(measure, { type: "image/png", base64: png.toString("base64") });
      await alone.screenshot({ path: playground.pathOf(`picture-alone-${theme}`) });
      await alone.close();
      assert.deepEqual([fine.width, fine.height], [2 * size.width, 2 * size.height]);
      const columns = Number(await playground.board.getAttribute("aria-colcount"));
      const rows = Number(await playground.board.getAttribute("aria-rowcount"));
      for (const [side, cells] of [[size.width, columns], [size.height, rows]]) {
        assert.ok(side >= CELL * cells && side <= CELL * cells + SPACE, `${side} pixels for ${cells} cells on a ${screen}`);
      }
      // Floor, obstacles, agents, their rings and flags: and the ground is the theme's.
      assert.ok(fine.colours > 40, `${fine.colours} colours`);
      assert.equal(fine.corner, theme === "light" ? "244,245,243,255" : "18,20,23,255");
    }, { theme, screens, reducedMotion: "reduce" });
  }

  flow("hold names as text, whatever they are", async (playground) => {
    const name = "<script>alert(1)</script>\u0007\u202e&\"";
    const agent = { name: "<b>\u0001", start: [0, 0], goal: [1, 0] };
    await playground.open({ name: "a.json", bytes: JSON.stringify({ giveway: 1, name, map: [".."], agents: [agent] }) });
    await playground.shows("<script>");
    const svg = await save(playground, "Save picture (SVG)", "script-alert-1-script-0.svg");
    await standsByItself(playground.page, svg.toString());
  }, { screens: ["desktop"] });

  flow("show the part of a large map that is in sight", async (playground) => {
    await playground.example("Large warehouse");
    await playground.says(/^(Optimal|Best plan)/);
    const whole = await save(playground, "Save picture (SVG)");
    await standsByItself(playground.page, whole.toString());
    await playground.press("Zoom in");
    await playground.press("Zoom in");
    const part = await save(playground, "Save picture (SVG)");
    const width = (svg) => Number(/viewBox="\S+ \S+ (\d+)/.exec(svg.toString())[1]);
    assert.ok(width(part) < width(whole), `${width(part)} of ${width(whole)}`);
  }, { screens: ["desktop"] });
});

/** Stops the opening plan at a time, with an agent selected and the pointer on the board. */
async function at(playground, time) {
  await playground.says(OPENING);
  await playground.pause();
  await playground.press("To start");
  for (let step = 0; step < time; step += 1) {
    await playground.press("Step forward");
  }
  await playground.reaches(time);
  await playground.cell(3, 1).click();
}

/** What is saved under an item of the menu `Save`, which a phone has in its only one. */
async function save(playground, item, name) {
  const download = playground.page.waitForEvent("download");
  await playground.press(playground.isPhone() ? "More" : "Save");
  await playground.press(item);
  const saved = await download;
  if (name) {
    assert.equal(saved.suggestedFilename(), name);
  }
  return readFileSync(await saved.path());
}

/** That an SVG is one, and needs and does nothing beside. */
async function standsByItself(page, svg) {
  const found = await page.evaluate((svg) => {
    const read = new DOMParser().parseFromString(svg, "image/svg+xml");
    const all = [...read.querySelectorAll("*")];
    return {
      error: read.querySelector("parsererror")?.textContent ?? null,
      root: read.documentElement.localName,
      named: read.querySelector("title")?.textContent.length > 0,
      shapes: all.length,
      scripts: all.filter((element) => /script|foreignObject|style|image|use|^a$/i.test(element.localName)).length,
      attributes: [...new Set(all.flatMap((element) => element.getAttributeNames()))],
      cursors: all.filter((element) => element.getAttribute("width") === "94").length,
      foreign: /(?:https?:)?\/\/(?!www\.w3\.org\/2000\/svg)|var\(|light-dark/.exec(svg)?.[0] ?? null,
    };
  }, svg);
  assert.equal(found.error, null);
  assert.deepEqual([found.root, found.named, found.scripts, found.cursors, found.foreign], ["svg", true, 0, 0, null]);
  assert.ok(found.shapes > 8, `${found.shapes} shapes`);
  const onPage = found.attributes.filter((name) => /^(class|style|tabindex|on.*|aria-.*|data-.*)$/.test(name));
  assert.deepEqual(onPage, []);
}

/** Shows a picture on an empty page and looks at its pixels. */
async function measure({ type, base64 }) {
  const image = new Image();
  image.src = `data:${type};base64,${base64}`;
  await image.decode();
  document.body.style.margin = "0";
  document.body.replaceChildren(image);
  const canvas = new OffscreenCanvas(image.naturalWidth, image.naturalHeight);
  const paper = canvas.getContext("2d");
  paper.drawImage(image, 0, 0);
  const { data } = paper.getImageData(0, 0, canvas.width, canvas.height);
  const colours = new Set();
  for (let at = 0; at < data.length; at += 4) {
    colours.add(data.slice(at, at + 4).join());
  }
  return { width: canvas.width, height: canvas.height, colours: colours.size, corner: data.slice(0, 4).join() };
}
