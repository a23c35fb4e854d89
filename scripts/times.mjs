// Where the minutes go: node scripts/times.mjs STEPS [FILES]
// Both hold lines of seconds, a tab, and a name: the steps of a command in their order, and
// the test files, which may have run side by side (scripts/test-times.mjs writes them).

import { existsSync, readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

/** Seconds as minutes: 75.4 is "1:15". */
function minutes(seconds) {
  const whole = Math.round(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

/** What the lines of a file say. */
export function read(text) {
  return text.split("\n").filter(Boolean).map((line) => {
    const [seconds, name] = line.split("\t");
    return { seconds: Number(seconds), name };
  });
}

/** A table of times with their sum and each one's part of it. */
export function table(title, rows) {
  const sum = rows.reduce((sum, { seconds }) => sum + seconds, 0);
  const line = ({ seconds, name }) => {
    const part = sum > 0 ? Math.round(100 * seconds / sum) : 0;
    return `${minutes(seconds).padStart(7)} ${`${part} %`.padStart(6)}  ${name}`;
  };
  return [title, ...rows.map(line), line({ seconds: sum, name: "in all" })].join("\n");
}

/** The tables of both files; without test files only the first. */
export function tables(steps, files = "") {
  const tests = read(files).sort((a, b) => b.seconds - a.seconds);
  const all = [table("Minutes of each step", read(steps))];
  if (tests.length > 0) {
    all.push(table("Minutes of each test file; two ran at a time", tests));
  }
  return `\n${all.join("\n\n")}\n`;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [steps, files] = process.argv.slice(2);
  const text = (path) => (path && existsSync(path) ? readFileSync(path, "utf8") : "");
  console.log(tables(text(steps), text(files)));
}
