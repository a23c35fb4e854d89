//! The rules of the problem and of the scene, as the inspector lists them.

use giveway_model::constraint::TimedConstraint;
use giveway_model::{AtGoal, Ground, Scene, tr};

use super::loosening::can_loosen;
use super::price::tag;
use super::{Lit, LooserPart, Piece, Tag, icon, pieces};
use crate::State;

/// The rules of the scene on the board.
#[derive(Clone, Debug, PartialEq)]
pub struct List {
    /// How many are in force, and how many off: `5 in force, 1 off`.
    pub count: String,
    /// The rules of the problem.
    pub problem: Vec<ProblemRule>,
    /// The rules of the scene's own.
    pub rows: Vec<Row>,
    /// The rules that changes of the world have added or removed, with the times.
    pub changed: Vec<String>,
    /// All zones, by name, with whether each is lit.
    pub zones: Vec<(String, bool)>,
    /// While prices are asked for: how many are known, and of how many.
    pub asking: Option<(u32, u32)>,
    /// Why not every price is known, where somebody asked.
    pub left_open: Option<String>,
    /// For how long it would go on, in seconds, where that is longer than Settings say.
    pub longer: Option<u32>,
    /// Whether what they cost can be asked for.
    pub can_ask: bool,
    /// What prices came to as a whole, to be read aloud.
    pub told: String,
    /// The same in a few words, which stand where it was asked: on a phone the rows are above.
    pub summary: Option<String>,
}

/// A rule of the problem.
#[derive(Clone, Debug, PartialEq)]
pub struct ProblemRule {
    /// The name of its icon.
    pub icon: &'static str,
    /// Its sentence.
    pub sentence: String,
    /// What changes it, where the page has a choice.
    pub change: Option<crate::Edit>,
}

/// A rule of the scene's own.
#[derive(Clone, Debug, PartialEq)]
#[allow(
    clippy::struct_excessive_bools,
    reason = "each is of its own: a row shows them in different places"
)]
pub struct Row {
    /// Its index in the scene.
    pub index: usize,
    /// The icon of its kind.
    pub icon: &'static str,
    /// Its sentence.
    pub pieces: Vec<Piece>,
    /// Its sentence as plain words.
    pub sentence: String,
    /// Its name, where it has one.
    pub name: Option<String>,
    /// Whether it is in force.
    pub is_on: bool,
    /// Whether it is lit.
    pub is_lit: bool,
    /// Whether its row is open.
    pub is_open: bool,
    /// Whether it has a number or times, of which it can ask for less.
    pub can_loosen: bool,
    /// How it can be loosened, where somebody asked.
    pub looser: Option<LooserPart>,
    /// Whether the best plan without it is shown beside the plan.
    pub is_beside: bool,
    /// When the plan on the board breaks it, and who does; or that it is one of those that leave
    /// no plan.
    pub broken: Option<String>,
    /// Its price, where somebody asked.
    pub price: Option<Tag>,
}

impl Row {
    /// The rule aloud: its sentence, then its price, then where the plan breaks it.
    pub fn label(&self) -> String {
        let price = self.price.as_ref().filter(|_| self.is_on);
        let parts = [price.map(|price| &price.text), self.broken.as_ref()];
        let parts = parts.into_iter().flatten();
        parts.fold(self.sentence.clone(), |label, part| {
            format!("{label}, {part}")
        })
    }
}

