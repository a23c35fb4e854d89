//! What the inspector tells of a plan of elsewhere, and what a report does.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_formats::{CellOrder, Conventions, ForeignPlan, Origin, Up};
use giveway_model::check::Violation;
use giveway_model::words::capital;
use giveway_model::{Cost, Costs, Plan, tr};

use super::gap::Known;
use super::rows::{CostRow, Fact, ViolationRow, costs, facts as file_facts, violation};
use super::verdict::{Verdict, verdict};
use super::{Audit, Beside};
use crate::State;
use crate::words::name;

/// The most violations that are told one by one.
const MOST: usize = 50;

/// What there is to tell of a plan of elsewhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Facts {
    /// What the whole is called.
    pub title: String,
    /// The file.
    pub file: String,
    /// `8 robots, times 0 to 14`.
    pub extent: String,
    /// All plans of the files, where there are several.
    pub plans: Vec<PlanRow>,
    /// The ways to read it.
    pub choices: Vec<Choice>,
    /// Whether it can be read again: its files are at hand.
    pub can_read_again: bool,
    /// How it was read, and what it says.
    pub facts: Vec<Fact>,
    /// The verdict.
    pub verdict: Verdict,
    /// What goes wrong.
    pub violations: Vec<ViolationRow>,
    /// How many more there are.
    pub more: usize,
    /// What it costs; only of a legal plan.
    pub costs: Vec<CostRow>,
    /// Of the first cost: how much of it is proved (0 to 100), and that in words.
    pub stands: Option<(u32, String)>,
    /// What else a person should know, each a sentence.
    pub notes: Vec<String>,
    /// What there is to look for: `Find a better plan`.
    pub find: Option<String>,
    /// How it is compared with another plan; nothing where there is none.
    pub compared: Option<Compared>,
    /// What takes the other plan: `Use the legal plan`, where it is shown.
    pub take: Option<String>,
}

/// How a plan is compared with another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compared {
    /// Not yet.
    Not,
    /// Both are side by side, or one after the other where there is no room.
    Beside,
    /// Only the other one is seen, as there is no room for both.
    Instead,
}

/// A plan of the files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanRow {
    /// Its file.
    pub file: String,
    /// Whether it is legal, and its first cost.
    pub detail: String,
    /// Whether it is the one that is looked at.
    pub is_chosen: bool,
}

/// A way to read the plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The conventions.
    pub conventions: Conventions,
    /// Those in words.
    pub words: String,
    /// What it would mean.
    pub meaning: String,
    /// Whether it is read so now.
    pub is_chosen: bool,
}

/// What a report tells: all that the inspector does, and what programs want.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Told {
    /// The scene's name.
    pub scene: String,
    /// What the inspector tells.
    pub facts: Facts,
    /// What the file tells.
    pub file: ForeignPlan,
    /// Every broken rule.
    pub violations: Vec<Violation>,
    /// What the plan costs, where every robot has a path.
    pub costs: Option<Costs>,
    /// What every plan costs at least.
    pub bounds: BTreeMap<Cost, u32>,
    /// Whether every cost is proved to be the least.
    pub is_best: bool,
    /// A better plan, where one was found.
    pub better: Option<Plan>,
}

/// What there is to tell; nothing unless a plan of elsewhere is on the board.
pub fn facts(state: &State) -> Option<Facts> {
    let run = state.work.solving();
    let known = Known::of(state.audit()?, run);
    facts_by(state, &known, run.is_some())
}

/// What there is to tell by what is known.
fn facts_by(state: &State, known: &Known, is_running: bool) -> Option<Facts> {
    let audit = state.audit()?;
    let (plan, file) = (&*audit.plan, &audit.plan.file);
    let time = state.view.playback.time;
    let shown = plan.violations.iter().take(MOST);
    let is_legal = plan.is_legal();
    let first = audit.objective().costs().first().copied();
    let compares = audit.beside != Beside::Nothing && audit.other().is_some();
    let steps = file.plan.paths.values().map(Vec::len).max().unwrap_or(1);
    Some(Facts {
        title: plan.title().to_owned(),
        file: file.file.clone(),
        extent: tr!(
            "{n} robot, times 0 to {last}"
                | "{n} robots, times 0 to {last}" % file.plan.paths.len(),
            last = steps.saturating_sub(1)
        ),
        plans: rows(audit),
        choices: choices(file),
        can_read_again: !audit.files.is_empty(),
        facts: file_facts(audit, known),
        verdict: verdict(audit, known, is_running),
        violations: shown
            .enumerate()
            .map(|(index, broken)| violation(plan, broken, index, broken.time == time))
            .collect(),
        more: plan.violations.len().saturating_sub(MOST),
        costs: if is_legal {
            costs(audit, known)
        } else {
            Vec::new()
        },
        stands: first
            .filter(|_| is_legal)
            .and_then(|cost| stands(audit, cost, known, is_running)),
        notes: audit.notes.iter().chain(&file.notes).cloned().collect(),
        find: find(audit, known),
        compared: audit.other().map(|_| match audit.beside {
            Beside::Nothing => Compared::Not,
            Beside::InPlace if !state.view.is_wide => Compared::Instead,
            Beside::Other | Beside::InPlace => Compared::Beside,
        }),
        take: take(audit).filter(|_| compares),
    })
}

