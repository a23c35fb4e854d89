// The plan as a picture that moves, for slides: animated SVG, and GIF.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { describe } from "node:test";

import { flows, LOOKS } from "./flow.mjs";

const OPENING = /^Optimal: makespan 18/;
/** The side of a cell and the space around the map in a picture, in pixels. */
const CELL = 64;
const SPACE = 12;
/** How long the start is seen, and a step takes, in milliseconds. */
const LEAD = 600;
const STEP = 480;

describe("pictures that move", () => {
  const flow = flows();

  for (const { theme, screens } of LOOKS) {
    flow(`play as SVG, ${theme}`, async (playground, { context }) => {
      await playground.says(OPENING);
      const svg = await save(playground, "Save moving picture (SVG)", "warehouse.svg");
      assert.ok(svg.length < 60_000, `${svg.length} bytes`);
      const alone = await context.newPage();
      await alone.setContent(svg.toString());
      // Those who want less motion see the start.
      assert.equal(await alone.evaluate(() => document.getAnimations().length), 0);
      await alone.emulateMedia({ reducedMotion: "no-preference" });
      const places = [];
      for (const step of [0, 5, 18]) {
        places.push(await alone.evaluate(placesAt, { time: LEAD + STEP * step + 1, names: ["A1", "A2"] }));
      }
      // In cells: the plan of the opening scene.
      assert.deepEqual(places, [[[0, 0], [9, 2]], [[3, 1], [6, 0]], [[9, 2], [0, 0]]]);
      await alone.evaluate((time) => document.getAnimations().forEach((it) => { it.pause(); it.currentTime = time; }), LEAD + STEP * 9);
      await alone.screenshot({ path: playground.pathOf(`moving-${theme}`) });
      await alone.close();
    }, { theme, screens, reducedMotion: "reduce" });

    flow(`are saved as GIF, ${theme}`, async (playground) => {
      await playground.says(OPENING);
      const gif = await save(playground, "Save moving picture (GIF)", "warehouse.gif");
      writeFileSync(playground.pathOf(`moving-${theme}`).replace(".png", ".gif"), gif);
      await playground.says(OPENING);
      const seen = await playground.page.evaluate(frames, gif.toString("base64"));
      const [columns, rows] = [10, 3];
      assert.deepEqual([seen.width, seen.height], [columns * CELL + 2 * SPACE, rows * CELL + 2 * SPACE + 24]);
      assert.equal(seen.count, 8 * 18 + 1);
      const ground = theme === "light" ? "244,245,243" : "18,20,23";
      assert.equal(seen.corner, ground);
      // A robot beside its name: at the start, and at its goal at the end.
      const [blue, floor] = theme === "light" ? ["0,90,230", "255,255,255"] : ["0,160,250", "35,39,45"];
      const at = ([x, y]) => [SPACE + CELL * x + CELL / 2, SPACE + CELL * y + CELL / 2 - 14];
      const colours = await playground.page.evaluate(pixels, { base64: gif.toString("base64"), frame: 0, points: [at([0, 0]), at([5, 2])] });
      assert.deepEqual(colours, [blue, floor]);
      const last = await playground.page.evaluate(pixels, { base64: gif.toString("base64"), frame: seen.count - 1, points: [at([9, 2])] });
      assert.deepEqual(last, [blue]);
    }, { theme, screens, reducedMotion: "reduce" });
  }

  flow("can be cancelled while they are drawn", async (playground) => {
    await playground.says(OPENING);
    const downloads = [];
    playground.page.on("download", (download) => downloads.push(download.suggestedFilename()));
    await open(playground, "Save moving picture (GIF)");
    await playground.says(/^Drawing the moving picture, frame \d+ of 145/);
    await playground.press("Cancel");
    await playground.says(OPENING);
    // Escape does the same; and what was cancelled does not come later.
    await open(playground, "Save moving picture (GIF)");
    await playground.says(/^Drawing the moving picture, frame \d+ of 145/);
    await playground.page.keyboard.press("Escape");
    await playground.says(OPENING);
    const svg = await save(playground, "Save moving picture (SVG)", "warehouse.svg");
    assert.ok(svg.length > 1000);
    assert.deepEqual(downloads, ["warehouse.svg"]);
  });

  flow("are offered for a plan of the scene only", async (playground, { context }) => {
    await playground.says(OPENING);
    const agent = { name: "<b>\u0001</text>", start: [0, 0], goal: [1, 0] };
    await playground.open({ name: "a.json", bytes: JSON.stringify({ giveway: 1, name: "</svg>", map: [".."], agents: [agent] }) });
    await playground.shows("</svg>");
    const button = playground.page.getByRole("button", { name: "Save moving picture (SVG)" });
    await playground.press("Save");
    assert.equal(await button.count(), 0);
    await playground.page.keyboard.press("Escape");
    await playground.press("Solve");
    await playground.says(/^Optimal/);
    const svg = (await save(playground, "Save moving picture (SVG)", "svg.svg")).toString();
    // The page itself allows no style within a document.
    const alone = await context.newPage();
    const error = await alone.evaluate((svg) => new DOMParser().parseFromString(svg, "image/svg+xml").querySelector("parsererror")?.textContent ?? null, svg);
    await alone.close();
    assert.equal(error, null);
    assert.ok(svg.includes("&lt;b&gt;"));
  });
});

/** Presses an item of the menu `Save`, which a phone has in its only one. */
async function open(playground, item) {
  await playground.press(playground.isPhone() ? "More" : "Save");
  await playground.press(item);
}

/** What is saved under an item. */
async function save(playground, item, name) {
  const download = playground.page.waitForEvent("download");
  await open(playground, item);
  const saved = await download;
  assert.equal(saved.suggestedFilename(), name);
  return readFileSync(await saved.path());
}

/** Where robots are at a time of the animation, in cells. */
function placesAt({ time, names }) {
  for (const animation of document.getAnimations()) {
    animation.pause();
    animation.currentTime = time;
  }
  const svg = document.querySelector("svg");
  const titles = [...svg.querySelectorAll("g > title")];
  return names.map((name) => {
    const place = titles.find((title) => title.textContent === name).parentElement.parentElement;
    const { e, f } = new DOMMatrix(getComputedStyle(place).transform);
    return [e, f].map((units) => Math.round((units - 50) / 10) / 10);
  });
}

/** The frames of a GIF, as the browser reads it. */
async function frames(base64) {
  const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const decoder = new ImageDecoder({ data, type: "image/gif" });
  await decoder.completed;
  const { image } = await decoder.decode({ frameIndex: 0 });
  const canvas = new OffscreenCanvas(image.displayWidth, image.displayHeight);
  const paper = canvas.getContext("2d", { willReadFrequently: true });
  paper.drawImage(image, 0, 0);
  const corner = paper.getImageData(0, 0, 1, 1).data.slice(0, 3).join();
  return { width: canvas.width, height: canvas.height, count: decoder.tracks.selectedTrack.frameCount, corner };
}

/** The colours of some points of a frame. */
async function pixels({ base64, frame, points }) {
  const data = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const decoder = new ImageDecoder({ data, type: "image/gif" });
  await decoder.completed;
  const { image } = await decoder.decode({ frameIndex: frame });
  const canvas = new OffscreenCanvas(image.displayWidth, image.displayHeight);
  const paper = canvas.getContext("2d", { willReadFrequently: true });
  paper.drawImage(image, 0, 0);
  return points.map(([x, y]) => paper.getImageData(x, y, 1, 1).data.slice(0, 3).join());
}
