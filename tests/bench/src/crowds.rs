//! Crowds: how good a plan, and how high a bound, stands after so many seconds.

use std::error::Error;
use std::fmt::Write as _;

use giveway_model::{Cost, Objective};

use crate::rows::{Row, data};
use crate::run::Command;

/// The maps, the numbers of agents, the wall seconds up to the first look, and what
/// MAPF-LNS2 had after 10 s on a machine of this kind, where it had a plan.
const ROWS: [(&str, usize, u32, Option<u32>); 11] = [
    ("random-32-32-20", 100, 1, Some(2420)),
    ("random-32-32-20", 150, 1, Some(3844)),
    ("random-32-32-20", 250, 1, Some(7544)),
    ("maze-32-32-2", 50, 1, Some(3236)),
    ("maze-32-32-2", 100, 1, Some(7861)),
    ("room-32-32-4", 60, 1, Some(1754)),
    ("room-32-32-4", 120, 1, Some(3805)),
    ("warehouse-10-20-10-2-1", 300, 1, Some(25308)),
    ("warehouse-10-20-10-2-1", 600, 1, None),
    ("warehouse-10-20-10-2-1", 1000, 3, None),
    ("empty-32-32", 300, 1, Some(6929)),
];

/// The later looks, in wall seconds.
const LATER: [u32; 2] = [10, 60];

const HEAD: &str = "\
| map, agents | first look | plan, bound | 10 s: plan, bound | of MAPF-LNS2 | 60 s: plan, bound | peak MB |
| --- | ---: | ---: | ---: | ---: | ---: | ---: |
";

/// The table of all of them.
///
/// # Errors
/// Where the command cannot be run or does not answer as documented.
pub(crate) fn table(parts: &[String]) -> Result<String, Box<dyn Error>> {
    let mut text = HEAD.to_owned();
    for (map, agents, first, other) in ROWS {
        let name = format!("{map}, {agents}");
        if !parts.is_empty() && !parts.iter().any(|part| name.contains(part)) {
            continue;
        }
        let row = Row {
            file: data(&format!("movingai/{map}-random-1.scen")),
            name,
            agents: Some(agents),
            objective: Objective::new(vec![Cost::SumOfCosts])?,
            known: Vec::new(),
        };
        let mut cells = Vec::new();
        let mut peak = 0;
        for seconds in [first].into_iter().chain(LATER) {
            let command = Command::beside_this_program(seconds)?;
            let outcome = command.run(&row)?;
            eprintln!("{seconds} s: {}", outcome.line());
            peak = peak.max(outcome.peak_bytes);
            let plan = outcome.answer.costs.map(|costs| costs.sum_of_costs);
            let bound = outcome.answer.bounds.get(&Cost::SumOfCosts).copied();
            cells.push((plan, bound));
        }
        let shown = |(plan, bound): (Option<u32>, Option<u32>)| {
            let number = |n: Option<u32>| n.map_or_else(|| "-".to_owned(), |n| n.to_string());
            format!("{}, {}", number(plan), number(bound))
        };
        let [begin, middle, end] = cells.as_slice() else {
            continue;
        };
        let ratio = middle.0.zip(other).map_or_else(
            || "-".to_owned(),
            |(plan, other)| format!("{:.3}", f64::from(plan) / f64::from(other)),
        );
        let _ = writeln!(
            text,
            "| {} | {first} s | {} | {} | {ratio} | {} | {:.0} |",
            row.name,
            shown(*begin),
            shown(*middle),
            shown(*end),
            peak as f64 / 1e6
        );
    }
    Ok(text)
}
