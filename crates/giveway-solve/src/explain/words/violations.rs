//! The collisions of an agent as clauses after "it would".

use std::collections::BTreeSet;

use giveway_model::check::{Rule, Violation};
use giveway_model::words::and;
use giveway_model::{Instance, tr};

use super::facts::broken_down;
use crate::explain::Here;

/// The most that a sentence tells one by one.
const MOST: usize = 3;
/// The most robots that are named beside the one that would break a rule.
const MOST_OTHERS: usize = 3;

/// The violations in the order in which a sentence tells them. Where there are more than it tells
/// one by one, those with the robots that are let pass come first: who is named as let pass is
/// named as met, too.
pub(crate) fn passing_first<'a>(
    violations: Vec<&'a Violation>,
    here: Option<&Here>,
) -> Vec<&'a Violation> {
    let Some(here) = here.filter(|_| violations.len() > MOST) else {
        return violations;
    };
    let named: BTreeSet<&String> = here.let_pass().collect();
    let passes = |it: &&Violation| it.agents.iter().any(|name| named.contains(name));
    let (first, then): (Vec<_>, Vec<_>) = violations.into_iter().partition(passes);
    // Each of them once, before any of them again.
    let mut met: BTreeSet<&Vec<String>> = BTreeSet::new();
    let (once, again): (Vec<_>, Vec<_>) = first
        .into_iter()
        .partition(|&it: &&'a Violation| met.insert(&it.agents));
    [once, then, again].concat()
}

/// `meet A1 at (2, 1) at time 1 and have too little battery at time 9`. A meeting with
/// an agent that has broken down names the breakdown.
pub(crate) fn would(agent: &str, violations: &[&Violation], instance: Option<&Instance>) -> String {
    let mut phrases: Vec<String> = Vec::new();
    let mut seen = BTreeSet::new();
    for violation in violations {
        // Another agent is named at the first collision only.
        let collides = violation.agents.len() > 1;
        if !collides || seen.insert(&violation.agents) {
            phrases.push(phrase(agent, violation, instance));
        }
    }
    if phrases.len() > MOST {
        phrases.truncate(MOST);
        // As many as a list of all has beside these.
        let more = violations.len() - MOST;
        phrases.push(tr!("a robot would" => "run into {n} more problem" | "run into {n} more problems" % more));
    }
    and(&phrases)
}

fn phrase(agent: &str, violation: &Violation, instance: Option<&Instance>) -> String {
    let breakdowns = violation.agents.iter().flat_map(|name| {
        let own = instance.map_or(&[][..], |it| &it.start_state(name).breakdowns);
        own.iter().map(move |breakdown| (name, breakdown))
    });
    let of_now = breakdowns.filter(|(_, it)| (it.from..it.to).contains(&violation.time));
    let longest = of_now.max_by_key(|(_, breakdown)| breakdown.to);
    match longest {
        Some((name, breakdown)) if name != agent => {
            let meets = of_rule(agent, violation, instance);
            format!("{meets} ({})", broken_down(name, breakdown))
        }
        Some((_, breakdown)) if violation.rule == Rule::Move => {
            tr!("a robot would" => "have to move at time {time}, but it is broken down until time {to}",
                time = violation.time,
                to = breakdown.to
            )
        }
        _ => of_rule(agent, violation, instance),
    }
}

/// The rule of the scene's own that is broken.
fn named(violation: &Violation, instance: Option<&Instance>) -> Option<String> {
    let index = violation.broken.as_ref()?.index;
    let instance = instance?;
    let rule = instance.rule_as_written(index as usize)?;
    Some(rule.called_among(instance.agents()))
}

fn of_rule(agent: &str, violation: &Violation, instance: Option<&Instance>) -> String {
    let others = violation.agents.iter().filter(|name| *name != agent);
    let others: Vec<&String> = others.collect();
    let other = and(&others);
    let time = violation.time;
    let cell = violation
        .cell
        .map_or_else(String::new, |cell| tr!("a collision" => " at {cell}", cell));
    let edge = violation.edge.map_or_else(
        String::new,
        |[u, v]| tr!("a collision" => " between {u} and {v}", u, v),
    );
    match violation.rule {
        Rule::Vertex => {
            tr!("a robot would" => "meet {other}{cell} at time {time}", other, cell, time)
        }
        Rule::Swap => {
            tr!("a robot would" => "run into {other}{edge} at time {time}", other, edge, time)
        }
        Rule::SlowSwap => tr!("a robot would" => "meet {other} half way{edge} at time {time}",
            other,
            edge,
            time
        ),
        Rule::Battery => tr!("a robot would" => "have too little battery at time {time}", time),
        Rule::Waypoint => tr!("a robot would" => "miss its waypoint{cell}", cell),
        Rule::Obstacle => {
            tr!("a robot would" => "pass through the obstacle{cell} at time {time}", cell, time)
        }
        Rule::Goal => tr!("a robot would" => "not end at its goal").to_owned(),
        Rule::Charge => tr!("a robot would" => "charge at time {time}, where it cannot", time),
        Rule::Constraint => match named(violation, instance) {
            Some(rule) if (1..=MOST_OTHERS).contains(&others.len()) => {
                tr!("a robot would" => "break {rule} with {other} at time {time}", rule, other, time)
            }
            Some(rule) => tr!("a robot would" => "break {rule} at time {time}", rule, time),
            None => tr!("a robot would" => "break a rule of the scene at time {time}", time),
        },
        Rule::Shape | Rule::Start | Rule::Move => {
            tr!("a robot would" => "break a rule at time {time}", time)
        }
    }
}

#[cfg(test)]
mod tests {
    use giveway_model::Cell;

    use super::*;
    use crate::explain::Passing;

    fn meets(other: &str, time: u32) -> Violation {
        Violation {
            rule: Rule::Vertex,
            agents: vec!["A3".to_owned(), other.to_owned()],
            cell: Some(Cell::new(1, 1)),
            edge: None,
            time,
            message: String::new(),
            broken: None,
        }
    }

    /// Whoever a sentence says is let pass is among those that it says would be met.
    #[test]
    fn who_is_let_pass_is_named_as_met() {
        let violations: Vec<Violation> = [("A7", 1), ("A8", 2), ("A5", 3), ("A9", 4), ("A5", 5)]
            .map(|(other, time)| meets(other, time))
            .into();
        let passing = |name: &str| Passing {
            agent: name.to_owned(),
            cell: Cell::new(2, 1),
            time: 2,
        };
        let here = Here {
            agent: "A3".to_owned(),
            passing: vec![passing("A9"), passing("A6"), passing("A5")],
            violations: violations.clone(),
            words: String::new(),
        };
        let named: Vec<&String> = here.let_pass().collect();
        assert_eq!(named, ["A9", "A5"], "A6 would not be met");
        let told = |here| {
            would(
                "A3",
                &passing_first(violations.iter().collect(), here),
                None,
            )
        };
        assert_eq!(
            told(Some(&here)),
            "meet A5 at (1, 1) at time 3, meet A9 at (1, 1) at time 4, meet A7 at (1, 1) at time 1 \
             and run into 2 more problems"
        );
        assert!(!told(None).contains("A9"), "so it would be left out");
    }
}
