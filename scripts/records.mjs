// `node scripts/records.mjs FOLDER [--motion pebble] [--best SECONDS] [--limit SECONDS] [GIVEWAY]`: compares optima with
// those that SAT encodings of others have proved.
//
// FOLDER has optima.csv and its maps and scenarios (svancaj/MAPF-encodings, their JAIR experiments; counts of steps as
// ours). Rows whose map or scenario is not there are left out; --best takes those that their best encoding closed in so
// many seconds, --limit is the time for each of ours (30). Motion `parallel` is the plain problem, `pebble` has the rule
// "each cell stays free for 1 step behind any robot". It ends with 1 where an optimum or a bound differs.

import { spawnSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { parse } from "./optima/tables.mjs";
import { compared, sized } from "./optima/records.mjs";

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const options = { motion: "pebble", best: "Infinity", limit: "30" };
const places = [];
for (const args = process.argv.slice(2); args.length > 0;) {
  const next = args.shift();
  const name = next.replace(/^--/, "");
  if (next.startsWith("--") && name in options && args.length > 0) options[name] = args.shift();
  else places.push(next);
}
const [folder, giveway = join(root, "target/release/giveway")] = places;
const rules = { parallel: [], pebble: ["--constraint", '{ "kind": "gap", "steps": 1 }'] }[options.motion];
if (!folder || !rules) {
  console.error("records: expected the folder with optima.csv, and parallel or pebble as the motion");
  process.exit(1);
}

const csv = readFileSync(join(folder, "optima.csv"), "utf8").replaceAll("\r", "");
const rows = parse(csv).filter((row) => row.motion === options.motion
  && Number(row["best seconds"]) <= Number(options.best)
  && existsSync(join(folder, row.map)) && existsSync(join(folder, row.scenario)));
const place = mkdtempSync(join(tmpdir(), "records-"));
const counts = { equal: 0, open: 0, differs: 0 };
try {
  for (const row of rows) {
    const [map, scenario] = [join(folder, row.map), join(place, "instance.scen")];
    writeFileSync(scenario, sized(readFileSync(join(folder, row.scenario), "utf8"), readFileSync(map, "utf8")));
    // What it cannot close in time ends with another status than 0, and an answer.
    const { stdout } = spawnSync(resolve(giveway), ["solve", scenario, "--map", map, "--agents", row.agents, ...rules,
      "--objective", row.cost, "--time-limit", options.limit, "--format", "json", "--quiet"],
    { encoding: "utf8", maxBuffer: 1 << 30, stdio: ["ignore", "pipe", "inherit"] });
    const found = compared(row, JSON.parse(stdout));
    counts[found] += 1;
    if (found !== "equal") console.log(`${found}: ${row.scenario}, ${row.agents} robots, ${row.cost} ${row.optimum}`);
  }
} finally {
  rmSync(place, { recursive: true });
}
console.log(`${options.motion}: ${rows.length} rows, ${counts.equal} equal, ${counts.open} not closed, `
  + `${counts.differs} differ`);
process.exit(counts.differs > 0 ? 1 : 0);
