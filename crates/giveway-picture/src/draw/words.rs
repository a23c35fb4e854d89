//! What a picture says to those who do not see it.

use std::fmt::Write as _;

use giveway_model::Cell;
use giveway_model::words::count;

use super::stage::Stage;
use crate::whole;

/// More agents are only counted.
const NAMED: usize = 12;

impl Stage {
    /// The title: the name of the scene.
    pub(crate) fn title(&self) -> String {
        match self.instance.name() {
            "" => "A plan".to_owned(),
            name => name.to_owned(),
        }
    }

    /// What there is to see at a time.
    pub(crate) fn at_words(&self, time: f64) -> String {
        let mut words = self.who();
        if self.steps > 0 {
            // Writing to a string cannot fail.
            let _ = write!(words, " Step {} of {}.", whole(time), self.steps);
        }
        let place = |agent: usize| {
            let pose = self.tracks[agent].pose(time).filter(|pose| !pose.is_gone)?;
            let cell = pose.at.nearest_cell();
            Some(format!(" is at {}", written(cell)))
        };
        self.each(&mut words, |agent| {
            place(agent).unwrap_or_else(|| " is not there".to_owned())
        });
        words
    }

    /// What there is to see while it moves.
    pub(crate) fn moving_words(&self) -> String {
        let steps = count(self.steps, "step");
        let mut words = format!("{} They move for {steps}, again and again.", self.who());
        self.each(&mut words, |agent| {
            let own = &self.instance.agents()[agent];
            let arrival = self.tracks[agent].arrival();
            let to = own
                .goal
                .or_else(|| self.tracks[agent].path().last().copied().flatten());
            let (from, to) = (written(own.start), written(to.unwrap_or(own.start)));
            format!(" goes from {from} to {to} by step {arrival}")
        });
        words
    }

    fn who(&self) -> String {
        let grid = self.instance.grid();
        let robots = count(self.tracks.len() as u32, "robot");
        format!(
            "{robots} on a map of {} x {} cells.",
            grid.width(),
            grid.height()
        )
    }

    fn each(&self, words: &mut String, what: impl Fn(usize) -> String) {
        let agents = self.instance.agents();
        if agents.len() > NAMED {
            return;
        }
        for (index, agent) in agents.iter().enumerate() {
            words.push(' ');
            words.push_str(&agent.name);
            words.push_str(&what(index));
            words.push('.');
        }
    }
}

fn written(cell: Cell) -> String {
    format!("({}, {})", cell.x, cell.y)
}
