// CPU seconds of the package in Node beside those of the native command, on graded instances, some
// of which take over a second, and a crowd: node tests/package/speed.mjs [NAME...]
// The command is target/release/giveway, or GIVEWAY_COMMAND; warm-up is told apart.

import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../..", import.meta.url));
const folder = process.env.GIVEWAY_PACKAGE ?? join(root, "target/package");
const command = process.env.GIVEWAY_COMMAND ?? join(root, "target/release/giveway");
const data = join(root, "tests/data/mmapf");
const names = process.argv.slice(2);

const seconds = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1e6;
};
const taken = (work) => {
  const start = seconds();
  const result = work();
  return [seconds() - start, result];
};
const told = (n) => n.toFixed(2).padStart(8);

/** A standard scenario that takes the native command over a second. */
const crowd = () => execFileSync(command, ["convert", "--to", "giveway", "--agents", "50",
  join(root, "tests/data/movingai/random-32-32-20-random-1.scen")], { encoding: "utf8" });
const instances = new Map(readdirSync(data).sort()
  .filter((file) => /^(A0[1-9]|A10|A15|B22)_.*\.json$/.test(file))
  .map((file) => [file.slice(0, 3), () => readFileSync(join(data, file), "utf8")]));
instances.set("random-32-32-20, 50 agents", crowd);

const [loading, giveway] = taken(() => createRequire(import.meta.url)(join(folder, "nodejs/giveway_wasm.js")));
const small = JSON.parse(readFileSync(join(root, "tests/data/seed/warehouse.json"), "utf8"));
const [first] = taken(() => giveway.solve({ scene: small }));
console.log(`warm-up: loading ${loading.toFixed(2)} s, the first solve ${first.toFixed(2)} s\n`);
console.log(`${"instance".padEnd(27)}   native     Node    ratio`);
for (const [name, read] of instances) {
  if (names.length && !names.some((start) => name.startsWith(start))) {
    continue;
  }
  const input = read();
  const native = JSON.parse(execFileSync(command, ["solve", "-", "--format", "json", "--quiet"], { input, encoding: "utf8" }));
  const [wasm, answer] = taken(() => giveway.solve({ scene: JSON.parse(input) }));
  const same = JSON.stringify(native.plan) === JSON.stringify(answer.plan) ? "" : "   another plan!";
  const cpu = native.stats.cpu_seconds;
  console.log(`${name.padEnd(27)} ${told(cpu)} ${told(wasm)} ${told(wasm / cpu)}${same}`);
}
