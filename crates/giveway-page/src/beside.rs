//! Two plans side by side: which robots differ, and from when on.

mod rows;

use std::rc::Rc;

use giveway_model::sorting::sort_by_key;
use giveway_model::{Agent, Cell, Plan, tr};
use std::cmp::Reverse;
use std::collections::BTreeMap;

use crate::audit::Dropped;
use crate::{Answer, ComparedLanes, Lit, State};

pub use rows::DifferenceRow;
pub(crate) use rows::rows;

use rows::ROWS;

/// A time at which robots first leave their ways in the plan that is shown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// The time, in steps.
    pub time: u32,
    /// The robots, by their indices in the plan that is shown.
    pub agents: Vec<usize>,
}

/// Where one stands among the differences: the row under the boards.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Steps {
    /// Which difference, of how many and when, in words.
    pub text: String,
    /// Its robots, by index and name.
    pub agents: Vec<(usize, String)>,
    /// Whether there is one before.
    pub has_previous: bool,
    /// Whether there is one after.
    pub has_next: bool,
}

/// The first times at which robots are elsewhere, those at one time together, the earliest first.
pub(crate) fn differences(this: &Answer, other: &Answer) -> Vec<Difference> {
    let (Some(plan), Some(second)) = (this.plan(), other.plan()) else {
        return Vec::new();
    };
    let mut found: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    for (agent, who) in this.agents().iter().enumerate() {
        if let Some(time) = first_difference(plan, second, &who.name) {
            found.entry(time).or_default().push(agent);
        }
    }
    let found = found.into_iter();
    found
        .map(|(time, agents)| Difference { time, agents })
        .collect()
}

/// The first time at which a robot is elsewhere, or charges in only one of the plans.
fn first_difference(plan: &Plan, other: &Plan, name: &str) -> Option<u32> {
    let (one, two) = (plan.path(name), other.path(name));
    if one.is_empty() || two.is_empty() {
        return None;
    }
    // Who has arrived stays.
    let at = |path: &[Option<Cell>], time: usize| {
        let place = path.get(time).or_else(|| path.last());
        place.copied().flatten()
    };
    let (charges, others) = (plan.charges(name), other.charges(name));
    let times = 0..one.len().max(two.len());
    let mut times = times.zip(0_u32..);
    let found = times.find(|&(index, time)| {
        at(one, index) != at(two, index) || charges.contains(&time) != others.contains(&time)
    });
    found.map(|(_, time)| time)
}

/// How many differences have no row of their own, in words.
pub(crate) fn more_rows(state: &State) -> Option<String> {
    let more = state.differences().len().saturating_sub(ROWS) as u32;
    (more > 0).then(|| tr!("And {n} later difference." | "And {n} later differences." % more))
}

/// Whether two plans move all robots in the same way.
pub(crate) fn same_walks(one: &Plan, other: &Plan, agents: &[Agent]) -> bool {
    let mut agents = agents.iter();
    agents.all(|agent| first_difference(one, other, &agent.name).is_none())
}

impl State {
    /// The two plans that are compared: a question's, or those side by side.
    pub(crate) fn compared(&self) -> Option<(&Rc<Answer>, &Rc<Answer>)> {
        if let Some(asking) = self.document.mode.asking() {
            let is_hidden = self.is_inside() || self.hides_answers();
            let other = self.opened().filter(|_| !is_hidden)?;
            return Some((&asking.about, other));
        }
        Some((self.shown()?, self.beside()?))
    }

    /// Where the two plans differ; none where there are not two.
    pub(crate) fn differences(&self) -> Vec<Difference> {
        self.compared()
            .map(|(this, other)| differences(this, other))
            .unwrap_or_default()
    }
}

/// The time of the next difference after the time shown, or of the one before it.
pub(crate) fn next(state: &State, is_forward: bool) -> Option<u32> {
    let time = state.view.playback.time;
    let differences = state.differences();
    let mut times = differences.iter().map(|it| it.time);
    if is_forward {
        times.find(|&at| at > time)
    } else {
        times.rfind(|&at| at < time)
    }
}

/// The robots of the last difference up to the time shown, by their indices.
pub(crate) fn differing_now(state: &State) -> Vec<usize> {
    let time = state.view.playback.time;
    let mut all = state.differences().into_iter();
    all.rfind(|it| it.time <= time)
        .map_or_else(Vec::new, |it| it.agents)
}

