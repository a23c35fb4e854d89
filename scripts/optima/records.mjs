// Rows of other programs' optima beside our answers.

/** A scenario with the size of its map in each line: some name another one, which their program does not read. */
export function sized(scenario, map) {
  const size = (key) => map.match(new RegExp(`^${key} (\\d+)`, "m"))?.[1];
  const [width, height] = [size("width"), size("height")];
  return scenario.split("\n").map((line) => {
    const columns = line.trim().split(/\s+/);
    return columns.length < 9 ? line : columns.with(2, width).with(3, height).join("\t");
  }).join("\n");
}

/**
 * Whether an answer, as JSON of the command, has the optimum of a row: `equal`; `open`, where it is not closed and
 * both bounds allow it; or `differs`.
 */
export function compared(row, answer) {
  const optimum = Number(row.optimum);
  const [cost, bound] = [answer.costs?.[row.cost], answer.bounds?.[row.cost] ?? 0];
  if (answer.status === "optimal") return cost === optimum ? "equal" : "differs";
  const allows = answer.status !== "impossible" && bound <= optimum && (cost ?? optimum) >= optimum;
  return allows ? "open" : "differs";
}
