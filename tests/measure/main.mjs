// Measures the built page and writes docs/page.md: `./x measure`. With names of figures
// only these are measured, and nothing is written.

import { writeFileSync } from "node:fs";
import { cpus, loadavg } from "node:os";
import { join } from "node:path";

import { launch } from "../e2e/browser.mjs";
import { dist, root } from "../e2e/dist.mjs";
import { serve } from "../e2e/server.mjs";
import { FIGURES } from "./figures.mjs";

const wanted = process.argv.slice(2);
const unknown = wanted.filter((name) => !(name in FIGURES));
if (unknown.length > 0) {
  console.error(`found ${unknown.join(" ")}, expected some of ${Object.keys(FIGURES).join(" ")}`);
  process.exit(2);
}

const [load] = loadavg();
const host = await serve(dist);
const rows = [];
for (const [name, measure] of Object.entries(FIGURES)) {
  if (wanted.length === 0 || wanted.includes(name)) {
    for (const figure of await measure(host.url)) {
      rows.push(figure);
      console.log(line(figure));
    }
  }
}
await host.close();
if (wanted.length === 0) {
  writeFileSync(join(root, "docs/page.md"), await document(rows));
  console.log("written: docs/page.md");
}
process.exitCode = rows.every(isMet) ? 0 : 1;

function isMet({ value, most = Infinity, least = -Infinity }) {
  return value <= most && value >= least;
}

function line(figure) {
  return `${isMet(figure) ? "ok    " : "missed"}  ${figure.what}: ${told(figure)} (${target(figure)})`;
}

function told({ value, unit, digits, below }) {
  // The browser tells nothing of what is shorter.
  const number = below !== undefined && value === 0 ? `below ${below}` : value.toFixed(digits);
  return `${number} ${unit}`.trim();
}

function target({ most, least, unit, digits }) {
  const bound = most === undefined ? `at least ${least}` : `at most ${most.toFixed(digits)}`;
  return `${bound} ${unit}`.trim();
}

async function document(rows) {
  const browser = await launch();
  const version = browser.version();
  await browser.close();
  const others = load > cpus().length / 2
    ? `\n**The machine did other things, too** (load ${load.toFixed(0)}): what is told in processor time and memory holds, what is\ntold in seconds or frames is too long by as much as the processor was elsewhere.\n`
    : "";
  const table = rows.map((row) => `| ${row.what} | ${told(row)} | ${target(row)} | ${isMet(row) ? "yes" : "**no**"} |`);
  return `# How fast the page is

\`./x measure\` builds the page, measures it as it is served to a person, and writes this file. Times are the middle
ones of five; the page is opened in a fresh browser for each line. Frames are those of a browser without a graphics
card, which draws everything on the processor. Processor time and memory are what the system says of the threads and
the process of the tab.

Chromium ${version}, ${cpus().length} x ${cpus()[0].model.trim()}.
${others}
| what | measured | should be | met |
|---|---:|---:|---|
${table.join("\n")}
`;
}
