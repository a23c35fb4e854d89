//! Plans of more and more robots in words.

use giveway_model::tr;
use giveway_model::words::{capital, decimal, values};

use super::{Finding, SizingAnswer, SizingPoint, findings};
use crate::Status;

/// Each number of robots in a sentence, then what follows from the figures.
pub fn all(answer: &SizingAnswer) -> String {
    let points = answer.points.iter().map(|it| point(answer, it));
    let other = tr!("the other floor");
    let found = findings(answer);
    let found = found.iter().map(|it| finding(it, other));
    points.chain(found).collect::<Vec<_>>().join(" ")
}

/// The best plan of so many robots: `28 robots: makespan 99, sum of costs 1930 (proved).`
pub fn point(answer: &SizingAnswer, point: &SizingPoint) -> String {
    let robots = tr!("{n} robot" | "{n} robots" % point.robots);
    let costs = point
        .costs
        .map(|costs| values(answer.objective.costs(), &costs));
    match (point.status, costs) {
        (Status::Optimal, Some(costs)) => {
            tr!("{robots}: {costs}, proved best.", robots, costs)
        }
        (Status::Impossible, _) => match point.reach.within() {
            Some(within) => tr!(
                "{robots}: no plan up to makespan {within}, proved.",
                robots,
                within
            ),
            None => tr!("{robots}: no plan, proved.", robots),
        },
        (Status::Feasible | Status::Unknown, Some(costs)) => {
            tr!("{robots}: {costs}, best so far.", robots, costs)
        }
        (Status::Optimal | Status::Feasible | Status::Unknown, None) => {
            tr!("{robots}: not solved in time.", robots)
        }
    }
}

/// A fact in a sentence, and what is said of it in small print; `other` is the floor that is
/// compared: "one charger more".
pub fn finding_parts(finding: &Finding, other: &str) -> (String, String) {
    match finding {
        Finding::Later {
            from,
            at,
            before,
            alone,
        } => (
            tr!(
                "From {from} robots on the last one arrives at {at}",
                from,
                at
            ),
            match alone {
                Some(robot) => tr!(
                    "before that at {before}: {robot} alone needs {at}",
                    before,
                    robot,
                    at
                ),
                None => tr!("before that at {before}", before),
            },
        ),
        Finding::Delay {
            robots,
            steps,
            proved_to,
        } => (
            tr!(
                "{robots} robots are late by {steps} steps on average",
                robots,
                steps = decimal(*steps, 1)
            ),
            match proved_to {
                Some(to) if to == robots => tr!("proved, as all up to there are").to_owned(),
                Some(to) => tr!("best so far; proved up to {to} robots", to),
                None => tr!("best so far").to_owned(),
            },
        ),
        Finding::Saves {
            steps,
            robots,
            by,
            of,
        } => (
            saved(*steps, other),
            tr!("{by} of {of} with {robots} robots", by, of, robots),
        ),
        Finding::Sooner {
            robots,
            at,
            other: there,
        } => {
            let floor = capital(other);
            let steps = at.abs_diff(*there);
            (
                if there < at {
                    tr!(
                        "{floor}: the last one arrives {n} step sooner"
                            | "{floor}: the last one arrives {n} steps sooner" % steps,
                        floor
                    )
                } else {
                    tr!(
                        "{floor}: the last one arrives {n} step later"
                            | "{floor}: the last one arrives {n} steps later" % steps,
                        floor
                    )
                },
                tr!(
                    "{there} instead of {at} with {robots} robots",
                    there,
                    at,
                    robots
                ),
            )
        }
        Finding::NoPlan { robots, within } => (
            tr!("{robots} robots have no plan here", robots),
            match within {
                Some(within) => tr!("proved up to makespan {within}", within),
                None => tr!("a plan is" => "proved").to_owned(),
            },
        ),
        Finding::NotSolved { robots } => (
            tr!("{robots} robots were not solved in time", robots),
            tr!("there may be a plan").to_owned(),
        ),
    }
}

fn saved((least, most): (i64, i64), other: &str) -> String {
    let other = capital(other);
    match (least, most) {
        (0, 0) => tr!("{other} changes nothing in the sum", other),
        (least, most) if most <= 0 => tr!(
            "{other} costs {least} to {most} steps in all",
            other,
            least = -most,
            most = -least
        ),
        (least, most) if least == most => {
            tr!("{other} saves {most} steps in all", other, most)
        }
        (least, most) => tr!(
            "{other} saves {least} to {most} steps in all",
            other,
            least,
            most
        ),
    }
}

/// A fact as one sentence.
pub fn finding(finding: &Finding, other: &str) -> String {
    let (fact, small) = finding_parts(finding, other);
    tr!("a fact, then what is said of it" => "{fact} ({small}).", fact, small)
}
