/** A cell [x, y], from [0, 0] at the top left, y down. */
export type Cell = [number, number];

export type Cost = "makespan" | "sum-of-costs" | "charges" | "moves" | "waits" | "penalty";

/** The costs of a plan; a penalty only where rules of the scene make one. */
export type Costs = Record<Exclude<Cost, "penalty">, number> & { penalty?: number };

export interface Agent {
  /** Unique and not empty. */
  name: string;
  start: Cell;
  /** Left out or null, it may rest at any cell, and stays there. */
  goal?: Cell | null;
  /** Cells to visit, in any order. */
  waypoints?: Cell[] | null;
  /** In time steps; unlimited where left out or null. */
  battery?: { capacity: number; initial: number } | null;
  /** Where it faces at first, which matters where turns take time. */
  heading?: Heading | null;
}

export type Heading = "north" | "east" | "south" | "west";

/** A named part of the map: its cells, or a rectangle of first and last column and row. */
export type Zone = { name: string; cells: Cell[] } | { name: string; rect: [number, number, number, number] };

/** A rule of the scene's own. Times are included; left out, they are from 0 and for ever. */
export type Constraint = { name?: string; off?: boolean } & (
  | { kind: "sequence"; agent: string; cells: Cell[] }
  | { kind: "before"; first: { agent: string; cell: Cell }; second: { agent: string; cell: Cell } }
  | ({ agents?: string[] } & (
      | { kind: "capacity"; zone: string; most: number; from?: number; to?: number }
      | { kind: "closed"; zone: string; from?: number; to?: number }
      | { kind: "one-way"; lane: Cell[] }
      | { kind: "gap"; steps: number }
      | { kind: "apart"; distance: number; from?: number; to?: number }
      | { kind: "visit"; cell: Cell; stay?: number; from?: number; to?: number }
      | { kind: "arrive"; by?: number; from?: number }
      /** Each step late costs so much. */
      | { kind: "arrive"; by: number; weight: number }
      | { kind: "depart"; from: number }
      | { kind: "no-waiting"; zone: string; most?: number }
      | { kind: "turns"; quarter: number }
      | { kind: "avoid"; zone: string; weight: number }
    ))
);

/** An instance of the problem. */
export interface Scene {
  giveway: 1;
  name?: string;
  /** Rows from the top: `.` free, `#` obstacle, `~` slow zone, `+` charger, `*` charger in the slow zone. */
  map: string[];
  /** By default agents stay at their goals, and the floor is 0. */
  rules?: { at_goal?: "stay" | "vanish"; battery_floor?: number } | null;
  /** Costs to minimise, the most important first. */
  objective?: Cost[] | null;
  agents: Agent[];
  /** What the scene takes for granted, where it was read from a file of another maker. */
  assumptions?: Assumption[];
  /** Named parts of the map. */
  zones?: Zone[] | null;
  /** Rules of its own, which every plan must keep. */
  constraints?: Constraint[] | null;
  /** The side of a cell in metres, and the length of a time step in seconds; no claim is about them. */
  units?: { cell: number; step: number } | null;
}

/** Something that a scene takes for granted: whatever is said of it is said under that. */
export type Assumption =
  /** Goals or tasks were chosen out of those that the file leaves open. */
  | { assumes: "goals-chosen" }
  /** Its cell at each time from 0. With `closed`, rules of the scene close these cells, and only exchanges of cells are looked at. */
  | { assumes: "moving-obstacle"; name: string; path: Cell[]; closed?: boolean }
  /** A rule of the file's problem that scenes do not have: bounds hold with it, too; a plan that is found may break it. */
  | { assumes: "rule-left-out"; rule: "turning" | "long-moves" | "errand-order" | "handling" }
  /** A key of the file that is not heeded and may change the problem. */
  | { assumes: "unknown-key"; key: string };

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
  /** The last time whose changes the plan takes into account. */
  knows?: number;
  /** What agents slept through at their goals before a change made them go on. */
  slept?: Record<string, [number, number][]>;
}

export interface SolveRequest {
  scene: Scene;
  /** Where it is not the scene's own. */
  objective?: Cost[];
  /** All non-dominated costs of the objective's two or three, instead of the best plan. */
  pareto?: boolean;
  /** Only plans of at most this makespan count. */
  within?: number;
  /** A plan known already, to begin with; ignored where it breaks a rule or is beyond `within`. */
  start?: Plan;
  /** Whether to tell how the plan was found and proved; not with `pareto`. */
  trace?: boolean;
  limits?: Limits;
}

/** A budget; what is left out is not limited, but for the memory. */
export interface Limits {
  /** Wall seconds. */
  seconds?: number;
  /** Conflicts of the SAT solver: the same wherever it runs. */
  conflicts?: number;
  /** Units of work: states that planners and local search look at, and the SAT solver's steps, weighed in states.
   * Where only this ends a search, the same request has the same answer each time, here and natively. */
  work?: number;
  /** What the memory may grow to, in bytes. */
  memory_bytes?: number;
}

export interface CheckRequest {
  scene: Scene;
  plan: Plan;
  /** What changes while it runs. */
  changes?: Changes;
}

/** Something became known on the way. */
export type Progress =
  | { event: "bound"; cost: Cost; at_least: number }
  /** The best plan so far; it may be handed in again as `start`. */
  | { event: "plan"; costs: Costs; plan: Plan }
  | { event: "size"; variables: number; clauses: number; conflicts: number }
  | { event: "explained"; answer: ExplainAnswer }
  /** What a trace has more of by now. */
  | { event: "traced"; events: TraceEvent[] }
  /** What is known so far; `pending` has the parts that are to come. */
  | { event: "freedom"; answer: FreedomAnswer }
  /** What is known so far; `pending` counts the prices that are to come. */
  | { event: "priced"; answer: PriceAnswer }
  /** The ledger of a plan; the proof is to come. */
  | { event: "delays"; answer: DelaysAnswer }
  /** The plan of one more number of robots; `pending` counts those that are to come. */
  | { event: "sized"; floor: "this" | "beside"; point: SizingPoint; pending: number }
  | { event: "certifying"; claim: string; checking: boolean }
  /** So many certificates are made. */
  | { event: "exporting"; done: number; of: number };

/** For what may take long. */
export interface Options {
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
  work: number;
}

/** What ended a search. Only time, memory and a person end the same search elsewhere each time. */
export type Ended = "proof" | "work" | "conflicts" | "time" | "memory" | "cancelled" | "size" | "fault"
  | "assumptions";

export interface SolveAnswer {
  giveway: 1;
  status: Status;
  costs: Costs | null;
  /** The proved lower bound of each cost reached so far. */
  bounds: Partial<Record<Cost, number>>;
  /** The makespan up to which the claim was proved; null where it holds for plans of any makespan. */
  within: number | null;
  complete: boolean;
  ended?: Ended;
  /** Why there is no plan or no proof. */
  reason?: string;
  plan: Plan | null;
  stats: Stats;
  /** Where it was asked for. */
  trace?: SearchTrace;
}

