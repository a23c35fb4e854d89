// The tables of docs/optima/README.md, from the rows of its CSV.

const BEGIN = "<!-- reach: written by scripts/optima.mjs -->";
const END = "<!-- end of the reach -->";

/** The lines of a CSV as objects; no cell of these has a quote or a line break in it. */
export function parse(csv) {
  const [head, ...lines] = csv.trimEnd().split("\n");
  const cells = (line) => [...line.matchAll(/(?:^|,)(?:"([^"]*)"|([^,"]*))/g)].map(([, quoted, plain]) => quoted ?? plain);
  const keys = cells(head);
  return lines.map((line) => Object.fromEntries(cells(line).map((cell, index) => [keys[index], cell])));
}

const number = (value) => String(value).replace(/\B(?=(\d{3})+$)/g, ",");
const share = (part, whole) => (whole === 0 ? "none" : `${Math.floor(100 * part / whole)} %`);
const count = (rows, test) => rows.filter(test).length;
const isProved = ({ status }) => status === "optimal" || status === "impossible";

/** Rows by what a function tells of them, in the order in which these come. */
function grouped(rows, key) {
  const groups = new Map();
  for (const row of rows) {
    groups.set(key(row), [...groups.get(key(row)) ?? [], row]);
  }
  return groups;
}

/** Of a map and one kind of its scenarios: how far the proofs reach. */
function line(name, rows) {
  const proved = rows.filter(isProved);
  const largest = Math.max(0, ...proved.map((row) => Number(row.agents)));
  const open = rows.filter((row) => !isProved(row));
  const gaps = open.map((row) => row["gap %"]).filter((gap) => gap !== "");
  const ended = open.map((row) => Number(row.agents));
  return [
    name,
    grouped(rows, (row) => row.scenario).size,
    proved.length,
    largest,
    count(proved, (row) => row.certificate === "proved"),
    count(proved, (row) => row.certificate === "searched"),
    open.length === 0 ? "" : Math.min(...ended) === Math.max(...ended) ? ended[0] : `${Math.min(...ended)} to ${Math.max(...ended)}`,
    gaps.length === 0 ? "" : Math.max(...gaps.map(Number)).toFixed(2),
  ];
}

const HEAD = ["map, scenarios", "how many", "proved", "up to robots", "with a proof", "by a search", "not proved, robots", "gap %"];

function table(rows) {
  const kind = ({ scenario, map }) => `${map}, ${/-(even|random)-\d+$/.exec(scenario)?.[1] ?? "others"}`;
  const lines = [...grouped(rows, kind)].map(([name, own]) => line(name, own));
  const rule = HEAD.map((_, index) => (index === 0 ? "---" : "---:"));
  return [HEAD, rule, ...lines].map((cells) => `| ${cells.join(" | ")} |`).join("\n");
}

/** The part of the README that says how far the sweep came. */
export function reach(rows, left) {
  const proved = rows.filter(isProved);
  const made = count(proved, (row) => row.certificate !== "");
  const seconds = rows.reduce((sum, row) => sum + Number(row["CPU s"]) + Number(row["certificate CPU s"] || 0), 0);
  const bytes = rows.reduce((sum, row) => sum + Number(row["certificate bytes"] || 0), 0);
  const parts = [[
    `${number(rows.length)} tasks were tried, in ${(seconds / 3600).toFixed(2)} CPU hours: ${number(proved.length)} of them are`,
    `proved (${share(proved.length, rows.length)}), ${number(made)} of these with a certificate (${share(made, proved.length)}).`,
    `The certificates are ${(bytes / 1e9).toFixed(1)} GB together.`,
    left === 0
      ? "The sweep is at its end: each scenario ends with its last robots, or where `skip-after` ends it."
      : `${number(left)} tasks are left; many of them will be skipped, as those before them are not proved.`,
  ].join("\n")];
  for (const [objective, own] of grouped(rows, (row) => row.objective)) {
    parts.push(`### ${objective}`, table(own));
  }
  return parts.join("\n\n");
}

/** The README with what there is to say of these rows. */
export function written(text, rows, left) {
  const [before, rest] = text.split(BEGIN);
  const after = rest?.split(END)[1];
  if (after === undefined) {
    throw new Error("README.md: expected the two marks of the reach");
  }
  return `${before}${BEGIN}\n\n${reach(rows, left)}\n\n${END}${after}`;
}