/// The rules of the scene on the board; nothing while something else is done with it.
pub fn list(state: &State) -> Option<List> {
    if !state.can_write_rules() || state.lesson().is_some() {
        return None;
    }
    let scene = state.document.draft.scene();
    let lit = state.lit_rule();
    let row = |(index, rule): (usize, &giveway_model::Constraint)| {
        let pieces = pieces(rule, &scene.agents, false);
        Row {
            index,
            icon: icon(rule),
            sentence: super::card::plain(&pieces),
            pieces,
            name: rule.name.clone(),
            is_on: !rule.off,
            is_lit: state.is_lit(index, rule),
            is_open: state.view.rules.open == Some(index),
            can_loosen: can_loosen(rule),
            looser: super::loosening::part(state, index),
            is_beside: state
                .plan_without()
                .is_some_and(|without| without.rule == index),
            broken: super::outdated::told(state, index)
                .or_else(|| super::clash::told(state, index)),
            price: tag(state, index, rule.off),
        }
    };
    let off = scene.constraints.iter().filter(|rule| rule.off).count();
    let on = scene.constraints.len() - off;
    let count = match (on, off) {
        (0, 0) => String::new(),
        (on, 0) => tr!("{n} in force" | "{n} in force" % on),
        (on, off) => tr!(
            "{n} in force, {off} off" | "{n} in force, {off} off" % on,
            off
        ),
    };
    let rows: Vec<Row> = scene.constraints.iter().enumerate().map(row).collect();
    let told = state.prices().and_then(|prices| prices.told.clone());
    let asking = state.is_pricing().then(|| match &told {
        Some(told) => {
            let all = told.prices.len() as u32;
            (all.saturating_sub(told.pending), all)
        }
        None => (0, on as u32),
    });
    let said = told.as_ref().map(|told| told.words.clone());
    Some(List {
        count,
        problem: of_problem(scene, state),
        changed: changed(state),
        zones: scene
            .zones
            .iter()
            .map(|zone| {
                (
                    zone.name.clone(),
                    lit == Some(&Lit::Zone(zone.name.clone())),
                )
            })
            .collect(),
        left_open: super::left_open::left_open(state),
        longer: super::left_open::longer(state),
        can_ask: on > 0 && state.document.draft.instance().is_ok(),
        told: said.filter(|_| asking.is_none()).unwrap_or_default(),
        summary: if asking.is_none() {
            summary(&rows)
        } else {
            None
        },
        asking,
        rows,
    })
}

/// What the rules in force cost, in a few words; nothing where nobody asked, or not every price is known.
fn summary(rows: &[Row]) -> Option<String> {
    let in_force = rows.iter().filter(|row| row.is_on);
    let prices: Vec<&Tag> = in_force.filter_map(|row| row.price.as_ref()).collect();
    if prices
        .iter()
        .any(|price| !["cost", "free"].contains(&price.class))
    {
        return None;
    }
    let costs = prices.iter().filter(|price| price.class == "cost").count();
    match prices.as_slice() {
        [] => None,
        [price] => Some(tr!("The rule {price}.", price = price.text)),
        all => Some(tr!(
            "{n} of {all} rules costs something." | "{n} of {all} rules cost something." % costs,
            all = all.len()
        )),
    }
}

/// The rules that changes of the world have added or removed, as the plan on the board knows them.
fn changed(state: &State) -> Vec<String> {
    let answer = state.document.answer.as_ref();
    let course = answer.and_then(|answer| answer.course.as_ref());
    let rules = course.map_or(&[][..], |course| course.history.constraints());
    let told = |rule: &TimedConstraint| {
        let sentence = rule.constraint.sentence();
        Some(match (rule.since, rule.until) {
            (None, None) => return None,
            (Some(since), None) => tr!("From time {since} on: {sentence}", since, sentence),
            (None, Some(until)) => tr!("Until time {until}: {sentence}", until, sentence),
            (Some(since), Some(until)) => {
                tr!(
                    "From time {since} until {until}: {sentence}",
                    since,
                    until,
                    sentence
                )
            }
        })
    };
    rules.iter().filter_map(told).collect()
}

/// The rules of the problem, as far as the scene has what they are about.
fn of_problem(scene: &Scene, state: &State) -> Vec<ProblemRule> {
    let rule = |icon, sentence: String| ProblemRule {
        icon,
        sentence,
        change: None,
    };
    let at_goal = |text: &str, other| ProblemRule {
        change: Some(crate::Edit::AtGoal(other)),
        ..rule("goal", text.to_owned())
    };
    let mut rules = vec![
        rule(
            "collision",
            tr!("Robots never share a cell or swap places").to_owned(),
        ),
        match scene.rules.at_goal {
            AtGoal::Stay => at_goal(tr!("Robots stay at their goals"), AtGoal::Vanish),
            AtGoal::Vanish => at_goal(tr!("Robots vanish at their goals"), AtGoal::Stay),
        },
    ];
    let grid = state.document.draft.grid();
    let is_slow = |y: u32| grid.row(y).iter().copied().any(Ground::is_slow);
    if (0..grid.height()).any(is_slow) {
        rules.push(rule(
            "slow",
            tr!("A move in the slow zone takes 2 steps").to_owned(),
        ));
    }
    if scene.agents.iter().any(|agent| agent.battery.is_some()) {
        let floor = scene.rules.battery_floor;
        rules.push(rule(
            "charger",
            tr!("No battery falls below {floor}", floor),
        ));
    }
    rules
}
