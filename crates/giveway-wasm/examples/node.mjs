// @ts-check
// Solves every scene that is named, checks each plan, and asks why it takes so long:
// node node.mjs SCENE.json...

import { readFileSync } from "node:fs";
import { check, explain, readScene, solve } from "giveway";

for (const path of process.argv.slice(2)) {
  const scene = readScene(readFileSync(path, "utf8"));
  const answer = solve({ scene, limits: { seconds: 60 } });
  console.log(`${scene.name || path}: ${answer.status}`);
  if (!answer.plan) {
    const why = explain({ scene, question: { kind: "unsolvable" } });
    console.log(why.words);
    continue;
  }
  const { valid, costs } = check({ scene, plan: answer.plan });
  console.log(`  the judge: ${valid ? "valid" : "broken"}, makespan ${costs?.makespan}, sum of costs ${costs?.["sum-of-costs"]}`);
  const why = explain({ scene, plan: answer.plan, question: { kind: "makespan" }, limits: { seconds: 60 } });
  console.log(`  why not sooner? ${why.verdict}: ${why.words.split("\n")[0]}`);
}