/** How the best plan was found and proved: the first 200 steps and the last 2,000. */
export interface SearchTrace {
  giveway: 1;
  objective: Cost[];
  events: TraceEvent[];
  /** How many steps there were between those. */
  left_out: number;
}

/** A step of the search. */
export type TraceEvent = {
  /** Among all steps, from 0. */
  number: number;
  /** Conflicts of the SAT solver up to now. */
  conflicts: number;
  /** A sentence that is true by itself. */
  text: string;
  /** Rules of the scene that it rests on, as far as they are known: with these it holds, without any rule it does not. */
  rules?: Constraint[];
} & (
  | { event: "alone"; cost: Cost; agents: AgentLeast[]; at_least: number }
  | {
    event: "plan";
    costs: Costs;
    by: "given" | "alone" | "prioritised" | "lacam" | "repair" | "lns" | "solver" | "partly-solver" | "exhaustion";
  }
  /** The next cost, given those before it. */
  | { event: "phase"; cost: Cost; given: Partial<Record<Cost, number>> }
  | { event: "round"; cost: Cost }
  | { event: "entered"; agents: { agent: string; with: string[] }[] }
  | ({ event: "core" } & Core)
  | { event: "closed"; cost: Cost; condition?: TraceCondition; from: number; to: number; took: number }
  | { event: "counted"; cost: Cost; agents: string[]; at: { passage: Cell[] } | { zone: { rule: number; most: number } }; at_least: number }
  | { event: "exhausted"; bounds: Partial<Record<Cost, number>> }
  | { event: "restarted"; why: "more-time" | "horizon" }
  | { event: "met"; costs: Partial<Record<Cost, number>>; within: number | null }
  | { event: "impossible"; agents: string[]; within: number | null }
  | { event: "stopped"; reason: string; costs: Costs | null; bounds: Partial<Record<Cost, number>> }
);

/** Limits that no plan keeps all at once, so that the bound rises. */
export interface Core {
  cost: Cost;
  limits: AgentLimit[];
  /** Earlier cores, by the numbers of their steps, of which no more than so many limits may be broken. */
  sums?: { event: number; at_most: number }[];
  /** What all robots of this core and those below it need beyond the least of each. */
  together: { agents: AgentLeast[]; more: number } | null;
  condition?: TraceCondition;
  from: number;
  to: number;
  /** Its size as first found, and once it was made smaller. */
  literals: { before: number; after: number };
  /** Conflicts that it took. */
  took: number;
}

export interface AgentLeast {
  agent: string;
  /** What it needs alone. */
  least: number;
}

export interface AgentLimit extends AgentLeast {
  /** Of makespan and sum of costs: when it arrives at the latest. */
  at_most: number;
}

/** Of which plans a claim is made; of all where it is not there. */
export interface TraceCondition {
  given?: Partial<Record<Cost, number>>;
  /** Plans with no more of the cost that is bounded. */
  at_most?: number;
  within?: number;
  /** Plans of all robots, not of the named ones alone. */
  others?: true;
}

/** Why can some robots not all keep their limits? */
export interface TogetherRequest {
  scene: Scene;
  cost: Cost;
  agents: AgentLimit[];
  /** What they may have together beyond the least of each. */
  more?: number;
  /** Only plans of at most this makespan count. */
  within?: number;
  limits?: Limits;
}

export interface TogetherAnswer {
  giveway: 1;
  /** Where each can be, and from when to when, while it arrives in time. */
  regions: { agent: string; by: number; cells: { cell: Cell; first: number; last: number }[] }[];
  /** Where a robot has to be at a time, as far as that explains the meetings. */
  passes: { agent: string; cell: Cell; time: number; rests: boolean }[];
  /** Where two of them collide whichever ways they take. */
  meetings: (
    & { agents: [string, string]; time: number }
    & ({ kind: "vertex" | "target"; cell: Cell } | { kind: "swap"; edge: [Cell, Cell] })
  )[];
  /** The search for these robots only; null where they are more than four. */
  alone: {
    scene: Scene;
    solved: SolveAnswer;
    /** Whether they cannot keep their limits even by themselves; null where that is open. */
    refuted: boolean | null;
  } | null;
}

/** The answer to a request with `pareto`: an answer a point. */
export interface FrontAnswer {
  giveway: 1;
  status: Status;
  ended?: Ended;
  complete: boolean;
  within: number | null;
  front: SolveAnswer[];
}

export interface Violation {
  rule:
    | "shape" | "start" | "goal" | "waypoint" | "move" | "obstacle"
    | "vertex" | "swap" | "slow-swap" | "battery" | "charge" | "constraint";
  agents: string[];
  /** Of a rule of the scene's own: its kind, its number from 0, its name, and where. */
  kind?: Constraint["kind"];
  index?: number;
  name?: string | null;
  cells?: Cell[];
  cell?: Cell;
  /** From and to, as the first agent goes. */
  edge?: [Cell, Cell];
  time: number;
  message: string;
}

export interface CheckAnswer {
  giveway: 1;
  valid: boolean;
  costs: Costs | null;
  violations: Violation[];
}

/** A question about a plan. Times are steps from 0; agents go by their names. */
export type Question =
  /** Why does it wait? Or, with `at-least`, why so long? */
  | { kind: "wait"; agent: string; at?: Cell; from?: number; to?: number; "at-least"?: number }
  | { kind: "charge"; agent: string; at?: Cell; time?: number }
  | { kind: "no-charge"; agent: string; at: Cell }
  | { kind: "visit"; agent: string; at: Cell; time?: number }
  /** Without an agent: why does nobody pass? */
  | { kind: "no-visit"; agent?: string; at: Cell }
  | { kind: "move" | "no-move"; agent: string; "from-cell": Cell; "to-cell": Cell; time?: number }
  /** Over one edge where both of its cells are given, over any else. */
  | { kind: "slow"; agent: string; "from-cell"?: Cell; "to-cell"?: Cell }
  | { kind: "order"; agent: string; first: Cell; second: Cell }
  | { kind: "arrival"; agent: string }
  | { kind: "length"; agent: string; "fewer-than"?: number }
  | { kind: "makespan" | "sum-of-costs" | "penalty" }
  /** Without an agent: of all of them. */
  | { kind: "charges" | "moves" | "waits"; agent?: string }
  /** Why does `agent` give way to `to`? */
  | { kind: "yield"; agent: string; to: string; at: Cell }
  /** Why does the plan not keep this rule, which is none of the scene's? */
  | { kind: "rule"; rule: Constraint }
  | { kind: "unsolvable" }
  | { kind: "plan" };

