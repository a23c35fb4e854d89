//! The state of the page.

use std::rc::Rc;

use giveway_model::{Agent, Cell, Plan, Question};
use giveway_proof::Report;

use crate::changing::Changing;
use crate::course::World;
use crate::front::Front;
use crate::link::Linked;
use crate::steering::Steering;
use crate::things::{Hold, Thing, fresh_name};
use crate::{Answer, Asking, Draft, Fill, History, Playback, Settings, Tool, View, Work};

/// All that the page shows. Plain data: two equal states look the same.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// The scene on the board.
    pub draft: Rc<Draft>,
    /// The last answer; it may be of another draft, see [`State::is_stale`].
    pub answer: Option<Rc<Answer>>,
    /// The Pareto front that was found last; it may be of another draft, see
    /// [`State::front()`].
    pub(crate) front: Option<Rc<Front>>,
    /// The question that was asked last, until it is left.
    pub asking: Option<Rc<Asking>>,
    /// A question that came without a plan, and the run that may find one.
    pub(crate) wanted: Option<(u64, Question)>,
    /// What changes in the world while the plan runs, until that is adopted or
    /// left.
    pub changing: Option<Rc<Changing>>,
    /// The plan of one's own in which agents are led by hand, until it is left.
    pub steering: Option<Rc<Steering>>,
    /// What came of checking the proof of an answer; it may be of another answer,
    /// see [`State::report`].
    pub(crate) checked: Option<(Rc<Answer>, Rc<Report>)>,
    /// What the solver does.
    pub work: Work,
    /// Undo and redo.
    pub history: History,
    /// The stroke that is not finished.
    pub(crate) stroke: Option<Stroke>,
    /// The agent that is being placed.
    pub placing: Option<Placing>,
    /// What the pointer does on the board.
    pub tool: Tool,
    /// The cell of the keyboard on the board.
    pub cursor: Cell,
    /// What the inspector tells of.
    pub selection: Selection,
    /// The time shown.
    pub playback: Playback,
    /// What the solver is told.
    pub settings: Settings,
    /// What is strewn by chance next time.
    pub fill: Fill,
    /// What is shown and how.
    pub view: View,
    /// What a person must be told once.
    pub notice: Option<Notice>,
    /// The runs of the solver so far: no two have the same number.
    pub(crate) runs: u64,
}

/// A stroke on its way over the board.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stroke {
    pub(crate) hold: Hold,
    /// The cell that it began on.
    pub(crate) from: Cell,
    /// The cell that it came to last.
    pub(crate) at: Cell,
    /// Whether it ever left its first cell.
    pub(crate) has_left: bool,
    /// The draft before it: one stroke is one step of undo.
    pub(crate) before: Rc<Draft>,
}

/// An agent on its way onto the board: its start is chosen, its goal not yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placing {
    /// Where it will start.
    pub start: Cell,
    /// Where the pointer or the keyboard is: its goal, as far as known.
    pub goal: Cell,
    /// Whether the pointer is down.
    pub is_held: bool,
    /// Whether the goal was pressed by itself: then it may be the start, too.
    pub(crate) is_second: bool,
}

/// What the inspector tells of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Selection {
    /// The plan as a whole.
    #[default]
    Nothing,
    /// An agent, by its index in the scene.
    Agent(usize),
    /// A cell.
    Cell(Cell),
}

/// What a person must be told: something was refused, or failed and was mended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// One sentence: what happened.
    pub sentence: String,
    /// More lines: places and reasons.
    pub details: Vec<String>,
}

impl State {
    /// A page that shows a draft and nothing else yet.
    ///
    /// ```
    /// use giveway_model::Scene;
    /// use giveway_page::{Draft, Phase, State};
    /// let scene = Scene { map: vec!["..".into()], ..Scene::default() };
    /// let state = State::new(Draft::new(scene).unwrap());
    /// assert_eq!(state.phase(), Phase::Editing);
    /// ```
    pub fn new(draft: Draft) -> Self {
        Self {
            draft: Rc::new(draft),
            answer: None,
            front: None,
            asking: None,
            wanted: None,
            changing: None,
            steering: None,
            checked: None,
            work: Work::Idle,
            history: History::default(),
            stroke: None,
            placing: None,
            tool: Tool::Select,
            cursor: Cell::new(0, 0),
            selection: Selection::Nothing,
            playback: Playback::default(),
            settings: Settings::default(),
            fill: Fill::default(),
            view: View::default(),
            notice: None,
            runs: 0,
        }
    }

