//! Every phase of the search on scenes of three agents, against the oracle.
//!
//! By default most phases begin only with the long proofs of large scenes, which no
//! oracle can judge. Tiny thresholds lead small scenes through them, and the trace tells
//! that it did.
#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "a test that cannot go on ends with a panic"
)]

use giveway_model::{Cost, Instance, Objective, Plan};
use giveway_solve::trace::{FoundBy, SearchEvent};
use giveway_solve::{SolveAnswer, Thresholds};
use giveway_tests::compare::{self, Comparison};
use giveway_tests::{ask, random, traced};

/// Scenes that are compared at each pace.
const SCENES: usize = 60;
/// By so many steps a poor plan begins late.
const LATE: usize = 3;

/// Nothing is waited for, and no core is too small or too large for anything.
fn eager() -> Thresholds {
    Thresholds {
        polish_after: 0,
        polish_after_given: 0,
        polish_states: 0,
        polished_after: 0,
        upper_bound_after: 0,
        closed_gap: u32::MAX,
        exhausted_core: usize::MAX,
        stretched_core: usize::MAX,
        round_core: usize::MAX,
        small_core: 0,
        ..Thresholds::default()
    }
}

/// How often the traces told of a phase.
#[derive(Debug, Default)]
struct Seen {
    cores: usize,
    /// Cores over the violations of earlier ones.
    sums: usize,
    /// Cores over the violations of earlier ones of the same round: the agents of a core are
    /// looked at by themselves.
    exhausted_cores: usize,
    /// Cores in whose proof levels may have a part that only plans worse than the best one have.
    hardened: usize,
    rounds: usize,
    /// Gaps closed in one call though a further cost follows, which only the last phase does.
    closed: usize,
    /// Plans that local search found once the proof had begun.
    polished: usize,
    /// Plans made of a model that ends a round.
    upper_bounds: usize,
    exhausted: usize,
}

impl Seen {
    fn add(&mut self, answer: &SolveAnswer) {
        let trace = answer.trace.as_ref().unwrap();
        let last = trace.objective.costs().last();
        let (mut has_begun, mut round) = (false, 0);
        for event in &trace.events {
            match &event.event {
                SearchEvent::Core(core) => {
                    has_begun = true;
                    self.cores += 1;
                    self.sums += usize::from(!core.sums.is_empty());
                    let is_of_round = core.sums.iter().any(|sum| sum.event >= round);
                    self.exhausted_cores += usize::from(is_of_round);
                    self.hardened += usize::from(core.scope.at_most.is_some());
                }
                SearchEvent::Round { .. } => {
                    round = event.number;
                    self.rounds += 1;
                }
                SearchEvent::Closed { cost, .. } => self.closed += usize::from(Some(cost) != last),
                SearchEvent::Plan {
                    by: FoundBy::PartlySolver,
                    ..
                } => self.upper_bounds += 1,
                SearchEvent::Exhausted { .. } => self.exhausted += 1,
                SearchEvent::Plan {
                    by: FoundBy::Lns, ..
                } if has_begun => self.polished += 1,
                _ => {}
            }
        }
    }
}

/// Scenes of three agents, whose sum of costs comes first.
fn scenes() -> impl Iterator<Item = Instance> {
    let all = (0..).map(|number| random::small(3, number));
    all.filter(|instance| instance.agents().len() == 3)
        .map(|instance| {
            let costs = instance.objective().costs().iter().copied();
            let rest = costs.filter(|&cost| cost != Cost::SumOfCosts);
            let costs = std::iter::once(Cost::SumOfCosts).chain(rest).collect();
            instance.with_objective(Objective::new(costs).unwrap())
        })
}

/// A plan that is far from the best: its moves are few, and everybody begins late. (Where that
/// is against the rules, the search begins without a plan.)
fn poor(instance: &Instance) -> Option<Plan> {
    let moves = Objective::new(vec![Cost::Moves]).unwrap();
    let mut plan = ask::best(&instance.clone().with_objective(moves), None).plan?;
    for path in plan.paths.values_mut() {
        let first = path.first().copied()?;
        path.splice(0..0, [first; LATE]);
    }
    for time in plan.charges.values_mut().flatten() {
        *time += u32::try_from(LATE).unwrap();
    }
    Some(plan)
}

/// Compares the answers at a pace with the oracle; what the traces told.
fn check(pace: Thresholds) -> Seen {
    let mut seen = Seen::default();
    let mut faults = Vec::new();
    let mut compared = 0;
    for (number, instance) in scenes().enumerate() {
        if compared == SCENES {
            break;
        }
        let start = number.is_multiple_of(2).then(|| poor(&instance)).flatten();
        let comparison = compare::answered(&instance, None, || {
            let answer = ask::best_at_pace(&instance, None, pace, start);
            faults.extend(traced::replay(&answer));
            seen.add(&answer);
            answer
        });
        match comparison {
            Comparison::Agreed => compared += 1,
            Comparison::TooLarge => {}
            Comparison::Differ(found) => {
                compared += 1;
                println!("{}", serde_json::to_string(&instance.to_scene()).unwrap());
                faults.extend(found);
            }
        }
    }
    assert_eq!(faults, [""; 0], "the scenes are printed above");
    println!("{seen:?}");
    seen
}

/// The last phase at once, whatever the gap.
#[test]
fn the_gap_is_closed_at_once() {
    let seen = check(eager());
    assert!(seen.closed > 0, "{seen:?}");
}

/// No last phase: cores up to the optimum, and models between rounds, of which plans are
/// made.
#[test]
fn rounds_of_cores_with_models_between_them() {
    let seen = check(Thresholds {
        closed_gap: 0,
        exhausted_core: 0,
        stretched_core: 0,
        ..eager()
    });
    assert!(seen.cores > 20 && seen.rounds > 10, "{seen:?}");
    assert!(seen.polished > 0, "{seen:?}");
}

/// Plans are made of the models between rounds only.
#[test]
fn upper_bounds_by_models() {
    let seen = check(Thresholds {
        closed_gap: 0,
        exhausted_core: 0,
        stretched_core: 0,
        polish_after: u64::MAX,
        polish_after_given: u64::MAX,
        ..eager()
    });
    assert!(seen.upper_bounds > 0, "{seen:?}");
}

/// Cores of any size are exhausted and stretched.
#[test]
fn exhausted_cores() {
    let seen = check(Thresholds {
        closed_gap: 0,
        polish_after: u64::MAX,
        polish_after_given: u64::MAX,
        upper_bound_after: u64::MAX,
        ..eager()
    });
    assert!(seen.exhausted_cores > 2, "{seen:?}");
}

/// Each core ends its round, and none is made smaller; levels are excluded in between.
#[test]
fn a_round_for_each_core() {
    let seen = check(Thresholds {
        closed_gap: 0,
        round_core: 0,
        exhausted_core: 0,
        stretched_core: 0,
        small_core: usize::MAX,
        ..eager()
    });
    assert!(seen.rounds > 10 && seen.hardened > 0, "{seen:?}");
}

/// Joint states are exhausted as soon as a clause was written.
#[test]
fn joint_states_instead_of_patience() {
    let seen = check(Thresholds {
        patience: 0,
        patience_clauses: 0,
        few_joint_states: usize::MAX,
        ..Thresholds::default()
    });
    assert!(seen.exhausted > 5, "{seen:?}");
}
