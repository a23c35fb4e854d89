//! Why there is no plan, against the oracle: repairs that help do help, with the
//! costs that they are told with, and single edits that are not told do not.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::collections::BTreeSet;

use giveway_model::Instance;
use giveway_solve::explain::{Edit, edited_instance};
use giveway_tests::oracle::{self, Verdict};
use giveway_tests::{ask, random};

/// Instances without a plan to look at.
const COUNT: u32 = 40;
/// Labels that the oracle may make for one question.
const CAP: usize = 100_000;
/// The most repairs that an answer tells.
const MOST: usize = 12;

fn best(instance: &Instance) -> Verdict {
    let question = oracle::Question {
        instance,
        within: None,
        cap: CAP,
    };
    question.best()
}

/// Edits that take something away: one for each obstacle, waypoint and agent.
fn simple_edits(instance: &Instance) -> BTreeSet<Edit> {
    let cells = instance.grid().cells();
    let obstacles = cells.filter(|(_, ground)| !ground.is_vertex());
    let mut edits: BTreeSet<Edit> = obstacles
        .map(|(cell, _)| Edit::RemoveObstacle { cell })
        .collect();
    for agent in instance.agents() {
        let name = &agent.name;
        edits.insert(Edit::LeaveOut {
            agent: name.clone(),
        });
        edits.extend(agent.waypoints.iter().map(|&cell| Edit::DropWaypoint {
            agent: name.clone(),
            cell,
        }));
    }
    edits
}

#[test]
fn repairs_are_those_that_help() {
    let (mut helped, mut useless, mut looked_at) = (0, 0, 0);
    for number in 0.. {
        if looked_at >= COUNT {
            break;
        }
        let instance = random::small(11, number);
        let Some(answer) = ask::unsolvable(&instance) else {
            continue;
        };
        looked_at += 1;
        for repair in &answer.repairs {
            let after = edited_instance(&instance, &repair.edits);
            match best(&after) {
                Verdict::Best(point) => {
                    let objective = instance.objective();
                    let told = repair.costs.vector(objective);
                    assert_eq!(told, point.vector, "{number}: {}", repair.text);
                    helped += 1;
                }
                Verdict::Capped => {}
                Verdict::Impossible => panic!("{number}: {} does not help", repair.text),
            }
        }
        let singles = answer.repairs.iter().filter(|r| r.edits.len() == 1);
        let told: BTreeSet<&Edit> = singles.map(|repair| &repair.edits[0]).collect();
        if !answer.exhaustive || answer.repairs.len() >= MOST {
            continue;
        }
        for edit in simple_edits(&instance) {
            if told.contains(&edit) {
                continue;
            }
            let after = edited_instance(&instance, std::slice::from_ref(&edit));
            let verdict = best(&after);
            assert!(
                !matches!(verdict, Verdict::Best(_)),
                "{number}: {edit:?} would help, too"
            );
            useless += 1;
        }
    }
    assert!(
        helped > 30 && useless > 30,
        "{helped} helped, {useless} did not"
    );
}
