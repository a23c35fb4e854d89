//! When the search turns from one means to the next.

/// The pace of a search: from when on it uses which means, and how much of each.
///
/// The defaults were measured on scenes that take seconds. No threshold makes an answer
/// wrong, whatever its value: it may change how long a search takes, and which of several
/// best plans it finds. Tests set tiny ones, with which a scene of three agents goes
/// through what otherwise only large ones do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Thresholds {
    /// Clauses that the SAT solver derives before the best plan is improved for the first
    /// time: what is proved sooner needs no better plan.
    pub polish_after: u64,
    /// Clauses given to the SAT solver after which the best plan is improved in any case.
    pub polish_after_given: u64,
    /// States of single agents that an improvement expands at least, once it begins.
    pub polish_states: u64,
    /// Improvement ends after this many states without a better plan.
    pub polished_after: u64,
    /// Clauses derived before a plan is made of a model that ends a round.
    pub upper_bound_after: u64,
    /// The largest gap between bound and best plan that the last phase closes in one call.
    pub closed_gap: u32,
    /// The most literals of a core whose agents are exhausted by themselves.
    pub exhausted_core: usize,
    /// The most agents of a core that is tried at higher levels.
    pub stretched_core: usize,
    /// A core of more literals ends a round: the rest is rarely unsatisfiable without them, and a further
    /// call takes as long as the next round.
    pub round_core: usize,
    /// A core of at most so many literals is not minimised.
    pub small_core: usize,
    /// Conflicts after which few joint states are exhausted instead.
    pub patience: u64,
    /// Clauses after which few joint states are exhausted instead: with a far horizon, writing
    /// clauses takes longest.
    pub patience_clauses: u64,
    /// The least agents at a bottleneck for which it is counted what they need there.
    pub fewest_at_gate: usize,
    /// At most this many joint states count as few.
    pub few_joint_states: usize,
    /// With more agents a question is answered from what is at hand, a plan near by and the proof
    /// of the plan that is asked about, and its reason begins with a small set of agents.
    pub few_agents: usize,
}

impl Default for Thresholds {
    fn default() -> Self {
        Self {
            polish_after: 1_000,
            polish_after_given: 400_000,
            polish_states: 20_000,
            polished_after: 1_000_000,
            upper_bound_after: 300,
            closed_gap: 3,
            exhausted_core: 8,
            stretched_core: 2,
            round_core: 10,
            small_core: 4,
            patience: 4_000,
            patience_clauses: 300_000,
            fewest_at_gate: 4,
            few_joint_states: 200_000,
            few_agents: 8,
        }
    }
}
