//! The column of a search by hand: the conflicts of the node, the robot that the split names,
//! both branches, the splits so far.

use giveway_model::tr;
use giveway_solve::plan::{
    ConflictChoice, MOST_SPLITS, NodeFate, ToldBranch, ToldConflict, TreeNode, words,
};

use super::standing::{Standing, is_open, is_plan, of};
use super::steps::StepRow;
use super::{HandAction, HandRun, TallyRow, done, steps};
use crate::State;
use crate::inside::{Button, InsideAction, Verdict, index};

/// What it says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HandColumn {
    /// Whether a way leads back to the text of a lesson.
    pub is_in_lesson: bool,
    /// The title.
    pub title: String,
    /// What is to be done, in sentences.
    pub lead: String,
    /// What it came to.
    pub verdict: Option<Verdict>,
    /// What both took: the person and the planner.
    pub table: Vec<TallyRow>,
    /// The conflicts to choose from.
    pub conflicts: Vec<ConflictRow>,
    /// How many more there are.
    pub more: Option<String>,
    /// The two robots of the conflict.
    pub robots: Vec<RobotRow>,
    /// What the split gives.
    pub branches: Vec<Branch>,
    /// The title of the splits so far.
    pub steps_title: String,
    /// The splits so far.
    pub steps: Vec<StepRow>,
    /// A remark.
    pub remark: Option<String>,
    /// What stays at its foot.
    pub foot: Vec<Button>,
}

/// A conflict to choose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConflictRow {
    /// Its robots, by index and name.
    pub robots: [(Option<usize>, String); 2],
    /// How they meet, between both names: `and`, `swaps with`.
    pub verb: &'static str,
    /// Where and when.
    pub place: String,
    /// The whole in a sentence.
    pub name: String,
    /// Whether it is chosen.
    pub is_on: bool,
}

/// A robot to name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RobotRow {
    /// Its index.
    pub agent: Option<usize>,
    /// Its name.
    pub name: String,
    /// Whether it is chosen.
    pub is_on: bool,
}

/// A branch before it is made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Branch {
    /// Whom its constraint is about, by the index.
    pub agent: Option<usize>,
    /// Its constraint.
    pub text: String,
    /// How many conflicts are left.
    pub small: String,
    /// Its cost; a dash where it is a dead end.
    pub cost: String,
    /// Whether it is a dead end.
    pub is_dead: bool,
}

/// What the column says; `None` where nothing is known yet.
#[inline(never)]
pub fn column(state: &State) -> Option<HandColumn> {
    if !state.is_by_hand() {
        return None;
    }
    let told = state.looked()?.by_hand.as_ref()?;
    let mut column = match told {
        Ok(run) => match of(run) {
            Standing::Proved { cost } => done::column(state, run, cost),
            Standing::NotYet { .. }
            | Standing::Found { .. }
            | Standing::Assumed { .. }
            | Standing::Exhausted => on_the_way(state, run),
        },
        Err(why) => without(state, why),
    };
    column.is_in_lesson = state.lesson().is_some();
    Some(column)
}

/// Where there is no tree.
fn without(state: &State, why: &str) -> HandColumn {
    let has_splits = !state.inside.by_hand.splits.is_empty();
    let back = has_splits.then_some(InsideAction::Hand(HandAction::TakeBack));
    HandColumn {
        title: tr!("No conflict tree").to_owned(),
        remark: Some(why.to_owned()),
        foot: vec![
            Button::new("undo", tr!("Take back"), back, false),
            Button::new("", tr!("Try again"), Some(InsideAction::Again), true),
        ],
        ..HandColumn::default()
    }
}

fn on_the_way(state: &State, run: &HandRun) -> HandColumn {
    let hand = &state.inside.by_hand;
    let node = run.tree.node(run.asked.node);
    let choices = run
        .choices
        .as_ref()
        .filter(|choices| choices.node == run.asked.node);
    let chosen = choices.and_then(|choices| choices.conflicts.get(hand.conflict));
    let rows = choices.map_or(&[][..], |choices| choices.conflicts.as_slice());
    let rows = rows.iter().enumerate();
    let rows = rows.map(|(place, choice)| row(state, choice, place == hand.conflict));
    let more = choices.map_or(0, |choices| choices.left_out);
    let mut steps = steps::rows(run);
    steps.reverse();
    HandColumn {
        title: node.map_or_else(String::new, title),
        lead: match dearer(run, node) {
            Some(cost) => tr!(
                "A plan of {cost} is found: a split of this branch, which costs no less, proves nothing.",
                cost
            ),
            None => lead(node, chosen),
        },
        conflicts: rows.collect(),
        more: (more > 0).then(|| {
            tr!("{n} more conflict comes later." | "{n} more conflicts come later." % more)
        }),
        robots: chosen.map_or_else(Vec::new, |choice| robots(state, choice)),
        branches: chosen.map_or_else(Vec::new, |choice| branches(state, choice)),
        steps_title: tr!("Your splits so far, the last one first").to_owned(),
        steps,
        remark: (run.splits.len() >= MOST_SPLITS).then(|| {
            tr!("These are as many splits as can be made by hand. Take some back, or look at the planner's tree.").to_owned()
        }),
        foot: vec![take_back(run), onward(state, run, node)],
        ..HandColumn::default()
    }
}

