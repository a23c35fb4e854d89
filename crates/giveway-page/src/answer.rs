//! An answer of the solver, with the draft that it answers.

use std::rc::Rc;

use giveway_model::change::{Changes, Trajectory};
use giveway_model::{Agent, Fault, Plan, check};
use giveway_solve::plan::Planner;
use giveway_solve::{Ended, ProvedBest, Reach, SolveAnswer, SolveRequest, Status};

use crate::Draft;
use crate::course::{Adopted, Course, World};

/// An answer, and what the page derives from it once.
#[derive(Clone, Debug, PartialEq)]
pub struct Answer {
    /// The draft that was solved.
    pub draft: Rc<Draft>,
    /// The request.
    pub request: Rc<SolveRequest>,
    /// What the solver said.
    pub solved: SolveAnswer,
    /// The battery level of each agent at each time up to its arrival; empty
    /// for agents without a battery, and without a plan.
    pub levels: Vec<Vec<i64>>,
    /// When each agent arrives; `None` without a plan, and for one that is removed.
    pub arrivals: Vec<Option<u32>>,
    /// What changed while the plan ran, where something did.
    pub course: Option<Rc<Course>>,
    /// Whether the plan came from elsewhere and nothing was proved of it here.
    pub is_shared: bool,
    /// The planner of the textbook whose plan it is; `None` where it is of the search
    /// for the best plan, or from elsewhere.
    pub by: Option<Planner>,
    /// How far bounds of a search on this page prove that none is better, where the plan came
    /// from an answer about that search's plan.
    pub(crate) proved_by_bounds: Option<Reach>,
}

impl Answer {
    /// Takes an answer in.
    pub(crate) fn new(draft: Rc<Draft>, request: Rc<SolveRequest>, solved: SolveAnswer) -> Self {
        let count = draft.agents().len();
        let (mut levels, mut arrivals) = (vec![Vec::new(); count], vec![None; count]);
        if let (Ok(instance), Some(plan)) = (draft.instance(), &solved.plan) {
            arrivals = check::arrivals(instance, plan);
            for (agent, levels) in levels.iter_mut().enumerate() {
                if instance.agents()[agent].battery.is_some() {
                    *levels = check::levels(instance, agent, plan);
                }
            }
        }
        Self {
            draft,
            request,
            solved,
            levels,
            arrivals,
            course: None,
            is_shared: false,
            by: None,
            proved_by_bounds: None,
        }
    }

    /// Takes in a plan around which the world changed; the draft is the world
    /// before.
    ///
    /// # Errors
    /// The faults of changes that contradict the world as the plan has it.
    pub(crate) fn over_time(
        draft: Rc<Draft>,
        request: Rc<SolveRequest>,
        solved: SolveAnswer,
        changes: Changes,
        steps: Vec<Adopted>,
    ) -> Result<Self, Vec<Fault>> {
        let (Ok(instance), Some(plan)) = (draft.instance(), &solved.plan) else {
            return Ok(Self::new(draft, request, solved));
        };
        let course = Course::new(instance, draft.scene(), changes, steps, plan)?;
        let (mut levels, mut arrivals) = (Vec::new(), Vec::new());
        for timeline in course.history.timelines() {
            let trajectory = Trajectory::of(&course.history, timeline, plan);
            let is_there = |trajectory: &&Trajectory<'_>| !trajectory.is_removed();
            arrivals.push(trajectory.as_ref().filter(is_there).map(Trajectory::end));
            let own =
                |trajectory: &Trajectory<'_>| check::levels_over_time(&course.history, trajectory);
            levels.push(trajectory.as_ref().map_or_else(Vec::new, own));
        }
        Ok(Self {
            draft,
            request,
            solved,
            levels,
            arrivals,
            course: Some(Rc::new(course)),
            is_shared: false,
            by: None,
            proved_by_bounds: None,
        })
    }

    /// The agents of the plan: those of the scene, then those that joined, each at
    /// its index at all times.
    pub fn agents(&self) -> &[Agent] {
        let last = self
            .course
            .as_deref()
            .and_then(|course| course.worlds.last());
        last.map_or(self.draft.agents(), |world| world.draft.agents())
    }

    /// The world at a time, where it is another than the draft.
    pub fn world(&self, time: u32) -> Option<&World> {
        self.course.as_deref()?.world(time)
    }

    /// The time from which an agent is gone, where it was removed.
    pub fn removed(&self, agent: usize) -> Option<u32> {
        let timelines = self.course.as_deref()?.history.timelines();
        timelines.get(agent)?.until
    }