export interface ExplainRequest {
  scene: Scene;
  /** The plan that is asked about; without one the scene is solved first. */
  plan?: Plan;
  /**
   * What changed while the plan ran: the question is about what comes from the last change on, in
   * times of the whole plan. Of `unsolvable` the plan is the one that ran until then.
   */
  changes?: Changes;
  /** The time that is looked at: later changes do not count. */
  at?: number;
  question: Question;
  /** Where it is not the scene's own. */
  objective?: Cost[];
  /** Only plans of at most this makespan count. */
  within?: number;
  /** Each with those of `whole`, `reason` and `help` before it; without any these three. */
  layers?: Layer[];
  limits?: Limits;
}

/** The layers of an answer, the quickest first. */
export type Layer = "here" | "near" | "whole" | "reason" | "help";

/** What the plan shows where something is asked about. */
export interface Here {
  /** The robot that would do otherwise. */
  agent: string;
  /** Of a wait: who uses the robot's further way meanwhile. */
  passing: { agent: string; cell: Cell; time: number }[];
  /** The rules that would be broken if only this changed, all others as in the plan. */
  violations: Violation[];
  words: string;
}

/** A robot that another plan moves differently. */
export interface AgentDifference {
  agent: string;
  arrival: number;
  other: number;
  more_waits: number;
  other_way: boolean;
}

/** A plan near to the one that is asked about. */
export interface Variation {
  kind: "elsewhere" | "other-way" | "swapped" | "others";
  /** Of `swapped`: the robot that waits. */
  other?: string;
  /** Of `elsewhere`: where the robot waits, and from when on. */
  cell?: Cell;
  from?: number;
  costs: Costs;
  deltas: Partial<Record<Cost, number>>;
  pays: AgentDifference[];
  /** The paths and charges of the robots that move differently; all others do as in the plan. */
  plan: Plan;
  text: string;
}

/** Small variations of the plan that are as asked for, the cheapest first. */
export interface Near {
  variations: Variation[];
  /** The costs of the cheapest: the best other plan costs no more. */
  at_most?: Costs;
  words: string;
}

/** Of the best other plan: it costs the same, less, more; there is none; not known. */
export type Verdict = "needless" | "improvable" | "costly" | "necessary" | "unknown";

/** A fact of the scene that can be left out. */
export interface Fact {
  kind: "task" | "waypoint" | "battery" | "obstacle" | "slow" | "collision" | "stay" | "deadline" | "floor" | "breakdown" | "presence" | "rest"
    | "constraint";
  agents: string[];
  cell: Cell | null;
  /** Of a rule of the scene's own: its number, from 0. */
  index?: number;
  /** Of a breakdown: when it began, and the time from which the agent may go on. Of a rule: when a change added it. */
  time?: number;
  until?: number;
  text: string;
  /** Whether leaving out this fact alone gives the whole scene a plan; null where it is not known. */
  helps: boolean | null;
}

/** Facts of one set that are told together: of one robot, of a shelf block, of an aisle. */
export interface FactGroup {
  kind: "agent" | "agents" | "collisions" | "aisle" | "shelf" | "shelves" | "rule" | "rules";
  agents: string[];
  /** The cells of an aisle, or the obstacles of a shelf block among the facts. */
  cells: Cell[];
  /** By their places in the set, from 0. */
  facts: number[];
  text: string;
  /** Whether it is shown that the group is needed in the set: without it there is a plan. */
  needed: boolean;
  /** Whether leaving out one of its facts alone helps; null where it is not known. */
  helps: boolean | null;
  /** The least costs of the whole scene without one of its facts, as far as was tried. */
  price?: FactPrice;
}

/** The costs of the whole scene without one fact, with what the question asks for. */
export interface FactPrice {
  /** The fact, by its place in the set, from 0. */
  fact: number;
  costs: Costs;
  /** Whether it is proved that no plan costs less. */
  proved: boolean;
}

/** What some robots alone need, proved: no plan of all costs less. After a change of the whole plan, with what was paid before. */
export interface SubsetBound {
  agents: string[];
  cost: Cost;
  /** What they need where each is alone: the most of one for the makespan, else the sum. */
  own: number;
  least: number;
  /** What they have in the plan that is asked about, or in the other plan where that costs more of this and no more of what matters more. */
  here: number;
}

/** Facts that alone make it impossible, or so costly; others may make it so, too. */
export interface Core {
  facts: Fact[];
  /** The facts in groups, the deciding one first, where there are more than three: seven at most. */
  groups?: FactGroup[];
  /** What the whole scene costs without one of the facts, as far as was tried. */
  prices?: FactPrice[];
  /** Each is needed in the set: with only the others of the set there is a plan. */
  minimal: boolean;
  complete: boolean;
  within: number | null;
  /** Where no fact helps (robots left out apart): sets that make it so, too, sharing as few facts as was found. */
  further?: Core[];
}

export type Edit =
  | { edit: "remove-obstacle" | "add-charger" | "make-normal"; cell: Cell }
  | { edit: "battery"; agent: string; capacity: number; initial: number }
  | { edit: "battery-floor"; floor: number }
  | { edit: "deadline"; within: number }
  | { edit: "drop-waypoint"; agent: string; cell: Cell }
  | { edit: "vanish" }
  | { edit: "leave-out"; agent: string }
  /** Of a rule of the scene's own, by its number and in words. */
  | { edit: "switch-off"; index: number; rule: string }
  | { edit: "allow-more"; index: number; rule: string; most: number }
  | { edit: "give-until"; index: number; rule: string; to: number };

/** Edits after which there is a plan. */
export interface Repair {
  edits: Edit[];
  /** Whether its battery, floor or deadline is proved to be the least change that helps. */
  least: boolean;
  costs: Costs;
  /** When the robot arrives then whose arrival is asked about; left out for other questions. */
  arrival?: number;
  /** Whether no plan of the edited instance is better. */
  proved: boolean;
  plan: Plan;
  text: string;
}

export interface ExplainAnswer {
  giveway: 1;
  question: Question;
  /** The time from which it is answered, where the world changed before. */
  since?: number;
  /** The plan that is asked about, where the request had none. */
  plan?: Plan;
  verdict: Verdict;
  /** Of the other plan, as the alternative. */
  costs: Costs | null;
  deltas: Partial<Record<Cost, number>>;
  /** Of `costly`: whether the first of these that is not 0 is only an upper bound. */
  at_most?: boolean;
  within: number | null;
  complete: boolean;
  alternative: Plan | null;
  /** Whether it is proved that no other best plan is closer. */
  closest: boolean;
  /** Of `needless`: how the other plan does without it; `free` is there only alone. */
  how?: ("others" | "other-way" | "elsewhere" | "free")[];
  /** The robots that the other plan moves differently; who arrives later by most is the first. */
  pays?: AgentDifference[];
  /** Where these layers are asked for; `alternative` is the cheapest variation until there is a verdict. */
  here?: Here;
  near?: Near;
  /** What would happen; of `unsolvable` with the class of rules that were soft. */
  witness: (Violation & { class?: "collision" | "obstacle" | "battery" | "waypoint" })[];
  core: Core | null;
  /** What sets of robots alone need, where the question is about a cost of the whole plan, or no small reason was found. */
  alone?: SubsetBound[];
  repairs: Repair[];
  /** Whether all repairs were tried. */
  /** How many more repairs help than are told. */
  further_repairs: number;
  exhaustive: boolean;
  /** Of `plan` only, as the next three. */
  valid?: boolean;
  violations?: Violation[];
  optimal?: boolean;
  excess?: { agent: string; cost: Cost; by: number }[];
  /** The parts that are still to come. */
  pending?: ("verdict" | "closest" | "witness" | "core" | "repairs")[];
  words: string;
  stats: Stats;
}

