// Nobody loses work, and nobody has to wonder whether they did: links, reloads, data that
// cannot be read, two tabs, a browser that keeps nothing, and a page that breaks down.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { flows, sample } from "./flow.mjs";
import { Playground } from "./page.mjs";
import { eventually } from "./wait.mjs";

const OPENING = /^Optimal: makespan 18/;
const LINK = "giveway=1&map=3.9f&name=sent&rules=0.0&costs=0&agents=A.0.0.2.2&plan=2r2d";
const NEWER = "giveway-kept=3\nnobody knows what this is\n";
const THEMES = ["light", "dark"];

describe("a link", () => {
  const flow = flows();

  for (const theme of THEMES) {
    flow(`keeps what it takes the place of, ${theme}`, async (playground, { page }) => {
      await edit(playground);
      await follow(page, LINK);
      await playground.shows("sent");
      await playground.tells(/Your own scene is kept.*Yours, “warehouse”, is where you left it\./s);
      await look(playground, `slot-link-${theme}`);
      await page.setViewportSize({ width: 1024, height: 768 });
      await look(playground, `slot-link-tablet-${theme}`);
    }, { theme });
  }

  flow("is left by one press, and comes back by another", async (playground, { page }) => {
    await edit(playground);
    await follow(page, LINK);
    await playground.tells(/Your own scene is kept/);
    await playground.press("Back to it");
    await playground.shows("warehouse");
    await playground.cellTells(0, 1, /^obstacle/);
    await playground.tells(/The scene of the link is kept/);
    await playground.press("Back to it");
    await playground.shows("sent");
    await playground.slot.getByRole("button", { name: "Close" }).click();
    await playground.tells(/^$/);
    await playground.press("Undo");
    await playground.cellTells(0, 1, /^obstacle/);
  });

  flow("may be loaded again: the press is still there, and the scene among the others", async (playground, { page, host }) => {
    await edit(playground);
    await page.goto("about:blank");
    await playground.goto(`${host.url}#${LINK}`);
    await playground.tells(/Your own scene is kept/);
    await eventually("the link to be kept", () => playground.keeps(), (text) => text.includes("=name=sent"));
    await playground.reload();
    await playground.tells(/Your own scene is kept/);
    await scenes(playground);
    const dialog = page.getByRole("dialog", { name: "Scenes" });
    await dialog.getByRole("button", { name: "warehouse (before the link)", exact: true }).waitFor();
    await playground.picture("scenes-before-the-link");
    await playground.key("Escape");
    await playground.press("Back to it");
    await playground.cellTells(0, 1, /^obstacle/);
    // Kept once, not once a reload.
    const names = await page.evaluate(() => Object.keys(localStorage).filter((name) => name.includes("before the link")));
    assert.deepEqual(names, ["giveway.scene.warehouse (before the link)"]);
  });

  flow("takes the place of an example that nobody touched without a word", async (playground, { page }) => {
    await playground.says(OPENING);
    await follow(page, LINK);
    await playground.shows("sent");
    await playground.tells(/^$/);
  }, { screens: ["desktop"] });
});

describe("a reload", () => {
  const flow = flows();

  flow("keeps undo", async (playground) => {
    await edit(playground);
    await playground.pick("Charger");
    await playground.stroke([9, 1]);
    await playground.reload();
    await playground.cellTells(9, 1, /^charger/);
    await playground.press("Undo");
    await playground.cellTells(9, 1, /^(?!charger)/);
    await playground.cellTells(0, 1, /^obstacle/);
    await playground.press("Undo");
    await playground.cellTells(0, 1, /^(?!obstacle)/);
    await playground.says(OPENING);
  });

  flow("keeps what was done while it played", async (playground) => {
    await playground.example("Who waits?");
    await playground.says(/^Optimal: makespan 4/);
    // The plan plays round and round: only the time changes.
    await eventually("it to be kept", () => playground.keeps(), (text) => text.includes("name=scenario%201") && text.includes("plan="));
    await playground.reload();
    await playground.shows("scenario 1");
    await playground.says(/^Optimal: makespan 4/);
  }, { screens: ["desktop"] });

  flow("opens what the version before kept", async (playground, { page }) => {
    await playground.says(OPENING);
    await page.evaluate((former) => {
      const plant = () => {
        localStorage.clear();
        localStorage.setItem("giveway.page", former);
      };
      addEventListener("pagehide", plant);
      document.addEventListener("visibilitychange", plant);
    }, LINK);
    await playground.reload();
    await playground.shows("sent");
    await eventually("it to be kept", () => playground.keeps(), (text) => text.includes("=name=sent"));
    // A page of that version that is still open somewhere does no harm.
    assert.equal(await page.evaluate(() => localStorage.getItem("giveway.page")), LINK);
  }, { screens: ["desktop"] });
});

