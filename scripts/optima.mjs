// `node scripts/optima.mjs [--start] FILES RESULTS [GIVEWAY]`: writes docs/optima/ from the rows of its sweep.
//
// FILES is the folder with the maps and scenarios, RESULTS the folder of rows, GIVEWAY the command
// (by default target/release/giveway). Any number of rows will do: the README says what is left.
// With --start it is the other way round: RESULTS gets the rows that are published, so that
// `giveway sweep` goes on behind them.

import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { chosen, PUBLISHED, started, together } from "./optima/rows.mjs";
import { parse, written } from "./optima/tables.mjs";

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const folder = join(root, "docs/optima");

const args = process.argv.slice(2);
const starts = args[0] === "--start" && args.shift() === "--start";
const [files, results, giveway = join(root, "target/release/giveway")] = args;
if (!files || !results) {
  console.error("optima: expected the folder of the maps and scenarios, and the folder of results");
  process.exit(1);
}

const run = (...args) => execFileSync(resolve(giveway), args, { encoding: "utf8", maxBuffer: 1 << 30 });

/** The CSV of rows, lines of JSON. */
function table(rows) {
  const place = mkdtempSync(join(tmpdir(), "optima-"));
  try {
    writeFileSync(join(place, "rows.jsonl"), rows);
    return run("table", place, "--show", "optima", "--to", "csv");
  } finally {
    rmSync(place, { recursive: true });
  }
}

const listed = run("sweep", join(folder, "spec.toml"), "--files", files, "--list");
const rows = join(folder, "rows.csv");
if (starts) {
  const lines = started(readFileSync(rows, "utf8"), listed);
  mkdirSync(results, { recursive: true });
  writeFileSync(join(results, PUBLISHED), lines);
  console.log(`${results}: ${lines.split("\n").length - 1} published rows`);
} else {
  const names = existsSync(results) ? readdirSync(results) : [];
  const own = names.filter((name) => name.endsWith(".jsonl") && !name.startsWith("."));
  const texts = new Map(own.map((name) => [name, readFileSync(join(results, name), "utf8")]));
  const { kept, published, left } = chosen(texts, listed);
  if (kept === "" && published.length === 0) {
    console.error(`optima: found no row of a task of docs/optima/spec.toml in ${results}`);
    process.exit(1);
  }
  const csv = together(kept === "" ? "" : table(kept), published);
  writeFileSync(rows, csv);
  const readme = join(folder, "README.md");
  writeFileSync(readme, written(readFileSync(readme, "utf8"), parse(csv), left));
  console.log(`docs/optima: ${parse(csv).length} rows, ${left} tasks left`);
}