/** Something that changes while a plan runs. */
export type Change = { at: number } & (
  | { change: "add-agent"; agent: Agent }
  | { change: "remove-agent"; agent: string }
  | { change: "add-obstacle" | "remove-obstacle" | "add-charger" | "remove-charger"; cell: Cell }
  | { change: "move-obstacle"; from: Cell; to: Cell }
  | { change: "set-slow" | "set-normal"; cells: Cell[] }
  | { change: "set-goal" | "add-waypoint" | "drop-waypoint"; agent: string; cell: Cell }
  | { change: "set-battery"; agent: string; level: number }
  | { change: "delay-agent"; agent: string; steps: number }
  | { change: "stop-agent"; agent: string }
  /** The zone of the rule is one of the scene. */
  | { change: "add-constraint"; constraint: Constraint }
  /** Rules that changes added are numbered on from those of the scene. */
  | { change: "remove-constraint"; name: string }
  | { change: "remove-constraint"; index: number }
);

export interface Changes {
  giveway: 1;
  changes: Change[];
}

/** `tunnel=2`: within so many steps of the rest of their paths. */
export type Method = "revise" | "replan" | `tunnel=${number}`;

export interface ChangeRequest {
  scene: Scene;
  plan: Plan;
  changes: Changes;
  /** The first time whose changes are new to the plan; else as few as make it valid are known to it. */
  since?: number;
  /** Tried at each time; the first that has a plan is adopted. */
  methods?: Method[];
  objective?: Cost[];
  within?: number;
  /** For each method at each time. */
  limits?: Limits;
}

/** Why a method has no plan. */
export interface Cause {
  agent: string;
  kind: "obstacle" | "goal" | "waypoint" | "rule" | "battery" | "no-way" | "blocked";
  cell: Cell | null;
  agents?: string[];
  /** The rule of the scene's own that leaves no plan, by its number, where it is one. */
  rule?: { index: number; name: string | null };
  within: number | null;
  text: string;
}

/** What a method makes of a change: the names of the agents it keeps, re-times, and so on. */
export interface MethodAnswer extends SolveAnswer {
  kept: string[];
  retimed: string[];
  rerouted: string[];
  added: string[];
  freed: string[];
  fewest: boolean;
  /** The makespan up to which no fewer could be freed; left out where that holds for every one. */
  fewest_within?: number;
  cause: Cause | null;
  closest: boolean;
}

/** The changes of one time, and how to go on. */
export interface ChangeStep {
  at: number | null;
  before: Costs | null;
  methods: Partial<Record<Method, MethodAnswer>>;
  adopted: Method | null;
}

/** Of the last time; those before it are the history. */
export interface ChangeAnswer extends ChangeStep {
  giveway: 1;
  history: ChangeStep[];
}

/** That there is no plan of some kind. */
export interface Claim {
  /** The costs that such a plan would have at most. */
  most: Partial<Record<Cost, number>>;
  within: number | null;
  /** What such a plan would be like beside its costs. */
  condition?: Condition;
}

/** A condition on a plan. */
export type Condition =
  | { contrast: Question }
  | { arrival: { agent: string; before: number } }
  | { "at-most": { agent: string; cost: Cost; most: number } };

/** What was answered, to be proved again. */
export interface CertifyRequest {
  scene: Scene;
  objective?: Cost[];
  /** What all claims are limited to; of all plans `{ most: {}, within: null }`. */
  about: Claim;
  /** The lower bounds that were claimed. */
  bounds: Partial<Record<Cost, number>>;
  /** Whether it was claimed that there is no plan. */
  impossible: boolean;
  complete: boolean;
  within: number | null;
  plan: Plan | null;
  /** Cores of the search, as guesses for lemmas: those of a trace. */
  hints?: { cost: Cost; limits: Record<string, number>; agents: string[]; more: number; is_clause: boolean }[];
  limits?: Limits;
}

/** A statement about some robots alone: they have no plan in which each arrives by its time, at such costs together. */
export interface Lemma {
  by: Record<string, number>;
  most?: Partial<Record<Cost, number>>;
}

/** A claim that was checked: by a proof, by lemmas with a proof each, by a search, or not. */
export type Checked = { text: string; claim: Claim } & (
  | { kind: "proof"; variables: number; clauses: number; steps: number }
  | {
      kind: "lemmas";
      /** What the lemmas add to: the steps that goals are away, or what a search of each robot alone found. */
      least: "distance" | "search";
      lemmas: { text: string; lemma: Lemma; variables: number; clauses: number; steps: number }[];
      variables: number;
      clauses: number;
      steps: number;
    }
  | { kind: "search"; method: "alone" | "joint" | "counting" }
  | { kind: "none"; why: string }
);

/** What came of checking a certificate. */
export interface Report {
  giveway: 1;
  accepted: boolean;
  /** What its claims were shown by, taken together. */
  certified: "proved" | "proved-and-searched" | "not-certified";
  /** What plan and claims say together. */
  conclusion: string | null;
  /** The same for programs. */
  concluded:
    | { kind: "best"; objective: Cost[]; condition: Condition | null; within: number | null }
    | { kind: "believed" }
    | { kind: "bounds" }
    | { kind: "no-plan"; claim: Claim }
    | null;
  /** Why it was not accepted. */
  reason: string | null;
  /** Whether the check ended before it came to a result. */
  stopped: boolean;
  claims: Checked[];
}

/** Certificates as one file. */
export interface Exported {
  /** A zip archive with a folder for each, not compressed; `giveway verify` reads it. */
  zip: Uint8Array;
  /** What came of checking each, by their names; those that there was no time for are not there. */
  reports: Record<string, Report>;
}

export interface VerifyRequest {
  /** The texts of a certificate's files by their names. */
  files: Record<string, string>;
  limits?: Limits;
}

export interface AuditRequest {
  scene: Scene;
  /** It may break any rule. */
  plan: Plan;
  /** Where it is not the scene's own. */
  objective?: Cost[];
  /** Compared with plans of at most this makespan, and of that of the plan itself. */
  within?: number;
  limits?: Limits;
}