describe("what cannot be read", () => {
  const flow = flows();

  for (const theme of THEMES) {
    flow(`is offered and not overwritten, ${theme}`, async (playground, { page }) => {
      await edit(playground);
      await playground.reloadOn(NEWER);
      await playground.says(OPENING);
      await playground.tells(/We could not read what was kept.*newer version/s);
      await look(playground, `slot-lost-${theme}`);
      assert.equal(await playground.slot.getByRole("button", { name: "Close" }).count(), 0);
      // Editing is free, and is kept beside it. On a phone the sheet has to be answered first.
      if (playground.isPhone()) {
        await playground.press("Download it");
      }
      await edit(playground);
      await eventually("the edit to be kept", () => playground.keeps(), (text) => text.includes("touched"));
      assert.equal(await planted(page, NEWER), 1);
      if (playground.isPhone()) {
        return;
      }
      await playground.reload();
      await playground.cellTells(0, 1, /^obstacle/);
      await playground.tells(/We could not read what was kept/);

      const download = page.waitForEvent("download");
      await playground.press("Download it");
      const saved = await download;
      assert.equal(saved.suggestedFilename(), "kept.giveway");
      assert.equal(readFileSync(await saved.path(), "utf8"), NEWER);
      await playground.tells(/^$/);
      await playground.reload();
      await playground.cellTells(0, 1, /^obstacle/);
      await playground.tells(/^$/);
      assert.equal(await planted(page, NEWER), 1, "a newer page may still read it");
    }, { theme });
  }

  for (const damaged of ["{", "giveway-kept=2\n+0.-.0", "giveway=1&map=5.7f", "\u0000"]) {
    flow(`begins anew on ${JSON.stringify(damaged)}`, async (playground, { page }) => {
      await playground.says(OPENING);
      await playground.reloadOn(damaged, { "giveway.preferences": damaged });
      await playground.says(OPENING);
      await playground.tells(/We could not read what was kept.*Nothing was deleted\./s);
      assert.equal(await planted(page, damaged), 1);
      await playground.press("Start afresh");
      await playground.tells(/^$/);
      await playground.reload();
      await playground.says(OPENING);
      await playground.tells(/^$/);
    }, { screens: ["desktop"] });
  }
});

describe("two tabs", () => {
  const flow = flows();

  for (const theme of THEMES) {
    flow(`that both go on ask, ${theme}`, async (playground, { context, host }) => {
      const other = await goApart(playground, context, host);
      await playground.tells(/Another tab changed this scene.*Undo brings back the one you do not take\./s);
      await look(playground, `slot-tab-${theme}`);
      await playground.cellTells(9, 1, /^obstacle/);
      await playground.press("Take theirs");
      await playground.tells(/^$/);
      await playground.cellTells(8, 0, /^charger/);
      await playground.cellTells(9, 1, /^(?!obstacle)/);
      await playground.press("Undo");
      await playground.cellTells(9, 1, /^obstacle/);
      await other.page.close();
    }, { theme, before: deafen });
  }

  flow("that both go on may keep their own", async (playground, { context, host }) => {
    const other = await goApart(playground, context, host);
    await playground.tells(/Another tab changed this scene/);
    await playground.press("Keep mine");
    await playground.tells(/^$/);
    await playground.cellTells(9, 1, /^obstacle/);
    await playground.press("Undo");
    await playground.cellTells(8, 0, /^charger/);
    await other.page.close();
  }, { screens: ["desktop"], before: deafen });

  for (const theme of THEMES) {
    flow(`of which one only watches follow the other, ${theme}`, async (playground, { context, host }) => {
      await playground.says(OPENING);
      const other = await tab(playground, context, host);
      await other.says(OPENING);
      await stroke(other, "Obstacle", [0, 1]);
      await playground.tells(/Another tab changed this scene.*There \(0, 1\) is an obstacle\. It is shown here, too\./s);
      await playground.cellTells(0, 1, /^obstacle/);
      await look(playground, `slot-taken-${theme}`);
      await playground.press("Undo it here");
      await playground.cellTells(0, 1, /^(?!obstacle)/);
      await playground.tells(/^$/);
      // The other one stays as it is.
      await other.cellTells(0, 1, /^obstacle/);
      await other.page.close();
    }, { theme });
  }

  flow("keep a scene each, and come back to their own", async (playground, { context, host }) => {
    await playground.example("No way past");
    await playground.shows("scenario 6");
    const other = await tab(playground, context, host);
    await other.shows("scenario 6");
    await other.example("Who waits?");
    await other.shows("scenario 1");
    await eventually("it to be kept", () => other.keeps(), (text) => text.includes("scenario%201"));
    await playground.tells(/^$/);
    await playground.reload();
    await playground.shows("scenario 6");
    await other.reload();
    await other.shows("scenario 1");
    // A new tab opens what was kept last.
    const before = await playground.keeps();
    await stroke(playground, "Obstacle", [0, 0]);
    await eventually("it to be kept", () => playground.keeps(), (text) => text !== before);
    const third = await tab(playground, context, host);
    await third.shows("scenario 6");
    // What a closed tab leaves behind is among the scenes.
    await other.page.close();
    await scenes(third);
    const dialog = third.page.getByRole("dialog", { name: "Scenes" });
    await third.picture("scenes-other-tabs");
    await dialog.getByRole("button", { name: "scenario 1", exact: true }).click();
    await third.shows("scenario 1");
    await third.page.close();
  }, { screens: ["desktop"] });

  flow("of one number get another one", async (playground, { context, host, page }) => {
    await edit(playground);
    await eventually("it to be kept", () => playground.keeps(), (text) => text.includes("touched"));
    const number = await page.evaluate(() => localStorage.getItem("giveway.tabs").split(" ")[0]);
    // As a browser does that duplicates a tab whose page is away.
    const other = await tab(playground, context, host, (number) => sessionStorage.setItem("giveway.tab", number), number);
    await stroke(other, "Charger", [9, 1]);
    const numbers = () => page.evaluate(() => Object.keys(localStorage).filter((name) => name.startsWith("giveway.tab.")));
    await eventually("two documents", numbers, (names) => names.length === 2);
    await other.page.close();
  }, { screens: ["desktop"] });
});

