//! What the worker is to do, and how far it has come.

mod about;

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::{Cost, Costs, Plan, Question};
use giveway_solve::change::ChangeRequest;
use giveway_solve::delays::DelaysRequest;
use giveway_solve::explain::ExplainRequest;
use giveway_solve::freedom::FreedomRequest;
use giveway_solve::order::OrderRequest;
use giveway_solve::plan::{PlanRequest, Planner};
use giveway_solve::sizing::SizingRequest;
use giveway_solve::trace::SearchTrace;
use giveway_solve::{CertifyRequest, Request, SolveRequest, price::PriceRequest};

use crate::certificate::Exporting;
use crate::changing::Changing;
use crate::inside::Looking;
use crate::{Answer, Document, Draft};

/// What runs in the worker: at most one job. No two jobs ever have the same
/// number, so what a job still tells when it is over is known by its number.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Work {
    job: Option<Job>,
    started: u64,
}

/// One thing that runs in the worker.
#[derive(Clone, Debug, PartialEq)]
pub struct Job {
    /// Its number, from 1.
    pub id: u64,
    /// What is to be done, and how far it has come.
    pub task: Task,
}

/// What is to be done.
#[derive(Clone, Debug, PartialEq)]
pub enum Task {
    /// The scene is solved.
    Solve(Solving),
    /// A question is answered; what is known stands in the document.
    Explain(Rc<ExplainRequest>),
    /// What was answered is proved again and checked.
    Certify(Certifying),
    /// What was answered is made into files that anyone can check.
    Export(Exporting),
    /// Ways to go on are looked for where the world changes.
    Change(Adapting),
    /// A planner is looked into.
    Look(Looking),
    /// What all best plans share is looked for; what is known stands in the document.
    Freedom(Rc<FreedomRequest>),
    /// What each rule costs is looked for; what is known stands beside the document.
    Price(Rc<Draft>, Rc<PriceRequest>),
    /// Who costs whom is added up; what is known stands in the document.
    Delays(Rc<DelaysRequest>),
    /// The order of the plan is made; what is known stands in the document.
    Order(Rc<OrderRequest>),
    /// More and more robots are solved; what is known stands beside the document.
    Sizing(Rc<SizingRequest>),
}

/// A scene on its way to an answer, and what is known so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Solving {
    /// The draft that is solved.
    pub draft: Rc<Draft>,
    /// The request.
    pub request: Rc<SolveRequest>,
    /// The planner of the textbook that plans; `None`: the search for the best plan.
    pub planner: Option<Planner>,
    /// What was known when it began, if it goes on from there.
    pub from: Option<Rc<Answer>>,
    /// The proved lower bound of each cost reached so far.
    pub bounds: BTreeMap<Cost, u32>,
    /// The costs of the best plan so far.
    pub best: Option<Costs>,
    /// That plan.
    pub plan: Option<Rc<Plan>>,
    /// What it told of its steps so far.
    pub trace: Option<Rc<SearchTrace>>,
    /// The plan that the board shows while the search goes on; a better one may be
    /// known.
    pub preview: Option<Rc<Answer>>,
    /// How large the formula is.
    pub size: Size,
    /// The question to ask about the plan once there is one.
    pub then: Option<Question>,
    /// How the answer comes into the document.
    pub arrival: Arrival,
}

/// How an answer comes into the document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrival {
    /// A person asked for it: undo takes it back.
    Step,
    /// It belongs to the step before: to an edit, to a scene that was opened.
    Quiet,
}

/// A search for ways to go on.
#[derive(Clone, Debug, PartialEq)]
pub struct Adapting {
    /// What changes.
    pub changing: Rc<Changing>,
    /// The request.
    pub request: Rc<ChangeRequest>,
    /// How large the formula is that is worked on.
    pub size: Size,
}

/// The check of a proof on its way.
#[derive(Clone, Debug, PartialEq)]
pub struct Certifying {
    /// The request.
    pub request: Rc<CertifyRequest>,
    /// What is certified.
    pub about: Certifies,
    /// The claim that it has come to, and whether its proof is being checked.
    pub at: Option<(String, bool)>,
}