/** What is known of a plan. */
export interface AuditAnswer {
  giveway: 1;
  legal: boolean;
  violations: Violation[];
  objective: Cost[];
  /** Of the plan as it stands, legal or not; null where an agent has no path. */
  costs: Costs | null;
  /** No legal plan has less of the first cost, and none that is best in those before of a later one. */
  bounds: Partial<Record<Cost, number>>;
  /** The makespan up to which that was proved; null where it holds for plans of any makespan. */
  within: number | null;
  complete: boolean;
  /** `optimal`: legal, and proved to be the best. */
  status: "optimal" | "feasible" | "illegal" | "unknown";
  /** How far the first cost of a legal plan is above its bound, as a part of the bound. */
  gap: number | null;
  /** A plan with lower costs; where the audited one is illegal, a legal one. */
  better: Plan | null;
  better_costs: Costs | null;
  /** What is known of the best plan: `optimal` where `better`, or else the audited plan, is proved to be it. */
  search: Status;
  /** Why something is not known, or why there is no legal plan. */
  reason?: string;
  stats: Stats;
}

/** A part of what must be so. */
export type FreedomPart = "backbone" | "slack" | "plans" | "critical" | "farthest";

export interface FreedomRequest {
  scene: Scene;
  /** The plan that is looked at, which must break no rule; without one the scene is solved first. */
  plan?: Plan;
  /** Where it is not the scene's own. */
  objective?: Cost[];
  /** Only plans of at most this makespan. */
  within?: number;
  /** All where none is named. */
  parts?: FreedomPart[];
  /** The number of plans up to which is counted; 1,000 where it is not given. */
  count?: number;
  limits?: Limits;
}

/** Proved; disproved by a plan; or null, where it is open. */
export type Known = boolean | null;

/** One entry of an agent's path in the plan. */
export interface Visit {
  time: number;
  /** null in transit. */
  cell: Cell | null;
  /** Whether every best plan has it. */
  always: Known;
  /** Whether no other best plan has it. */
  only: Known;
  /** The same of a charge at that time. */
  charge?: { always: Known; only: Known };
}

export interface Counted {
  count: number;
  /** Whether it is proved that there are no others. */
  complete: boolean;
  known: "exactly" | "more-than" | "at-least";
}

/** The ways of one agent in best plans. */
export interface Ways extends Counted {
  /** Every step that it takes in a best plan that was found. */
  steps: { time: number; from: Cell; to: Cell }[];
  /** Whether it is proved that it takes no other step in any best plan. */
  all: Known;
}

/** Steps for which an agent could stand still; null in transit. */
export type Hold = number | "unlimited" | null;

/** How late an agent could be. */
export interface Slack {
  /** How many steps later it arrives in some best plan, the others planned anew; null where it is open. */
  arrival: number | null;
  "arrival-at-least": number;
  /** For how long it could stand still at each time, nobody else doing anything else. */
  hold: Hold[];
  /** The least of `hold`; null where it has nothing to do. */
  late: Hold;
}

/** A free cell, and what it would cost to make it an obstacle. */
export interface CriticalCell {
  cell: Cell;
  status: "optimal" | "impossible" | "unknown";
  /** Of the best plan without the cell. */
  costs: Costs | null;
  /** How much more it has of each cost of the objective. */
  deltas: Partial<Record<Cost, number>> | null;
  /** Who needs the very cell. */
  needed?: "start" | "goal" | "waypoint" | "rule";
  /** Where it is open: whether it is proved that something is lost. */
  worse?: boolean;
  complete: boolean;
  within: number | null;
}

/** Another best plan, as different as can be. */
export type Farthest =
  | { status: "only" | "unknown" }
  | { status: "found"; plan: Plan; differs: number; most: Known };

/** What all best plans share, and what is free to choose. */
export interface FreedomAnswer {
  giveway: 1;
  /** The parts are there only where it is `optimal`: they speak of all best plans. */
  status: Status;
  objective: Cost[];
  /** Which plan it is about. */
  about: "given" | "found" | "better";
  costs: Costs | null;
  plan: Plan | null;
  backbone?: Record<string, Visit[]>;
  plans?: Counted & { ways: Record<string, Ways> };
  farthest?: Farthest;
  slack?: Record<string, Slack>;
  critical?: CriticalCell[];
  /** The parts that are not finished. */
  pending?: FreedomPart[];
  /** Whether what is said of all best plans holds whatever the horizon. */
  complete: boolean;
  within: number | null;
  /** Why something is open. */
  reason?: string;
  stats: Stats;
}

export interface PriceRequest {
  scene: Scene;
  /** Where it is not the scene's own. */
  objective?: Cost[];
  /** Only plans of at most this makespan. */
  within?: number;
  /** A plan that is known already: the search begins with it. */
  start?: Plan;
  /** The price of this rule alone, by its number from 0, and the least looser form that helps. */
  loosen?: number;
  limits?: Limits;
}

/** The least looser form of a rule that changes the costs, or with which there is a plan. */
export interface LooserRule {
  /** The rule as it would be. */
  rule: Constraint;
  /** The costs of the best plan under it. */
  costs: Partial<Record<Cost, number>>;
  /** With the rule as it is minus these; left out where there is no plan with it. */
  difference?: Partial<Record<Cost, number>>;
  /** No plan under it is better. */
  exact: boolean;
  /** Every tighter form is proved to change nothing. */
  least: boolean;
}

/** A rule of the scene's own, with its price. */
export interface RulePrice {
  /** Its number in the scene, from 0. */
  index: number;
  kind: Constraint["kind"];
  name: string | null;
  /** `decides`: there is a plan without it, and none with it. `none`: there is none without it, either. */
  price: "free" | "costs" | "decides" | "none" | "unknown";
  /** Both sides are proved: optimal or impossible. */
  exact: boolean;
  /** The costs of the best plan without it. */
  without?: Partial<Record<Cost, number>>;
  /** With it minus without it; a later cost may be negative. */
  difference?: Partial<Record<Cost, number>>;
  /** The cost of the two below, where it is not the first: in those before it both sides are proved equal. */
  range_of?: Cost;
  /** Of the first cost, where the price is unknown. */
  at_least?: number;
  at_most?: number;
}

/** What the rules of the scene's own cost. */
export interface PriceAnswer {
  giveway: 1;
  /** Of the scene with all rules that are in force. */
  status: Status;
  objective: Cost[];
  costs: Costs | null;
  plan: Plan | null;
  complete: boolean;
  within: number | null;
  /** Why there is no plan or no proof. */
  reason?: string;
  prices: RulePrice[];
  /** Rules and facts that exclude each other, where there is no plan. */
  conflict: Core | null;
  /** All sets of the fewest rules whose switching off leaves a plan. */
  switch_off: number[][];
  switch_off_settled: boolean;
  /** How the rule can be loosened that the request names. */
  loosened?: {
    index: number;
    /** It has a number or times to loosen. */
    can_loosen: boolean;
    looser: LooserRule[];
    /** Every other way is proved to change nothing. */
    settled: boolean;
  };
  /** How many prices are still to come. */
  pending: number;
  /** All of it in sentences. */
  words: string;
  stats: Stats;
}

