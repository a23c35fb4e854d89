// Files that a person opens and saves: one by one, together, dropped, and such that
// must be refused.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe } from "node:test";

import { BOTH, flows, sample, scene } from "./flow.mjs";

const OPENING = /^Optimal: makespan 18/;
const MAP = sample("movingai/empty-8-8.map");
const SCENARIO = sample("movingai/empty-8-8-even-1.scen");

describe("files", () => {
  const flow = flows();

  flow("opens a MovingAI map with its scenario, and solves it", async (playground) => {
    await playground.open(MAP, SCENARIO);
    await chooseAgents(playground, 5);
    await playground.shows("empty-8-8-even-1");
    await playground.press("Solve");
    // Proved by the command, too: giveway solve empty-8-8-even-1.scen --agents 5.
    await playground.says(/^Optimal: makespan 8, sum of costs 27, 0 charges\.$/);
    await playground.picture("movingai");
  });

  flow("opens a map alone", async (playground) => {
    await playground.open(sample("movingai/room-32-32-4.map"));
    await playground.shows("room-32-32-4");
    assert.equal(await playground.board.getAttribute("aria-colcount"), "32");
    await playground.picture("map-alone");
  });

  flow("tells that a scenario alone has no map", async (playground) => {
    await playground.says(OPENING);
    await playground.open(SCENARIO);
    await playground.warns(/empty-8-8\.map: open both files together/);
    await staysAsItWas(playground);
  });

  flow("opens files that are dropped", async (playground) => {
    const files = [MAP, SCENARIO].map((path) => ({ name: path.split("/").at(-1), text: readFileSync(path, "utf8") }));
    await playground.page.evaluate((files) => {
      const data = new DataTransfer();
      for (const { name, text } of files) {
        data.items.add(new File([text], name));
      }
      for (const kind of ["dragover", "drop"]) {
        document.body.dispatchEvent(new DragEvent(kind, { dataTransfer: data, bubbles: true, cancelable: true }));
      }
    }, files);
    await chooseAgents(playground, 3);
    await playground.shows("empty-8-8-even-1");
  }, { screens: ["desktop"] });

  flow("saves the scene and the plan, and opens what it saved", async (playground) => {
    await playground.says(OPENING);
    const saved = await save(playground, "Save scene");
    assert.equal(saved.name, "warehouse.json");
    const { map, agents } = scene("seed/warehouse.json");
    const read = JSON.parse(saved.text);
    assert.deepEqual(read.map, map);
    assert.deepEqual(read.agents, agents);
    const plan = await save(playground, "Save plan");
    assert.equal(plan.name, "warehouse-plan.json");
    assert.match(plan.text, /"A2"/);

    await playground.example("No way past");
    await playground.shows("scenario 6");
    await playground.open({ name: saved.name, bytes: saved.text });
    await playground.shows("warehouse");
  }, { screens: BOTH });

  const refused = [
    ["a JSON file that breaks off", "broken.json", '{\n  "giveway": 1,\n  "map": [".."', /broken\.json.*line 3.*column \d+/s],
    ["a JSON file with a fault", "fault.json", '{"giveway": 1, "map": [".x"], "agents": []}', /fault\.json, line 1, column 26: map\[0\]\[1\]: found "x"/],
    ["a picture", "photo.png", Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0, 1, 2, 255), /photo\.png is no picture that can be shown/],
    ["an empty file", "empty.json", "", /empty\.json cannot be opened/],
    ["a huge file", "huge.json", new Uint8Array(20_000_001).fill(32), /found 21 MB, expected at most 20 MB/],
    ["a map that is larger than the page takes", "large.map", wideMap(2100), /2100.*from 1 to 2048/s],
    ["a file that would be a program", "<img src=x onerror=alert(1)>.json", '{"giveway": "<script>alert(1)</script>"}', /<img src=x onerror=alert\(1\)>\.json cannot be opened/],
  ];
  for (const [what, name, bytes, told] of refused) {
    flow(`refuses ${what}, and the scene stays`, async (playground) => {
      await playground.says(OPENING);
      await playground.open({ name, bytes });
      await playground.warns(told);
      await staysAsItWas(playground);
    }, { screens: ["desktop"] });
  }

  flow("tells the place of a fault, and the notice goes when it is dismissed", async (playground) => {
    await playground.says(OPENING);
    await playground.open({ name: "broken.json", bytes: '{\n  "giveway": 1,\n  "map": [".."' });
    await playground.warns(/line 3/);
    await playground.picture("broken-file");
    await playground.press("Dismiss");
    await playground.warns(/^\s*$/);
    await staysAsItWas(playground);
  }, { screens: BOTH });
});

async function chooseAgents(playground, count) {
  const dialog = playground.page.getByRole("dialog", { name: "How many robots?" });
  await dialog.getByLabel("Robots", { exact: true }).fill(String(count));
  await dialog.getByRole("button", { name: "Open scene" }).click();
  await dialog.waitFor({ state: "detached" });
}

/** That the page shows what it opened on, and can be used. */
async function staysAsItWas(playground) {
  await playground.shows("warehouse");
  await playground.says(OPENING);
  await playground.press("Solve");
  await playground.says(OPENING);
}

/** What is saved under an item of the menu `Save`, which a phone has in its only one. */
async function save(playground, item) {
  const download = playground.page.waitForEvent("download");
  if (playground.isPhone()) {
    await playground.press("More");
  } else {
    await playground.press("Save");
  }
  await playground.press(item);
  const saved = await download;
  return { name: saved.suggestedFilename(), text: readFileSync(await saved.path(), "utf8") };
}

function wideMap(width) {
  return `type octile\nheight 1\nwidth ${width}\nmap\n${".".repeat(width)}\n`;
}