/// What is certified.
#[derive(Clone, Debug, PartialEq)]
pub enum Certifies {
    /// The plan, or that there is none.
    Answer(Rc<Answer>),
    /// The answer to a question.
    Question(Rc<ExplainRequest>),
    /// What all best plans share.
    Freedom(Rc<FreedomRequest>),
}

/// How large a formula is, and how far its solution.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Size {
    /// SAT variables.
    pub variables: u64,
    /// Clauses.
    pub clauses: u64,
    /// Conflicts met.
    pub conflicts: u64,
}

impl Work {
    /// What is to be done, if there is anything.
    pub fn task(&self) -> Option<&Task> {
        self.job.as_ref().map(|job| &job.task)
    }

    /// What is to be done, if the job of this number is not over.
    pub(crate) fn task_mut(&mut self, id: u64) -> Option<&mut Task> {
        let job = self.job.as_mut().filter(|job| job.id == id)?;
        Some(&mut job.task)
    }

    /// The number of the job, if there is one.
    pub fn id(&self) -> Option<u64> {
        self.job.as_ref().map(|job| job.id)
    }

    /// Whether nothing runs.
    pub const fn is_idle(&self) -> bool {
        self.job.is_none()
    }

    /// What the worker is to be asked, with the number of the job.
    pub fn request(&self) -> Option<(u64, Request)> {
        let job = self.job.as_ref()?;
        Some((job.id, job.task.request()))
    }

    /// The solve that runs, if one does.
    pub fn solving(&self) -> Option<&Solving> {
        match self.task()? {
            Task::Solve(solving) => Some(solving),
            _ => None,
        }
    }

    /// The solve that runs, to take in what it tells.
    pub(crate) fn solving_mut(&mut self) -> Option<&mut Solving> {
        match &mut self.job.as_mut()?.task {
            Task::Solve(solving) => Some(solving),
            _ => None,
        }
    }

    /// A person asks for what runs already: its answer is a step of its own then.
    /// `false` where nothing is solved.
    pub(crate) fn ask_for(&mut self) -> bool {
        let run = self.solving_mut();
        let runs = run.map(|run| run.arrival = Arrival::Step);
        runs.is_some()
    }

    /// Starts a task in the place of what ran.
    pub(crate) fn start(&mut self, task: Task) {
        self.started += 1;
        self.job = Some(Job {
            id: self.started,
            task,
        });
    }

    /// Ends what runs: what it still tells is not heard.
    pub(crate) fn end(&mut self) -> Option<Task> {
        self.job.take().map(|job| job.task)
    }

    /// Ends what is about something that the document no longer holds.
    pub(crate) fn keep_to(&mut self, document: &Document) {
        let is_about = |job: &Job| job.task.is_about(document);
        self.job = self.job.take().filter(is_about);
    }
}

impl Solving {
    fn request(&self) -> Request {
        let request = &*self.request;
        match self.planner {
            None => Request::Solve(request.clone()),
            Some(planner) => Request::Plan(PlanRequest {
                within: request.within,
                limits: request.limits,
                ..PlanRequest::new(request.scene.clone(), planner)
            }),
        }
    }
}

impl Task {
    fn request(&self) -> Request {
        match self {
            Self::Solve(run) => run.request(),
            Self::Explain(request) => Request::Explain((**request).clone()),
            Self::Certify(run) => Request::Certify((*run.request).clone()),
            Self::Export(run) => Request::Export((*run.request).clone()),
            Self::Change(run) => Request::Change((*run.request).clone()),
            Self::Look(looking) => looking.request(),
            Self::Freedom(request) => Request::Freedom((**request).clone()),
            Self::Price(_, request) => Request::Price((**request).clone()),
            Self::Delays(request) => Request::Delays((**request).clone()),
            Self::Order(request) => Request::Order((**request).clone()),
            Self::Sizing(request) => Request::Sizing((**request).clone()),
        }
    }
}
