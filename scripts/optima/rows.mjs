// The rows of docs/optima/rows.csv as rows of a sweep, and back: so that who goes on begins where they end.

import { parse } from "./tables.mjs";

/** The file of the results that holds them. */
export const PUBLISHED = "published.jsonl";

const lines = (text) => text.trimEnd().split("\n").filter((line) => line !== "");
const key = (scenario, objective, agents) => [scenario, objective, agents].join(" ");
const CERTIFIED = { proved: "proved", searched: "proved-and-searched", "": "not-certified" };

/** A published row as `giveway sweep` keeps it. What the CSV does not say, it does not claim. */
function row(told, line, { task, instance, agents, objective, planner }) {
  const [first] = objective;
  const seconds = Number(told["CPU s"]);
  const made = told["certificate CPU s"];
  return {
    giveway: 1, task, instance, map: told.map, agents, objective, planner,
    status: told.status, complete: false, within: null, costs: null,
    bounds: told["lower bound"] === "" ? {} : { [first]: Number(told["lower bound"]) },
    ...made !== "" && { certificate: {
      certified: CERTIFIED[told.certificate], bytes: Number(told["certificate bytes"]),
      ...told["manifest SHA-256"] !== "" && { manifest: told["manifest SHA-256"] },
    } },
    took: { cpu_seconds: seconds, wall_seconds: seconds, ...made !== "" && { certificate_cpu_seconds: Number(made) } },
    line,
  };
}

/** The published rows of tasks, as lines of JSON; `listed` is what `giveway sweep --list` says. */
export function started(csv, listed) {
  const tasks = new Map(lines(listed).map((text) => {
    const task = JSON.parse(text);
    const scenario = task.instance.split("/").pop().replace(/\.scen$/, "");
    return [key(scenario, task.objective.join(","), task.agents), task];
  }));
  const [, ...rows] = lines(csv);
  const told = parse(csv);
  const known = rows.flatMap((line, index) => {
    const { scenario, objective, agents } = told[index];
    const task = tasks.get(key(scenario, objective, agents));
    return task === undefined ? [] : [`${JSON.stringify(row(told[index], line, task))}\n`];
  });
  return known.join("");
}

/**
 * The rows of a folder of results that are of the listed tasks: `kept`, lines of JSON for `giveway table`;
 * `published`, lines of CSV of those that nobody did again; and how many tasks are `left`. `files` are the
 * texts of the folder's files by their names.
 */
export function chosen(files, listed) {
  const tasks = new Set(lines(listed).map((text) => JSON.parse(text).task));
  const rows = (name) => {
    const text = files.get(name) ?? "";
    const all = lines(text.slice(0, text.lastIndexOf("\n") + 1)).map((line) => ({ line, row: JSON.parse(line) }));
    return all.filter(({ row }) => tasks.has(row.task));
  };
  const kept = [...files.keys()].filter((name) => name !== PUBLISHED).sort().flatMap(rows);
  const tried = new Set(kept.filter(({ row }) => row.status !== "skipped").map(({ row }) => row.task));
  const published = rows(PUBLISHED).filter(({ row }) => !tried.has(row.task));
  const done = new Set([...kept, ...published].map(({ row }) => row.task));
  return {
    kept: kept.map(({ line }) => `${line}\n`).join(""),
    published: published.map(({ row }) => row.line),
    left: tasks.size - done.size,
  };
}

const HEAD = "map,scenario,agents,objective,lower bound,upper bound,status,gap %,CPU s,certificate,certificate bytes,"
  + "certificate CPU s,manifest SHA-256";

/** A CSV with more lines, all in the order of maps, scenarios, objectives and numbers of robots. */
export function together(csv, more) {
  const [head = HEAD, ...own] = lines(csv);
  const all = [...own, ...more];
  const told = parse([head, ...all].join("\n"));
  const compare = (a, b) => (a < b ? -1 : a > b ? 1 : 0);
  const order = (a, b) => compare(told[a].map, told[b].map) || compare(told[a].scenario, told[b].scenario)
    || compare(told[a].objective, told[b].objective) || told[a].agents - told[b].agents;
  const sorted = all.map((_, index) => index).sort(order).map((index) => all[index]);
  return `${[head, ...sorted].join("\n")}\n`;
}
