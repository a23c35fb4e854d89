//! What the methods made of the changes of a time.

use std::rc::Rc;

use giveway_model::{Cost, Costs};
use giveway_solve::SolveRequest;
use giveway_solve::change::{ChangeAnswer, Method, MethodAnswer};

use super::Changing;
use crate::Answer;
use crate::course::{Adopted, World};

/// What changes, with what each method made of it, side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparing {
    /// What changes.
    pub changing: Rc<Changing>,
    /// What was told of it.
    pub(crate) told: Rc<ChangeAnswer>,
    /// The costs of the plan before.
    pub before: Option<Costs>,
    /// The methods, in the order in which they were asked.
    pub tried: Vec<Tried>,
    /// The one that is previewed; `None` where none has a plan.
    pub chosen: Option<usize>,
}

/// What one method made of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Tried {
    /// The method.
    pub method: Method,
    /// Its answer.
    pub told: MethodAnswer,
    /// Its plan as the page shows plans, from time 0; `None` without one.
    pub answer: Option<Rc<Answer>>,
    /// Whether no other method has lower costs.
    pub is_least: bool,
}

impl Comparing {
    /// Takes an answer in; `None` where it is not about these changes.
    pub(crate) fn new(changing: &Rc<Changing>, told: ChangeAnswer) -> Option<Self> {
        if told.at != Some(changing.at) || !told.history.is_empty() {
            return None;
        }
        let costs = objective(changing);
        let value = |told: &MethodAnswer| -> Option<Vec<u32>> {
            let found = told.result.costs?;
            told.result.plan.as_ref()?;
            Some(costs.iter().map(|&cost| found.get(cost)).collect())
        };
        let least = told.methods.0.iter().filter_map(|(_, told)| value(told));
        let least = least.min();
        let before = told.before;
        // The other methods with the same plan.
        let also = |method: Method, of: &MethodAnswer| {
            let plan = of.result.plan.as_ref();
            let others = told.methods.0.iter().filter(|(other, told)| {
                *other != method && plan.is_some() && told.result.plan.as_ref() == plan
            });
            let mut others = others.map(|(other, _)| *other);
            [others.next(), others.next()]
        };
        let tried = |(method, told): (Method, MethodAnswer)| Tried {
            is_least: least.is_some() && value(&told) == least,
            answer: preview(changing, (method, also(method, &told)), before, &told),
            method,
            told,
        };
        let all = told.methods.0.iter().cloned();
        let tried: Vec<Tried> = all.map(tried).collect();
        // Of equally good plans the one that keeps closest to the old plan.
        let chosen = tried.iter().position(|tried| tried.is_least);
        Some(Self {
            changing: Rc::clone(changing),
            told: Rc::new(told),
            before,
            tried,
            chosen,
        })
    }

    /// The answer that is previewed.
    pub fn preview(&self) -> Option<&Rc<Answer>> {
        self.tried.get(self.chosen?)?.answer.as_ref()
    }

    /// The world at a time, where it is another than the draft.
    pub(crate) fn world_at(&self, time: u32) -> Option<&World> {
        match self.preview() {
            Some(preview) => preview.world(time),
            None => self.changing.world_at(time),
        }
    }
}

/// The costs by which methods are compared: the makespan always first.
pub(super) fn objective(changing: &Changing) -> Vec<Cost> {
    let request = &changing.about.request;
    let asked = request.objective.as_ref();
    let objective = asked.unwrap_or(&request.scene.objective);
    let others = objective.costs().iter().copied();
    let mut costs = vec![Cost::Makespan];
    costs.extend(others.filter(|&cost| cost != Cost::Makespan));
    costs
}

fn preview(
    changing: &Changing,
    (method, also): (Method, [Option<Method>; 2]),
    before: Option<Costs>,
    told: &MethodAnswer,
) -> Option<Rc<Answer>> {
    told.result.plan.as_ref()?;
    let about = &changing.about;
    let mut steps = about
        .course
        .as_deref()
        .map_or_else(Vec::new, |course| course.steps.clone());
    steps.push(Adopted {
        at: changing.at,
        method: Some(method),
        also,
        before,
        after: told.result.costs,
    });
    let (draft, request) = (Rc::clone(&about.draft), Rc::clone(&about.request));
    let request: Rc<SolveRequest> = request;
    let answer = Answer::over_time(
        draft,
        request,
        told.result.clone(),
        changing.changes(),
        steps,
    );
    // A plan that does not fit the changes is none.
    answer.ok().map(Rc::new)
}
