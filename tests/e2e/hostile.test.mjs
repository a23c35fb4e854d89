// Files, links and pasted texts that mean harm: each is refused with a sentence or shown
// as text, and the page goes on as if nothing had been.

import assert from "node:assert/strict";
import { describe } from "node:test";

import { flows } from "./flow.mjs";
import { eventually } from "./wait.mjs";

const OPENING = /^Optimal: makespan 18/;
const MARKUP = "<img src=x onerror=alert(1)>";
const json = (rest) => JSON.stringify({ giveway: 1, map: ["..."], agents: [], ...rest });
const agent = (rest) => ({ name: "A", start: [0, 0], goal: [2, 0], ...rest });
const map = (height, width, rows) => `type octile\nheight ${height}\nwidth ${width}\nmap\n${rows}`;

/** Files that must be refused, and what is said of them. */
const FILES = [
  ["a map that claims 100000 x 100000 cells", "a.map", map(100_000, 100_000, "....\n"), /a\.map cannot be opened/],
  ["a map whose sides overflow", "a.map", map("4294967296", "18446744073709551616", "."), /a\.map cannot be opened/],
  ["a map of 2,100 x 2,100 cells", "a.json", json({ map: Array(2100).fill(".".repeat(2100)) }), /at most 2048/],
  ["a scenario of a million agents", "a.scen", `version 1\n${"0\ta.map\t8\t8\t0\t0\t1\t1\t1\n".repeat(200_000)}`, /a\.scen cannot be opened/],
  ["10001 agents", "a.json", json({ map: Array(101).fill(".".repeat(101)), agents: Array.from({ length: 10_001 }, (_, n) => agent({ name: `A${n}`, start: [n % 101, Math.floor(n / 101)], goal: [n % 101, Math.floor(n / 101)] })) }), /10[,.]?001/],
  ["an agent off the map", "a.json", json({ agents: [agent({ goal: [4_294_967_295, 4_294_967_295] })] }), /4294967295/],
  ["numbers that are none", "a.json", json({ agents: [agent({ goal: [1e308, -1] })] }), /a\.json, line 1/],
  ["a battery of minus one", "a.json", json({ agents: [agent({ battery: { capacity: -1, initial: 0 } })] }), /a\.json, line 1/],
  ["__proto__ among its keys", "a.json", '{"giveway": 1, "map": [".."], "agents": [], "__proto__": {"polluted": true}}', /__proto__/],
  ["constructor.prototype among its keys", "a.json", '{"giveway": 1, "map": [".."], "agents": [], "constructor": {"prototype": {"polluted": true}}}', /constructor/],
  ["a hundred thousand brackets", "a.json", "[".repeat(100_000), /a\.json, line 1/],
  ["objects in objects without end", "a.json", '{"giveway":'.repeat(50_000), /a\.json, line 1/],
  ["another version", "a.json", '{"giveway": 2, "map": [".."], "agents": []}', /found 2|version/],
  ["a version that is markup", "a.json", json({ giveway: MARKUP }), /a\.json, line 1/],
  ["half of a surrogate pair", "a.json", '{"giveway": 1, "name": "\\ud800", "map": [".."], "agents": []}', /a\.json, line 1/],
  ["bytes that are no UTF-8", "a.json", Uint8Array.of(0x7b, 0x22, 0xff, 0xfe, 0x22, 0x7d), /a\.json/],
  ["a plan for nobody", "a.json", '{"giveway": 1, "paths": {"__proto__": [[0, 0]]}}', /Its plan breaks a rule/],
  ["something that was compressed", "a.json", Uint8Array.of(0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 0, 3), /a\.json/],
];

const LINK = "giveway=1&map=3.3f&rules=0.0&costs=0&agents=";

/** Links that must be refused, and what is said of them. */
const LINKS = [
  ["100000 x 100000 cells", "giveway=1&map=100000.10000000000f&rules=0.0&costs=0&agents=", /map.*broken/],
  ["more cells than can be counted", "giveway=1&map=9.99999999999999999999999999f", /map.*broken/],
  // Runs of letters are all that is ever packed in a link.
  ["a run that would fill the memory", `${LINK}A.0.0.2.0&plan=4000000000w`, /plan is broken/],
  ["a million runs", `${LINK}A.0.0.2.0&plan=${"999999wl".repeat(1000)}`, /plan is broken/],
  ["more agents than the page takes", `${LINK}${Array(10_001).fill("A.0.0.2.0").join(";")}`, /10[,.]?001/],
  ["two million letters", `${LINK}${"A".repeat(2_000_000)}`, /longer than the page takes/],
  ["another version", "giveway=99&map=3.3f", /version 99; this page reads version 1/],
  ["a broken escape", `${LINK}%E0%A4.0.0.2.0`, /agents.*broken/],
  ["half of a surrogate pair", `${LINK}%ED%A0%80.0.0.2.0`, /agents.*broken/],
  ["another packing", "giveway=1&map=H4sIAAAAAAAAAwMAAAAAAAAAAAA=", /map.*broken/],
  ["__proto__ for a key", `${LINK}&__proto__=1`, /__proto__.*broken/],
  ["a program for a question", `${LINK}A.0.0.2.0&plan=2r&ask=javascript:alert(1)`, /ask.*broken/],
  ["a time beyond all times", `${LINK}A.0.0.2.0&plan=2r&time=99999999999999`, /time.*broken/],
  ["changes without end", `${LINK}A.0.0.2.0&plan=2r&changes=${"1o1.0;".repeat(20_001)}`, /changes.*broken/],
];

