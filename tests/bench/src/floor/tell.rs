//! The tables of questions on floors.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use giveway_solve::explain::MOST_GROUPS;

use super::{Asked, Floor, HERE, NEAR, REASON, WHOLE};

const HEAD: &str = "\
| floor | robots | plan, CPU s | here, most | near, most | verdict, median | in 3 s | known | \
reason, median | reasons | robots | cells | groups, most |
| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
";

const BY_ROBOTS: &str = "\
| robots | floors | proved best in 60 s | questions | here in time | near in time | \
verdict in 3 s | known | reasons | in 3 s more |
| ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
";

/// What all answers come to, then a row for each number of robots and one for each floor.
pub(super) fn tables(floors: &[Floor], seconds: f64) -> String {
    let all: Vec<&Asked> = floors.iter().flat_map(|floor| &floor.asked).collect();
    let of_best = floors.iter().filter(|floor| floor.is_best);
    let of_best: Vec<&Asked> = of_best.flat_map(|floor| &floor.asked).collect();
    let sizes = floors.iter().flat_map(sizes);
    let (robots, cells): (Vec<f64>, Vec<f64>) = sizes.unzip();
    let mut text = format!(
        "{} questions. In time: here {} (in {HERE} s), near {} (in {NEAR} s); the verdict (in \
         {WHOLE} s) {}, of the {} about plans that are proved best {}. A verdict is there within \
         {seconds} s for {}; ",
        all.len(),
        count(&all, |it| it.here <= HERE),
        count(&all, |it| it.near <= NEAR),
        count(&all, is_soon),
        of_best.len(),
        count(&of_best, is_soon),
        count(&all, Asked::is_known),
    );
    let minimal = |it: &Asked| it.answer.core.as_ref().is_some_and(|core| core.minimal);
    let _ = write!(
        text,
        "of {} that cost more or cannot be, {} have a reason, {} of them {REASON} s after the \
         closest plan or sooner, {} shown minimal. A reason has {:.0} robots and {:.0} % of the \
         cells in the median, and {} of {MOST_GROUPS} groups at most.\n\n",
        count(&all, Asked::is_refuted),
        count(&all, has_reason),
        count(&all, |it| has_reason(it) && it.reason <= REASON),
        count(&all, minimal),
        median(robots),
        median(cells),
        all.iter().map(|it| it.groups()).max().unwrap_or(0),
    );
    text.push_str(BY_ROBOTS);
    let mut by_robots: BTreeMap<usize, Vec<&Floor>> = BTreeMap::new();
    for floor in floors {
        let robots = floor.instance.agents().len();
        by_robots.entry(robots).or_default().push(floor);
    }
    for (robots, floors) in by_robots {
        let all: Vec<&Asked> = floors.iter().flat_map(|floor| &floor.asked).collect();
        let best = floors.iter().filter(|floor| floor.is_best).count();
        let _ = writeln!(
            text,
            "| {robots} | {} | {best} | {} | {} | {} | {} | {} | {} | {} |",
            floors.len(),
            all.len(),
            count(&all, |it| it.here <= HERE),
            count(&all, |it| it.near <= NEAR),
            count(&all, is_soon),
            count(&all, Asked::is_known),
            count(&all, has_reason),
            count(&all, |it| has_reason(it) && it.reason <= REASON),
        );
    }
    text.push('\n');
    text.push_str(HEAD);
    for floor in floors {
        push_row(&mut text, floor);
    }
    text
}

fn push_row(text: &mut String, floor: &Floor) {
    let all: Vec<&Asked> = floor.asked.iter().collect();
    let times = |time: fn(&Asked) -> f64| all.iter().map(|it| time(it)).collect::<Vec<f64>>();
    let (robots, cells): (Vec<f64>, Vec<f64>) = sizes(floor).unzip();
    let with_reason = all.iter().filter(|it| has_reason(it));
    let _ = writeln!(
        text,
        "| {} | {} | {:.1}{} | {:.2} | {:.2} | {:.2} | {} | {} | {:.2} | {} | {:.0} | {:.0} % | {} |",
        floor.name,
        floor.instance.agents().len(),
        floor.seconds,
        if floor.is_best { "" } else { ", not proved" },
        most(&times(|it| it.here)),
        most(&times(|it| it.near)),
        median(times(|it| it.verdict)),
        count(&all, is_soon),
        count(&all, Asked::is_known),
        median(with_reason.map(|it| it.reason).collect()),
        count(&all, has_reason),
        median(robots),
        median(cells),
        all.iter().map(|it| it.groups()).max().unwrap_or(0),
    );
}

fn sizes(floor: &Floor) -> impl Iterator<Item = (f64, f64)> {
    let asked = floor.asked.iter();
    asked.filter_map(|it| it.size(&floor.instance))
}

fn count(asked: &[&Asked], is_so: impl Fn(&Asked) -> bool) -> usize {
    asked.iter().filter(|it| is_so(it)).count()
}

fn is_soon(asked: &Asked) -> bool {
    asked.is_known() && asked.verdict <= WHOLE
}

const fn has_reason(asked: &Asked) -> bool {
    asked.answer.core.is_some()
}

fn most(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
