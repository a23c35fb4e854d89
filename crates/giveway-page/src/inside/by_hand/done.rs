//! What the column says once a plan is proved by hand: what it took, beside the planner.

use giveway_model::words::{capital, name};
use giveway_model::{Cost, tr};

use super::column::HandColumn;
use super::standing::counted;
use super::tally::Tally;
use super::{HandAction, HandRun, steps};
use crate::State;
use crate::inside::{Button, InsideAction, Tint, Verdict};

/// A row of the table: what is counted, for the person and for the planner.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TallyRow {
    /// What.
    pub name: String,
    /// How many a person took.
    pub own: String,
    /// How many the planner took; a dash while that is not known.
    pub planner: String,
}

pub(super) fn column(state: &State, run: &HandRun, cost: u32) -> HandColumn {
    let own = Tally::of(&run.tree.nodes, 0);
    let told = state.looked().and_then(|looked| looked.tree.as_ref());
    let tree = told.and_then(|told| told.as_ref().ok());
    let planner = tree.map(|tree| Tally::of(&tree.nodes, tree.left_out));
    let n = own.nodes;
    let title = match planner {
        Some(planner) => tr!(
            "You took {n} node, the planner {planner}"
                | "You took {n} nodes, the planner {planner}" % n,
            planner = planner.nodes
        ),
        None => tr!("You took {n} node" | "You took {n} nodes" % n),
    };
    let is_in_lesson = state.lesson().is_some();
    let mut foot = vec![super::column::take_back(run)];
    if state.can_show_planners_tree() {
        foot.push(Button::new(
            "",
            tr!("Planner's tree"),
            Some(InsideAction::Hand(HandAction::Show(false))),
            !is_in_lesson,
        ));
    }
    if is_in_lesson {
        foot.push(super::column::to_lesson(true));
    }
    HandColumn {
        title,
        verdict: Some(Verdict {
            tint: Tint::Proved,
            word: tr!("the status in a word" => "Proved").to_owned(),
            beside: counted(state, run, cost),
            text: why(run, own, cost),
        }),
        table: rows(state, own, planner),
        steps: steps::rows(run),
        steps_title: tr!("Split by split").to_owned(),
        remark: Some(match told {
            Some(Err(why)) => why.clone(),
            _ => tr!(
                "The planner does not look for a lucky plan. It opens the cheapest node, and takes a conflict that makes both branches dearer where there is one."
            )
            .to_owned(),
        }),
        foot,
        ..HandColumn::default()
    }
}

/// When the plan came, and what proved it: splits of branches that cost less.
fn why(run: &HandRun, own: Tally, cost: u32) -> String {
    let found = own.first_plan.unwrap_or(own.nodes).saturating_sub(1) / 2;
    let later = run.splits.iter().skip(found as usize);
    let later = later.filter_map(|made| run.tree.node(made.node)?.cost);
    let more = later.filter(|&split| split < cost).count();
    match (found, more) {
        (0, _) => {
            tr!("No two robots are in each other's way: each takes its shortest way.").to_owned()
        }
        (_, 0) => tr!(
            "Your last split gave a plan, and no open branch costs less than {cost}.",
            cost
        ),
        (1, more) => tr!(
            "Your first split gave a plan at once. {n} more split showed that no other branch is cheaper."
                | "Your first split gave a plan at once. {n} more splits showed that no other branch is cheaper."
                    % more
        ),
        (found, more) => tr!(
            "Split {found} gave the first plan. {n} more split showed that no other branch is cheaper."
                | "Split {found} gave the first plan. {n} more splits showed that no other branch is cheaper."
                    % more,
            found
        ),
    }
}

fn rows(state: &State, own: Tally, planner: Option<Tally>) -> Vec<TallyRow> {
    let row = |name: &str, of: fn(Tally) -> Option<u64>| {
        let told = |count: Option<u64>| count.map_or("\u{2013}".to_owned(), |n| n.to_string());
        TallyRow {
            name: name.to_owned(),
            own: told(of(own)),
            planner: told(planner.and_then(of)),
        }
    };
    let objective = &state.document.draft.scene().objective;
    let cost = objective.costs().first().copied().unwrap_or(Cost::Makespan);
    vec![
        row(tr!("of a tree" => "Nodes"), |tally| Some(tally.nodes)),
        row(tr!("of a tree" => "Splits"), |tally| Some(tally.splits)),
        row(tr!("Nodes to the first plan"), |tally| tally.first_plan),
        row(tr!("Dead ends"), |tally| Some(tally.dead_ends)),
        row(&capital(name(cost)), |tally| tally.cost.map(u64::from)),
    ]
}
