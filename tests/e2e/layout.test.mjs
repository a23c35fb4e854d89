// Where things stand on screens of all sizes: each of these once was not so.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { adapt, begin, join, running } from "./change.mjs";
import { flows, sample } from "./flow.mjs";
import { geometry } from "./geometry.mjs";
import { eventually, still } from "./wait.mjs";

const HARD = sample("mmapf/A17_mm_20x20_o15_a30.json");
const OPENING = /^Optimal: makespan 18/;
const screens = ["desktop"];
const reducedMotion = "reduce";
const lying = { screens: ["phone"], width: 844, height: 390, reducedMotion };

describe("the layout", () => {
  const flow = flows();

  for (const width of [721, 768, 820, 860, 861, 1024, 1180, 1181, 1240, 1280, 1340, 1370, 1440]) {
    flow(`the transport has its place at ${width} pixels`, async (playground, { page }) => {
      await playground.says(OPENING);
      await playground.pause();
      await areApart(page.locator(".transport"));
      assert.deepEqual(await geometry(page), []);
    }, { screens, width, height: 800, reducedMotion });
  }

  for (const width of [390, 412, 430]) {
    flow(`the speed leaves the time free on a phone of ${width} pixels`, async (playground, { page }) => {
      await playground.says(OPENING);
      await playground.pause();
      await playground.press("To end");
      await playground.reaches(18);
      await page.getByText("of 18").waitFor();
      await page.getByTitle("Speed").waitFor();
      await areApart(page.locator(".transport"));
    }, { screens: ["phone"], width, height: 800, reducedMotion });
  }

  flow("on a phone that lies the board stands beside the rest", async (playground, { page }) => {
    await playground.says(OPENING);
    await playground.pause();
    const board = await playground.board.boundingBox();
    assert.ok(board.height >= 190 && board.width >= 400, `the board is ${board.width} by ${board.height}`);
    // Whichever of the two is there: the inspector, or the lanes.
    const told = await playground.inspector.or(page.getByRole("group", { name: "Lanes" })).first().boundingBox();
    assert.ok(told.x >= board.x + board.width, "what is told is beside it");
    const tools = await playground.tools.boundingBox();
    const play = await playground.button("To start").boundingBox();
    assert.ok(tools.x + tools.width <= play.x, "the tools cover the transport");
    await playground.pick("Slow zone");
    assert.equal(await playground.tools.getByRole("button", { name: "Slow zone" }).getAttribute("aria-pressed"), "true");
    await playground.picture("lying");
  }, lying);

  for (const [how, options] of [["stands", { screens: ["phone"], reducedMotion }], ["lies", lying]]) {
    flow(`on a phone that ${how} all is in its place while a first plan is proved`, async (playground, { page }) => {
      await playground.says(OPENING);
      await page.getByRole("tab", { name: "Plan" }).click();
      await playground.open(HARD);
      await playground.press("Solve");
      await playground.button("Pause").waitFor();
      // Whichever tab was chosen: there are none now.
      await playground.inspector.getByText("So far").waitFor();
      const last = page.locator(".clock span");
      assert.ok(await last.evaluate((words) => words.scrollWidth <= words.clientWidth), "the last time is cut off");
      await areApart(page.locator(".wait > .transport"));
      await playground.picture(`solving-${how}`);
      await playground.press("Cancel");
    }, options);
  }

  for (const height of [664, 740, 844]) {
    flow(`an answer is read at once on a phone of ${height} pixels`, async (playground, { page }) => {
      await answered(playground);
      const board = await playground.board.boundingBox();
      assert.ok(board.height <= height * 0.35 + 1, `the board has ${board.height}`);
      const verdict = await playground.inspector.getByText("same cost", { exact: true }).first().boundingBox();
      const words = await playground.inspector.getByText(/^A2 lets A1 pass: /).first().boundingBox();
      const foot = await playground.button("Show the other plan").boundingBox();
      assert.ok(verdict.y > board.y + board.height && words.y + words.height <= foot.y, "the verdict is not in sight");
      const costs = await playground.inspector.getByRole("table", { name: "Who pays" }).boundingBox();
      assert.ok(verdict.y < costs.y, "the verdict comes first");
      assert.equal(await playground.tools.isVisible(), false, "the tools fold away");
      await playground.picture(`answer-${height}`);
      await playground.key("Escape");
      await playground.tools.waitFor();
    }, { screens: ["phone"], width: 390, height, reducedMotion });
  }

  for (const [width, height] of [[1440, 900], [1280, 720], [390, 664]]) {
    flow(`what would help is in sight where there is no plan, at ${width} by ${height}`, async (playground) => {
      await playground.example("No way past");
      await playground.says(/^No plan/);
      await playground.inspector.getByRole("button", { name: /^Why is there no plan\?/ }).click();
      const repair = playground.inspector.getByRole("listitem").filter({ hasText: "makespan 6, sum of costs 8" }).first();
      await repair.waitFor();
      const { y, height: high } = await repair.boundingBox();
      assert.ok(y + high <= height, `the first repair ends at ${y + high}`);
      // The reasons carry the numbers that stand on the map.
      const map = playground.board.locator(".num text");
      // The third is about both robots among each other, and has no place.
      await eventually("the numbers", () => map.allTextContents(), (found) => found.join("") === "124");
      for (const number of ["1", "2", "3", "4"]) {
        await playground.inspector.getByRole("button", { name: new RegExp(`^${number}\\s`) }).waitFor({ state: "attached" });
      }
      const verdict = await playground.inspector.locator(".verdict").innerText();
      assert.ok(verdict.length < 160, `a wall of text: ${verdict}`);
    }, { screens, width, height, reducedMotion });
  }

  flow("a number leaves the name of a robot free", async (playground, { page }) => {
    await answered(playground);
    await playground.press("Step forward");
    await playground.reaches(1);
    const names = await boxes(page.getByRole("grid", { name: "Board" }).locator(".agent .name"));
    const circles = await boxes(page.getByRole("grid", { name: "Board" }).locator(".num circle"));
    assert.ok(names.length === 2 && circles.length === 2);
    for (const name of names) {
      for (const circle of circles) {
        assert.ok(isOutside(name, circle), `${JSON.stringify(circle)} lies on ${JSON.stringify(name)}`);
      }
    }
  }, { screens, reducedMotion });

  flow("a star leaves the bolt of its charger free", async (playground, { page }) => {
    const scene = { giveway: 1, name: "starred", map: ["..+.."], agents: [{ name: "A1", start: [0, 0], goal: [4, 0], waypoints: [[2, 0]] }] };
    await playground.open({ name: "starred.json", bytes: Buffer.from(JSON.stringify(scene)) });
    await playground.shows("starred");
    const covered = await page.evaluate(() => {
      const [bolt, star] = [document.querySelector(".bolt"), document.querySelector(".star .body")];
      const across = star.getScreenCTM().inverse().multiply(bolt.getScreenCTM());
      const length = bolt.getTotalLength();
      return Array.from({ length: 100 }, (_, step) => bolt.getPointAtLength(length * step / 100).matrixTransform(across))
        .filter((point) => star.isPointInFill(point) || star.isPointInStroke(point)).length;
    });
    assert.equal(covered, 0, "of 100 points of the bolt");
  }, { screens, reducedMotion });

  flow("one next step is filled", async (playground, { page }) => {
    await answered(playground);
    assert.deepEqual(await geometry(page), []);
    assert.deepEqual(await filled(page), ["Show the other plan"]);
    await playground.press("Show the other plan");
    await page.mouse.move(2, 2);
    await eventually("to keep the plan to be the next step", () => filled(page), (names) => names.join() === "Keep this plan");
    await playground.press("Keep this plan");
    await playground.press("Done");
    await eventually("play to be the next step", () => filled(page), (names) => names.join() === "Play");
    await playground.example("No way past");
    await playground.says(/^No plan/);
    assert.deepEqual(await filled(page), ["Why is there no plan?"]);
    await page.getByRole("region", { name: "Timeline" }).getByRole("button", { name: "Why is there no plan?" }).click();
    await eventually("a repair to be the next step", () => filled(page), (names) => names.length === 1 && names[0].startsWith("Remove the obstacle at"));
  }, { screens, reducedMotion });

  flow("each way to go on has a board of its own, in step with the others", async (playground, { page }) => {
    await running(playground);
    await begin(playground);
    await join(playground, [2, 2], [1, 0]);
    await playground.key("Escape");
    await adapt(playground);
    // Methods that found the same plan have one board.
    const names = (await page.getByRole("article").evaluateAll((all) => all.map((one) => one.getAttribute("aria-label")))).filter(Boolean);
    const boards = await page.getByRole("grid", { name: /^Plan (with|near) / }).all();
    assert.ok(boards.length >= 1 && boards.length <= 3, `${boards.length} boards for ${names}`);
    const sizes = [];
    for (const board of boards) {
      await playground.cellTells(2, 2, /A3/, board);
      const { width, height } = await board.boundingBox();
      assert.ok(width > 150 && height >= 110, `${width} by ${height}`);
      sizes.push(`${Math.round(width)} by ${Math.round(height)}`);
    }
    assert.equal(new Set(sizes).size, 1, sizes.join(", "));
    await playground.press("To end");
    await playground.reaches(4);
    for (const board of boards) {
      await playground.cellTells(1, 0, /A3/, board);
    }
    // What changes is added on the board, which comes back for it.
    assert.equal(await playground.board.isVisible(), false);
    await playground.press("Add a change on the board");
    await playground.board.waitFor();
    await playground.pick("Select");
    await boards[0].waitFor();
  }, { screens, reducedMotion });

  flow("without a way to go on it is told why, and what would help", async (playground, { page }) => {
    await playground.example("Siding");
    await playground.says(/^Optimal/);
    await playground.press("To start");
    await playground.press("Step forward");
    await playground.press("Step forward");
    await playground.reaches(2);
    await begin(playground);
    await playground.pick("Obstacle");
    await playground.stroke([4, 0]);
    await adapt(playground);
    const replan = page.getByRole("article", { name: "Everything new", exact: true });
    assert.match(await replan.innerText(), /No plan\s+A1 and A2 cannot both arrive/);
    await page.getByRole("grid", { name: "Plan with everything new" }).waitFor();
    await playground.picture("no-way-to-go-on");
    // The answer beside them offers repairs, and the first of them is the next step.
    await eventually("one next step", () => filled(page), (names) => names.length === 1 && /^Remove the obstacle at \(4, 0\)/.test(names[0]));
    await page.getByRole("region", { name: "What you could try" }).getByRole("button", { name: /^Take back: / }).click();
    await eventually("the columns to be gone", () => replan.count(), (count) => count === 0);
    await playground.cellTells(4, 0, /^free/);
  }, { screens, reducedMotion });

  flow("after a pinch all of the map comes back by a touch, and a tool tells its name", async (playground, { context, page }) => {
    await playground.says(OPENING);
    const fit = page.getByRole("button", { name: "Fit", exact: true });
    assert.equal(await fit.count(), 0);
    const wide = async () => (await playground.cell(4, 0).boundingBox()).width;
    await playground.pause();
    const before = await still("the board", wide);
    const session = await context.newCDPSession(page);
    const touch = (type, ...at) => session.send("Input.dispatchTouchEvent", { type, touchPoints: at.map(({ x, y }, id) => ({ x, y, id })) });
    const { x, y } = await playground.middleOf(4, 0);
    await touch("touchStart", { x: x - 10, y });
    await touch("touchStart", { x: x - 10, y }, { x: x + 10, y });
    await touch("touchMove", { x: x - 50, y }, { x: x + 50, y });
    await touch("touchEnd");
    await eventually("larger cells", wide, (now) => now > before * 1.5);
    await playground.picture("fit");
    await fit.tap();
    await eventually("all of the map", wide, (now) => Math.abs(now - before) < 1);
    await fit.waitFor({ state: "detached" });
    await playground.tools.getByRole("button", { name: "Slow zone" }).tap();
    await playground.tools.getByText("Slow zone", { exact: true }).waitFor();
    await playground.picture("tool-name");
  }, { screens: ["phone"], reducedMotion });
});

