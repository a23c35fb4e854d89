//! What follows from the plans of more and more robots, by their figures alone.

use giveway_model::Cost;

use super::{SizingAnswer, SizingPoint};
use crate::Status;

/// A fact that follows from the figures.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// From so many robots on the last one arrives later, proved on both sides.
    Later {
        /// From how many robots on.
        from: u32,
        /// When the last robot arrives then.
        at: u32,
        /// When it did with fewer.
        before: u32,
        /// The robot that needs as long alone.
        alone: Option<String>,
    },
    /// How late the robots are on average with the most of them.
    Delay {
        /// How many robots there are.
        robots: u32,
        /// Their mean delay, in steps.
        steps: f64,
        /// Up to how many robots all plans are proved; `None` where the first is not.
        proved_to: Option<u32>,
    },
    /// How many steps the other floor saves in all, at least and at most; negative where it
    /// loses them.
    Saves {
        /// The least and the most of all numbers of robots that are proved on both floors.
        steps: (i64, i64),
        /// The most robots that are proved on both floors.
        robots: u32,
        /// What it saves there.
        by: i64,
        /// The sum of costs on the floor there.
        of: u32,
    },
    /// By how much sooner the last robot arrives on the other floor; negative where it arrives
    /// later.
    Sooner {
        /// The most robots that are proved on both floors.
        robots: u32,
        /// When the last one arrives on the floor.
        at: u32,
        /// When it does on the other one.
        other: u32,
    },
    /// With so many robots there is no plan; proved.
    NoPlan {
        /// How many robots there are.
        robots: u32,
        /// The makespan up to which that is proved; `None` for every one.
        within: Option<u32>,
    },
    /// With so many robots no plan was found in time.
    NotSolved {
        /// How many robots there are.
        robots: u32,
    },
}

/// What follows from the figures, in the order in which it is told.
pub fn findings(answer: &SizingAnswer) -> Vec<Finding> {
    let later = last_jump(&answer.points);
    let parts = [later, sooner(answer), saves(answer), delay(answer)];
    let found = parts.into_iter().flatten();
    found.chain(without_plan(&answer.points)).collect()
}

/// The last number of robots from which on the makespan is larger, both sides proved.
fn last_jump(points: &[SizingPoint]) -> Option<Finding> {
    let proved: Vec<&SizingPoint> = points.iter().filter(|it| is_proved(it)).collect();
    let mut jumps = proved.windows(2).filter_map(|pair| {
        let [before, after] = [pair[0].costs?.makespan, pair[1].costs?.makespan];
        let alone = pair[1].slowest.as_ref().filter(|it| it.steps == after);
        (after > before).then(|| Finding::Later {
            from: pair[1].robots,
            at: after,
            before,
            alone: alone.map(|it| it.agent.clone()),
        })
    });
    jumps.next_back()
}

/// The mean delay of the largest number of robots that has a plan.
fn delay(answer: &SizingAnswer) -> Option<Finding> {
    let points = &answer.points;
    let last = points.iter().rev().find(|it| it.costs.is_some())?;
    let proved = points.iter().take_while(|it| is_proved(it));
    Some(Finding::Delay {
        robots: last.robots,
        steps: last.mean_delay(&answer.objective)?.0,
        proved_to: proved.last().map(|it| it.robots),
    })
}

/// When the last robot arrives on both floors, with the most robots that are proved on both.
fn sooner(answer: &SizingAnswer) -> Option<Finding> {
    let both = answer.points.iter().zip(&answer.beside);
    let mut both = both.filter(|(this, beside)| is_proved(this) && is_proved(beside));
    let (this, beside) = both.next_back()?;
    let (at, other) = (this.costs?.makespan, beside.costs?.makespan);
    (at != other).then_some(Finding::Sooner {
        robots: this.robots,
        at,
        other,
    })
}

/// What the other floor saves in the sum of costs, where both plans are proved.
fn saves(answer: &SizingAnswer) -> Option<Finding> {
    let both = answer.points.iter().zip(&answer.beside);
    let is_asked = answer.objective.costs().contains(&Cost::SumOfCosts);
    let both = both.filter(|(this, beside)| is_asked && is_proved(this) && is_proved(beside));
    let saved: Vec<(u32, i64, u32)> = both
        .filter_map(|(this, beside)| {
            let (this_sum, beside_sum) = (this.costs?.sum_of_costs, beside.costs?.sum_of_costs);
            let by = i64::from(this_sum) - i64::from(beside_sum);
            Some((this.robots, by, this_sum))
        })
        .collect();
    let least = saved.iter().map(|&(_, by, _)| by).min()?;
    let most = saved.iter().map(|&(_, by, _)| by).max()?;
    let &(robots, by, of) = saved.last()?;
    Some(Finding::Saves {
        steps: (least, most),
        robots,
        by,
        of,
    })
}

/// The first number of robots without a plan, and the first that was not solved.
fn without_plan(points: &[SizingPoint]) -> impl Iterator<Item = Finding> {
    let first = |status| points.iter().find(|it| it.status == status);
    let none = first(Status::Impossible).map(|it| Finding::NoPlan {
        robots: it.robots,
        within: it.reach.within(),
    });
    let open = first(Status::Unknown).map(|it| Finding::NotSolved { robots: it.robots });
    none.into_iter().chain(open)
}

fn is_proved(point: &SizingPoint) -> bool {
    point.status == Status::Optimal
}
