//! Ways to choose from.

use giveway_model::words::or;
use giveway_model::{Cell, sorting, tr};
use giveway_solve::freedom::{FreedomAnswer, PlanCount, same_steps};

use super::{Freedom, MOST, Row};
use crate::freedom::words::how_many;
use crate::words::at;

/// The ways of robots.
#[derive(Clone, Debug, PartialEq)]
pub struct Ways {
    /// A line each.
    pub rows: Vec<Row>,
    /// How many plans they make.
    pub sum: String,
}

/// So many robots have a factor each in the product of their ways.
const FACTORS: usize = 4;

/// The most cells that are named where a robot may wait.
const WAITS: usize = 2;

pub(super) fn ways(freedom: &Freedom, told: &FreedomAnswer) -> Option<Ways> {
    let plans = told.plans.as_ref()?;
    let row = |(agent, name): (usize, &str)| {
        let ways = plans.ways.get(name)?;
        let n = ways.number.number();
        let is_fixed = ways.number == PlanCount::Exactly(1);
        let many = how_many(ways.number);
        Some(Row {
            agent,
            title: name.to_owned(),
            detail: if is_fixed {
                tr!("every step is fixed").to_owned()
            } else {
                fixed(told, name) + &waits(&ways.steps)
            },
            value: tr!("of a robot" => "{many} way" | "{many} ways" % n, many),
            is_fixed,
        })
    };
    Some(Ways {
        rows: freedom.names().filter_map(row).take(MOST).collect(),
        sum: sum(freedom, told)?,
    })
}

/// `2 of 5 steps are fixed`.
fn fixed(told: &FreedomAnswer, name: &str) -> String {
    let visits = told.backbone.as_ref().and_then(|all| all.get(name));
    match visits.map(|visits| same_steps(visits)) {
        None => String::new(),
        Some((0, _)) => tr!("no step is fixed").to_owned(),

        Some((same, all)) if same == all => {
            tr!("every step is fixed, but not when it charges").to_owned()
        }
        Some((same, all)) => tr!(
            "{n} of {all} steps is fixed" | "{n} of {all} steps are fixed" % same,
            all
        ),
    }
}

/// `, may wait at (6, 1) or at (5, 1)`.
fn waits(steps: &[giveway_solve::freedom::Step]) -> String {
    let cells = steps.iter().filter(|step| step.from == step.to);
    let mut cells: Vec<(u32, Cell)> = cells.map(|step| (step.time, step.from)).collect();
    sorting::sort(&mut cells);
    let mut named: Vec<String> = Vec::new();
    for (_, cell) in cells {
        // No line ends within a cell's numbers.
        let cell = tr!("at {cell}", cell = at(cell).replace(' ', "\u{a0}"));
        if !named.contains(&cell) {
            named.push(cell);
        }
    }
    if named.is_empty() || named.len() > WAITS {
        return String::new();
    }
    tr!(", may wait {places}", places = or(&named))
}

/// `3 × 1 × 5 = 15 best plans`.
fn sum(freedom: &Freedom, told: &FreedomAnswer) -> Option<String> {
    let plans = told.plans.as_ref()?;
    let number = plans.number;
    let all = tr!(
        "{many} best plan" | "{many} best plans" % number.number(),
        many = how_many(number)
    );
    let all = giveway_model::words::capital(&all);
    let is_exact = number.is_exact() && plans.ways.values().all(|ways| ways.number.is_exact());
    let factors = freedom.names().filter_map(|(_, name)| plans.ways.get(name));
    let mut factors: Vec<u32> = factors.map(|ways| ways.number.number()).collect();
    let product = factors
        .iter()
        .map(|&n| u64::from(n))
        .fold(1, u64::saturating_mul);
    if !is_exact || factors.len() < 2 {
        return Some(all);
    }
    if product != u64::from(number.number()) {
        return Some(tr!("{all}: not every choice goes with every other.", all));
    }
    if factors.len() > FACTORS {
        factors.retain(|&n| n > 1);
    }
    if factors.len() < 2 || factors.len() > 2 * FACTORS {
        return Some(all);
    }
    let factors: Vec<String> = factors.iter().map(u32::to_string).collect();
    Some(format!("{} = {all}", factors.join(" \u{d7} ")))
}