/// The row under the boards; nothing where there are not two plans.
pub fn steps(state: &State) -> Option<Steps> {
    let (this, _) = state.compared()?;
    let differences = state.differences();
    let time = state.view.playback.time;
    let all = differences.len();
    let passed = differences.iter().filter(|it| it.time <= time).count();
    let (text, agents) = match (
        passed.checked_sub(1).and_then(|at| differences.get(at)),
        all,
    ) {
        (_, 0) => (
            tr!("Both plans move all robots in the same way.").to_owned(),
            &[][..],
        ),
        (None, _) => (
            tr!("{n} difference, none yet." | "{n} differences, none yet." % all as u32),
            &[][..],
        ),
        (Some(it), _) => (
            tr!(
                "Difference {number} of {all} at time {time}:",
                number = passed,
                all,
                time = it.time
            ),
            it.agents.as_slice(),
        ),
    };
    let name = |&agent: &usize| Some((agent, this.agents().get(agent)?.name.clone()));
    Some(Steps {
        text,
        agents: agents.iter().filter_map(name).collect(),
        has_previous: next(state, false).is_some(),
        has_next: next(state, true).is_some(),
    })
}

/// The lanes that matter while two plans are compared: the robot that was asked about, then those
/// that differ, who loses most first. `None` where all lanes are shown.
pub fn lanes(state: &State) -> Option<Vec<String>> {
    if state.view.lanes == ComparedLanes::All {
        return None;
    }
    let (this, other) = state.compared()?;
    let differences = state.differences();
    if differences.is_empty() {
        return None;
    }
    let asked = state.document.mode.asking();
    let asked = asked.and_then(|asking| asking.question().agent());
    let mut agents: Vec<usize> = differences.into_iter().flat_map(|it| it.agents).collect();
    agents.sort_unstable();
    let arrival = |answer: &Answer, name: &str| {
        let at = answer.agents().iter().position(|it| it.name == name);
        at.and_then(|at| answer.arrivals.get(at).copied().flatten())
    };
    let mut names: Vec<&str> = agents
        .iter()
        .filter_map(|&agent| this.agents().get(agent))
        .map(|agent| agent.name.as_str())
        .collect();
    sort_by_key(&mut names, |name| {
        let before = arrival(this, name).map_or(0, i64::from);
        let after = arrival(other, name).map_or(0, i64::from);
        (Some(*name) != asked, Reverse(after - before))
    });
    Some(names.into_iter().map(str::to_owned).collect())
}

/// Whose ways ahead are drawn: of two plans those of the robots that differ; of an answer those of
/// the robot asked about and of those that differ, or of the one that is lit up. `None` draws all.
pub fn ahead(state: &State) -> Option<Vec<usize>> {
    let agents = state.world().agents();
    let index = |name: &str| agents.iter().position(|agent| agent.name == name);
    let Some(asking) = state.document.mode.asking() else {
        let Some((this, _)) = state.compared() else {
            return crate::audit::ahead(state);
        };
        let differ = state.differences().into_iter().flat_map(|it| it.agents);
        let names = differ.filter_map(|agent| Some(this.agents().get(agent)?.name.as_str()));
        return Some(names.filter_map(index).collect());
    };
    if let Some(Lit::Robot(agent)) = asking.lit {
        return Some(vec![agent]);
    }
    let pays = asking.pays();
    if pays.is_empty() {
        return None;
    }
    let names = pays.iter().map(|it| it.agent.as_str());
    let names = names.chain(asking.question().agent());
    Some(names.filter_map(index).collect())
}

/// How many robots drive the same in both plans, where some do and some do not.
pub fn same(state: &State) -> Option<u32> {
    let (this, _) = state.compared()?;
    let differ: usize = state.differences().iter().map(|it| it.agents.len()).sum();
    let same = this.agents().len().saturating_sub(differ) as u32;
    (differ > 0 && same > 0).then_some(same)
}

/// The title of the plan on the board, beside another one.
pub fn title(state: &State) -> String {
    let mode = &state.document.mode;
    if mode.steering().is_some() {
        return tr!("Your plan").to_owned();
    }
    match mode.audit() {
        Some(audit) => dropped(&audit.plan),
        None if state.plan_without().is_some() => tr!("With the rule").to_owned(),
        None => tr!("This plan").to_owned(),
    }
}

/// The title of the plan beside it.
pub fn other_title(state: &State) -> String {
    let beside = state.beside();
    if let Some(without) = state.plan_without()
        && beside.is_some_and(|it| Rc::ptr_eq(it, &without.answer))
    {
        return tr!("Without the rule").to_owned();
    }
    if let Some(name) = crate::ask::other_name(state) {
        return tr!("The other plan: {which}", which = name);
    }
    let audit = state.document.mode.audit();
    let mut plans = audit.into_iter().flat_map(|audit| audit.plans.iter());
    let is_it = |plan: &&Rc<Dropped>| beside.is_some_and(|it| Rc::ptr_eq(it, &plan.answer));
    plans
        .find(is_it)
        .map_or_else(|| tr!("Other plan").to_owned(), |plan| dropped(plan))
}

/// A plan of elsewhere is called by its file; that it breaks a rule is said with it.
fn dropped(plan: &Dropped) -> String {
    let file = &plan.file.file;
    if plan.is_legal() {
        file.clone()
    } else {
        tr!("{file}, not legal", file)
    }
}
