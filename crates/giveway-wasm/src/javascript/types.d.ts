/** A cell [x, y], from [0, 0] at the top left, y down. */
export type Cell = [number, number];

export type Cost = "makespan" | "sum-of-costs" | "charges" | "moves" | "waits";

export interface Agent {
  /** Unique and not empty. */
  name: string;
  start: Cell;
  goal: Cell;
  /** Cells to visit, in any order. */
  waypoints?: Cell[];
  /** In time steps; unlimited where left out or null. */
  battery?: { capacity: number; initial: number } | null;
}

/** An instance of the problem. */
export interface Scene {
  giveway: 1;
  name?: string;
  /** Rows from the top: `.` free, `#` obstacle, `~` slow zone, `+` charger, `*` charger in the slow zone. */
  map: string[];
  /** By default agents stay at their goals, and the floor is 0. */
  rules?: { at_goal?: "stay" | "vanish"; battery_floor?: number };
  /** Costs to minimise, the most important first. */
  objective?: Cost[];
  agents: Agent[];
}

/** Where each agent is at each time up to its arrival; null in transit. */
export interface Plan {
  giveway: 1;
  paths: Record<string, (Cell | null)[]>;
  /** The times at which an agent charges, ascending. */
  charges?: Record<string, number[]>;
  /** The time of an agent's first entry, where it is not 0. */
  from?: Record<string, number>;
  /** The time from which a removed agent is gone. */
  until?: Record<string, number>;
}

export interface SolveRequest {
  scene: Scene;
  /** Where it is not the scene's own. */
  objective?: Cost[];
  /** All non-dominated costs of the objective's two or three, instead of the best plan. */
  pareto?: boolean;
  /** Only plans of at most this makespan count. */
  within?: number;
  limits?: {
    /** Wall seconds. */
    seconds?: number;
    /** Conflicts of the SAT solver: the same wherever it runs. */
    conflicts?: number;
    /** What the memory may grow to, in bytes. */
    memory_bytes?: number;
  };
}

export interface CheckRequest {
  scene: Scene;
  plan: Plan;
}

/** Something became known on the way. */
export type Progress =
  | { event: "bound"; cost: Cost; at_least: number }
  | { event: "plan"; costs: Record<Cost, number> }
  | { event: "size"; variables: number; clauses: number; conflicts: number };

export interface SolveOptions {
  onProgress?: (event: Progress) => void;
  /** Asked about a hundred times a second; true ends in what is known by then. */
  shouldStop?: () => boolean;
}

/** Running out of a limit is `feasible` or `unknown`, never `impossible`. */
export type Status = "optimal" | "feasible" | "impossible" | "unknown";

export interface Stats {
  cpu_seconds: number;
  solver_calls: number;
  variables: number;
  clauses: number;
  conflicts: number;
}

export interface SolveAnswer {
  giveway: 1;
  status: Status;
  costs: Record<Cost, number> | null;
  /** The proved lower bound of each cost reached so far. */
  bounds: Partial<Record<Cost, number>>;
  /** The makespan up to which the claim was proved; null where it holds whatever the horizon. */
  within: number | null;
  complete: boolean;
  /** Why there is no plan or no proof. */
  reason?: string;
  plan: Plan | null;
  stats: Stats;
}

/** The answer to a request with `pareto`: an answer a point. */
export interface FrontAnswer {
  giveway: 1;
  status: Status;
  complete: boolean;
  within: number | null;
  front: SolveAnswer[];
}

export interface Violation {
  rule:
    | "shape" | "start" | "goal" | "waypoint" | "move" | "obstacle"
    | "vertex" | "swap" | "slow-swap" | "battery" | "charge";
  agents: string[];
  cell?: Cell;
  /** From and to, as the first agent goes. */
  edge?: [Cell, Cell];
  time: number;
  message: string;
}

export interface CheckAnswer {
  giveway: 1;
  valid: boolean;
  costs: Record<Cost, number> | null;
  violations: Violation[];
}

export interface MovingAiOptions {
  /** The scene's name. */
  name?: string;
  /** How many of the scenario's agents; all where left out. */
  agents?: number;
}

export interface Fault {
  /** Keys and indices, such as `scene.agents[1].goal`; absent for the whole. */
  place?: string;
  /** From 1, where the input was text. */
  line?: number;
  column?: number;
  found: string;
  expected: string;
}

/** What the functions throw where the input is wrong. */
export interface GivewayError extends Error {
  name: "GivewayError";
  code: "bad-input" | "bad-scene" | "bad-text" | "broken";
  place: string;
  found: string;
  expected: string;
  /** At least one. */
  faults: Fault[];
}
