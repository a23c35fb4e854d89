// Plans of elsewhere: dropped, seen, judged, compared, brought back.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { AISLES, BEST, HALL, LATE, lines, octile, own, plan, straight } from "./elsewhere.mjs";
import { BOTH, LOOKS, flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

/** Waits until the inspector tells this. */
function tells(playground, pattern) {
  return eventually(`the inspector to tell ${pattern}`, () => playground.inspector.innerText(), (text) => pattern.test(text));
}

/** Drops files onto the page, as a hand does. */
function drop(playground, ...files) {
  return playground.page.evaluate((dropped) => {
    const data = new DataTransfer();
    for (const { name, bytes } of dropped) {
      data.items.add(new File([bytes], name));
    }
    for (const kind of ["dragover", "drop"]) {
      document.body.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
    }
  }, files);
}

const WRONG = [own("aisles.json", AISLES), plan("paths.json", straight(AISLES))];

describe("a plan of elsewhere", () => {
  const flow = flows();

  for (const look of LOOKS) {
    flow(`that is not legal is told with every broken rule (${look.theme})`, async (playground) => {
      await drop(playground, ...WRONG);
      await playground.says(/^paths\.json breaks rules \d+ times\. As it stands it would cost 78\.$/);
      await tells(playground, /every legal plan costs at least 84\. So it had to break a rule\./);
      const rows = playground.inspector.getByRole("button", { name: /, go to time \d+$/ });
      await rows.nth(1).click();
      await playground.inspector.locator("[aria-current=true]").first().waitFor();
      await playground.picture(`audit-${look.theme}`);
      await playground.press("Find a legal plan");
      await playground.button("Use the legal plan").waitFor();
      await playground.picture(`audit-compared-${look.theme}`);
      await playground.press("Use the legal plan");
      await playground.says(/^Optimal: sum of costs 84, makespan \d+\.$/);
      await playground.act("Undo");
      await playground.says(/^paths\.json breaks/);
    }, look);
  }

  flow("that is legal is told how far it is from the best", async (playground) => {
    await drop(playground, own("hall.json", HALL), plan("late.json", LATE));
    await playground.says(/^This plan was shared|^There is a better plan|sum of costs 7/);
  });

  flow("and a second one of the same scene are compared", async (playground) => {
    const wrong = plan("straight.json", straight(HALL));
    await drop(playground, own("hall.json", HALL), wrong, plan("late.json", LATE), plan("best.json", BEST));
    await tells(playground, /straight\.json/);
    await playground.inspector.getByRole("button", { name: /^late\.json/ }).click();
    await tells(playground, /Legal\n*16\.7 % above the best\. There is a plan that costs 6, and this one costs 7\./);
    await playground.picture("audit-legal");
    await playground.press("Compare side by side");
    await playground.picture("audit-two");
  }, { screens: BOTH });

  flow("comes back after a reload, and a link carries it", async (playground) => {
    await drop(playground, ...WRONG);
    await tells(playground, /at least 84/);
    await playground.page.reload();
    await playground.says(/^paths\.json breaks/);
    await tells(playground, /at least 84/);
    assert.equal(await playground.inspector.getByRole("heading", { name: "A plan from elsewhere" }).count(), 1);
  });

  flow("a scene with its plan is played, and one press asks how good the plan is", async (playground) => {
    await playground.open(own("hall.json", HALL), plan("hall-plan.json", LATE));
    await playground.shows("hall");
    await playground.button("How good is this plan?").click();
    await tells(playground, /16\.7 % above the best/);
    assert.equal(await playground.inspector.getByRole("heading", { name: "How good is this plan?" }).count(), 1);
    await playground.says(/^This plan keeps every rule\./);
    await playground.press("Undo");
    await playground.button("How good is this plan?").waitFor();
  });

  flow("waits for its map, is read another way, and read so again by Undo", async (playground) => {
    await drop(playground, { name: "paths.txt", bytes: lines(straight(AISLES)) });
    await playground.warns(/paths\.txt does not name its map: open the map \(\.map\) that the plan was made for, too\./);
    await drop(playground, { name: "aisles.map", bytes: octile(AISLES.map) });
    await playground.says(/^paths\.txt breaks rules 6 times\./);
    await tells(playground, /One line for each robot\s+as EECBS and CBSH2 write it/);
    await drop(playground, own("aisles.json", AISLES), { name: "paths.txt", bytes: lines(straight(AISLES)) });
    await playground.says(/^paths\.txt breaks rules 6 times\./);
    await playground.inspector.getByRole("button", { name: "Change" }).click();
    await playground.picture("audit-change");
    await playground.inspector.getByRole("button", { name: /^Column first, then row, from 0/ }).click();
    await tells(playground, /Not for this scene\s+A1 starts elsewhere: 0 of 8 robots fit\./);
    await playground.act("Undo");
    await tells(playground, /6 collisions/);
  });

  flow("of a map of the benchmark finds that by its name", async (playground) => {
    const tracker = `"agents","lower_cost","lower_date","solution_cost","solution_date","path"\n"1","1","","1","","rr"\n`;
    await drop(playground, { name: "empty-8-8_random-1_1.tracker.csv", bytes: tracker });
    await playground.says(/^empty-8-8_random-1_1\.tracker\.csv breaks/);
    assert.equal(await playground.board.getAttribute("aria-colcount"), "8");
  });

  flow("is pressed through by keys, with names that say where they lead", async (playground) => {
    await drop(playground, ...WRONG);
    const row = playground.inspector.getByRole("button", { name: "A7 enters (6, 4), where A3 stays from time 8, go to time 9" });
    await row.focus();
    await playground.page.keyboard.press("Enter");
    await playground.inspector.locator("[aria-current=true]", { hasText: "A7 enters (6, 4)" }).waitFor();
    await eventually("time 9", () => playground.page.getByRole("slider", { name: "Time" }).getAttribute("aria-valuenow"), (time) => time === "9");
  });

  flow("is told in a report, and saved as others write it", async (playground) => {
    await drop(playground, ...WRONG);
    await tells(playground, /at least 84/);
    const saved = async (name, ending) => {
      await playground.press("Save");
      await playground.press("Report, other formats");
      const dialog = playground.page.getByRole("dialog");
      await dialog.getByRole("button", { name }).click();
      const download = playground.page.waitForEvent("download", (file) => file.suggestedFilename().endsWith(ending));
      await dialog.getByRole("button", { name: "Save", exact: true }).click();
      const file = await download;
      return { name: file.suggestedFilename(), text: readFileSync(await file.path(), "utf8") };
    };
    const report = await saved(/^Markdown/, ".md");
    assert.equal(report.name, "paths-report.md");
    assert.match(report.text, /\*\*Not legal: 6 collisions\.\*\*/);
    assert.match(report.text, /#giveway=1&/);
    const paths = await saved(/^One line for each robot/, ".txt");
    assert.match(paths.text, /^Agent 0: ?\(4,11\)->/);
  });

  flow("that is none of any format is refused with its place", async (playground) => {
    await drop(playground, { name: "notes.txt", bytes: "good morning" });
    await playground.warns(/notes\.txt, line 1, column 1/);
  });
});