    /// The breakdowns of an agent: it begins no move from the first of each two times up to,
    /// not including, the second.
    pub fn breakdowns(&self, agent: usize) -> &[(u32, u32)] {
        let course = self.course.as_deref();
        let timeline = course.and_then(|course| course.history.timelines().get(agent));
        timeline.map_or(&[][..], |timeline| &timeline.held)
    }

    /// The last time at which the world changed.
    pub fn changed_last(&self) -> Option<u32> {
        self.course.as_deref()?.history.times().last()
    }

    /// The plan, where there is one.
    pub const fn plan(&self) -> Option<&Plan> {
        self.solved.plan.as_ref()
    }

    /// Whether a search for the best plan said what is claimed here. It did not say that of a
    /// plan from elsewhere, of another plan that a person took, or where a proof showed that
    /// another plan is better.
    pub fn is_searched(&self) -> bool {
        let solved = &self.solved;
        let was_stopped = solved.ended.is_some_and(|ended| ended != Ended::Proof);
        !self.is_shared && (solved.status != Status::Feasible || was_stopped)
    }

    /// How far the search for the best plan proved on this page that none is better: of its own plan
    /// in a world that does not change.
    pub(crate) fn proved_here(&self) -> Option<Reach> {
        let searched = self
            .has_own_search()
            .then_some(self.solved.reach)
            .or(self.proved_by_bounds);
        searched.filter(|_| self.solved.status == Status::Optimal)
    }

    /// The same, with what that proof leaves the robots.
    pub(crate) fn proved_best(&self) -> Option<ProvedBest> {
        let reach = self.proved_here()?;
        Some(if self.has_own_search() {
            ProvedBest::by_search(&self.solved)
        } else {
            reach.into()
        })
    }

    /// Whether it is of a search of this page for the best plan of a world that does not change.
    fn has_own_search(&self) -> bool {
        // What a link or the browser's store says is no proof: only a search of this page has a trace.
        self.is_searched()
            && self.by.is_none()
            && self.course.is_none()
            && self.solved.trace.is_some()
    }

    /// The index, in the draft that was solved, of an agent of another draft.
    /// `None` where the plan is no plan of it: it has another name or another task
    /// there, or its path leads through what is no way there.
    pub fn agent(&self, draft: &Draft, agent: usize) -> Option<usize> {
        if std::ptr::eq(Rc::as_ptr(&self.draft), draft) {
            return (agent < draft.agents().len()).then_some(agent);
        }
        let who = draft.agents().get(agent)?;
        if self.course.is_some() || draft.is_only_shown() {
            // Goals and waypoints of a world that changes are those of a time.
            let is = |other: &Agent| other.name == who.name && other.start == who.start;
            return self.agents().iter().position(is);
        }
        self.same(who).filter(|_| self.is_walkable(draft, who))
    }

    /// The index of an agent of the same name with the same task.
    fn same(&self, who: &Agent) -> Option<usize> {
        self.draft.agents().iter().position(|other| other == who)
    }

    /// Whether the path of an agent is a way on the map of another draft, of as
    /// many steps.
    fn is_walkable(&self, draft: &Draft, who: &Agent) -> bool {
        let path = self.plan().map_or(&[][..], |plan| plan.path(&who.name));
        let (mine, other) = (self.draft.grid(), draft.grid());
        let mut cells = path.iter().copied().flatten();
        cells.all(|cell| {
            other.is_vertex(cell)
                && other.is_slow(cell) == mine.is_slow(cell)
                && other.is_charger(cell) == mine.is_charger(cell)
        })
    }

    /// The indices of [`Answer::agent`], for all agents of a draft.
    pub(crate) fn agents_of(&self, draft: &Draft) -> Vec<Option<usize>> {
        let agents = 0..draft.agents().len();
        agents.map(|agent| self.agent(draft, agent)).collect()
    }

    /// The last time of the plan, in steps; 0 without one.
    pub fn makespan(&self) -> u32 {
        let makespan = self.solved.costs.map_or(0, |costs| costs.makespan);
        let Some(course) = self.course.as_deref() else {
            return makespan;
        };
        // Something may change, and somebody leave, when all others have arrived.
        let left = course.history.timelines().iter();
        let left = left
            .filter_map(|timeline| timeline.until)
            .max()
            .unwrap_or(0);
        makespan.max(left).max(self.changed_last().unwrap_or(0))
    }
}