/// All plans, where there are several.
fn rows(audit: &Audit) -> Vec<PlanRow> {
    let first = audit.objective().costs().first().copied();
    let row = |plan: &Rc<super::Dropped>| {
        let cost = first.zip(plan.answer.solved.costs);
        let cost = cost.map_or_else(String::new, |(cost, costs)| {
            format!(", {}", crate::words::value(cost, costs.get(cost)))
        });
        let legal = if plan.is_legal() {
            tr!("a plan" => "legal")
        } else {
            tr!("a plan" => "not legal")
        };
        PlanRow {
            file: plan.file.file.clone(),
            detail: format!("{legal}{cost}"),
            is_chosen: Rc::ptr_eq(plan, &audit.plan),
        }
    };
    let plans = audit.plans.iter().filter(|_| audit.plans.len() > 1);
    plans.map(row).collect()
}

/// The ways to read a file, the one that was taken first; none where there is
/// only one.
fn choices(file: &ForeignPlan) -> Vec<Choice> {
    if file.alternatives.is_empty() {
        return Vec::new();
    }
    let taken = Choice {
        conventions: file.conventions,
        words: conventions(file, file.conventions),
        meaning: match &file.fit.first {
            None => tr!("Everything fits.").to_owned(),
            Some(misfit) => format!("{}.", capital(misfit)),
        },
        is_chosen: true,
    };
    let others = file.alternatives.iter().map(|other| Choice {
        conventions: other.conventions,
        words: conventions(file, other.conventions),
        meaning: match &other.misfit {
            None => tr!("Everything fits, too.").to_owned(),
            Some(misfit) => format!("{}.", capital(misfit)),
        },
        is_chosen: false,
    });
    std::iter::once(taken).chain(others).collect()
}

/// Conventions in words: only what matters to the file.
fn conventions(file: &ForeignPlan, how: Conventions) -> String {
    let has = |about: &str| file.words.iter().any(|(own, _)| own == about);
    let mut words = Vec::new();
    if has("cells") {
        words.push(match how.cells {
            CellOrder::RowColumn => tr!("row first, then column"),
            CellOrder::ColumnRow => tr!("column first, then row"),
        });
        words.push(match how.origin {
            Origin::Zero => tr!("from 0"),
            Origin::One => tr!("from 1"),
        });
    }
    if has("up") {
        words.push(match how.up {
            Up::Lowers => tr!("up is the row above"),
            Up::Raises => tr!("up is the row below"),
        });
    }
    capital(&words.join(", "))
}

/// How much of the first cost is proved.
fn stands(audit: &Audit, cost: Cost, known: &Known, is_running: bool) -> Option<(u32, String)> {
    let value = audit.plan.answer.solved.costs?.get(cost);
    let &bound = known.bounds.get(&cost)?;
    let share = u64::from(bound.min(value)) * 100 / u64::from(value.max(1));
    let rest = value.saturating_sub(bound);
    let mut words = tr!("Proved up to {bound}. The gap is {rest}.", bound, rest);
    if rest == 0 {
        words = tr!("Proved: no plan has a smaller {cost}.", cost = name(cost));
    } else if is_running {
        words += tr!(" Still searching.");
    }
    let share = if value == 0 { 100 } else { share };
    Some((u32::try_from(share).unwrap_or(100), words))
}

/// What there is to look for; nothing where no plan can be better.
fn find(audit: &Audit, known: &Known) -> Option<String> {
    if !audit.plan.is_legal() {
        return (!known.is_impossible).then(|| tr!("Find a legal plan").to_owned());
    }
    let costs = audit.plan.answer.solved.costs?;
    let gap = super::gap::Gap::of(audit.objective(), &costs, known);
    (gap != super::gap::Gap::None).then(|| tr!("Find a better plan").to_owned())
}

/// What takes the other plan.
fn take(audit: &Audit) -> Option<String> {
    let other = audit.other()?;
    let is_ours = audit.better().is_some_and(|ours| Rc::ptr_eq(ours, other));
    is_ours.then(|| {
        let use_it = if audit.plan.is_legal() {
            tr!("Use the better plan")
        } else {
            tr!("Use the legal plan")
        };
        use_it.to_owned()
    })
}

/// What a report tells, by what is known and these bounds; nothing unless a plan of elsewhere is on the board.
pub(crate) fn told(state: &State, bounds: &BTreeMap<Cost, u32>) -> Option<Told> {
    let audit = state.audit()?;
    let mut known = Known::of(audit, None);
    known.raise(bounds);
    let costs = audit.plan.answer.solved.costs;
    let gap = costs.map(|costs| super::gap::Gap::of(audit.objective(), &costs, &known));
    Some(Told {
        scene: audit.plan.answer.draft.scene().name.clone(),
        facts: facts_by(state, &known, false)?,
        file: audit.plan.file.clone(),
        violations: audit.plan.violations.clone(),
        costs,
        bounds: known.bounds,
        is_best: audit.plan.is_legal() && gap == Some(super::gap::Gap::None),
        better: audit.better().and_then(|better| better.plan().cloned()),
    })
}
