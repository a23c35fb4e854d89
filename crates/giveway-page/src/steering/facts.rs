//! What the inspector tells of a plan of one's own.

use giveway_model::{Cost, tr};

use super::Steering;
use crate::ask::{CostRow, Happening};
use crate::words::at;
use crate::{State, words};

/// The most violations that are told one by one.
const MOST: usize = 30;

/// What there is to tell of the agent that is led, and of the plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Facts {
    /// Who is led, by its index in the scene.
    pub agent: usize,
    /// Its name.
    pub name: String,
    /// Where it has been led to: `A1 is at (3, 1) at time 5, battery 4 of 10`.
    pub place: String,
    /// Whether there is a step to take back.
    pub can_go_back: bool,
    /// Whether it charges in its next step; `None` where it cannot.
    pub charges: Option<bool>,
    /// Whether it has a battery.
    pub has_battery: bool,
    /// What is against the rules; lit is what is so at the time shown.
    pub violations: Vec<Happening>,
    /// The rule of the scene's own that the last step breaks, by its index.
    pub breaks: Option<usize>,
    /// How many more there are.
    pub more: usize,
    /// What is not done yet.
    pub to_do: Vec<String>,
    /// How many problems the plan has as it stands, in a sentence; nothing where it has none.
    pub count: Option<String>,
    /// The costs of the plan that it began with, and of this one.
    pub rows: Vec<CostRow>,
}

/// What there is to tell; nothing unless an agent is led.
pub fn facts(state: &State) -> Option<Facts> {
    let steering = state.document.mode.steering()?;
    let (agent, time) = (steering.agent, steering.time());
    let battery = steering.about.draft.agents().get(agent)?.battery;
    let name = steering.name();
    let mut place = tr!(
        "{name} is at {cell} at time {time}",
        name,
        cell = at(steering.cell()),
        time
    );
    if let Some(battery) = battery {
        let levels = steering.answer.levels.get(agent);
        let level = levels.and_then(|levels| levels.get(time as usize).or(levels.last()));
        let level = level.copied().unwrap_or_default();
        // Writing to a string cannot fail.
        place += &tr!(
            ", battery {level} of {capacity}",
            level,
            capacity = battery.capacity
        );
    }
    let violations = steering.violations.iter().enumerate();
    let violations = violations.map(|(index, violation)| Happening {
        index,
        number: Some(index + 1),
        text: violation.message.clone(),
        time: violation.time,
        is_lit: Steering::is_now(violation, state.view.playback.time),
    });
    let to_do = steering.to_do.iter();
    let name_of = |violation: &&giveway_model::check::Violation| {
        violation.time == time && violation.agents.iter().any(|of| of == name)
    };
    let mut of_last = steering.violations.iter().filter(name_of);
    let breaks = of_last.find_map(|it| Some(it.broken.as_ref()?.index as usize));
    Some(Facts {
        agent,
        name: name.to_owned(),
        place,
        can_go_back: steering.can_go_back(),
        charges: steering.charges(),
        has_battery: battery.is_some(),
        violations: violations.take(MOST).collect(),
        breaks: breaks.filter(|_| steering.can_go_back()),
        more: steering.violations.len().saturating_sub(MOST),
        to_do: to_do.map(|open| open.message.clone()).collect(),
        count: count(steering),
        rows: rows(steering),
    })
}

/// The same number as the answer to what is wrong with the plan, and what it is made of.
fn count(steering: &Steering) -> Option<String> {
    let all = steering.problems();
    if all == 0 {
        return None;
    }
    let count = tr!("As it stands, the plan has {n} problem."
        | "As it stands, the plan has {n} problems." % all);
    let follows = steering.follows;
    Some(if follows == 0 {
        count
    } else {
        let why = tr!("{n} of them goes away once a robot is led on."
            | "{n} of them go away once robots are led on." % follows);
        format!("{count} {why}")
    })
}

/// All five costs, those of the objective first.
fn rows(steering: &Steering) -> Vec<CostRow> {
    let costs = steering
        .about
        .solved
        .costs
        .zip(steering.answer.solved.costs);
    let Some((this, other)) = costs else {
        return Vec::new();
    };
    let objective = steering.about.draft.scene().objective.costs();
    let others = Cost::USUAL.into_iter().filter(|c| !objective.contains(c));
    let all = objective.iter().copied().chain(others);
    all.map(|cost| CostRow {
        title: words::title(cost).to_owned(),
        agent: None,
        this: this.get(cost),
        other: other.get(cost),
    })
    .collect()
}