async function answered(playground) {
  await playground.example("Who waits?");
  await playground.says(/^Optimal: makespan 4, sum of costs 7/);
  await playground.press("To start");
  await playground.reaches(0);
  await playground.showTab("Inspector");
  await playground.inspector.getByRole("button", { name: /^A2\b/ }).first().click();
  await playground.inspector.getByRole("button", { name: /^Why does A2 wait at \(3, 1\)\?/ }).first().click();
  await playground.button("Show the other plan").waitFor();
  await playground.answered();
}

/** What stands in a row there lies beside each other, and within it. */
async function areApart(row) {
  const { x, width } = await row.boundingBox();
  const parts = await row.locator("button, .clock > *").evaluateAll((all) => all
    .map((part) => part.getBoundingClientRect())
    .filter((rect) => rect.width > 0)
    .map(({ left, right, top, bottom }) => ({ left, right, top, bottom }))
    .sort((a, b) => a.left - b.left));
  assert.ok(parts.length > 2);
  parts.forEach((part, index) => {
    assert.ok(part.right <= x + width + 0.5, `part ${index} ends at ${part.right}, the row at ${x + width}`);
    // On a narrow tablet the tabs have a row of their own.
    const besides = parts.slice(0, index).filter((other) => other.top < part.bottom && part.top < other.bottom);
    assert.ok(besides.every((other) => part.left >= other.right - 0.5), `part ${index} lies on one before it`);
  });
}

/** The boxes of shapes on the screen. */
function boxes(shapes) {
  return shapes.evaluateAll((all) => all.map((shape) => {
    const { left, top, right, bottom } = shape.getBoundingClientRect();
    return { left, top, right, bottom };
  }));
}

/** Whether a box is outside of the circle in another box. */
function isOutside(box, circle) {
  const [x, y] = [(circle.left + circle.right) / 2, (circle.top + circle.bottom) / 2];
  const across = Math.max(box.left - x, 0, x - box.right);
  const down = Math.max(box.top - y, 0, y - box.bottom);
  return Math.hypot(across, down) >= (circle.right - circle.left) / 2;
}

/** The buttons that are filled. */
function filled(page) {
  return page.getByRole("button").evaluateAll((all) => {
    const probe = document.createElement("i");
    document.body.append(probe);
    probe.style.background = "var(--ink)";
    const ink = getComputedStyle(probe).backgroundColor;
    probe.remove();
    return all
      .filter((button) => !button.disabled && getComputedStyle(button).backgroundColor === ink)
      .map((button) => (button.innerText.trim().split("\n")[0]));
  });
}
