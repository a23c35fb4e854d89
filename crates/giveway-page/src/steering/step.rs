//! An agent is led: a step more, a charge, or a step back.

use giveway_model::words::Sentence;
use giveway_model::{Cell, tr_data};

use super::Steering;
use crate::words::at;

/// The most steps that an agent is led.
const LONGEST: usize = 10_000;

impl Steering {
    /// A step so many cells right and down, or a wait.
    ///
    /// # Errors
    /// Why there is no such step, as a sentence.
    pub(crate) fn step(&self, by: (i32, i32)) -> Result<Self, Sentence> {
        let (name, from) = (self.name().to_owned(), self.cell());
        let refused = |why: Sentence| Err(tr_data!("{name} stays: {why}.", name = &name, why));
        if self.path().len() >= LONGEST {
            return refused(tr_data!("nobody is led that far"));
        }
        let to = from.x.checked_add_signed(by.0);
        let to = to.zip(from.y.checked_add_signed(by.1));
        let to = to.map(|(x, y)| Cell::new(x, y));
        let Some(to) = to.filter(|&to| self.grid().ground(to).is_some()) else {
            return refused(tr_data!("the map ends there"));
        };
        if !self.grid().is_vertex(to) {
            return refused(tr_data!("at {cell} there is an obstacle", cell = at(to)));
        }
        if to != from && !to.touches(from) {
            return refused(tr_data!("{cell} is not beside it", cell = at(to)));
        }
        let mut plan = self.plan.clone();
        if let Some(path) = plan.paths.get_mut(&name) {
            if self.grid().is_slow_edge(from, to) {
                path.push(None);
            }
            path.push(Some(to));
        }
        Ok(self.after(plan))
    }

    /// Whether it charges in its next step, the other way round.
    ///
    /// # Errors
    /// Why it cannot, as a sentence.
    pub(crate) fn charge(&self) -> Result<Self, Sentence> {
        let (name, time) = (self.name().to_owned(), self.time());
        let Some(charges) = self.charges() else {
            let cell = at(self.cell());
            return Err(tr_data!("{name} cannot charge at {cell}.", name, cell));
        };
        let mut plan = self.plan.clone();
        let times = plan.charges.entry(name.clone()).or_default();
        if charges {
            times.retain(|&charge| charge != time);
        } else {
            times.push(time);
        }
        // It begins with the next step, and is judged with that.
        Ok(Self {
            told: if charges {
                tr_data!("{name} does not charge.", name)
            } else {
                tr_data!("{name} charges in its next step.", name)
            },
            plan,
            ..self.clone()
        })
    }

    /// The same without the last step.
    ///
    /// # Errors
    /// That there is none, as a sentence.
    pub(crate) fn back(&self) -> Result<Self, Sentence> {
        if !self.can_go_back() {
            return Err(tr_data!("There is no step to take back."));
        }
        let name = self.name().to_owned();
        let mut plan = self.plan.clone();
        if let Some(path) = plan.paths.get_mut(&name) {
            path.pop();
            while path.last() == Some(&None) {
                path.pop();
            }
            let last = path.len().saturating_sub(1);
            if let Some(charges) = plan.charges.get_mut(&name) {
                // That of the step taken back stays chosen, to be made anew.
                charges.retain(|&charge| charge as usize <= last);
            }
        }
        Ok(Self {
            told: Sentence::default(),
            ..self.after(plan)
        })
    }
}
