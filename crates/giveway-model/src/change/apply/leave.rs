//! Agents that leave: removed, or broken down for good.

use super::{Reason, Whereabouts, World, refuse};
use crate::Ground;
use crate::change::Stopped;

impl World<'_> {
    /// An agent is gone; one that has broken down for good is taken away, and its cell is as it
    /// was before.
    pub(super) fn remove(&mut self, name: &str) -> Result<(), Reason> {
        let at = self.at;
        let mut timelines = self.after.timelines.iter_mut();
        let stopped = timelines
            .find(|timeline| timeline.name() == name)
            .and_then(|timeline| timeline.stopped.as_mut())
            .filter(|stopped| stopped.until.is_none());
        if let Some(stopped) = stopped {
            stopped.until = Some(at);
            let (cell, ground) = (stopped.cell, stopped.ground);
            self.grid.set_ground(cell, ground);
            return Ok(());
        }
        self.leave(name)
    }

    /// An agent breaks down for good: it is an obstacle where it is, or where the slow move ends
    /// that is under way.
    pub(super) fn stop(&mut self, name: &str) -> Result<(), Reason> {
        let at = self.at;
        let mut trajectories = self.trajectories.iter();
        let trajectory = trajectories.find(|trajectory| trajectory.timeline.name() == name);
        let place = trajectory.map(|trajectory| trajectory.place(at));
        self.leave(name)?;
        let Some(Whereabouts::At(cell) | Whereabouts::Transit { to: cell, .. }) = place else {
            return Err(refuse::vanished(name, at));
        };
        let ground = self.ground(cell)?;
        if ground == Ground::Obstacle {
            return Err(refuse::blocked(cell));
        }
        self.grid.set_ground(cell, Ground::Obstacle);
        let mut timelines = self.after.timelines.iter_mut();
        if let Some(timeline) = timelines.find(|timeline| timeline.name() == name) {
            timeline.stopped = Some(Stopped {
                cell,
                ground,
                until: None,
            });
        }
        Ok(())
    }

    fn leave(&mut self, name: &str) -> Result<(), Reason> {
        let at = self.at;
        let timeline = self.timeline(name)?;
        if timeline.from == at && at > 0 {
            return Err(refuse::just_added(name));
        }
        timeline.until = Some(at);
        Ok(())
    }
}
