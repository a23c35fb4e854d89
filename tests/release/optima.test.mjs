// The published benchmark: what docs/optima/README.md says is what its rows say.

import assert from "node:assert/strict";
import { test } from "node:test";

import { chosen, PUBLISHED, started, together } from "../../scripts/optima/rows.mjs";
import { compared, sized } from "../../scripts/optima/records.mjs";
import { parse, reach, written } from "../../scripts/optima/tables.mjs";
import { read } from "./house.mjs";

const HEAD = "map,scenario,agents,objective,lower bound,upper bound,status,gap %,CPU s,certificate,certificate bytes,certificate CPU s,manifest SHA-256";

test("rows are counted by map, kind of scenario and objective", () => {
  const rows = parse(`${HEAD}
room,room-even-1,5,makespan,7,7,optimal,0.00,1800.00,proved,2000000000,0.00,abc
room,room-even-1,10,makespan,7,9,feasible,28.57,1800.00,,,,
room,room-even-2,5,makespan,6,6,optimal,0.00,0.00,,,,
room,room-random-1,5,"a,b",6,6,optimal,0.00,0.00,searched,10,0.00,
`);
  assert.equal(rows[3].objective, "a,b");
  const said = reach(rows, 1234);
  assert.match(said, /^4 tasks were tried, in 1\.00 CPU hours: 3 of them are\nproved \(75 %\), 2 of these with a certificate \(66 %\)\./);
  assert.match(said, /2\.0 GB together\.\n1,234 tasks are left/);
  assert.match(said, /### makespan\n\n.*\n.*\n\| room, even \| 2 \| 2 \| 5 \| 1 \| 0 \| 10 \| 28\.57 \|\n/);
  assert.match(said, /### a,b\n\n.*\n.*\n\| room, random \| 1 \| 1 \| 5 \| 0 \| 1 \|  \|  \|$/);
  assert.match(reach(rows, 0), /The sweep is at its end/);
});

test("the README says what the rows say", () => {
  const readme = read("docs/optima/README.md");
  const [, left] = /^([\d,]+) tasks are left/m.exec(readme) ?? ["", "0"];
  const rows = parse(read("docs/optima/rows.csv"));
  assert.equal(written(readme, rows, Number(left.replaceAll(",", ""))), readme);
  assert.throws(() => written("nothing", rows, 0), /the two marks/);
});

/** What `giveway sweep --list` says of a scenario. */
const listed = (...tasks) => tasks.map(([scenario, agents, objective]) => {
  const instance = `maps/${scenario}.scen`;
  const task = `${instance} planner=search objective=${objective} agents=${agents} cpu-seconds=30`;
  return `${JSON.stringify({ task, instance, agents, objective: objective.split(","), planner: "search" })}\n`;
}).join("");

test("the published rows are rows of a sweep, and come back as they were", () => {
  const csv = `${HEAD}
room,room-even-1,5,makespan,7,7,optimal,0.00,1.50,proved,20,0.25,abc
room,room-even-1,10,makespan,7,9,feasible,28.57,30.00,,,,
room,room-even-1,5,"sum-of-costs,makespan",60,60,optimal,0.00,0.00,searched,10,0.00,
`;
  const tasks = listed(
    ["room-even-1", 5, "makespan"], ["room-even-1", 5, "sum-of-costs,makespan"],
    ["room-even-1", 10, "makespan"], ["room-even-1", 15, "makespan"],
  );
  const text = started(csv, tasks);
  const rows = text.trimEnd().split("\n").map((line) => JSON.parse(line));
  assert.deepEqual(rows[0].certificate, { certified: "proved", bytes: 20, manifest: "abc" });
  assert.deepEqual([rows[1].status, rows[1].bounds, rows[1].certificate], ["feasible", { makespan: 7 }, undefined]);
  assert.equal(rows[2].certificate.certified, "proved-and-searched");

  const files = new Map([[PUBLISHED, text]]);
  const none = chosen(files, tasks);
  assert.deepEqual([none.kept, none.left], ["", 1]);
  assert.equal(together("", none.published), csv);

  // Rows of another budget and half a row stay out; what was done again replaces what was published.
  const again = JSON.stringify({ task: rows[1].task, status: "optimal" });
  const other = JSON.stringify({ task: `${rows[1].task}0`, status: "optimal" });
  files.set("results-1-of-1.jsonl", `${other}\n${again}\n{"task":"half`);
  const more = chosen(files, tasks);
  assert.deepEqual([more.kept, more.left, more.published.length], [`${again}\n`, 1, 2]);
  const made = "room,room-even-1,10,makespan,9,9,optimal,0.00,2.00,,,,";
  const lines = together(`${HEAD}\n${made}\n`, more.published).split("\n");
  assert.deepEqual([lines.length, lines[2]], [5, made]);
  assert.equal(started(csv, listed(["maze-even-1", 5, "makespan"])), "", "files that are not at hand");
});

test("the published rows can be gone on with", () => {
  const csv = read("docs/optima/rows.csv");
  const tasks = parse(csv).map(({ scenario, agents, objective }) => [scenario, Number(agents), objective]);
  const text = started(csv, listed(...tasks));
  const { published, left } = chosen(new Map([[PUBLISHED, text]]), listed(...tasks));
  assert.equal(together("", published), csv);
  assert.equal(left, 0);
});

test("a row of others' optima is equal, not closed, or differs", () => {
  const row = { cost: "makespan", optimum: "9" };
  const answer = (status, cost, bound) => compared(row, { status, costs: cost && { makespan: cost }, bounds: { makespan: bound } });
  assert.equal(answer("optimal", 9, 9), "equal");
  assert.equal(answer("optimal", 10, 10), "differs");
  assert.equal(answer("feasible", 12, 9), "open");
  assert.equal(answer("feasible", 8, 7), "differs");
  assert.equal(answer("feasible", 12, 10), "differs");
  assert.equal(answer("unknown", null, 5), "open");
  assert.equal(answer("impossible", null, undefined), "differs");
});

test("a scenario gets the size of its map", () => {
  const map = "type octile\nheight 4\nwidth 3\nmap\n...\n";
  assert.equal(sized("version 1\n0\ta.map\t9\t9\t0\t1\t2\t3\t4.5\n", map), "version 1\n0\ta.map\t3\t4\t0\t1\t2\t3\t4.5\n");
});