describe("what means harm", () => {
  const flow = flows();

  flow("in files is refused with a sentence, and the page goes on", async (playground, { page }) => {
    await begin(playground);
    for (const [what, name, bytes, told] of FILES) {
      await playground.open({ name, bytes });
      await refuses(playground, what, told);
    }
    await goesOn(playground, page);
  }, { screens: ["desktop"] });

  flow("in links is refused with a sentence, and the page goes on", async (playground, { page }) => {
    await begin(playground);
    for (const [what, link, told] of LINKS) {
      await page.evaluate((link) => {
        location.hash = link;
      }, link);
      await refuses(playground, what, told);
    }
    await goesOn(playground, page);
  }, { screens: ["desktop"] });

  const names = [
    MARKUP,
    "javascript:alert(1)",
    "\"><script>alert(1)</script>",
    "{{constructor.constructor('alert(1)')()}}",
    "__proto__",
    "\u202egnp.exe",
    "a\u0000b\u0007c\u200b\ufeff",
    "Z\u0351\u036b\u0343\u036a".repeat(50),
    "\u{1f469}\u200d\u{1f680}".repeat(100),
    "x".repeat(5000),
  ];
  for (const screen of ["desktop", "phone"]) {
    flow("in names is shown as text", async (playground, { page }) => {
      await begin(playground);
      const agents = names.map((name, n) => agent({ name, start: [0, n], goal: [2, n] }));
      const rows = Array(names.length).fill("...");
      for (const name of names) {
        await playground.open({ name: `${name.slice(0, 60).replaceAll(/[/\u0000]/g, "")}.json`, bytes: json({ name, map: rows, agents }) });
        // White space and controls are as the browser shows them.
        const begins = name.slice(0, 20).replaceAll(/[\u0000-\u001f]/g, "");
        await eventually(`the name ${begins}`, () => playground.sceneName.textContent(), (text) => text.replaceAll(/[\u0000-\u001f]/g, "").startsWith(begins));
      }
      await playground.press("Solve");
      await playground.says(/^Optimal: makespan 2, /);
      await playground.reaches(2);
      await playground.cellTells(2, 0, /<img src=x onerror=alert\(1\)>/);
      await playground.picture("hostile-names");
      for (const tab of ["Inspector", "Plan"]) {
        await playground.showTab(tab);
        await playground.picture(`hostile-names-${tab}`);
      }
      await playground.cell(2, 0).click();
      await playground.showTab("Inspector");
      await playground.inspector.getByRole("heading", { name: MARKUP, level: 2 }).waitFor();
      await playground.act("Share");
      await page.getByRole("dialog", { name: "Share" }).waitFor();
      await playground.key("Escape");
      await playground.reload();
      await eventually("it to come back", () => playground.sceneName.textContent(), (text) => text.startsWith("xxx"));
      await runsNothing(page);
    }, { screens: [screen] });
  }

  flow("in what the browser kept is left out, and the page begins anew", async (playground, { page }) => {
    await begin(playground);
    for (const kept of ["{", "giveway=1&map=256.9999999999f", "giveway=1&claim=%", MARKUP, "\ud800", "giveway=9", `${LINK}&listed=1!x`]) {
      await playground.reloadOn(kept, { "giveway.preferences": kept, [`giveway.scene.${kept}`]: kept });
      await playground.says(/./);
      await playground.tells(/could not read what was kept/);
      await playground.press("Start afresh");
    }
    await playground.sceneName.getByRole("button").click();
    const dialog = page.getByRole("dialog", { name: "Scenes" });
    await dialog.getByRole("button", { name: MARKUP, exact: true }).click();
    await playground.warns(/scene cannot be opened/);
    await playground.press("Dismiss");
    await runsNothing(page);
  }, { screens: ["desktop"] });
});

/** Watches for anything that would run, and for refusals of the page's policy. */
async function begin(playground) {
  await playground.says(OPENING);
  await playground.pause();
  await playground.page.evaluate(() => {
    window.alert = () => {
      window.alarmed = true;
    };
    window.refused = [];
    document.addEventListener("securitypolicyviolation", (event) => window.refused.push(event.violatedDirective));
  });
}

async function refuses(playground, what, told) {
  const notice = await playground.warns(/cannot be opened/);
  assert.match(notice, told, what);
  assert.ok(notice.length < 1000, `${what}: a notice of ${notice.length} letters`);
  await playground.press("Dismiss");
  await playground.warns(/^\s*$/);
  await playground.shows("warehouse");
}

/** That a person can still paint and solve. */
async function goesOn(playground, page) {
  await playground.says(OPENING);
  assert.ok(await playground.button("Undo").isDisabled(), "nothing was changed");
  await playground.pick("Obstacle");
  await playground.stroke([1, 2], [2, 2]);
  await playground.cellTells(2, 2, /^obstacle/);
  await playground.press("Undo");
  await playground.press("Solve");
  await playground.says(OPENING);
  await runsNothing(page);
}

async function runsNothing(page) {
  const found = await page.evaluate(() => ({
    alarmed: window.alarmed ?? false,
    refused: window.refused ?? [],
    polluted: {}.polluted ?? false,
    images: document.querySelectorAll("img, script:not([src]), iframe").length,
  }));
  assert.deepEqual(found, { alarmed: false, refused: [], polluted: false, images: 0 });
}