describe("a browser that keeps nothing", () => {
  const flow = flows();

  for (const theme of THEMES) {
    flow(`is told of once, with a download, ${theme}`, async (playground, { page }) => {
      await playground.says(OPENING);
      await page.evaluate(() => {
        window.setItem = Storage.prototype.setItem;
        Storage.prototype.setItem = () => {
          throw new DOMException("no room", "QuotaExceededError");
        };
      });
      await edit(playground);
      await playground.tells(/Your work is not being kept/);
      await look(playground, `slot-unkept-${theme}`);
      const download = page.waitForEvent("download");
      await playground.press("Download it");
      const saved = await download;
      assert.equal(saved.suggestedFilename(), "warehouse.giveway");
      const bytes = readFileSync(await saved.path());
      await playground.tells(/^$/);
      await stroke(playground, "Charger", [9, 1]);
      await playground.pick("Select");
      await new Promise((resolve) => setTimeout(resolve, 1000));
      assert.equal(await playground.slot.getByRole("button").count(), 0, "it was told already");
      await page.evaluate(() => {
        Storage.prototype.setItem = window.setItem;
      });
      // What was downloaded can be opened again.
      await playground.open({ name: "warehouse.giveway", bytes });
      await playground.cellTells(9, 1, /^(?!charger)/);
      await playground.cellTells(0, 1, /^obstacle/);
    }, { theme });
  }
});

describe("a page that breaks down", () => {
  const flow = flows();

  for (const theme of THEMES) {
    flow(`saves, says so, and goes on, ${theme}`, async (playground, { page }) => {
      await edit(playground);
      await breakDown(playground);
      const overlay = page.getByRole("alertdialog", { name: "Something went wrong in the page." });
      await overlay.getByText("Your work is saved.").waitFor();
      await look(playground, `broke-${theme}`);
      await overlay.getByText("What happened").click();
      await overlay.getByText(/panicked at/).waitFor();
      await overlay.getByRole("button", { name: "Reload the page" }).click();
      await overlay.waitFor({ state: "detached" });
      await playground.board.waitFor();
      await playground.cellTells(0, 1, /^obstacle/);
      await playground.tells(/^$/);
      await playground.press("Undo");
      await playground.cellTells(0, 1, /^(?!obstacle)/);
    }, { theme, complains: true });
  }

  flow("as it opens puts aside what it opened", async (playground, { context, page }) => {
    await edit(playground);
    await eventually("the edit to be kept", () => playground.keeps(), (text) => text.includes("touched"));
    // It breaks down when it opens what is kept, and only then.
    await context.addInitScript(() => {
      const create = Document.prototype.createElementNS;
      Document.prototype.createElementNS = function (...words) {
        if (sessionStorage.getItem("giveway.opening")) {
          throw new Error("out of order");
        }
        return create.apply(this, words);
      };
    });
    const overlay = page.getByRole("alertdialog");
    await page.reload();
    await overlay.getByRole("button", { name: "Reload the page" }).waitFor();
    await overlay.getByRole("button", { name: "Reload the page" }).click();
    await playground.says(OPENING);
    await playground.tells(/broke down when it opened what was kept/);
    await look(playground, "slot-breaks");
    await playground.cellTells(0, 1, /^(?!obstacle)/);
    const download = page.waitForEvent("download");
    await playground.press("Download it");
    assert.match(readFileSync(await (await download).path(), "utf8"), /^giveway-kept=2\n/);
  }, { complains: true, screens: ["desktop"] });
});

