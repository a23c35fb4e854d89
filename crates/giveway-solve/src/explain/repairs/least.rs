//! The least battery, the highest floor, the least deadline that help.

use giveway_model::{MAX_CAPACITY, constraint::MAX_NUMBER};

use super::{
    super::answer::Edit,
    candidate::{Candidate, allow_more, battery, give_until},
    search::{RepairSearch, flat},
};

impl RepairSearch<'_> {
    /// Replaces one of some edits that help by the least of its kind that still does
    /// with the others; true where less is proved not to.
    pub(super) fn lessen(
        &mut self,
        candidate: &Candidate,
        index: usize,
        edits: &mut [Option<Edit>],
        within: Option<u32>,
    ) -> bool {
        let mut with = |search: &mut Self, edit: Option<Edit>| {
            edits[index] = edit;
            search.helps(&flat(edits), within)
        };
        let kind = |search: &Self, rule: usize| {
            let rule = search.broken.instance.rule_as_written(rule);
            rule.map(|rule| rule.kind.clone())
        };
        let (edit, is_least) = match *candidate {
            Candidate::Edit(_) | Candidate::Deadline => return true,
            Candidate::Battery(agent) => self.least_battery(agent, &mut with),
            Candidate::Floor => self.highest_floor(&mut with),
            Candidate::Most(rule) => {
                let today = kind(self, rule).and_then(|kind| kind.most());
                self.least_of(today, &mut |search, most| {
                    let edit = allow_more(search.broken.instance, rule, most);
                    (edit.clone(), with(search, edit))
                })
            }
            Candidate::Until(rule) => {
                let today = kind(self, rule).and_then(|kind| kind.last_chance());
                self.least_of(today, &mut |search, to| {
                    let edit = give_until(search.broken.instance, rule, to);
                    (edit.clone(), with(search, edit))
                })
            }
        };
        edits[index] = edit;
        is_least
    }

    /// The least number of a rule, above today's, that helps. Each number has its edit.
    fn least_of(
        &mut self,
        today: Option<u32>,
        with: &mut impl FnMut(&mut Self, u32) -> (Option<Edit>, Option<bool>),
    ) -> (Option<Edit>, bool) {
        let Some(today) = today else {
            return (None, true);
        };
        let (least, is_least) = self.least_doubling((today, true), MAX_NUMBER, |search, number| {
            with(search, number).1
        });
        (with(self, least).0, is_least)
    }

    /// The least larger battery that helps: of today's capacity if a full one helps,
    /// else of the least capacity; then of the least level at the start.
    fn least_battery(
        &mut self,
        agent: usize,
        helps: &mut impl FnMut(&mut Self, Option<Edit>) -> Option<bool>,
    ) -> (Option<Edit>, bool) {
        let instance = self.broken.instance;
        let Some(today) = instance.agents().get(agent).and_then(|a| a.battery) else {
            return (None, true);
        };
        let of = |capacity, initial| battery(instance, agent, capacity, initial);
        let full_today = if today.initial == today.capacity {
            Some(false)
        } else {
            helps(self, of(today.capacity, today.capacity))
        };
        let (mut capacity, mut is_least) = (today.capacity, true);
        // A level that is known not to help with this capacity.
        let mut too_low = Some(today.initial);
        if full_today != Some(true) {
            let full = |search: &mut Self, capacity| helps(search, of(capacity, capacity));
            let known = (today.capacity, full_today == Some(false));
            (capacity, is_least) = self.least_doubling(known, MAX_CAPACITY, full);
            too_low = today.initial.checked_sub(1);
        }
        // (With a larger battery, today's level may be enough.)
        let (low, high) = (too_low.map_or(0, |low| low + 1), capacity);
        let level = |search: &mut Self, level| helps(search, of(capacity, level));
        let (initial, level_is_least) = self.least_between(low, high, level);
        (of(capacity, initial), is_least && level_is_least)
    }

    /// The highest floor below today's that helps.
    fn highest_floor(
        &mut self,
        helps: &mut impl FnMut(&mut Self, Option<Edit>) -> Option<bool>,
    ) -> (Option<Edit>, bool) {
        let today = self.broken.instance.rules().battery_floor;
        let (by, is_least) = self.least_between(1, today, |search, by| {
            let floor = today - by;
            helps(search, Some(Edit::BatteryFloor { floor }))
        });
        let floor = today - by;
        (Some(Edit::BatteryFloor { floor }), is_least)
    }

    /// The least deadline that helps with some edits, later than one that does not, and
    /// no later than one that does.
    pub(super) fn least_deadline(
        &mut self,
        edits: &[Edit],
        too_soon: u32,
        enough: u32,
    ) -> (u32, bool) {
        self.least_between(too_soon + 1, enough, |search, within| {
            search.helps(edits, Some(within))
        })
    }

    /// The least number above one, up to the `most`, which helps: twice as far each
    /// time, then halving, as what helps is small. The flag of `known` says whether
    /// that number is known not to help.
    fn least_doubling(
        &mut self,
        (known, mut is_known): (u32, bool),
        most: u32,
        mut helps: impl FnMut(&mut Self, u32) -> Option<bool>,
    ) -> (u32, bool) {
        let (mut less, mut step) = (known, 1);
        loop {
            let next = less.saturating_add(step).min(most);
            if next == most {
                break;
            }
            match helps(self, next) {
                Some(true) => break,
                outcome => is_known = outcome.is_some(),
            }
            less = next;
            step *= 2;
        }
        let enough = less.saturating_add(step).min(most);
        let (least, is_least) = self.least_between(less + 1, enough, helps);
        // Just above `less`, it is the least only if that one is known not to help.
        (least, is_least && (is_known || least > less + 1))
    }

    /// The least number of some that helps, where the last one does, and whether less is
    /// proved not to. What is not known counts as not enough.
    fn least_between(
        &mut self,
        first: u32,
        last: u32,
        mut helps: impl FnMut(&mut Self, u32) -> Option<bool>,
    ) -> (u32, bool) {
        let (mut low, mut high) = (first, last);
        let mut is_least = true;
        while low < high {
            let middle = low + (high - low) / 2;
            match helps(self, middle) {
                Some(true) => high = middle,
                outcome => {
                    is_least = outcome.is_some();
                    low = middle + 1;
                }
            }
        }
        (high, is_least)
    }
}
