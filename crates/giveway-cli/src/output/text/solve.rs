//! The answer of `solve` as text.

use std::fmt::Write as _;

use giveway_model::words::{count, name};
use giveway_model::{Assumption, Cost, Costs, Instance, Objective};
use giveway_solve::audit::words::percent;
use giveway_solve::words::{self, Headline};
use giveway_solve::{Ended, SolveAnswer, Stats, Status};

use super::{drawings, status_word, title};
use crate::output::plain;

/// The whole answer: what is known, the costs, the map, the plan, the work.
pub(crate) fn solve(
    instance: &Instance,
    objective: &Objective,
    answer: &SolveAnswer,
    columns: usize,
) -> String {
    let mut parts = vec![
        title(instance),
        status(objective, answer, instance.assumptions()),
    ];
    if let Some(costs) = &answer.costs {
        parts.push(cost_table(objective, costs, answer));
    }
    parts.push(drawings(instance, answer.plan.as_ref(), columns));
    parts.push(work(&answer.stats));
    parts.join("\n")
}

/// Said where the same command may print another plan.
const ANOTHER_RUN: &str =
    "Another run may end with another plan; --work-limit ends at the same place each time.\n";

/// What is known, with the reach of the claim.
fn status(objective: &Objective, answer: &SolveAnswer, assumptions: &[Assumption]) -> String {
    let Headline { word, rest } = words::headline(objective, answer);
    let word = status_word(answer.status, &plain::text(&word));
    let more = match answer.status {
        Status::Optimal => Some(words::claim_under(answer, assumptions)),
        _ => words::reach_of_bounds(answer),
    };
    let mut more = more.map_or_else(String::new, |more| more + "\n");
    if answer.status == Status::Feasible && words::may_differ(answer.ended) {
        more += ANOTHER_RUN;
    }
    format!("{word}{}\n{more}", plain::text(&rest))
}

/// All five costs, those of the objective first, each with its proved bound and,
/// where the search ended early, how far the cost may be above the best.
fn cost_table(objective: &Objective, costs: &Costs, answer: &SolveAnswer) -> String {
    let others = Cost::USUAL
        .iter()
        .filter(|cost| !objective.costs().contains(cost));
    // Under an assumption the plan may be none of the problem: then it has no gap.
    let early = answer.status == Status::Feasible && answer.ended != Some(Ended::Assumptions);
    let mut text = format!("{:<14}{:>8}{:>18}", "cost", "value", "proved at least");
    text += if early { "          gap\n" } else { "\n" };
    for &cost in objective.costs().iter().chain(others) {
        let (n, bound) = (costs.get(cost), answer.bounds.get(&cost));
        let said = |said: Option<String>| said.unwrap_or_else(|| "-".to_owned());
        let at_least = said(bound.map(u32::to_string));
        let name = plain::pad_right(name(cost), 14);
        let _ = write!(text, "{name}{n:>8}{at_least:>18}");
        if early {
            let _ = write!(
                text,
                "{:>13}",
                said(bound.and_then(|&bound| percent(n, bound, false)))
            );
        }
        text.push('\n');
    }
    text
}

/// How much work it took.
pub(super) fn work(stats: &Stats) -> String {
    format!(
        "{:.2} s CPU, {}, {}, {}, {}, work {}\n",
        stats.cpu_seconds,
        count(stats.solver_calls, "solver call"),
        count(stats.variables, "variable"),
        count(stats.clauses, "clause"),
        count(stats.conflicts, "conflict"),
        stats.work,
    )
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use expect_test::{Expect, expect};
    use giveway_model::Version;
    use giveway_solve::{Reason, Stop};

    use super::*;
    use crate::output::text::{reach_of, unpainted};

    fn answer(status: Status, within: Option<u32>, reason: Option<Reason>) -> SolveAnswer {
        SolveAnswer {
            giveway: Version,
            status,
            costs: matches!(status, Status::Optimal | Status::Feasible).then_some(Costs {
                makespan: 23,
                sum_of_costs: 35,
                charges: 3,
                moves: 30,
                waits: 1,
                ..Costs::default()
            }),
            bounds: BTreeMap::from([(Cost::Makespan, 22)]),
            reach: reach_of(within),
            ended: None,
            reason,
            plan: None,
            stats: Stats::default(),
            trace: None,
        }
    }

    fn check(answer: &SolveAnswer, expect: &Expect) {
        expect.assert_eq(&unpainted(&status(&Objective::default(), answer, &[])));
    }

    #[test]
    fn optimal_says_how_far_it_holds() {
        check(
            &answer(Status::Optimal, None, None),
            &expect![[r#"
                Optimal: makespan 23, sum of costs 35, 3 charges.
                No plan is better, no matter how many steps you allow.
            "#]],
        );
        check(
            &answer(Status::Optimal, Some(57), None),
            &expect![[r#"
                Optimal within makespan 57: makespan 23, sum of costs 35, 3 charges.
                No plan of makespan at most 57 is better; a longer one might be.
            "#]],
        );
    }

    #[test]
    fn feasible_says_what_is_proved() {
        let reason = Some(Reason::Stopped(Stop::Time));
        check(
            &answer(Status::Feasible, None, reason.clone()),
            &expect![[r#"
                Best so far: makespan 23, proved at least 22; sum of costs 35; 3 charges. The time limit was reached.
            "#]],
        );
        check(
            &answer(Status::Feasible, Some(57), reason),
            &expect![[r#"
                Best so far: makespan 23, proved at least 22; sum of costs 35; 3 charges. The time limit was reached.
                What is proved holds for plans of makespan at most 57.
            "#]],
        );
    }

    #[test]
    fn impossible_says_why() {
        let agents = vec!["A1".to_owned()];
        let reason = Some(Reason::Clash { agents });
        check(
            &answer(Status::Impossible, None, reason),
            &expect![[r#"
                No plan exists, no matter how many steps you allow: A1 cannot arrive.
            "#]],
        );
        check(
            &answer(Status::Impossible, Some(17), None),
            &expect![[r#"
                No plan within makespan 17.
            "#]],
        );
    }

    #[test]
    fn unknown_is_no_impossible() {
        let reason = Some(Reason::Stopped(Stop::Time));
        check(
            &answer(Status::Unknown, None, reason),
            &expect![[r#"
                The time limit was reached. There may be a plan; none was found yet. Proved so far: makespan is at least 22.
            "#]],
        );
    }

    #[test]
    fn every_cost_stands_beside_its_bound() {
        let answer = answer(Status::Feasible, None, None);
        let objective = "charges,makespan".parse().unwrap();
        expect![[r#"
            cost             value   proved at least          gap
            charges              3                 -            -
            makespan            23                22        4.6 %
            sum of costs        35                 -            -
            moves               30                 -            -
            waits                1                 -            -
        "#]]
        .assert_eq(&cost_table(&objective, &answer.costs.unwrap(), &answer));
    }
}
