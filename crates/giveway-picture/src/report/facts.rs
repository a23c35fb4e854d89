//! What a report says of the scene, its costs and its changes.

use giveway_model::words::{duration, grouped, length};
use giveway_model::{Cost, Ground, tr};

use super::{ChangeRow, CostRow, Known, Subject};

/// The name of the scene.
pub(super) fn title(subject: &Subject<'_>) -> String {
    match subject.instance.name() {
        "" => tr!("Untitled").to_owned(),
        name => name.to_owned(),
    }
}

/// What the scene has; then what cells and steps are in the world.
pub(super) fn facts(subject: &Subject<'_>) -> Vec<String> {
    let grid = subject.grid();
    let (width, height) = (grid.width(), grid.height());
    let count = |is: fn(Ground) -> bool| grid.cells().filter(|&(_, ground)| is(ground)).count();
    let mut parts = vec![
        tr!("{width} \u{d7} {height} cells", width, height),
        tr!("{n} robot" | "{n} robots" % subject.robots.len()),
    ];
    let obstacles = count(|ground| ground == Ground::Obstacle);
    if obstacles > 0 {
        parts.push(tr!("{n} obstacle" | "{n} obstacles" % obstacles));
    }
    let chargers = count(Ground::is_charger);
    if chargers > 0 {
        parts.push(tr!("{n} charger" | "{n} chargers" % chargers));
    }
    let slow = count(Ground::is_slow);
    if slow > 0 {
        parts.push(tr!("{n} slow cell" | "{n} slow cells" % slow));
    }
    let mut facts = vec![parts.join(", ")];
    if let Some(units) = subject.units() {
        facts.push(tr!(
            "A cell is {cell} m, a step {step} s: the floor is {width} \u{d7} {height}",
            cell = units.cell,
            step = units.step,
            width = length(units, width),
            height = length(units, height)
        ));
    }
    facts
}

/// How cells and times are told, and what a slow zone does.
pub(super) fn conventions(subject: &Subject<'_>) -> Vec<String> {
    let mut told = vec![
        tr!(
            "A cell is written as its column, then its row, both counted from 0 at the top left; a time in steps from the start, which is 0."
        )
        .to_owned(),
    ];
    if subject.grid().cells().any(|(_, ground)| ground.is_slow()) {
        told.push(
            tr!("A move within a slow zone takes 2 steps, and counts as one move.").to_owned(),
        );
    }
    told
}

/// What the plan costs, in words.
pub(super) fn costs_told(subject: &Subject<'_>) -> String {
    let Some(costs) = subject.costs else {
        return tr!("Not every robot has a path.").to_owned();
    };
    let makespan = costs.makespan;
    let mut told = match duration(subject.units(), makespan) {
        Some(time) => tr!(
            "The last robot arrives at {makespan}, after {time}.",
            makespan,
            time
        ),
        None => tr!("The last robot arrives at {makespan}.", makespan),
    };
    let sum = grouped(costs.sum_of_costs.into());
    told.push(' ');
    told += &match costs.charges {
        0 => tr!("The arrivals add up to {sum} steps.", sum),
        charges => tr!(
            "The arrivals add up to {sum} steps, with {n} charge."
                | "The arrivals add up to {sum} steps, with {n} charges." % charges,
            sum
        ),
    };
    told
}

/// The costs, those of the objective first.
pub(super) fn costs(subject: &Subject<'_>, known: &Known) -> Vec<CostRow> {
    let Some(costs) = subject.costs else {
        return Vec::new();
    };
    let first = subject.instance.objective().costs();
    let others = Cost::USUAL.iter().filter(|cost| !first.contains(cost));
    let row = |&cost: &Cost| CostRow {
        cost,
        value: costs.get(cost),
        time: match cost {
            Cost::Makespan | Cost::SumOfCosts | Cost::Waits => {
                duration(subject.units(), costs.get(cost))
            }
            Cost::Charges | Cost::Moves | Cost::Penalty => None,
        },
        at_least: {
            let mut bounds = known.bounds.iter();
            bounds.find(|(of, _)| *of == cost).map(|&(_, least)| least)
        },
        before: known.before.map(|before| before.get(cost)),
    };
    first.iter().chain(others).map(row).collect()
}

/// What changed while the plan ran, by time.
pub(super) fn changes(subject: &Subject<'_>, known: &Known) -> Vec<ChangeRow> {
    let Some(changes) = subject.changes else {
        return Vec::new();
    };
    let by_time = changes.by_time().into_iter();
    let rows = by_time.flat_map(|(at, changes)| {
        let mut methods = known.methods.iter();
        let mut method = methods.find(|(of, _)| *of == at).map(|(_, it)| it.clone());
        let row = move |(_, change): (usize, &giveway_model::change::Change)| {
            let (what, detail) = change.what.sentence();
            ChangeRow {
                at,
                what: match detail {
                    Some(detail) => format!("{what}: {detail}"),
                    None => what,
                },
                method: method.take(),
            }
        };
        changes.into_iter().map(row).collect::<Vec<_>>()
    });
    rows.collect()
}
