//! Rules of a scene's own: which are lit, which is being written, what each costs.

mod action;
mod card;
mod judge;
mod list;
mod lost;
mod never;
mod offers;
mod parts;
mod pieces;
mod price;
mod times;
mod waits;
mod writing;

use std::rc::Rc;

use giveway_model::{Constraint, Scene};
pub use giveway_picture::zone_of;

use crate::{Activity, State};

pub use action::{Lit, RuleAction, Value};
pub use card::{Card, Editor, Offer, Stay, card};
pub(crate) use judge::keeps;
pub use judge::{Count, Judged, Ruling, ranges};
pub use list::{List, ProblemRule, Row, list};
pub(crate) use lost::lost;
pub(crate) use offers::{every, of_zone, offered};
pub(crate) use parts::parts;
pub use pieces::{Piece, Slot, pieces};
pub use price::Tag;
pub(crate) use price::{Pricing, Without, request, without};
pub(crate) use times::broken;
pub use times::{Stretch, TimesRow, in_lit_zone, times_row};
pub use waits::waits_for;
pub(crate) use writing::Writing;

/// What is shown of the rules, and written of one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RulesView {
    /// The rule or the zone that is lit on the board and in the list.
    pub(crate) lit: Option<Lit>,
    /// The rule whose row is open, by its index in the scene.
    pub(crate) open: Option<usize>,
    /// The zone that strokes of the tool go on with, by its name.
    pub(crate) zone: Option<String>,
    /// The rule that is being written.
    pub(crate) writing: Option<Rc<Writing>>,
    /// The best plan without a rule, beside the plan on the board.
    pub(crate) without: Option<Without>,
    /// Whether the timeline shows the times of all rules.
    pub(crate) shows_all_times: bool,
    /// What the rules of a scene cost; it may be of an older scene.
    pub(crate) prices: Option<Rc<Pricing>>,
}

impl State {
    /// Whether rules can be written: the scene itself is on the board.
    pub(crate) const fn can_write_rules(&self) -> bool {
        matches!(self.document.mode.activity, Activity::Editing)
    }

    /// Whether a rule can be added while a plan runs: the world changes.
    pub(crate) fn can_add_rules(&self) -> bool {
        self.can_write_rules() || self.document.mode.changing().is_some()
    }

    /// The rule or the zone that is lit.
    pub const fn lit_rule(&self) -> Option<&Lit> {
        self.view.rules.lit.as_ref()
    }

    /// Whether a rule is being written.
    pub fn is_writing_rule(&self) -> bool {
        self.view.rules.writing.is_some() && self.can_add_rules()
    }
}

/// The name of the icon of a rule.
pub const fn icon(rule: &Constraint) -> &'static str {
    rule.kind_name()
}

/// A name that no zone has: `zone 2`, of the least free number.
pub(crate) fn fresh_zone(scene: &Scene) -> String {
    let is_free = |name: &String| scene.zones.iter().all(|zone| zone.name != *name);
    let mut names = (1..=scene.zones.len() + 1)
        .map(|number| giveway_model::tr!("the name of a zone" => "zone {number}", number));
    names.find(is_free).unwrap_or_default()
}

/// The slot of a rule in which it can ask for less: its number, else its times.
pub(crate) fn loosened(rule: &Constraint) -> Option<Slot> {
    let mut kind = rule.kind.clone();
    let parts = parts(&mut kind);
    if let Some(last) = parts.numbers.len().checked_sub(1) {
        return Some(Slot::Number(last));
    }
    parts.times.is_some().then_some(Slot::When)
}