/** A robot comes so many steps late to a cell. */
export interface Lateness {
  agent: string;
  cell: Cell;
  /** Which of its visits of the cell, from 1; 1 by default. */
  visit?: number;
  steps: number;
}

export type OrderFormat = "dot" | "csv" | "waypoints" | "vda5050";

export interface OrderRequest {
  scene: Scene;
  /** Without one, the scene is solved first. With changes it has to be there. */
  plan?: Plan;
  /** What changes while the plan runs. */
  changes?: Changes;
  /** Who comes late, and where. */
  late?: Lateness[];
  /** Other formats in which the order is written, too. */
  to?: OrderFormat[];
  /** Of the search for a plan, where it is not the scene's own. */
  objective?: Cost[];
  /** The horizon of that search. */
  within?: number;
  limits?: Limits;
}

/** A stay of a robot at a cell, without lateness. */
export interface OrderVisit {
  cell: Cell;
  /** When it begins its move into the cell; `null` where its way begins. */
  comes: number | null;
  arrives: number;
  /** When it begins to leave; `null` where it stays for good. */
  leaves: number | null;
  /** The least steps that it stands there, to turn. */
  stands?: number;
  charges?: boolean;
}

/** A visit, by its number from 0, as an end of a link: when its robot begins to leave, or to come. */
export interface OrderLinkEnd {
  agent: string;
  visit: number;
  time: number;
}

/** `second` begins its move into the cell no earlier than `gap` steps after `first` begins to leave it. */
export interface OrderLink {
  cell: Cell;
  first: OrderLinkEnd;
  second: OrderLinkEnd;
  gap: number;
  /** How many steps later the first may leave before the second has to wait. */
  slack: number;
}

/** A move into the cell of a visit. */
export interface OrderMove {
  agent: string;
  visit: number;
  cell: Cell;
}

export interface Order {
  agents: { agent: string; heading?: "north" | "east" | "south" | "west"; visits: OrderVisit[]; end: "stays" | "vanishes" | "removed" }[];
  /** By cell, row by row, then by time. */
  links: OrderLink[];
  /** Moves in a circle, which begin in one step. */
  rotations: { time: number; moves: OrderMove[] }[];
  /** Moves that begin later than in the plan, since the order alone has to be safe. */
  later: { agent: string; cell: Cell; planned: number; begins: number }[];
}

/** Something that robots may break though they keep to the order. */
export type OrderLoss =
  | { loss: "rule"; index: number; kind: Constraint["kind"]; text: string }
  | { loss: "battery"; agent: string; spare: number }
  | { loss: "changes"; last: number }
  | { loss: "moving-obstacles" };

/** What follows if some robots come late and all keep to the order. */
export interface LateOutcome {
  late: Lateness[];
  /** `most`: by how much it is late at most, at any of its cells. */
  arrivals: { agent: string; planned: number; now: number | null; most: number }[];
  /** Visits that are later than without lateness. */
  visits: { agent: string; visit: number; cell: Cell; planned: number; now: number }[];
  /** The plan as it is carried out. */
  plan: Plan;
  /** What that plan breaks. */
  violations: Violation[];
  /** Changes that contradict the world as that plan has it. */
  refused: string[];
}

/** In which order robots pass each cell. */
export interface OrderAnswer {
  giveway: 1;
  costs: Costs | null;
  order: Order | null;
  /** How many links have no slack. */
  without_slack: number;
  /** Moves that would wait for each other, where no order alone keeps the plan safe. */
  none?: { moves: OrderMove[] };
  losses: OrderLoss[];
  late?: LateOutcome;
  files?: { format: OrderFormat; text: string }[];
  /** The plan that was found, where none was handed in. */
  plan?: Plan;
  /** Why there is no plan. */
  reason?: string;
  /** All of it in sentences. */
  words: string;
  stats: Stats;
}

export interface SizingRequest {
  /** The floor with all robots, in the order in which they are added. */
  scene: Scene;
  /** Another floor for the same numbers of robots, to be compared. */
  beside?: Scene;
  /** Ascending numbers of robots: the first of the scene, so many of them. */
  counts: number[];
  /** Where it is not the scene's own. */
  objective?: Cost[];
  /** Only plans of at most this makespan. */
  within?: number;
  /** Of each solve by itself. */
  limits?: Limits;
}

/** The best plan of so many robots. */
export interface SizingPoint {
  robots: number;
  status: Status;
  costs: Costs | null;
  bounds: Partial<Record<Cost, number>>;
  complete: boolean;
  within: number | null;
  /** Why there is no plan or no proof. */
  reason?: string;
  /** The sum of costs if each robot arrived as early as alone. */
  alone: number | null;
  /** The robot that needs the most steps alone. */
  slowest: { agent: string; steps: number } | null;
  plan: Plan | null;
}

/** How many robots a floor bears. */
export interface SizingAnswer {
  giveway: 1;
  objective: Cost[];
  points: SizingPoint[];
  beside?: SizingPoint[];
  /** How many plans were not begun. */
  pending: number;
  /** All of it in sentences. */
  words: string;
  stats: Stats;
}

export interface DelaysRequest {
  scene: Scene;
  /** Without one, the scene is solved first. */
  plan?: Plan;
  /** What changed while the plan ran: robots are compared with their best ways from the last change on. */
  changes?: Changes;
  /** Later changes do not count. */
  at?: number;
  /** Where it is not the scene's own. */
  objective?: Cost[];
  /** The proof is only about plans of at most this makespan. */
  within?: number;
  /** Without the search for the proof. */
  ledger_only?: boolean;
  limits?: Limits;
}

/** An exact number of steps, in its lowest terms. */
export interface Fraction {
  numerator: number;
  denominator: number;
}

/** Whom, or what, a robot lets pass; `nobody`: this could be saved. */
export type DelayCause =
  | { because: "agent"; agent: string }
  | { because: "rule"; index: number; kind: Constraint["kind"]; name: string | null; text: string }
  | { because: "nobody" };

export interface CellLoss {
  cell: Cell;
  steps: number;
}

/** A robot's row of the ledger. */
export interface AgentDelay {
  agent: string;
  arrival: number;
  /** Its least arrival alone: its waypoints, battery and own rules kept. */
  alone: number;
  delay: number;
  /** Even parts, which add up to the delay. */
  because: (DelayCause & { steps: Fraction })[];
  /** Where it loses steps; they add up to the delay. */
  lost: CellLoss[];
}

