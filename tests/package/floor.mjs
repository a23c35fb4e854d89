// The questions of the benchmark about warehouse floors, answered by the package in Node, in CPU
// seconds: ./x bench --floor && ./x package && node tests/package/floor.mjs [NAME...]
// The numbers go to docs/package.md by hand.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { isDeepStrictEqual } from "node:util";

const root = fileURLToPath(new URL("../..", import.meta.url));
const folder = process.env.GIVEWAY_PACKAGE ?? join(root, "target/package");
const floors = process.env.GIVEWAY_FLOORS ?? join(root, "target/floors.json");
const giveway = createRequire(import.meta.url)(join(folder, "nodejs/giveway_wasm.js"));
const names = process.argv.slice(2);

/** Seconds for a plan, for an answer about one that is proved best, and for one of which only the first layers count. */
const PLAN = 60;
const ANSWER = 30;
const FIRST = 5;
/** CPU seconds within which each layer is to be there. */
const HERE = 0.1;
const NEAR = 1;
const VERDICT = 3;

const seconds = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1e6;
};
const told = (value) => value.toFixed(2).padStart(6);

/** The CPU seconds of each layer by itself, and the verdict. */
const ask = (scene, plan, question, limit) => {
  const begin = seconds();
  const there = {};
  const request = { scene, plan, question, layers: ["here", "near", "reason"], limits: { seconds: limit } };
  const answer = giveway.explain(request, { onProgress: (now) => {
    if (now.event !== "explained") {
      return;
    }
    for (const part of ["here", "near", "verdict"].filter((part) => !now.answer.pending?.includes(part))) {
      there[part] ??= seconds() - begin;
    }
  } });
  const [here, near, verdict] = ["here", "near", "verdict"].map((part) => there[part] ?? seconds() - begin);
  return { here, near: near - here, verdict: verdict - near, is: answer.verdict };
};

const all = { here: 0, near: 0, asked: 0, soon: 0, ofBest: 0, node: 0, native: 0 };
for (const floor of JSON.parse(readFileSync(floors, "utf8"))) {
  if (names.length && !names.includes(floor.name)) {
    continue;
  }
  const begin = seconds();
  // The package keeps the proof. It is of this plan, or questions would be about no best plan.
  const solved = floor.best ? giveway.solve({ scene: floor.scene, trace: true, limits: { seconds: PLAN } }) : undefined;
  const isBest = solved?.status === "optimal" && isDeepStrictEqual(solved.plan, floor.plan);
  console.log(`${floor.name}: ${isBest ? `proved in ${told(seconds() - begin)}` : "not proved"}`);
  for (const { question, verdict, seconds: native } of floor.asked) {
    const one = ask(floor.scene, floor.plan, question, isBest ? ANSWER : FIRST);
    const differs = [one.is, verdict].includes("unknown") || one.is === verdict ? "" : "   another verdict!";
    process.exitCode ||= Number(differs !== "");
    console.log(`  ${one.is.padEnd(10)} here ${told(one.here)} near ${told(one.near)} verdict ${told(one.verdict)}; natively ${verdict.padEnd(10)} ${native.map(told).join(" ")}${differs}`);
    all.asked += 1;
    all.here += one.here <= HERE;
    all.near += one.near <= NEAR;
    all.ofBest += isBest;
    all.soon += isBest && one.is !== "unknown" && one.verdict <= VERDICT;
    all.node += one.here + one.near;
    all.native += native[0] + native[1];
  }
}
console.log(`\nin time: here ${all.here} and near ${all.near} of ${all.asked}, the verdict ${all.soon} of ${all.ofBest} about plans that are proved best`);
console.log(`here and near take ${(all.node / all.native).toFixed(1)} times the command's CPU time`);
