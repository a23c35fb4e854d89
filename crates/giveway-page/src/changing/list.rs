//! The list of changes with one more, or one less: as far as the world allows it.

use giveway_model::Battery;
use giveway_model::change::What;
use giveway_model::words::Sentence;

use super::entries::entries;
use super::{Changing, facts, listed};
use crate::edit::{Edit, world};

impl Changing {
    /// The list with what edits ask for, as far as the world allows it; with why
    /// a part of it was refused.
    pub(crate) fn with_edits(&self, edits: &[Edit]) -> (Self, Option<Sentence>) {
        if let [Edit::SetBattery(agent, battery)] = edits
            && let Some(list) = self.with_battery(*agent, *battery)
        {
            return match self.with(list) {
                Ok(after) => (after, None),
                Err(faults) => {
                    let fault = faults.first();
                    (
                        self.clone(),
                        fault.map(|fault| facts::contradiction(fault).into()),
                    )
                }
            };
        }
        let mut refused = None;
        let mut parts = Vec::new();
        for edit in edits {
            match world::changes(edit, self.draft()) {
                Ok(part) => parts.push(part),
                Err(sentence) => refused = refused.or(Some(sentence)),
            }
        }
        let mut all = self.list.clone();
        for what in parts.iter().flatten() {
            listed::add(&mut all, what.clone());
        }
        if all == self.list {
            return (self.clone(), refused);
        }
        if let Ok(after) = self.with(all) {
            return (after, refused);
        }
        // Not all of it can be: then what can.
        let mut after = self.clone();
        for part in parts {
            let mut list = after.list.clone();
            for what in part {
                listed::add(&mut list, what);
            }
            match after.with(list) {
                Ok(next) => after = next,
                Err(faults) => {
                    refused = refused.or(faults
                        .first()
                        .map(|fault| facts::contradiction(fault).into()));
                }
            }
        }
        (after, refused)
    }

    /// The list with another battery of an agent that joins by it; `None` for any other agent.
    fn with_battery(&self, agent: usize, battery: Option<Battery>) -> Option<Vec<What>> {
        let name = &self.draft().agents().get(agent)?.name;
        let mut list = self.list.clone();
        let joins = list.iter_mut().find_map(|what| match what {
            What::AddAgent { agent } if agent.name == *name => Some(agent),
            _ => None,
        });
        joins?.battery = battery;
        Some(list)
    }

    /// The list without one entry, which begins with a change, and without those that then contradict the
    /// world; with the number of these.
    pub(crate) fn without(&self, index: usize) -> (Self, usize) {
        let mut after = match self.with(Vec::new()) {
            Ok(after) => after,
            Err(_) => self.clone(),
        };
        let mut lost = 0;
        let entries = entries(self.about.plan(), &self.list, self.at);
        let own = entries
            .iter()
            .find(|entry| entry.changes.first() == Some(&index));
        let own = own.map_or(&[][..], |entry| entry.changes.as_slice());
        let taken = self.list.get(index);
        let joins = match taken {
            Some(What::AddAgent { agent }) => Some(agent.name.as_str()),
            _ => None,
        };
        for (other, what) in self.list.iter().enumerate() {
            let goes = joins.is_some() && listed::whose(what) == joins;
            if other == index || own.contains(&other) || goes {
                continue;
            }
            let mut list = after.list.clone();
            list.push(what.clone());
            match after.with(list) {
                Ok(next) => after = next,
                Err(_) => lost += 1,
            }
        }
        (after, lost)
    }
}
