//! The parts of the card of an answer.

use super::CostRow;
use super::coming::Coming;
use super::could::CouldRow;
use super::groups::GroupRow;
use super::missing::Missing;
use super::pieces::Piece;
use super::tight::Tight;
use crate::beside::DifferenceRow;

/// What is said, part by part, as far as it is known.
#[derive(Clone, Debug, PartialEq)]
pub struct Card {
    /// The question.
    pub question: String,
    /// Who does what it is about, where and when; nothing where that is not one thing.
    pub about: Option<String>,
    /// The verdict; nothing before it is there.
    pub verdict: Option<VerdictPart>,
    /// Costs and arrivals of both plans; nothing without an other plan.
    pub pays: Option<WhoPays>,
    /// What could be done instead, a row for each way that was looked at.
    pub could: Vec<CouldRow>,
    /// Whether the other plan can be shown and taken, and whether it is shown.
    pub other: Option<Other>,
    /// Where the two plans differ, while both are shown.
    pub differences: Vec<DifferenceRow>,
    /// How many more differences there are, in words.
    pub more_differences: Option<String>,
    /// What sets of robots alone need.
    pub tight: Option<Tight>,
    /// What would go wrong, under its headings.
    pub witness: Vec<(String, Vec<Happening>)>,
    /// What together makes it impossible.
    pub cores: Vec<Facts>,
    /// What would help.
    pub repairs: Vec<Offered>,
    /// Parts that were not found, though the search is over.
    pub missing: Vec<Missing>,
    /// How many more would help, in words.
    pub more_repairs: Option<String>,
    /// Whether it comes in layers: what stands keeps its place.
    pub holds_places: bool,
    /// How far it has come; nothing where all of it stands and is proved.
    pub coming: Option<Coming>,
    /// What the claim rests on, once the answer is whole.
    pub standing: Option<String>,
}

/// The verdict, as the card begins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VerdictPart {
    /// Its word, icon and class.
    pub badge: Badge,
    /// What it comes to: a sentence of few words.
    pub title: String,
    /// How far it is proved, in a few words.
    pub claim: Option<String>,
    /// One sentence that names who arrives later.
    pub sentence: String,
    /// The sentence cut at the robots and cells that it names; empty where nothing is pressed.
    pub pieces: Vec<Piece>,
}

/// Who pays for the other plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WhoPays {
    /// How many pay and gain, in a few words; nothing where all arrive as before.
    pub summary: Option<String>,
    /// The costs of the objective in order, then others that differ.
    pub costs: Vec<CostRow>,
    /// The robots that differ: who loses most is the first.
    pub robots: Vec<CostRow>,
    /// So many more differ that are folded away.
    pub hidden: u32,
    /// How many robots arrive as before, in words.
    pub rest: Option<String>,
    /// The robot that is lit up, by its index.
    pub lit: Option<usize>,
}

/// A verdict's word, icon and class.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Badge {
    /// The word.
    pub word: &'static str,
    /// The icon's name.
    pub icon: &'static str,
    /// The class in the style sheet.
    pub class: &'static str,
}

/// The other plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Other {
    /// Which of those that could be looked at; nothing where there is no choice.
    pub which: Option<String>,
    /// Whether the board shows it in the place of this one.
    pub is_shown: bool,
    /// Whether it is shown beside this one.
    pub is_beside: bool,
    /// Whether it costs less than this one.
    pub is_better: bool,
}

/// Something that would go wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Happening {
    /// Its place among all of them, by which it lights up.
    pub index: usize,
    /// Its number on the map, from 1; `None` where the facts have the numbers.
    pub number: Option<usize>,
    /// What.
    pub text: String,
    /// When.
    pub time: u32,
    /// Whether it is lit up.
    pub is_lit: bool,
}

/// A minimal set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Facts {
    /// The heading.
    pub title: &'static str,
    /// In how many groups, in words; nothing where there are few facts.
    pub summary: Option<String>,
    /// What is claimed of it.
    pub claim: String,
    /// Its groups, the deciding one first; none where there are few facts.
    pub groups: Vec<GroupRow>,
    /// The facts.
    pub facts: Vec<FactRow>,
}

/// A fact of a minimal set.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FactRow {
    /// Its number on the map, from 1; `None` where what would happen has the numbers.
    pub number: Option<usize>,
    /// The icon of its kind.
    pub icon: &'static str,
    /// What.
    pub text: String,
    /// That leaving it out alone helps, where its set does not say so of all its facts.
    pub mark: Option<&'static str>,
    /// Its place among the facts of all sets, by which it lights up.
    pub index: usize,
    /// When it began, for a breakdown.
    pub time: Option<u32>,
    /// The rule that it is, by its index in the scene, where that can be loosened there.
    pub loosens: Option<usize>,
    /// Whether it is lit up.
    pub is_lit: bool,
}

/// A repair.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Offered {
    /// The icon of its first edit.
    pub icon: &'static str,
    /// Whether something is given up altogether: a rule, a robot, a waypoint. Else it is loosened.
    pub gives_up: bool,
    /// What it does.
    pub text: String,
    /// What the plan would cost.
    pub costs: String,
    /// What it saves or costs more than this plan: `\u{2212}2`; nothing where there is no plan.
    pub difference: Option<(String, bool)>,
}