describe("new and dropped", () => {
  const flow = flows();

  for (const theme of THEMES) {
    flow(`a new scene of a size, as one step, ${theme}`, async (playground, { page }) => {
      await playground.says(OPENING);
      await (playground.isPhone() ? playground.act("New scene") : playground.press("New"));
      const dialog = page.getByRole("dialog", { name: "New scene" });
      await dialog.getByLabel("Name").fill("my hall");
      await dialog.getByLabel("Columns").fill("5");
      await dialog.getByLabel("Rows").fill("4");
      await playground.picture(`new-scene-${theme}`);
      await dialog.getByRole("button", { name: "Create" }).click();
      await playground.shows("my hall");
      assert.equal(await playground.board.getAttribute("aria-colcount"), "5");
      assert.equal(await playground.board.getAttribute("aria-rowcount"), "4");
      await playground.press("Undo");
      await playground.shows("warehouse");
      await playground.says(OPENING);
    }, { theme });
  }

  flow("a plan for the scene on the board is judged", async (playground, { page }) => {
    await playground.says(OPENING);
    const plan = await save(playground, "Save plan");
    await stroke(playground, "Obstacle", [9, 1]);
    await drop(page, { name: "plan.json", text: plan });
    await playground.warns(/plan\.json cannot be opened.*breaks a rule/s);
    await playground.press("Dismiss");
    await playground.press("Undo");
    await drop(page, { name: "plan.json", text: plan });
    await playground.says(/makespan 18/);
    await playground.shows("warehouse");
  }, { screens: ["desktop"] });

  flow("a scenario for the map on the board is used with it", async (playground, { page }) => {
    const scen = { name: "empty-8-8-even-1.scen", text: readFileSync(sample("movingai/empty-8-8-even-1.scen"), "utf8") };
    await drop(page, scen);
    await playground.warns(/empty-8-8\.map: open both files together.*the map on the board is 10 x 3/s);
    await playground.press("Dismiss");
    await playground.open(sample("movingai/empty-8-8.map"));
    await playground.shows("empty-8-8");
    await drop(page, scen);
    const dialog = page.getByRole("dialog", { name: "How many agents?" });
    await dialog.getByLabel("Agents", { exact: true }).fill("3");
    await dialog.getByRole("button", { name: "Open scene" }).click();
    await playground.shows("empty-8-8-even-1");
  }, { screens: ["desktop"] });
});

/** A picture of what is said, once it stands still. */
async function look(playground, title) {
  await playground.page.evaluate(() => Promise.all([...document.querySelectorAll(".slot")].flatMap((slot) => slot.getAnimations()).map((motion) => motion.finished)));
  await playground.picture(title);
}

/** Closes a cell of the opening scene. */
async function edit(playground) {
  await playground.says(OPENING);
  await stroke(playground, "Obstacle", [0, 1]);
  await playground.cellTells(0, 1, /^obstacle/);
}

async function stroke(playground, tool, cell) {
  await playground.pick(tool);
  await playground.stroke(cell);
}

async function follow(page, link) {
  await page.evaluate((link) => {
    location.hash = link;
  }, link);
}

function scenes(playground) {
  return playground.sceneName.getByRole("button").click();
}

/** Another tab of the same browser, with the page in it. */
async function tab(playground, context, host, before, given) {
  const page = await context.newPage();
  if (before) {
    await page.addInitScript(before, given);
  }
  const other = new Playground(page, (title) => playground.pathOf(title));
  await other.goto(host.url);
  return other;
}

/** Pages hear of other tabs only where they are told to. */
function deafen(context) {
  return context.addInitScript(() => {
    addEventListener("storage", (event) => window.hears || event.stopImmediatePropagation(), true);
  });
}

/** Opens another tab, and edits in both before either hears of the other. */
async function goApart(playground, context, host) {
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
function planted(page, text) {
  return page.evaluate((text) => {
    const ofTabs = Object.entries({ ...localStorage }).filter(([name]) => name.startsWith("giveway.tab."));
    return ofTabs.filter(([, kept]) => kept === text).length;
  }, text);
}

/** Lets the page find that the browser makes no more pictures, which it relies on. */
async function breakDown(playground) {
  await playground.page.evaluate(() => {
    Document.prototype.createElementNS = () => {
      throw new Error("out of order");
    };
  });
  await (playground.isPhone() ? playground.press("More") : playground.press("Open"));
}

async function drop(page, ...files) {
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

async function save(playground, item) {
  const download = playground.page.waitForEvent("download");
  await playground.press("Save");
  await playground.press(item);
  return readFileSync(await (await download).path(), "utf8");
}
