// Plans of elsewhere for the tests: a scene of eight robots, and plans for it as other
// planners write them.

/** Aisles between shelves, and eight robots that cross them. */
export const AISLES = {
  giveway: 1,
  name: "aisles",
  map: ["............", ".##.##.##.#.", ".##.##.##.#.", "............", ".##.##.##.#.", ".##.##.##.#.", "............"],
  objective: ["sum-of-costs", "makespan"],
  agents: [
    { name: "A1", start: [11, 4], goal: [2, 6] },
    { name: "A2", start: [10, 0], goal: [0, 1] },
    { name: "A3", start: [11, 5], goal: [6, 4] },
    { name: "A4", start: [2, 0], goal: [11, 5] },
    { name: "A5", start: [4, 3], goal: [8, 6] },
    { name: "A6", start: [7, 6], goal: [0, 3] },
    { name: "A7", start: [11, 0], goal: [6, 5] },
    { name: "A8", start: [0, 4], goal: [3, 0] },
  ],
};

/** A hall in which two robots change places. */
export const HALL = {
  giveway: 1,
  name: "hall",
  map: ["...", "..."],
  objective: ["sum-of-costs", "makespan"],
  agents: [
    { name: "A1", start: [0, 0], goal: [2, 0] },
    { name: "A2", start: [2, 0], goal: [0, 0] },
  ],
};

/** Legal plans for the hall: one waits a step more than it need, the other is the best. */
export const LATE = {
  A1: [[0, 0], [0, 0], [1, 0], [2, 0]],
  A2: [[2, 0], [2, 1], [1, 1], [0, 1], [0, 0]],
};
export const BEST = { ...LATE, A1: [[0, 0], [1, 0], [2, 0]] };

/** Each robot's own shortest path, whoever is in its way. */
export function straight({ map, agents }) {
  return Object.fromEntries(agents.map(({ name, start, goal }) => [name, shortest(map, start, goal)]));
}

function shortest(map, start, goal) {
  const key = ([x, y]) => `${x},${y}`;
  const from = new Map([[key(start), null]]);
  const queue = [start];
  for (const cell of queue) {
    const [x, y] = cell;
    for (const next of [[x + 1, y], [x - 1, y], [x, y + 1], [x, y - 1]]) {
      const ground = map[next[1]]?.[next[0]];
      if (ground !== undefined && ground !== "#" && !from.has(key(next))) {
        from.set(key(next), cell);
        queue.push(next);
      }
    }
  }
  const path = [];
  for (let at = goal; at; at = from.get(key(at))) {
    path.unshift(at);
  }
  return path;
}

/** A file with an object of the project's own JSON. */
export function own(name, value) {
  return { name, bytes: JSON.stringify(value) };
}

/** A plan in the project's own JSON. */
export function plan(name, paths) {
  return own(name, { giveway: 1, paths });
}

/** A plan as EECBS and its kin write it: a line for each robot, row first. */
export function lines(paths) {
  const path = (cells) => cells.map(([x, y]) => `(${y},${x})->`).join("");
  return Object.values(paths).map((cells, index) => `Agent ${index}: ${path(cells)}\n`).join("");
}

/** A map as the standard benchmark has it. */
export function octile(map) {
  return `type octile\nheight ${map.length}\nwidth ${map[0].length}\nmap\n${map.join("\n").replaceAll("#", "@")}\n`;
}
