//! A Pareto front as text.

use std::fmt::Write as _;

use giveway_model::words::{count, name};
use giveway_model::{Cost, Instance, Objective};
use giveway_solve::{FrontAnswer, SolveAnswer, Stats, Status, words};

use super::{drawings, solve::work, status_word, title};

/// The front: what is known of it, and a row of costs for each of its plans.
pub(crate) fn front(
    instance: &Instance,
    objective: &Objective,
    answer: &FrontAnswer,
    columns: usize,
) -> String {
    let mut parts = vec![title(instance), status(objective, answer)];
    if !answer.front.is_empty() {
        parts.push(points(objective, &answer.front));
    }
    parts.push(drawings(instance, None, columns));
    parts.push(work(&total(&answer.front)));
    parts.join("\n")
}

fn status(objective: &Objective, answer: &FrontAnswer) -> String {
    let names: Vec<&str> = objective.costs().iter().map(|&c| name(c)).collect();
    let plans = count(answer.front.len(), "plan");
    let within = answer.reach.within();
    let said = |is_whole| format!(": {}", words::front(&plans, is_whole, within, answer.ended));
    let (word, rest) = match (answer.status, within) {
        (Status::Optimal, _) => ("Pareto front", said(true)),
        (Status::Feasible, _) => ("Part of the Pareto front", said(false)),
        (Status::Impossible, None) => ("No plan exists", format!(", {}.", words::FOR_EVER.text())),
        (Status::Impossible, Some(n)) => ("No plan", format!(" within makespan {n}.")),
        (Status::Unknown, _) => (
            "The search ended early.",
            " There may be a plan; none was found yet.".to_owned(),
        ),
    };
    format!(
        "{}{rest}\nCosts: {}.\n",
        status_word(answer.status, word),
        names.join(", ")
    )
}

/// A row a point: the costs of the objective, then the others.
fn points(objective: &Objective, front: &[SolveAnswer]) -> String {
    let others = Cost::USUAL
        .iter()
        .filter(|cost| !objective.costs().contains(cost));
    let costs: Vec<Cost> = objective.costs().iter().chain(others).copied().collect();
    let mut text = "point".to_owned();
    for &cost in &costs {
        let _ = write!(text, "{:>14}", name(cost));
    }
    text.push('\n');
    for (i, point) in front.iter().enumerate() {
        let _ = write!(text, "{:>5}", i + 1);
        for &cost in &costs {
            let value = point
                .costs
                .map_or("-".to_owned(), |costs| costs.get(cost).to_string());
            let _ = write!(text, "{value:>14}");
        }
        text += match point.status {
            Status::Optimal => "\n",
            _ => "  not proved\n",
        };
    }
    text + "--format json shows the plan of each point.\n"
}

/// The work for all points together.
fn total(front: &[SolveAnswer]) -> Stats {
    front.iter().fold(Stats::default(), |sum, point| Stats {
        cpu_seconds: sum.cpu_seconds + point.stats.cpu_seconds,
        solver_calls: sum.solver_calls + point.stats.solver_calls,
        variables: sum.variables.max(point.stats.variables),
        clauses: sum.clauses.max(point.stats.clauses),
        conflicts: sum.conflicts + point.stats.conflicts,
        work: sum.work.max(point.stats.work),
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use expect_test::{Expect, expect};
    use giveway_model::{Costs, Version};

    use super::*;
    use crate::output::text::{reach_of, unpainted};

    /// A front of one point for each makespan and number of charges.
    fn check(status_of_all: Status, within: Option<u32>, costs: &[[u32; 2]], expect: &Expect) {
        let point = |&[makespan, charges]: &[u32; 2]| SolveAnswer {
            giveway: Version,
            status: Status::Optimal,
            costs: Some(Costs {
                makespan,
                charges,
                ..Costs::default()
            }),
            bounds: BTreeMap::new(),
            reach: reach_of(within),
            ended: None,
            reason: None,
            plan: None,
            stats: Stats::default(),
            trace: None,
        };
        let answer = FrontAnswer {
            giveway: Version,
            status: status_of_all,
            ended: None,
            reach: reach_of(within),
            front: costs.iter().map(point).collect(),
        };
        let objective = "makespan,charges".parse().unwrap();
        let text = status(&objective, &answer) + &points(&objective, &answer.front);
        expect.assert_eq(&unpainted(&text));
    }

    #[test]
    fn a_whole_front() {
        check(
            Status::Optimal,
            None,
            &[[18, 3], [20, 2]],
            &expect![[r#"
                Pareto front: 2 plans, and no other plan is better in one of the costs without being worse in another.
                Costs: makespan, charges.
                point      makespan       charges  sum of costs         moves         waits
                    1            18             3             0             0             0
                    2            20             2             0             0             0
                --format json shows the plan of each point.
            "#]],
        );
        check(
            Status::Optimal,
            Some(57),
            &[[18, 3]],
            &expect![[r#"
                Pareto front: 1 plan, and no other plan of makespan at most 57 is better in one of the costs without being worse in another.
                Costs: makespan, charges.
                point      makespan       charges  sum of costs         moves         waits
                    1            18             3             0             0             0
                --format json shows the plan of each point.
            "#]],
        );
    }

    #[test]
    fn a_part_of_a_front_says_so() {
        check(
            Status::Feasible,
            None,
            &[[18, 3]],
            &expect![[r#"
                Part of the Pareto front: 1 plan so far: the limits ended the search, there may be more.
                Costs: makespan, charges.
                point      makespan       charges  sum of costs         moves         waits
                    1            18             3             0             0             0
                --format json shows the plan of each point.
            "#]],
        );
        check(
            Status::Unknown,
            None,
            &[],
            &expect![[r#"
                The search ended early. There may be a plan; none was found yet.
                Costs: makespan, charges.
                point      makespan       charges  sum of costs         moves         waits
                --format json shows the plan of each point.
            "#]],
        );
    }
}
