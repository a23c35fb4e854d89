//! How many events are kept, and what is said of single robots.

mod rules;

use giveway_model::{Cost, Objective};

use super::{
    AgentLeast, AgentLimit, Core, EarlierCore, Entrant, Literals, Recorder, Scope, SearchEvent,
    SearchTrace, Together, words,
};

fn recorder() -> Recorder {
    Recorder::new(vec!["A".to_owned()], Objective::default())
}

fn round() -> SearchEvent {
    SearchEvent::Round {
        cost: Cost::SumOfCosts,
    }
}

fn numbers(trace: &SearchTrace) -> Vec<u64> {
    trace.events.iter().map(|event| event.number).collect()
}

#[test]
fn the_first_and_the_last_are_kept() {
    let recorder = recorder().keeping(2, 3);
    let mut pushed = SearchTrace::new(Objective::default());
    for number in 0..20 {
        recorder.count_conflicts(10);
        assert_eq!(recorder.record(round()), number);
        let trace = recorder.trace();
        let kept: Vec<u64> = (0..=number)
            .filter(|&other| other < 2 || other + 3 > number)
            .collect();
        assert_eq!(numbers(&trace), kept);
        assert_eq!(trace.left_out, (number + 1).saturating_sub(5));
        assert_eq!(trace.events.last().unwrap().conflicts, 10 * (number + 1));
        // Whoever is told of one after the other comes to the same.
        pushed.push(trace.events.last().unwrap().clone());
    }
    assert_eq!(pushed.events.len(), 20);
}

#[test]
fn of_many_the_first_200_and_the_last_2000_are_kept() {
    let recorder = recorder();
    let mut pushed = SearchTrace::new(Objective::default());
    for number in 0..7_500 {
        recorder.record(round());
        for event in recorder.take_untold() {
            assert_eq!(event.number, number);
            pushed.push(event);
        }
    }
    let trace = recorder.trace();
    assert_eq!(
        numbers(&trace),
        (0..200).chain(5_500..7_500).collect::<Vec<u64>>()
    );
    assert_eq!(trace.left_out, 5_300);
    assert_eq!(pushed, trace);
}

fn core(cost: Cost, limits: &[(&str, u32, u32)]) -> Core {
    let limits = limits.iter().map(|&(agent, least, at_most)| AgentLimit {
        agent: agent.to_owned(),
        least,
        at_most,
    });
    Core {
        cost,
        limits: limits.collect(),
        sums: Vec::new(),
        together: None,
        scope: Scope::default(),
        from: 7,
        to: 8,
        literals: Literals {
            before: 1,
            after: 1,
        },
        took: 0,
    }
}

fn said(core: Core) -> String {
    words::sentence(&Objective::default(), &SearchEvent::Core(core))
}

#[test]
fn one_robot_is_held_up_by_others() {
    for (cost, limit, sentence) in [
        (
            Cost::SumOfCosts,
            (5, 5),
            "A cannot be on time: other robots are in its way.",
        ),
        (
            Cost::SumOfCosts,
            (5, 6),
            "A is at least 2 steps late: other robots are in its way.",
        ),
        (
            Cost::Makespan,
            (5, 7),
            "A cannot arrive by time 7: other robots are in its way.",
        ),
        (
            Cost::Waits,
            (0, 0),
            "A cannot do without waiting: other robots are in its way.",
        ),
        (
            Cost::Moves,
            (4, 4),
            "A needs more than 4 moves: other robots are in its way.",
        ),
    ] {
        assert_eq!(said(core(cost, &[("A", limit.0, limit.1)])), sentence);
    }
}

#[test]
fn who_joins_gets_in_the_way() {
    let entrant = |agent: &str, with: &[&str]| Entrant {
        agent: agent.to_owned(),
        with: with.iter().map(|&name| name.to_owned()).collect(),
    };
    for (agents, sentence) in [
        (
            vec![entrant("A", &["B"]), entrant("B", &["A"])],
            "A and B join the proof: they get in each other's way.",
        ),
        (
            vec![entrant("A", &["B"]), entrant("B", &["A", "C"])],
            "A and B join the proof: they get in others' way.",
        ),
        (
            vec![entrant("A", &["B", "C"])],
            "A joins the proof: it gets in the way of B and C.",
        ),
        (
            vec![entrant("A", &[])],
            "A joins the proof: its way around the others costs more than alone.",
        ),
    ] {
        let event = SearchEvent::Entered { agents };
        assert_eq!(words::sentence(&Objective::default(), &event), sentence);
    }
}

#[test]
fn among_some_plans_these_may_be_the_reason() {
    let mut core = core(Cost::Charges, &[("A", 1, 1)]);
    core.scope.given.insert(Cost::Makespan, 14);
    assert_eq!(said(core), "With makespan 14: A needs more than 1 charge.");
}

#[test]
fn what_robots_need_together_is_counted() {
    let earlier = EarlierCore {
        event: 3,
        at_most: 1,
    };
    for (more, sentence) in [
        (1, "A and B need at least 1 late step together."),
        (2, "A and B need 2 late steps together; 1 is not enough."),
        (3, "A and B need 3 late steps together; 2 are not enough."),
    ] {
        let agents = ["A", "B"].map(|agent| AgentLeast {
            agent: agent.to_owned(),
            least: 4,
        });
        let core = Core {
            sums: vec![earlier],
            together: Some(Together {
                agents: agents.into(),
                more,
            }),
            ..core(Cost::SumOfCosts, &[])
        };
        assert_eq!(said(core), sentence);
    }
}
