// The published benchmark: what docs/optima/README.md says is what its rows say.

import assert from "node:assert/strict";
import { test } from "node:test";

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
