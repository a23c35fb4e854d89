//! Who pays for the other plan: the costs of the objective, then the robots that differ.

use std::cmp::Reverse;

use giveway_model::sorting::sort_by_key;
use giveway_model::{Cost, Question, tr};

use super::CostRow;
use super::parts::WhoPays;
use super::verdict::is_coming;
use crate::timeline::Lane;
use crate::{Answer, Asking, Lit, words};

/// So many robots have a row at first.
const ROWS: usize = 5;

/// The table; nothing without the costs of both plans.
pub(super) fn pays(asking: &Asking, other: &Answer) -> Option<WhoPays> {
    let this = &asking.about;
    let (before, after) = (this.solved.costs?, other.solved.costs?);
    let objective = asking.objective();
    let asked = asked_about(asking.question());
    let asked = asked.filter(|cost| !objective.costs().contains(cost));
    let costs = objective.costs().iter().copied().chain(asked);
    let costs = costs.map(|cost| CostRow {
        title: words::title(cost).to_owned(),
        agent: None,
        this: before.get(cost),
        other: after.get(cost),
    });
    let mut robots = robots(asking, other);
    sort_by_key(&mut robots, order);
    let all = this.agents().len();
    let moved = robots.len();
    let told = asking.told.as_deref();
    let summary = if told.is_some_and(is_coming) && asking.chosen.is_none() {
        Some(tr!("a plan" => "the best found so far").to_owned())
    } else {
        summary(&robots, this)
    };
    let hidden = if asking.is_unfolded {
        0
    } else {
        moved.saturating_sub(ROWS)
    };
    robots.truncate(moved - hidden);
    Some(WhoPays {
        summary,
        costs: costs.collect(),
        robots,
        hidden: hidden as u32,
        rest: rest((all - moved.min(all)) as u32, moved),
        lit: match asking.lit {
            Some(Lit::Robot(agent)) => Some(agent),
            Some(Lit::Witness(_) | Lit::Fact(_) | Lit::Group(_) | Lit::Cell(_)) | None => None,
        },
    })
}

/// The cost that a question is about.
const fn asked_about(question: &Question) -> Option<Cost> {
    match question {
        Question::Makespan => Some(Cost::Makespan),
        Question::SumOfCosts | Question::Arrival { .. } => Some(Cost::SumOfCosts),
        Question::Charges { .. } => Some(Cost::Charges),
        Question::Moves { .. } | Question::Length { .. } => Some(Cost::Moves),
        Question::Waits { .. } => Some(Cost::Waits),
        Question::Penalty => Some(Cost::Penalty),
        Question::Wait { .. }
        | Question::Charge { .. }
        | Question::NoCharge { .. }
        | Question::Order { .. }
        | Question::Slow { .. }
        | Question::Visit { .. }
        | Question::NoVisit { .. }
        | Question::Move { .. }
        | Question::NoMove { .. }
        | Question::Yield { .. }
        | Question::Rule { .. }
        | Question::Unsolvable
        | Question::Plan => None,
    }
}

/// The robots that differ. Those that only drive differently have the same arrival twice.
fn robots(asking: &Asking, other: &Answer) -> Vec<CostRow> {
    let this = &asking.about;
    let moves_differently = |name: &str| asking.pays().iter().any(|it| it.agent == name);
    let mut rows = Vec::new();
    for (agent, who) in this.agents().iter().enumerate() {
        let arrival = |answer| Lane::of(answer, agent).map(|lane| lane.arrival);
        if let (Some(before), Some(after)) = (arrival(this), arrival(other))
            && (before != after || moves_differently(&who.name))
        {
            rows.push(CostRow {
                title: tr!("{name} arrives", name = who.name),
                agent: Some(agent),
                this: before,
                other: after,
            });
        }
    }
    rows
}

/// Who loses most is the first, who gains most the last; behind them those that arrive as before.
fn order(row: &CostRow) -> (bool, Reverse<i64>) {
    let more = i64::from(row.other) - i64::from(row.this);
    (more == 0, Reverse(more))
}

/// `A14 pays, 4 robots gain`.
fn summary(robots: &[CostRow], this: &Answer) -> Option<String> {
    let count = |is: fn(&CostRow) -> bool| robots.iter().filter(|row| is(row)).count() as u32;
    let lose = count(|row| row.other > row.this);
    let gain = count(|row| row.other < row.this);
    // Who loses most is the first.
    let first = robots.first().and_then(|row| this.agents().get(row.agent?));
    let pay = match (lose, first) {
        (0, _) => tr!("nobody pays").to_owned(),
        (1, Some(first)) => tr!("{name} pays", name = first.name),
        (n, _) => tr!("{n} robot pays" | "{n} robots pay" % n),
    };
    match (lose, gain) {
        (0, 0) => None,
        (_, 0) => Some(pay),
        (_, gain) => Some(tr!(
            "{pay}, {n} robot gains" | "{pay}, {n} robots gain" % gain,
            pay
        )),
    }
}

/// The robots without a row of their own, in words.
fn rest(others: u32, moved: usize) -> Option<String> {
    match (others, moved) {
        (0, _) => None,
        (_, 0) => Some(tr!("All robots arrive as before.").to_owned()),
        (n, _) => Some(tr!(
            "The other robot moves as before." | "The other {n} move as before." % n
        )),
    }
}
