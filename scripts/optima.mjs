// `node scripts/optima.mjs FILES RESULTS [GIVEWAY]`: writes docs/optima/ from the rows of its sweep.
//
// FILES is the folder with the maps and scenarios, RESULTS the folder of rows, GIVEWAY the command
// (by default target/release/giveway). Any number of rows will do: the README says what is left.

import { execFileSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

import { parse, written } from "./optima/tables.mjs";

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const folder = join(root, "docs/optima");

const [files, results, giveway = join(root, "target/release/giveway")] = process.argv.slice(2);
if (!files || !results) {
  console.error("optima: expected the folder of the maps and scenarios, and the folder of results");
  process.exit(1);
}

const run = (...args) => execFileSync(resolve(giveway), args, { encoding: "utf8", maxBuffer: 1 << 30 });
const tasks = run("sweep", join(folder, "spec.toml"), "--files", files, "--list").trim().split("\n");
const csv = run("table", results, "--show", "optima", "--to", "csv");
const all = parse(run("table", results, "--show", "rows", "--to", "csv"));

writeFileSync(join(folder, "rows.csv"), csv);
const readme = join(folder, "README.md");
const text = readFileSync(readme, "utf8");
writeFileSync(readme, written(text, parse(csv), tasks.length - all.length));
console.log(`docs/optima: ${parse(csv).length} rows, ${tasks.length - all.length} tasks left`);
