//! What was asked, what is known of it, and it as a table.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Scene, Version, tr};
use giveway_solve::sizing::{SizingAnswer, SizingFloor, SizingPoint, SizingRequest, csv};
use giveway_solve::{Limits, SolveAnswer, SolveRequest, Stats};

use super::{Said, floor};
use crate::{Answer, Draft, State};

/// A request about the floor of a draft, and what is known.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SizingRun {
    /// The draft whose floor it is.
    pub(crate) draft: Rc<Draft>,
    /// What was said.
    pub(crate) said: Said,
    /// What the solver was asked.
    pub(crate) request: Rc<SizingRequest>,
    /// What is known so far.
    pub(crate) answer: SizingAnswer,
}

impl SizingRun {
    /// A request; `None` where there is no room for a robot, or the floor has a fault.
    pub(crate) fn begin(state: &State, said: &Said) -> Option<Self> {
        let draft = Rc::clone(&state.own_document().draft);
        let counts = said.counts(&draft);
        let bare = floor(&draft);
        let agents = said.fleet.mixed(draft.grid());
        let peopled = |floor: Scene| Scene {
            agents: agents.clone(),
            ..floor
        };
        // A rule is named by its number in the scene of the draft.
        let beside = said.beside.map(|beside| {
            let mut scene = beside.of(draft.scene().clone())?;
            scene
                .constraints
                .retain(|rule| rule.named_agents().next().is_none());
            Some(peopled(scene))
        });
        let beside = match beside {
            None => None,
            Some(scene) => Some(scene?),
        };
        let scene = peopled(bare);
        giveway_model::Instance::new(scene.clone()).ok()?;
        let floors = if beside.is_some() { 2 } else { 1 };
        let pending = u32::try_from(counts.len() * floors).unwrap_or(u32::MAX);
        let objective = scene.objective.clone();
        let request = SizingRequest {
            scene,
            beside,
            counts,
            objective: None,
            within: state.own_document().within,
            limits: Limits {
                seconds: Some(f64::from(said.seconds)),
                ..Limits::default()
            },
        };
        (pending > 0).then(|| Self {
            draft,
            said: said.clone(),
            request: Rc::new(request),
            answer: SizingAnswer {
                giveway: Version,
                objective,
                points: Vec::new(),
                beside: Vec::new(),
                pending,
                words: String::new(),
                stats: Stats::default(),
            },
        })
    }

    /// Whether it is about the floor of a draft.
    pub(crate) fn is_of(&self, draft: &Rc<Draft>) -> bool {
        Rc::ptr_eq(&self.draft, draft) || self.draft == *draft
    }

    /// One more plan is there.
    pub(crate) fn learn(&mut self, floor: SizingFloor, point: SizingPoint, pending: u32) {
        match floor {
            SizingFloor::This => self.answer.points.push(point),
            SizingFloor::Beside => self.answer.beside.push(point),
        }
        self.answer.pending = pending;
    }

    /// How many plans there are in all.
    pub(crate) fn all(&self) -> usize {
        let floors = if self.request.beside.is_some() { 2 } else { 1 };
        self.request.counts.len() * floors
    }

    /// How many of them are known.
    pub(crate) fn known(&self) -> usize {
        self.answer.points.len() + self.answer.beside.len()
    }

    /// The scene with the robots of a plan, by its place.
    pub(crate) fn scene(&self, place: usize) -> Option<Scene> {
        let point = self.answer.points.get(place)?;
        let mut scene = self.request.scene.clone();
        scene.agents.truncate(point.robots as usize);
        Some(scene)
    }

    /// The plan of a number of robots as an answer about its own scene.
    pub(crate) fn answered(&self, place: usize) -> Option<Rc<Answer>> {
        let point = self.answer.points.get(place)?;
        point.plan.as_ref()?;
        let scene = self.scene(place)?;
        let request = SolveRequest {
            scene: scene.clone(),
            within: self.request.within,
            limits: self.request.limits,
            ..SolveRequest::default()
        };
        let solved = SolveAnswer {
            giveway: Version,
            status: point.status,
            costs: point.costs,
            bounds: point
                .bounds
                .iter()
                .map(|(&cost, &n)| (cost, n))
                .collect::<BTreeMap<_, _>>(),
            reach: point.reach,
            ended: None,
            reason: point.reason.clone(),
            plan: point.plan.clone(),
            stats: Stats::default(),
            trace: None,
        };
        let draft = Rc::new(Draft::new(scene).ok()?);
        Some(Rc::new(Answer::new(draft, Rc::new(request), solved)))
    }
}

/// What is known as a table for spreadsheets; nothing before there is anything.
pub fn table(state: &State) -> Option<String> {
    let run = state.sizing().filter(|run| run.known() > 0)?;
    let beside = super::card::beside_words(&run.draft, run.said.beside).unwrap_or_default();
    Some(csv(&run.answer, (tr!("this floor"), &beside)))
}