/** A longest run of neighbouring cells of a row or a column at each of which a step is lost. */
export interface LossPlace {
  cells: Cell[];
  steps: number;
  agents: { agent: string; steps: number }[];
}

/** Who costs whom in a plan. */
export interface DelaysAnswer {
  giveway: 1;
  objective: Cost[];
  /** The time of the last change, where there was one. */
  since?: number;
  costs: Costs | null;
  /** The sum of costs if each robot arrived as early as alone. */
  alone: number;
  /** The sum of costs less that. */
  delay: number;
  /** Who loses most is the first. */
  agents: AgentDelay[];
  /** Who costs others how much; a fraction of too large numbers is `null`. */
  because: (DelayCause & { steps: Fraction | null })[];
  /** Steps lost at each cell, row by row. */
  lost: CellLoss[];
  /** The worst first. */
  places: LossPlace[];
  /** How many steps each plan loses that has no more of the costs in `given`. */
  proof: { given: Partial<Record<Cost, number>>; at_least: number; at_most: number; complete: boolean; within: number | null } | null;
  /** The plan that was found, where none was handed in. */
  plan?: Plan;
  /** The calm plan by which delays are split, where it is not the plan itself. */
  calm?: Plan;
  /** Why there is no ledger. */
  reason?: string;
  /** Whether the proof is still to come. */
  pending: boolean;
  /** All of it in sentences. */
  words: string;
  stats: Stats;
}

/** A planner of the textbook. */
export type Planner = "prioritised" | "cbs" | "pibt" | "lacam" | "lns";

export interface PlanRequest {
  scene: Scene;
  planner: Planner;
  /** Where it is not the scene's own. CBS makes its first cost least: makespan or sum-of-costs. */
  objective?: Cost[];
  /** Only plans of at most this makespan. */
  within?: number;
  /** The order of prioritised planning; who is not named comes last. By default it looks for one. */
  order?: string[];
  /** The tree of CBS by hand, instead of the planner's own. */
  by_hand?: {
    /** At most 200. `conflict` is which of the node's, by time, from 0; both branches name `agent`. */
    splits?: { node: number; conflict: number; agent: string }[];
    /** The node of which it is told what each split would give; the root by default. */
    node?: number;
  };
  /** Whether to tell how it went; a tree by hand is told in any case. */
  trace?: boolean;
  limits?: Limits;
}

/** What a planner came to. */
export interface PlanAnswer {
  giveway: 1;
  planner: Planner;
  objective: Cost[];
  ended: PlanEnd;
  costs: Costs | null;
  /** No plan has less of the first cost; only CBS proves it. */
  bounds: Partial<Record<Cost, number>>;
  plan: Plan | null;
  /** What a step is depends on the planner: an order, a node, a time step, a configuration, a neighbourhood. */
  stats: { cpu_seconds: number; steps: number };
  trace?: PlanTrace;
}

/** How a planner ended. None says that there is no plan, unless a robot has none even alone. */
export type PlanEnd =
  /** No plan has less of the first cost: of at most this makespan, or none at all. */
  | { how: "best"; within: number | null }
  | { how: "found" }
  | { how: "no-order-works"; tried: number; within: number; stuck: StuckAgent }
  | { how: "stopped"; reason: string }
  /** There is no plan of at most this makespan; there may be a longer one. */
  | { how: "horizon"; within: number }
  | { how: "refused"; lack: Lack }
  /** `rules`: those of the scene without which it could, each needed. */
  | { how: "alone"; agent: string; rules?: Constraint[] };

/** What a planner has no method for. */
export type Lack =
  | { what: "no-goal" | "batteries" | "waypoints" | "many-waypoints"; agent: string }
  | { what: "shared-goals"; agents: [string, string] }
  | { what: "cost"; cost: Cost }
  | { what: "slow-zones" | "questions" }
  | { what: "rules"; rules: Constraint[] };

export interface StuckAgent {
  agent: string;
  /** Whom it meets on the best way of its own. */
  around: string[];
}

/** How a planner went; the schema has the whole. */
export type PlanTrace = { giveway: 1 } & (
  | {
    planner: "prioritised";
    orders: {
      order: string[];
      planned: { agent: string; arrival: number; alone: number; around: string[]; path?: (Cell | null)[] }[];
      stuck: StuckAgent | null;
      /** How far the one that is stuck comes. */
      furthest?: (Cell | null)[];
      /** Whether no cell is left free for it there. */
      dead_end?: boolean;
    }[];
  }
  | { planner: "cbs"; nodes: TreeNode[]; left_out: number }
  | {
    planner: "cbs-by-hand";
    nodes: TreeNode[];
    /** `rule`: what the rule of the planner splits this node on. */
    splits: { node: number; agent: string; branches: [number, number]; rule: TreeSplit; is_rule: boolean }[];
    /** What can be split at the node that was asked about; null where that is not open. */
    choices: {
      node: number;
      /** Each with the branches that name its first robot, then those that name its second one. */
      conflicts: { conflict: TreeConflict; branches: [TreeBranches, TreeBranches] }[];
      left_out: number;
    } | null;
  }
  /** `leaders`: the robot of the highest priority in each step. */
  | { planner: "pibt"; inherited: Inherited[]; leaders?: string[] }
  | {
    planner: "lacam";
    events: {
      from: number;
      /** The robots that had to go somewhere, and where. */
      constrained?: string[];
      constraints: Cell[];
      inherited: Inherited[];
      made: number | null;
      known: boolean;
      /** Where the robots are in a configuration that is new. */
      cells?: Cell[];
    }[];
  }
  | { planner: "lns"; improvements: { changed: string[]; before: number[]; after: number[] }[] }
);

/** A node of the constraint tree of CBS. */
export interface TreeNode {
  id: number;
  parent: number | null;
  constraint: TreeConstraint | null;
  /** Null where a robot cannot keep its constraints. */
  cost: number | null;
  conflicts: number;
  /** The paths that its parent has not; all of the root. */
  paths?: Record<string, (Cell | null)[]>;
  fate: "open" | "dead" | "split" | "best";
  /** Which one it was to be taken out of the open list, from 0. */
  turn?: number;
  /** How often it took the paths of a child that cost no more. */
  bypassed?: number;
  conflict?: TreeConflict;
}

/** What a robot does or does not do in a node. */
export interface TreeConstraint {
  rule: "not-at" | "at" | "not-along" | "along" | "arrive-after" | "arrive-by";
  agent: string;
  cell?: Cell;
  edge?: [Cell, Cell];
  time: number;
}

/** A conflict of two robots in a node. */
export interface TreeConflict {
  kind: "vertex" | "swap" | "target";
  agents: [string, string];
  cell?: Cell;
  edge?: [Cell, Cell];
  time: number;
  /** How many of the two cannot avoid it without arriving later. */
  delays: 0 | 1 | 2;
}

