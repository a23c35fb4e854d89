//! What the column beside the board says of the step that is looked at.

use giveway_model::tr;
use giveway_model::words::capital;
use giveway_solve::plan::Planner;

use super::{InsideAction, Method, crowd, node, order, proof};
use crate::{State, words};

/// What it says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Column {
    /// Above the title.
    pub over: String,
    /// The title.
    pub title: String,
    /// What the step comes to.
    pub verdict: Option<Verdict>,
    /// Why it is so, in sentences.
    pub why: Vec<String>,
    /// What it means, in sentences.
    pub means: Option<String>,
    /// Lists of facts, each with its title.
    pub facts: Vec<(String, Vec<Fact>)>,
    /// What to go on to, with its title.
    pub choices: Option<(String, Vec<Choice>)>,
    /// The orders that were tried, with their title.
    pub orders: Option<(String, Vec<OrderRow>)>,
    /// What robots need, with its titles.
    pub table: Option<Listed>,
    /// What is proved beside it.
    pub note: Option<String>,
    /// Whether the record can be saved.
    pub can_export: bool,
    /// Which planner it is about, where the plan of the scene is another planner's.
    pub about: Option<String>,
    /// A remark.
    pub remark: Option<String>,
    /// What stays at its foot.
    pub foot: Vec<Button>,
}

impl Column {
    /// Whether there is something to press in it, but for what stays at its foot.
    pub const fn has_buttons(&self) -> bool {
        self.choices.is_some() || self.orders.is_some() || self.can_export
    }
}

/// The colours of a verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tint {
    /// It tells.
    Info,
    /// It tells of something aside.
    Told,
    /// Something is proved.
    Proved,
    /// Something works.
    Fine,
    /// Nothing goes on.
    Stuck,
}

impl Tint {
    /// Its class in the style sheet, and its icon.
    pub const fn look(self) -> (&'static str, &'static str) {
        match self {
            Self::Info => ("needless", "tree"),
            Self::Told => ("", "clock"),
            Self::Proved => ("checked", "proved"),
            Self::Fine => ("fine", "check"),
            Self::Stuck => ("broken", "cancel"),
        }
    }
}

/// What a step comes to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Verdict {
    /// Its colours.
    pub tint: Tint,
    /// In a word.
    pub word: String,
    /// Beside that.
    pub beside: String,
    /// In sentences.
    pub text: String,
}

/// A fact about a robot, or about all.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fact {
    /// Whom it is about, by its index.
    pub agent: Option<usize>,
    /// What.
    pub text: String,
    /// Why, in small.
    pub small: String,
}

/// Something to go on to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// Whom it is about, by its index.
    pub agent: Option<usize>,
    /// What.
    pub text: String,
    /// What comes of it, in small.
    pub small: String,
    /// What a press does.
    pub action: InsideAction,
}

/// A table with a row a robot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Listed {
    /// Its title.
    pub title: String,
    /// The titles of its columns, after that of the robots.
    pub columns: [&'static str; 2],
    /// Its rows: the robot's index and name, and what stands in the columns.
    pub rows: Vec<(Option<usize>, String, [String; 2])>,
}

/// An order that was tried.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OrderRow {
    /// The robots, by index and name.
    pub agents: Vec<(Option<usize>, String)>,
    /// What came of it.
    pub outcome: String,
    /// Whether somebody got stuck.
    pub is_stuck: bool,
    /// Whether it is the one that is shown.
    pub is_current: bool,
    /// Its place in the list.
    pub place: usize,
}

/// A button at the foot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Button {
    /// Its icon; none where it is empty.
    pub icon: &'static str,
    /// Its words.
    pub text: &'static str,
    /// What it does; `None` where it cannot now.
    pub action: Option<InsideAction>,
    /// Whether it is the dark one.
    pub is_primary: bool,
}

impl Button {
    pub(super) const fn new(
        icon: &'static str,
        text: &'static str,
        action: Option<InsideAction>,
        is_primary: bool,
    ) -> Self {
        Self {
            icon,
            text,
            action,
            is_primary,
        }
    }
}

/// What the column says; `None` where nothing is looked at, or nothing is known yet.
pub fn column(state: &State) -> Option<Column> {
    if !state.is_inside() || state.is_by_hand() {
        return None;
    }
    let mut column = match state.inside.method {
        Method::Proof => proof::column(state),
        Method::Tree => node::column(state),
        Method::Orders => order::column(state),
        Method::Pibt => crowd::pibt_column(state),
        Method::Lacam => crowd::lacam_column(state),
    }?;
    column.about = about(state);
    Some(column)
}

/// Which planner it is about, where the plan of the scene is another planner's.
fn about(state: &State) -> Option<String> {
    let answer = state.document.fresh_answer()?;
    let costs = answer.solved.costs?;
    let looked = state.inside.method.planner();
    if answer.by == looked || answer.is_shared {
        return None;
    }
    let plan = words::values(&answer.draft.scene().objective, &costs);
    let planner = |by: Option<Planner>| {
        by.map_or_else(
            || tr!("a planner" => "the search for the best plan"),
            Planner::title,
        )
    };
    let (own, looked) = (planner(answer.by), capital(planner(looked)));
    Some(tr!(
        "{looked} on this scene, not the plan by {own}: {plan}.",
        looked,
        own,
        plan
    ))
}