    /// The page as the browser kept it.
    pub fn restored(linked: Linked) -> Self {
        let draft = Draft::clone(&linked.draft);
        let mut state = Self {
            answer: linked.answer,
            ..Self::new(draft)
        };
        state.draft = linked.draft;
        state.changing = linked.changing;
        state.steering = linked.steering;
        state.playback.time = match (&state.changing, &state.steering) {
            (Some(changing), _) => changing.at,
            (None, Some(steering)) => steering.time(),
            (None, None) => linked.time,
        };
        if let Some(steering) = &state.steering {
            state.selection = Selection::Agent(steering.agent);
        }
        state
    }

    /// Whether the answer is of another draft than the one on the board.
    pub fn is_stale(&self) -> bool {
        self.answer
            .as_ref()
            .is_some_and(|answer| !same(&answer.draft, &self.draft))
    }

    /// The answer, where it is of the draft on the board.
    pub fn fresh_answer(&self) -> Option<&Answer> {
        self.answer.as_deref().filter(|_| !self.is_stale())
    }

    /// What came of checking the proof of the answer, if that was done.
    pub fn report(&self) -> Option<&Report> {
        let (answer, report) = self.checked.as_ref()?;
        let is_of = self.answer.as_ref().is_some_and(|a| Rc::ptr_eq(a, answer));
        is_of.then_some(report)
    }

    /// The answer that is shown: the last one, or a plan of one's own; the other
    /// plan of a question where that takes its place; the one that is previewed
    /// where the world changes.
    pub fn shown(&self) -> Option<&Rc<Answer>> {
        if let Some(changing) = &self.changing {
            return Some(changing.shown());
        }
        let asking = self.asking.as_deref().filter(|asking| asking.shows_other);
        let asking = asking.filter(|_| !self.view.is_wide);
        let other = asking.and_then(|asking| asking.other.as_ref());
        other.or(self.own_answer())
    }

    /// The plan of one's own, where there is one; else the last answer.
    fn own_answer(&self) -> Option<&Rc<Answer>> {
        let own = self.steering.as_deref().map(|steering| &steering.answer);
        own.or(self.answer.as_ref())
    }

    /// The answer that is shown beside that one: the other plan of a question,
    /// where there is room for it.
    pub fn beside(&self) -> Option<&Rc<Answer>> {
        let has_room = self.view.is_wide && self.changing.is_none();
        let asking = self.asking.as_deref().filter(|_| has_room);
        asking.and_then(|asking| asking.other.as_ref())
    }

    /// The plan that is shown, stale or not.
    pub fn plan(&self) -> Option<&Plan> {
        self.shown()?.plan()
    }

    /// The last time that can be shown, in steps.
    pub fn last_time(&self) -> u32 {
        if let Some(changing) = &self.changing {
            return changing.last_time();
        }
        let both = self.shown().into_iter().chain(self.beside());
        let led = self.steering.as_deref().map(Steering::time);
        let ends = both.map(|answer| answer.makespan()).chain(led);
        ends.max().unwrap_or(0)
    }

    /// The agent that is shown on a cell at the time shown: where the plan has
    /// it then (in transit it is on both cells), or at its start without a plan.
    pub fn agent_at(&self, cell: Cell) -> Option<usize> {
        let draft = self.world();
        let is_on = |(index, agent): (usize, &Agent)| {
            if !self.is_there(index) {
                return false;
            }
            let (name, start) = (agent.name.as_str(), agent.start);
            let plan = self
                .shown()
                .filter(|answer| answer.agent(draft, index).is_some());
            let plan = plan.and_then(|answer| answer.plan());
            let path = plan.map_or(&[][..], |plan| plan.path(name));
            let from = plan.and_then(|plan| plan.from.get(name)).copied();
            let time = self.playback.time.saturating_sub(from.unwrap_or(0)) as usize;
            match path.get(time) {
                None => path.last().copied().flatten().unwrap_or(start) == cell,
                Some(Some(at)) => *at == cell,
                Some(None) => [time.wrapping_sub(1), time + 1]
                    .iter()
                    .any(|&t| path.get(t) == Some(&Some(cell))),
            }
        };
        let mut agents = draft.agents().iter().enumerate();
        agents.position(is_on)
    }

