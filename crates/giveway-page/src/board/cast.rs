//! Who is on the board, with all that moves.

use std::rc::Rc;

use giveway_model::Agent;

use super::{Mark, Track, Way, marks};
use crate::{Answer, Draft, State};
use giveway_model::sorting::sort;

/// The agents of a draft and what they do by the plan shown, if any.
#[derive(Clone, Debug)]
pub struct Cast {
    /// The agents, in the order of the scene.
    pub agents: Vec<Agent>,
    /// What each does.
    pub tracks: Vec<Track>,
    /// The way of each.
    pub ways: Vec<Way>,
    /// Goals and waypoints.
    pub marks: Vec<Mark>,
    /// The answer that holds the plan.
    answer: Option<Rc<Answer>>,
}

impl PartialEq for Cast {
    /// A plan is compared by the answer that it came with.
    fn eq(&self, other: &Self) -> bool {
        self.agents == other.agents && same(self.answer.as_ref(), other.answer.as_ref())
    }
}

fn same(one: Option<&Rc<Answer>>, other: Option<&Rc<Answer>>) -> bool {
    match (one, other) {
        (None, None) => true,
        (Some(one), Some(other)) => Rc::ptr_eq(one, other),
        _ => false,
    }
}

impl Cast {
    /// The cast of a state.
    pub fn of(state: &State) -> Self {
        let answer = state.shown();
        let answer = answer.filter(|answer| answer.plan().is_some() && fits(answer, &state.draft));
        let agents = state.draft.agents().to_vec();
        let at_goal = state.draft.scene().rules.at_goal;
        let track = |(index, agent): (usize, &Agent)| {
            let solved = answer.and_then(|answer| answer.agent(&state.draft, index));
            let plan = answer.filter(|_| solved.is_some());
            let plan = plan.and_then(|answer| answer.plan());
            let mut path = plan.map_or_else(Vec::new, |plan| plan.path(&agent.name).to_vec());
            let mut charges = plan.map_or_else(Vec::new, |plan| plan.charges(&agent.name).to_vec());
            sort(&mut charges);
            if path.is_empty() {
                path.push(Some(agent.start));
            }
            let battery = agent.battery.map(|battery| {
                let levels = answer.zip(solved);
                let levels = levels.and_then(|(answer, index)| answer.levels.get(index));
                let levels = levels.filter(|levels| !levels.is_empty()).cloned();
                let initial = || vec![i64::from(battery.initial)];
                (levels.unwrap_or_else(initial), battery.capacity)
            });
            Track::new(path, charges, battery, at_goal)
        };
        let tracks: Vec<Track> = agents.iter().enumerate().map(track).collect();
        Self {
            ways: Way::of_all(&tracks),
            marks: marks(&agents, &tracks),
            tracks,
            agents,
            answer: answer.cloned(),
        }
    }

    /// Whether this is still the cast of a state.
    pub fn is_of(&self, state: &State) -> bool {
        let answer = state.shown();
        let answer = answer.filter(|answer| answer.plan().is_some() && fits(answer, &state.draft));
        self.agents == state.draft.agents() && same(self.answer.as_ref(), answer)
    }

    /// Whether there is a plan to show.
    pub const fn has_plan(&self) -> bool {
        self.answer.is_some()
    }
}

/// Whether a plan can be drawn on a draft: it may be stale, but not of a map of
/// another size, or of other agents altogether.
fn fits(answer: &Answer, draft: &Draft) -> bool {
    let size = |draft: &Draft| (draft.grid().width(), draft.grid().height());
    let mut agents = 0..draft.agents().len();
    size(&answer.draft) == size(draft)
        && (agents.is_empty() || agents.any(|agent| answer.agent(draft, agent).is_some()))
}
