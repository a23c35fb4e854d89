//! What a report and the terminal say of an audit beside the verdict.

use giveway_model::check::Violation;
use giveway_model::compare::{ClaimedBound, ClaimedCost, Difference, claimed_loss, compare};
use giveway_model::words::{capital, name};
use giveway_model::{Cost, Ground};

use giveway_solve::audit::words::{headline_under, notes};
use giveway_solve::words::Headline;

use super::{Audited, TOLD};

/// What was recognised: what it is about, and what it is.
pub(crate) fn recognised(audited: &Audited) -> Vec<(String, String)> {
    let (plan, instance) = (&audited.plan, &audited.instance);
    let row = |about: &str, what: String| (about.to_owned(), what);
    let format = plan.format;
    let format = format!("{}, as {} ({format})", format.looks(), format.makers());
    let mut rows = vec![row("file", plan.file.clone()), row("format", format)];
    let words = plan.words.iter();
    rows.extend(words.map(|(about, how)| row(about, how.clone())));
    if !plan.words.is_empty() {
        rows.push(row("why", plan.why.clone()));
    }
    let grid = instance.grid();
    let map = format!("{} x {} cells", grid.width(), grid.height());
    let map = match instance.name() {
        "" => map,
        name => format!("{name}, {map}"),
    };
    rows.push(row("map", map));
    rows.push(row("robots", instance.agents().len().to_string()));
    let notes = audited.notes.iter().chain(&plan.notes);
    rows.extend(notes.map(|note| row("note", note.clone())));
    rows
}

/// The verdict in one sentence.
pub(crate) fn verdict(audited: &Audited) -> Headline {
    headline_under(&audited.answer, audited.instance.assumptions())
}

/// What else is to be said of the verdict, a sentence each.
pub(crate) fn more_of(audited: &Audited) -> Vec<String> {
    let mut all = notes(&audited.answer);
    all.extend(audited.otherwise.clone());
    all.extend(differs(audited));
    all
}

/// A row of the table of costs: what it is, of the plan, of its file, what is proved,
/// of the better plan.
pub(crate) struct CostRow {
    pub(crate) cost: &'static str,
    pub(crate) cells: [Option<u64>; 4],
}

/// What a link to the page says.
pub(crate) const OPEN: &str = "Open it in Giveway";

/// Why there is none.
pub(crate) const NO_LINK: &str =
    "There is no link to the page: it does not take a plan of this size.";

/// The headings of the table of costs.
pub(crate) const COST_HEADINGS: [&str; 4] = [
    "this plan",
    "its file says",
    "proved at least",
    "better plan",
];

/// The table of costs, those of the objective first.
pub(crate) fn costs(audited: &Audited) -> Vec<CostRow> {
    let answer = &audited.answer;
    let first = answer.objective.costs();
    let others = Cost::USUAL.iter().filter(|cost| !first.contains(cost));
    let row = |&cost: &Cost| CostRow {
        cost: name(cost),
        cells: [
            answer.costs.map(|costs| costs.get(cost).into()),
            claim(audited, cost).map(|claim| claim.claimed),
            answer.bounds.get(&cost).copied().map(u64::from),
            answer.better_costs.map(|costs| costs.get(cost).into()),
        ],
    };
    first.iter().chain(others).map(row).collect()
}

fn claim(audited: &Audited, cost: Cost) -> Option<&ClaimedCost> {
    audited.claims.iter().find(|claim| claim.cost == cost)
}

/// Why the file says something else than is counted here, a sentence for each cost.
pub(crate) fn claims(audited: &Audited) -> Vec<String> {
    let differing = audited.claims.iter().filter(|claim| !claim.agrees());
    let say = |claim: &ClaimedCost| {
        let called = name(claim.cost);
        let counted = match claim.counted {
            Some(counted) => format!("it is {counted} here"),
            None => "it cannot be counted here".to_owned(),
        };
        let why = match claim.definition {
            Some(definition) => format!(" {}", definition.sentence()),
            None if audited.answer.legal => " It is not known why.".to_owned(),
            None => String::new(),
        };
        format!(
            "The file says that its {called} is {}; {counted}.{why}",
            claim.claimed
        )
    };
    let bounds = audited.claimed_bounds.iter().map(ClaimedBound::sentence);
    let loss = claimed_loss(&audited.instance, &audited.plan.plan, audited.plan.bounds);
    differing.map(say).chain(bounds).chain(loss).collect()
}

/// What is different in the better plan, as a sentence.
fn differs(audited: &Audited) -> Option<String> {
    let better = audited.answer.better.as_ref()?;
    let compared = compare(&audited.instance, &audited.plan.plan, better);
    let of = |difference| compared.with(difference).count();
    Some(format!(
        "Robots that go another way in the {} plan: {}; the same way at other times: {}; that do the same: {}.",
        if audited.answer.legal {
            "better"
        } else {
            "legal"
        },
        of(Difference::Rerouted),
        of(Difference::Retimed),
        of(Difference::Same)
    ))
}

/// A violation in a line: `vertex, time 3: A1 and A2 ...`.
pub(crate) fn violation(violation: &Violation) -> String {
    format!("{}: {}", violation.rule.name(), violation.message)
}

/// How many violations there are beyond those that are told.
pub(crate) fn more(violations: &[Violation]) -> Option<String> {
    let more = violations
        .len()
        .checked_sub(TOLD)
        .filter(|&more| more > 0)?;
    Some(format!("and {more} more; --format json shows them all"))
}

/// A word as a heading.
pub(crate) fn heading(word: &str) -> String {
    capital(word)
}

/// The headings of a report.
pub(crate) const RECOGNISED: &str = "Recognised as";
pub(crate) const VERDICT: &str = "Verdict";
pub(crate) const VIOLATIONS: &str = "Violations";
pub(crate) const COSTS: &str = "Costs";
pub(crate) const MAP: &str = "Map";
pub(crate) const AGAIN: &str = "To see it again";
/// What the marks of the map mean.
pub(crate) fn legend(audited: &Audited) -> String {
    let grid = audited.instance.grid();
    let has =
        |is: fn(Ground) -> bool| (0..grid.height()).any(|y| grid.row(y).iter().any(|g| is(*g)));
    let mut legend = "Circles: starts. Squares: goals.".to_owned();
    if has(Ground::is_charger) {
        legend += " Yellow with a bolt: chargers.";
    }
    if has(Ground::is_slow) {
        legend += " Hatched: the slow zone.";
    }
    if !audited.answer.violations.is_empty() {
        legend += " Red: where a rule is broken.";
    }
    legend
}