    /// The scene as the world has it at the time shown: the draft, but where the
    /// world changes or has changed. Its agents are all that there ever are.
    pub fn world(&self) -> &Rc<Draft> {
        self.changed().map_or(&self.draft, |world| &world.draft)
    }

    /// Whether an agent of [`State::world`] is there at the time shown.
    pub fn is_there(&self, agent: usize) -> bool {
        match self.changed() {
            Some(world) => world.is_there.get(agent).copied().unwrap_or(false),
            None => agent < self.draft.agents().len(),
        }
    }

    /// The world at the time shown, where it is another than the draft.
    fn changed(&self) -> Option<&World> {
        let time = self.playback.time;
        match &self.changing {
            Some(changing) => changing.world_at(time),
            None => self.fresh_answer()?.world(time),
        }
    }

    /// Whether the world could change at the time shown: there is a plan, and
    /// nothing has changed then or later yet.
    pub fn can_change(&self) -> bool {
        let answer = self.fresh_answer().filter(|answer| answer.plan().is_some());
        let is_later = |answer: &Answer| {
            let last = answer.changed_last();
            last.is_none_or(|last| self.playback.time > last)
        };
        self.changing.is_none() && self.steering.is_none() && answer.is_some_and(is_later)
    }

    /// The agent that could be led by hand from the time shown: the one that is
    /// selected, where there is a plan of the scene in one world.
    pub fn can_steer(&self) -> Option<usize> {
        let agent = self.selected_agent().filter(|_| self.changing.is_none())?;
        let time = self.playback.time;
        let can = match (&self.steering, &self.answer) {
            (Some(own), _) => own.agent != agent || time < own.time(),
            (None, Some(answer)) => !self.is_stale() && Steering::can_begin(answer, agent, time),
            (None, None) => false,
        };
        can.then_some(agent)
    }

    /// The agent that is selected, by its index in the scene.
    pub const fn selected_agent(&self) -> Option<usize> {
        match self.selection {
            Selection::Agent(agent) => Some(agent),
            Selection::Nothing | Selection::Cell(_) => None,
        }
    }

    /// The agent that the camera goes with, by its index in the scene.
    pub fn followed(&self) -> Option<usize> {
        self.selected_agent().filter(|_| self.view.follow)
    }

    /// The name that the next agent gets.
    pub fn next_name(&self) -> String {
        match &self.changing {
            Some(changing) => changing.fresh_name(),
            None => fresh_name(self.draft.scene()),
        }
    }

    /// Whether there is something on a cell that the tool `Select` moves.
    pub fn can_move(&self, cell: Cell) -> bool {
        if self.steering.is_some() {
            return false;
        }
        match self.changing.as_deref() {
            Some(changing) => crate::reduce::can_hold(self, changing, cell),
            None => self.thing_at(cell).is_some(),
        }
    }

    /// What the tool `Select` takes hold of on a cell.
    pub(crate) fn thing_at(&self, cell: Cell) -> Option<Thing> {
        // What the scene is made of can only be moved where it is shown.
        let is_it = |world: &Rc<Draft>| world.scene().map == self.draft.scene().map;
        if !is_it(self.world()) {
            return None;
        }
        let scene = self.draft.scene();
        let standing = self.agent_at(cell);
        let is_start = |agent: &Agent| agent.start == cell;
        let starts = standing.filter(|&agent| scene.agents.get(agent).is_some_and(is_start));
        let start = starts.map(Thing::Start);
        start.or_else(|| Thing::lying(scene, cell, self.selected_agent()))
    }
}

/// Whether two drafts are equal; the usual case, one draft twice, takes no time.
fn same(a: &Rc<Draft>, b: &Rc<Draft>) -> bool {
    Rc::ptr_eq(a, b) || a == b
}