/** Both branches of a split; a cost of null is a dead end. */
export type TreeBranches = [TreeBranch, TreeBranch];

export interface TreeBranch {
  constraint: TreeConstraint;
  cost: number | null;
  conflicts: number;
}

/** A split that is not made. */
export interface TreeSplit {
  conflict: TreeConflict;
  agent: string;
  branches: TreeBranches;
}

/** A robot lends its priority to another one, which stands where it wants to be. */
export interface Inherited {
  time?: number;
  from: string;
  to: string;
  cell: Cell;
}

export interface CompareRequest {
  scene: Scene;
  plans: [Plan, Plan];
}

/** Two plans of one scene. */
export interface Comparison {
  giveway: 1;
  costs: [Costs | null, Costs | null];
  /** How much more the second one has. */
  deltas: Partial<Record<Cost, number>>;
  agents: {
    agent: string;
    /** `retimed`: the same cells at other times; `rerouted`: other cells. */
    difference: "same" | "retimed" | "rerouted";
    arrivals: [number | null, number | null];
    /** Where they part: null in transit, or gone. */
    first: { time: number; cells: [Cell | null, Cell | null] } | null;
  }[];
}

/** A format of files. */
export type Format =
  | "giveway" | "movingai" | "tracker" | "paths.txt" | "result.txt"
  | "multi-robot" | "lorr" | "asprilo" | "mapfw" | "class-project" | "grid";

/** What the numbers and letters of a plan mean. */
export interface Conventions {
  cells: "row, column" | "column, row";
  origin: "0" | "1";
  /** What up does to the row, counted from the top. */
  up: "y - 1" | "y + 1";
}

export interface ReadOptions {
  /** Only the first agents of a scenario, where no plan says how many there are. */
  agents?: number;
  /** How plans are to be read, instead of what fits best. */
  conventions?: Conventions;
  /** What becomes of agents at their goals, instead of what the files say. */
  at_goal?: "stay" | "vanish";
  /** The level below which no battery may fall, instead of what the files say. */
  battery_floor?: number;
}

/** A scene, and the plans for it in the order of the files' names. */
export interface Files {
  scene: Scene;
  plans: ForeignPlan[];
  notes: string[];
}

/** A plan of elsewhere, read; it may break any rule. */
export interface ForeignPlan {
  file: string;
  format: Format;
  /** How it was read, where that is a matter of convention: what it is about, and how. */
  words: [string, string][];
  conventions: Conventions;
  why: string;
  /** The other ways to read it, and what does not fit then. */
  alternatives: { conventions: Conventions; misfit: string | null }[];
  fit: { agents: number; fitting: number; misfits: number; first: string | null };
  /** What its file says that it costs. */
  claimed: { makespan?: number; "sum-of-costs"?: number };
  /** What it would cost if every step of the file counted. */
  written: { makespan?: number; "sum-of-costs"?: number };
  /** Where agents that turn look at each time. */
  headings: Record<string, ("east" | "south" | "west" | "north")[]>;
  notes: string[];
  plan: Plan;
  /** What its file says that every plan costs at least (`loss` is of the plan itself). */
  bounds: { makespan?: number; "sum-of-costs"?: number; "sum-of-loss"?: number; loss?: number };
}

export interface ConvertRequest {
  /** Texts by file names, of any format; `.scen` with its `.map`. */
  files: Record<string, string>;
  /** A format of plans needs a plan with its scene among the files. */
  to: Format;
  /** Only the first so many agents. */
  agents?: number;
}

export interface ConvertAnswer {
  files: Record<string, string>;
  /** What the other format cannot say. */
  notes: string[];
}

/** A JSON Schema (draft 2020-12): `$defs` has one of each object. */
export interface Schema {
  $schema: string;
  $defs: Record<string, object>;
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

/** Finds and proves the best plan. */
export function solve(request: SolveRequest & { pareto?: false }, options?: Options): SolveAnswer;
/** All non-dominated costs of the objective's two or three, a plan each. */
export function solve(request: SolveRequest & { pareto: true }, options?: Options): FrontAnswer;

/** Judges a plan. */
export function check(request: CheckRequest): CheckAnswer;

/** Answers a question about a plan, or about there being none. */
export function explain(request: ExplainRequest, options?: Options): ExplainAnswer;

/** Goes on with a plan around which the world changes. */
export function change(request: ChangeRequest, options?: Options): ChangeAnswer;

/** Judges a plan, and tells how far it is from the best. */
export function audit(request: AuditRequest, options?: Options): AuditAnswer;

/** Tells what must be so in every best plan, and what is free to choose. */
export function freedom(request: FreedomRequest, options?: Options): FreedomAnswer;

/** Tells what each rule of the scene's own costs. */
export function price(request: PriceRequest, options?: Options): PriceAnswer;

/** Tells who costs whom in a plan: each delay, split by whom the robot lets pass. */
export function delays(request: DelaysRequest, options?: Options): DelaysAnswer;
/** Tells how many robots a floor bears. */
export function sizing(request: SizingRequest, options?: Options): SizingAnswer;

/** Tells in which order robots pass each cell, and who is pushed if some are late; writes way-points, DOT and VDA 5050. */
export function order(request: OrderRequest, options?: Options): OrderAnswer;

/** Finds a plan with a planner of the textbook. */
export function plan(request: PlanRequest, options?: Options): PlanAnswer;

/** Tells why some robots cannot all keep their limits: one step of a trace. */
export function together(request: TogetherRequest, options?: Options): TogetherAnswer;

/** Compares two plans of one scene. */
export function compare(request: CompareRequest): Comparison;

/** Proves again what was answered, and checks the proofs. */
export function certify(request: CertifyRequest, options?: Options): Report;

/** Makes certificates, checks them, and packs them into a zip archive, each in a folder of its name. */
export function exportCertificates(requests: Record<string, CertifyRequest>, options?: Options): Exported;

/** Checks the files of a certificate, as `giveway verify` does. */
export function verify(request: VerifyRequest, options?: Options): Report;

/** Writes instances and plans in another format. */
export function convert(request: ConvertRequest): ConvertAnswer;

/** The JSON Schema of all objects. */
export function schema(): Schema;

/** Reads files of any planner that belong together, told apart by what they hold: texts, or bytes in UTF-8, UTF-16 or Windows-1252. */
export function readFiles(files: Record<string, string | Uint8Array>, options?: ReadOptions): Files;

/** Reads a scene in the project's own JSON, and checks it. */
export function readScene(text: string): Scene;

/** Reads a plan in the project's own JSON, without judging it. */
export function readPlan(text: string): Plan;

/** The scene of a MovingAI `.map` and the first agents of a `.scen`. */
export function readMovingAi(map: string, scenario: string, options?: MovingAiOptions): Scene;
