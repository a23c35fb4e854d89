//! The lanes over all best plans: solid bars where every one of them does the same at
//! the same time, dotted ones where there is a choice; hatched how late a robot may be.

use std::ops::Range;

use giveway_model::tr;
use giveway_solve::freedom::{Hold, Known, Visit};

use super::lines::known;
use crate::State;
use crate::timeline::{Axis, Lane, Row, Shapes, Step, rounded, stripes};

/// What is known of a lane.
#[derive(Clone, Debug, PartialEq)]
pub struct LaneMarks {
    /// What every best plan has, by time.
    visits: Vec<Visit>,
    /// How late it may be.
    late: Option<Hold>,
}

/// A lane as it is drawn: an empty path draws nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Marked {
    /// What is in every best plan, with all that stands beside the bars.
    pub shapes: Shapes,
    /// What is free to choose, outlined by dots.
    pub free: String,
    /// What is open, outlined by dashes.
    pub open: String,
    /// How late it may be, outlined.
    pub late: String,
    /// The stripes on that.
    pub hatch: String,
}

/// What is known of the lane of a robot; `None` where nothing is laid over the plan.
pub fn lane(state: &State, name: &str) -> Option<LaneMarks> {
    let told = state.freedom()?.told.as_deref()?;
    let visits = told.backbone.as_ref()?.get(name)?.clone();
    Some(LaneMarks {
        visits,
        late: hold(state, name),
    })
}

/// How late a robot may be, beside its name: `up to 3 late`.
pub fn late(state: &State, name: &str) -> Option<String> {
    Some(match hold(state, name)? {
        Hold::Steps(0) => tr!("no slack").to_owned(),
        Hold::Steps(steps) => tr!("up to {steps} late", steps),
        Hold::Unlimited => tr!("no hurry").to_owned(),
        Hold::InTransit => return None,
    })
}

/// How late a robot may be, where it goes by the plan that this is about.
fn hold(state: &State, name: &str) -> Option<Hold> {
    let told = state.freedom()?.told.as_deref()?;
    let slack = told.slack.as_ref()?.get(name)?;
    slack.late().filter(|_| state.farthest().is_none())
}

impl LaneMarks {
    /// Whether a step is in every best plan.
    fn knows(&self, step: &Step) -> Known {
        let visits = self.visits.get(step.begins as usize..=step.ends as usize);
        visits.map_or(Known::No, known)
    }

    /// What this adds to the words for a lane.
    pub fn sentence(&self, lane: &Lane) -> String {
        let all = lane.steps.len();
        let is_fixed = |step: &&Step| self.knows(step).is_proved();
        let fixed = lane.steps.iter().filter(is_fixed).count();
        tr!(", {fixed} of {all} steps in every best plan", fixed, all)
    }

    /// The shapes of a lane at the columns that are drawn. `is_alone`: no other plan is
    /// beside it, so that there is room for how late it may be.
    pub fn shapes(
        &self,
        lane: &Lane,
        axis: Axis,
        row: Row,
        seen: &Range<u32>,
        is_alone: bool,
    ) -> Marked {
        let mut fixed = lane.clone();
        let (mut free, mut open) = (String::new(), String::new());
        let x = |time: u32| axis.x(f64::from(time));
        for step in &lane.steps {
            let path = match self.knows(step) {
                Known::Yes => continue,
                Known::No => &mut free,
                Known::Open => &mut open,
            };
            if step.ends >= seen.start && step.begins < seen.end {
                let left = x(step.begins) + 2.0;
                let width = (x(step.ends) - 2.0 - left).max(1.0);
                rounded(path, left, row.bar + 1.0, width, row.thick - 2.0, 3.0);
            }
        }
        fixed.steps.retain(|step| self.knows(step).is_proved());
        let mut marked = Marked {
            shapes: Shapes::of(&fixed, axis, row, seen),
            free,
            open,
            late: String::new(),
            hatch: String::new(),
        };
        marked.shapes.after.clear();
        if is_alone {
            marked.add_late(self.late, lane, axis, row);
        }
        marked
    }
}

impl Marked {
    fn add_late(&mut self, late: Option<Hold>, lane: &Lane, axis: Axis, row: Row) {
        let last = axis.times - 1;
        let until = match late {
            Some(Hold::Steps(steps)) => lane.arrival.saturating_add(steps).min(last),
            Some(Hold::Unlimited) => last,
            Some(Hold::InTransit) | None => return,
        };
        // The flag needs some room before it.
        let from = axis.x(f64::from(lane.arrival)) + 15.0;
        let width = axis.x(f64::from(until)) - 1.0 - from;
        if until > lane.arrival && width > 2.0 {
            rounded(
                &mut self.late,
                from,
                row.bar + 0.5,
                width,
                row.thick - 1.0,
                3.5,
            );
            stripes(&mut self.hatch, from, row.bar, width, row.thick);
        }
    }
}
