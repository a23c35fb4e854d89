//! All non-dominated cost vectors of two or three costs.
//!
//! The lexicographic optimum under upper limits on all costs but the first is
//! never dominated: whatever were better in some cost and no worse in any would
//! keep the limits, too. So a box of limits is searched; the vector found splits
//! it into boxes that ask for less of one cost each, until every box is empty
//! (the rectangle splitting of Kirlik and Sayın, 2014, on integers).

use std::collections::BTreeMap;

use giveway_model::{Cost, Version};

use crate::{
    Ended, FrontAnswer, SolveAnswer, Status,
    problem::Problem,
    search::{Bounded, Proved},
    solve::{SolveTask, Solved, answer, best, without_search},
};

/// Upper limits, both included, by cost.
type CostLimits = BTreeMap<Cost, u32>;

/// The Pareto front of an objective's costs.
pub(crate) fn front(task: &SolveTask) -> FrontAnswer {
    let problem = match Problem::new(&task.instance, &task.budget) {
        Ok(problem) => problem,
        Err(error) => {
            let solved = without_search(task, &error);
            let SolveAnswer { status, ended, .. } = solved.answer;
            return whole((status, ended), solved.reach, Vec::new());
        }
    };
    let horizon = task.horizon(&problem);
    let costs = task.objective.costs();
    let mut points: BTreeMap<Vec<u32>, SolveAnswer> = BTreeMap::new();
    let mut empty: Vec<CostLimits> = Vec::new();
    let mut boxes = vec![CostLimits::new()];
    let mut reach: Option<Proved> = None;
    while let Some(limits) = boxes.pop() {
        if empty.iter().any(|other| contains(other, &limits)) {
            continue;
        }
        let bounded = Bounded { horizon, limits };
        let verdict = best(task, &problem, &bounded);
        let Solved {
            answer, reach: own, ..
        } = answer(task, &problem, verdict);
        // The claim of the front holds as far as the claim of every box.
        let both = reach.map_or(own, |reach| own.map(|own| reach.and(own)));
        match (answer.status, answer.costs) {
            (Status::Optimal, Some(found)) => {
                reach = both;
                for &cost in costs.iter().skip(1) {
                    if let Some(less) = found.get(cost).checked_sub(1) {
                        let mut limits = bounded.limits.clone();
                        limits.insert(cost, less);
                        boxes.push(limits);
                    }
                }
                points.insert(found.vector(&task.objective), answer);
            }
            (Status::Impossible, _) => {
                reach = both;
                empty.push(bounded.limits);
            }
            _ => {
                let status = if points.is_empty() {
                    Status::Unknown
                } else {
                    Status::Feasible
                };
                let end = (status, answer.ended);
                return whole(end, None, points.into_values().collect());
            }
        }
    }
    let status = if points.is_empty() {
        Status::Impossible
    } else {
        Status::Optimal
    };
    let end = (status, Some(Ended::Proof));
    whole(end, reach, points.into_values().collect())
}

/// Whether one box lies in another.
fn contains(outer: &CostLimits, inner: &CostLimits) -> bool {
    outer
        .iter()
        .all(|(cost, &most)| inner.get(cost).is_some_and(|&less| less <= most))
}

fn whole(
    (status, ended): (Status, Option<Ended>),
    reach: Option<Proved>,
    front: Vec<SolveAnswer>,
) -> FrontAnswer {
    FrontAnswer {
        giveway: Version,
        status,
        ended,
        reach: reach.into(),
        front,
    }
}
