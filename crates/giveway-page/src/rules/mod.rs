//! Rules of a scene's own: which are lit, which is being written, what each costs.

mod action;
mod card;
mod clash;
mod counts;
mod judge;
mod kept;
mod left_open;
mod list;
mod loosening;
mod lost;
mod never;
mod offers;
mod outdated;
mod parts;
mod pieces;
mod price;
mod shortest;
mod times;
mod waits;
mod who;
mod writing;

use std::rc::Rc;

use giveway_model::{Constraint, Scene};
pub use giveway_picture::zone_of;

use crate::{Activity, State};

pub use action::{Lit, RuleAction, Value};
pub use card::{Card, Editor, Offer, Stay, card};
pub(crate) use clash::{Clash, in_clash};
pub use clash::{ClashRow, ClashTimes, clash_times};
pub use counts::Count;
pub use judge::{Judged, Ruling, ranges};
pub(crate) use kept::kept;
pub(crate) use left_open::seconds;
pub use list::{List, ProblemRule, Row, list};
pub(crate) use loosening::{Loosening, can_loosen, costs as looser_costs, loosen_request, looser};
pub use loosening::{LooserPart, LooserRow};
pub(crate) use lost::lost;
pub(crate) use offers::{every, of_zone, offered};
pub(crate) use outdated::{Outdated, sentence as outdated};
pub(crate) use parts::parts;
pub use pieces::{Piece, Slot, pieces};
pub use price::{CostsOfRule, Tag};
pub(crate) use price::{Pricing, Without, best_without, request, without};
pub use shortest::{in_clash_robots, short_way};
pub(crate) use times::broken;
pub use times::{Stretch, TimesRow, in_lit_zone, times_row};
pub use waits::waits_for;
pub(crate) use who::with_names;
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
    /// Where a stale plan breaks rules that came after it.
    pub(crate) outdated: outdated::Known,
    /// Rules and facts that leave no plan, as they were answered last; they may be of an older
    /// scene.
    pub(crate) clash: Option<Rc<Clash>>,
    /// How a rule of a scene can be loosened; it may be of an older scene.
    pub(crate) loosening: Option<Rc<Loosening>>,
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

    /// Whether a rule is lit, by its index: by itself, or with its zone.
    pub(crate) fn is_lit(&self, index: usize, rule: &Constraint) -> bool {
        match self.lit_rule() {
            Some(Lit::Rule(lit)) => *lit == index,
            Some(Lit::Zone(zone)) => zone_of(&rule.kind) == Some(zone),
            None => false,
        }
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

/// The rule in force that says the same as another one, by its index; but for the one that it takes
/// the place of, and those that a change removes.
pub(crate) fn twin(state: &State, rule: &Constraint, but: Option<usize>) -> Option<usize> {
    let changing = state.document.mode.changing();
    let is_removed = |index: usize| changing.is_some_and(|changing| changing.removes_rule(index));
    let rules = &state.document.draft.scene().constraints;
    let mut rules = rules.iter().enumerate();
    let is_twin = |index: usize, other: &Constraint| {
        let says_the_same = other.kind == rule.kind && other.agents == rule.agents;
        says_the_same && !other.off && Some(index) != but && !is_removed(index)
    };
    let found = rules.find(|(index, other)| is_twin(*index, other));
    found.map(|(index, _)| index)
}
