//! Everything that a picture is about: who goes where, what lies there, how it looks.

use giveway_model::check::levels;
use giveway_model::{Agent, Instance, Plan};

use crate::ink::{Ink, Inks, robot};
use crate::xml::{Escaped, Number};
use crate::{Detail, Letters, Look, Mark, Stay, Track, Way, form, letters, marks_with, stays};

use super::motion::{Motion, When};
use super::sheet::Sheet;

/// A plan of an instance, to be drawn.
pub(crate) struct Stage {
    pub(crate) instance: Instance,
    pub(crate) look: Look,
    /// The look of each agent.
    pub(super) looks: Vec<usize>,
    pub(super) inks: Inks,
    pub(super) detail: Detail,
    pub(crate) sheet: Sheet,
    pub(crate) tracks: Vec<Track>,
    pub(super) ways: Vec<Way>,
    pub(super) marks: Vec<Mark>,
    /// The stays that rules ask for.
    pub(super) stays: Vec<Stay>,
    /// What stands on the form of each agent.
    pub(super) badges: Vec<String>,
    /// The last time at which something happens.
    pub(crate) steps: u32,
    /// What ids and classes begin with: other pictures of the same page have other ones.
    pub(super) prefix: String,
}

impl Stage {
    pub(crate) fn new(instance: &Instance, plan: &Plan, look: &Look) -> Self {
        let agents = instance.agents();
        let track = |(index, agent): (usize, &Agent)| track(instance, plan, index, agent);
        let tracks: Vec<Track> = agents.iter().enumerate().map(track).collect();
        let names: Vec<&str> = agents.iter().map(|agent| agent.name.as_str()).collect();
        let is_drawn = |letter| look.letters == Letters::Text || letters::is_drawn(letter);
        let badges = form::badges(&names, is_drawn);
        let steps = tracks.iter().map(Track::arrival).max().unwrap_or(0);
        Self {
            instance: instance.clone(),
            look: look.clone(),
            looks: look.looks.all(agents.len()),
            inks: Inks::of(look.theme),
            detail: Detail::of(f64::from(look.cell)),
            sheet: Sheet::new(instance.grid(), look.cell),
            ways: Way::of_all(&tracks),
            marks: marks_with(agents, &tracks, &badges),
            stays: stays(instance.constraints(), agents, plan),
            badges,
            tracks,
            steps,
            prefix: prefix(instance, plan, look),
        }
    }

    /// What ids and classes begin with.
    pub(crate) fn prefix(&self) -> &str {
        &self.prefix
    }

    /// All that is not always the same, at a time.
    pub(crate) fn at(&self, time: f64) -> String {
        self.all(&mut When::At(time))
    }

    /// The same without the line of the time.
    pub(crate) fn things_at(&self, time: f64) -> String {
        self.things(&mut When::At(time))
    }

    /// The same as it moves.
    pub(crate) fn in_motion(&self, motion: &mut Motion) -> String {
        self.all(&mut When::Moving(motion))
    }

    fn all(&self, when: &mut When<'_>) -> String {
        [self.things(when), self.time(when)].concat()
    }

    /// Zones that are closed, agents and marks, with the tags of rules above them, and stays that
    /// count down.
    fn things(&self, when: &mut When<'_>) -> String {
        let zones = self.zones_at(when);
        let (agents, flags) = (self.agents(when), self.flags(when));
        let (below, above) = if self.detail.covers_marks() {
            (flags, agents)
        } else {
            (agents, flags)
        };
        [zones, below, above, self.rule_tags(), self.stays_at(when)].concat()
    }

    /// The colour of an agent, and the one of its name on it.
    pub(super) fn robot(&self, agent: usize) -> (Ink, Ink) {
        robot(self.look.theme, self.look.colours, self.looks[agent])
    }

    /// A whole SVG around shapes; what moves has a style.
    pub(crate) fn svg(&self, title: &str, words: &str, style: &str, shapes: &str) -> String {
        let (width, height) = self.sheet.size;
        let [x, y, across, down] = self.sheet.view_box().map(Number);
        let page = self.inks.page;
        let (title, words) = (Escaped(title), Escaped(words));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"{x} {y} {across} {down}\" role=\"img\">\
             <title>{title}</title><desc>{words}</desc>{style}\
             <rect x=\"{x}\" y=\"{y}\" width=\"{across}\" height=\"{down}\" fill=\"{page}\"/>\
             {shapes}</svg>"
        )
    }

    /// A part of a picture that is laid over another one: it has no ground.
    #[cfg(feature = "gif")]
    pub(crate) fn overlay(&self, shapes: &str) -> String {
        let (width, height) = self.sheet.size;
        let [x, y, across, down] = self.sheet.view_box().map(Number);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
             viewBox=\"{x} {y} {across} {down}\">{shapes}</svg>"
        )
    }
}

/// What an agent does; one without a path stands at its start.
fn track(instance: &Instance, plan: &Plan, index: usize, agent: &Agent) -> Track {
    let name = &agent.name;
    let mut path = plan.path(name).to_vec();
    if path.iter().all(Option::is_none) {
        path = vec![Some(agent.start)];
    }
    let mut charges = plan.charges(name).to_vec();
    charges.sort_unstable();
    let battery = agent.battery.map(|battery| {
        let mut levels = levels(instance, index, plan);
        if levels.is_empty() {
            levels.push(i64::from(battery.initial));
        }
        (levels, battery.capacity)
    });
    let from = plan.from.get(name).copied().unwrap_or(0);
    let until = plan.until.get(name).copied();
    Track::new(path, charges, battery, instance.rules().at_end_of(agent)).between(from, until)
}

/// A short name by what is drawn (FNV-1a): the same picture has the same one.
fn prefix(instance: &Instance, plan: &Plan, look: &Look) -> String {
    // Memory is all that could run out.
    let bytes = borsh::to_vec(&(instance.to_scene(), plan, look)).unwrap_or_default();
    let hash = bytes.iter().fold(0x811c_9dc5_u32, |hash, byte| {
        (hash ^ u32::from(*byte)).wrapping_mul(0x0100_0193)
    });
    format!("g{hash:08x}")
}