fn title(node: &TreeNode) -> String {
    match (node.cost, &node.fate) {
        (None, _) => tr!("No way").to_owned(),
        (Some(cost), NodeFate::Split { .. }) => tr!("Cost {cost}, split already", cost),
        (Some(cost), _) if node.conflicts == 0 => tr!("Cost {cost}, and no conflict", cost),
        (Some(cost), _) => tr!("Cost {cost}. Which conflict?", cost),
    }
}

fn lead(node: Option<&TreeNode>, chosen: Option<&ConflictChoice>) -> String {
    let Some(node) = node else {
        return String::new();
    };
    if let Some(choice) = chosen {
        return match choice.conflict {
            ToldConflict::Vertex { .. } | ToldConflict::Target { .. } => tr!("Choose a conflict, and one of its robots. In one branch that robot is not there then. In the other one it is, and the others keep away."),
            ToldConflict::Swap { .. } => tr!("Choose a conflict, and one of its robots. In one branch that robot does not go there then. In the other one it does, and nobody comes against it."),
        }
        .to_owned();
    }
    match &node.fate {
        NodeFate::Dead => tr!("A robot has no way that keeps all of this. Press another branch in the tree."),
        NodeFate::Split { .. } => tr!("Press an open branch in the tree to go on."),
        NodeFate::Open | NodeFate::Best { .. } => tr!("This is a plan. While an open branch costs less, it may not be the best: press that branch in the tree."),
    }
    .to_owned()
}

/// The cost of a plan that is found already, where an open node costs no less.
fn dearer(run: &HandRun, node: Option<&TreeNode>) -> Option<u32> {
    let cost = node.filter(|node| is_open(node))?.cost?;
    let plans = run.tree.nodes.iter().filter(|node| is_plan(node));
    let plan = plans.filter_map(|node| node.cost).min()?;
    (plan <= cost).then_some(plan)
}

fn row(state: &State, choice: &ConflictChoice, is_on: bool) -> ConflictRow {
    let [a, b] = words::parties(&choice.conflict);
    let (first, verb, second, place) = match &choice.conflict {
        ToldConflict::Vertex { cell, time, .. } => (
            a,
            tr!("between two robots in one cell" => "and"),
            b,
            tr!("{cell} at {time}", cell, time),
        ),
        ToldConflict::Swap {
            edge: [from, to],
            time,
            ..
        } => (
            a,
            tr!("between two robots" => "swaps with"),
            b,
            tr!("{from}, {to} at {time}", from, to, time),
        ),
        ToldConflict::Target { cell, time, .. } => (
            b,
            tr!("between two robots" => "runs into"),
            a,
            tr!("{cell} at {time}", cell, time),
        ),
    };
    let robot = |name: &String| (index(state, name), name.clone());
    ConflictRow {
        robots: [robot(first), robot(second)],
        verb,
        place,
        name: words::conflict(&choice.conflict),
        is_on,
    }
}

/// The robots of the conflict, its first one first.
fn robots(state: &State, choice: &ConflictChoice) -> Vec<RobotRow> {
    let parties = words::parties(&choice.conflict).iter().enumerate();
    let row = |(place, name): (usize, &String)| RobotRow {
        agent: index(state, name),
        name: name.clone(),
        is_on: place == state.inside.by_hand.robot,
    };
    parties.map(row).collect()
}

fn branches(state: &State, choice: &ConflictChoice) -> Vec<Branch> {
    let own = choice.branches.get(state.inside.by_hand.robot);
    let branch = |told: &ToldBranch| Branch {
        agent: index(state, words::subject(&told.constraint)),
        text: words::constraint(&told.constraint),
        small: left(told.cost, told.conflicts),
        cost: told
            .cost
            .map_or("\u{2013}".to_owned(), |cost| cost.to_string()),
        is_dead: told.cost.is_none(),
    };
    own.into_iter().flatten().map(branch).collect()
}

/// `3 conflicts left`
pub(super) fn left(cost: Option<u32>, conflicts: u64) -> String {
    match (cost, conflicts) {
        (None, _) => tr!("no way: a dead end").to_owned(),
        (_, 0) => tr!("no conflict left").to_owned(),
        (_, n) => tr!("{n} conflict left" | "{n} conflicts left" % n),
    }
}

pub(super) fn take_back(run: &HandRun) -> Button {
    let back = InsideAction::Hand(HandAction::TakeBack);
    let is_possible = !run.asked.splits.is_empty();
    Button::new("undo", tr!("Take back"), is_possible.then_some(back), false)
}

pub(super) fn to_lesson(is_primary: bool) -> Button {
    let read = InsideAction::Hand(HandAction::Read(true));
    Button::new("", tr!("Back to the lesson"), Some(read), is_primary)
}

/// What goes on: the split; where nothing is to be split here, the way to an open branch.
fn onward(state: &State, run: &HandRun, node: Option<&TreeNode>) -> Button {
    if node.is_some_and(is_open) {
        let is_now = state.hand_now().is_some() && run.splits.len() < MOST_SPLITS;
        let can = is_now && run.choice(state.inside.by_hand.conflict).is_some();
        let split = InsideAction::Hand(HandAction::Split);
        return Button::new("", tr!("Split here"), can.then_some(split), true);
    }
    let open = run.tree.nodes.iter().filter(|node| is_open(node));
    let open = open.min_by_key(|node| node.cost);
    let go = open.map(|node| InsideAction::Node(node.id));
    Button::new("", tr!("To an open branch"), go, true)
}
