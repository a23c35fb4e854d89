//! What a person does to rules and zones beside the board.

use giveway_model::condition::Times;
use giveway_model::{Cell, Constraint};

use super::Slot;

/// What is looked at: it is lit on the board, in the list and in the lanes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Lit {
    /// A rule, by its index in the scene.
    Rule(usize),
    /// A zone, by its name.
    Zone(String),
}

/// What a person does to rules and zones beside the board.
#[derive(Clone, Debug, PartialEq)]
pub enum RuleAction {
    /// Lights a rule or a zone, or nothing.
    Light(Option<Lit>),
    /// Lights a zone while its tab or its name is looked at, by its name; afterwards no longer.
    OverZone(String, bool),
    /// Shows the list of all rules.
    List,
    /// Shows a rule in the list, open.
    Show(usize),
    /// Shows the times of all rules in the timeline, or of the first lines.
    AllTimes(bool),
    /// Opens the row of a rule, or closes it again.
    Open(usize),
    /// Puts a rule in force, or out of it.
    Switch(usize),
    /// Removes a rule.
    Remove(usize),
    /// Begins a rule that fits what is selected.
    Begin,
    /// Begins a rule of a zone.
    OfZone(String),
    /// Shows and opens the rule of a zone whose tab is pressed; pressed again, its next one.
    OfTab(String),
    /// Begins to edit a rule.
    Edit(usize),
    /// Asks by how little a rule has to ask for less so that something changes; stops where
    /// that is being found out.
    Loosen(usize),
    /// Puts a looser rule in the place of the one that was asked about, by its place among
    /// those that were found.
    TakeLooser(usize),
    /// Begins a question: why a rule is not kept.
    Question,
    /// Asks why the rule that is being written is not kept.
    Ask,
    /// Asks what a rule would cost that is not in force.
    AskAbout(usize),
    /// Shows the best plan without a rule beside the plan, or nothing.
    Without(Option<usize>),
    /// Writes another rule in the place of the one that is being written.
    Write(Constraint),
    /// Opens a slot of the sentence, or closes it.
    OpenSlot(Option<Slot>),
    /// Fills a slot of the sentence.
    Fill(Value),
    /// Reads the rule from words.
    Read(String),
    /// Gives the zone of the rule that is being written another name.
    RenameZone(String),
    /// Removes the zone of the rule that is being written, with its rules.
    RemoveZone,
    /// Adds the rule that is being written, or puts it in the place of the one that is edited.
    Add,
    /// Leaves the rule that is being written.
    Cancel,
    /// Asks what the rules cost; stops where that is being found out.
    Price,
}

/// What a slot of the sentence is filled with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// A number, by its place in the kind.
    Number(usize, u32),
    /// The robots that it binds, by name; `None` for all.
    Who(Option<Vec<String>>),
    /// A zone, by its name.
    Zone(String),
    /// When it holds.
    When(Times),
    /// A cell, by its place in the kind.
    Cell(usize, Cell),
    /// A robot of its own, by its place in the kind and its name.
    Agent(usize, String),
}
