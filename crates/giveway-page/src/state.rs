//! The state of the page: a document, what runs in the worker, what is shown.

use std::rc::Rc;

use giveway_model::{Agent, Cell, Plan};

use crate::course::World;
use crate::edit::fresh_name;
use crate::gesture::{Canvas, Gesture, Placing, Stroke, Thing};
use crate::history::Moment;
use crate::steering::Steering;
use crate::{Answer, Document, Draft, History, Mode, Place, Selection, Settings, Task, View, Work};

/// All that the page shows. Plain data: two equal states look the same.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// All that a person made or got and would miss, with what is being done
    /// with it.
    pub document: Document,
    /// What runs in the worker.
    pub work: Work,
    /// What is shown of the document, and how.
    pub view: View,
    /// What a person set, for all scenes.
    pub settings: Settings,
    /// Undo and redo.
    pub history: History,
    /// The document that another one was opened in the place of, until it is
    /// edited: one press brings it back.
    pub displaced: Option<Displaced>,
}

/// A document that another one was opened in the place of.
#[derive(Clone, Debug, PartialEq)]
pub struct Displaced {
    /// That document.
    pub moment: Rc<Moment>,
    /// What took its place: a link, or what a person went back to.
    pub by: By,
}

/// What took the place of a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// The document of a link.
    Link,
    /// A person's own one, after they went back to it from that of a link.
    Own,
}

/// What a person must be told: something was refused, or failed and was mended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// One sentence: what happened.
    pub sentence: String,
    /// More lines: places and reasons.
    pub details: Vec<String>,
}

impl Notice {
    /// One sentence, and nothing more.
    pub(crate) fn new(sentence: impl Into<String>) -> Self {
        Self {
            sentence: sentence.into(),
            details: Vec::new(),
        }
    }
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
        Self::of(Document::new(draft))
    }

    /// A page that shows a document.
    pub fn of(document: Document) -> Self {
        Self {
            document,
            work: Work::default(),
            view: View::default(),
            settings: Settings::default(),
            history: History::default(),
            displaced: None,
        }
    }

    /// The page as it was left.
    pub(crate) fn resumed(moment: Moment, history: History) -> Self {
        let mut state = Self::of(moment.document);
        state.view.selection = moment.selection;
        state.view.playback.stop_at(moment.time);
        state.history = history;
        crate::reduce::settle(&mut state);
        state
    }

    /// The document, and where it is looked at.
    pub fn moment(&self) -> Moment {
        Moment {
            document: self.document.clone(),
            time: self.view.playback.time,
            selection: self.view.selection,
        }
    }

    /// Whether the page is inside another one.
    pub fn is_embedded(&self) -> bool {
        self.view.place == Place::Embedded
    }

    /// Whether more of an answer to the question is being looked for.
    pub fn is_looking(&self) -> bool {
        matches!(self.work.task(), Some(Task::Explain(_)))
    }

    /// The answer that is shown: the last one, or a plan of one's own; the other
    /// plan of a question where that takes its place; the one that is previewed
    /// where the world changes.
    pub fn shown(&self) -> Option<&Rc<Answer>> {
        self.document.shown(!self.view.is_wide)
    }

    /// The answer that is shown beside that one: the other plan of a question,
    /// where there is room for it.
    pub fn beside(&self) -> Option<&Rc<Answer>> {
        let asking = self.document.mode.asking()?;
        asking.other.as_ref().filter(|_| self.view.is_wide)
    }

    /// The plan that is shown, stale or not.
    pub fn plan(&self) -> Option<&Plan> {
        self.shown()?.plan()
    }

    /// The plan that plays: the one that is shown, where anybody who is on the board
    /// has a part in it.
    pub fn playing(&self) -> Option<&Rc<Answer>> {
        let answer = self.shown()?;
        answer.plan()?;
        let draft = &self.document.draft;
        let mut agents = 0..draft.agents().len();
        let has_part = answer.course.is_some()
            || answer.agents().is_empty()
            || agents.any(|agent| answer.agent(draft, agent).is_some());
        has_part.then_some(answer)
    }

    /// The last time that can be shown, in steps.
    pub fn last_time(&self) -> u32 {
        let mode = &self.document.mode;
        match mode {
            Mode::Changing(changing) => return changing.at,
            Mode::Comparing(comparing) | Mode::Stuck(comparing, _) => {
                let preview = comparing.preview();
                return preview.map_or(comparing.changing.at, |answer| answer.makespan());
            }
            _ => {}
        }
        let both = self.playing().into_iter().chain(self.beside());
        let led = mode.steering().map(|own| Steering::time(own));
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
            let time = self.view.playback.time.saturating_sub(from.unwrap_or(0)) as usize;
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

    /// The scene as the board shows it: with the stroke that is not finished,
    /// and as the world has it at the time shown. Its agents are all that there
    /// ever are.
    pub fn world(&self) -> &Rc<Draft> {
        match self.stroke().map(|stroke| &stroke.canvas) {
            Some(Canvas::Scene { shown, .. }) => shown,
            Some(Canvas::World { after, .. }) => after.draft(),
            None => self
                .changed()
                .map_or(&self.document.draft, |world| &world.draft),
        }
    }

    /// Whether an agent of [`State::world`] is there at the time shown.
    pub fn is_there(&self, agent: usize) -> bool {
        let world = match self.stroke().map(|stroke| &stroke.canvas) {
            Some(Canvas::World { after, .. }) => Some(&after.world),
            Some(Canvas::Scene { .. }) => None,
            None => self.changed(),
        };
        match world {
            Some(world) => world.is_there.get(agent).copied().unwrap_or(false),
            None => agent < self.world().agents().len(),
        }
    }

    /// The world at the time shown, where it is another than the draft.
    fn changed(&self) -> Option<&World> {
        self.document.changed(self.view.playback.time)
    }

    /// The stroke that is not finished.
    pub(crate) fn stroke(&self) -> Option<&Stroke> {
        match &self.view.gesture {
            Gesture::Stroke(stroke) => Some(stroke),
            Gesture::None | Gesture::Placing(_) => None,
        }
    }

    /// The agent that is being placed.
    pub const fn placing(&self) -> Option<Placing> {
        match &self.view.gesture {
            Gesture::Placing(placing) => Some(*placing),
            Gesture::None | Gesture::Stroke(_) => None,
        }
    }

    /// Whether a stroke is being made: the board shows what it does so far, and
    /// nothing else has changed.
    pub fn has_stroke(&self) -> bool {
        self.stroke().is_some()
    }

    /// Whether the hand is doing something on the board.
    pub fn has_gesture(&self) -> bool {
        self.view.gesture != Gesture::None
    }

    /// Whether the world could change at the time shown: there is a plan, and
    /// nothing has changed then or later yet.
    pub fn can_change(&self) -> bool {
        let document = &self.document;
        let answer = document
            .fresh_answer()
            .filter(|answer| answer.plan().is_some());
        let is_later = |answer: &Rc<Answer>| {
            let last = answer.changed_last();
            last.is_none_or(|last| self.view.playback.time > last)
        };
        matches!(document.mode, Mode::Editing | Mode::Asking(_)) && answer.is_some_and(is_later)
    }

    /// The agent that could be led by hand from the time shown: the one that is
    /// selected, where there is a plan of the scene in one world.
    pub fn can_steer(&self) -> Option<usize> {
        let agent = self.selected_agent()?;
        let time = self.view.playback.time;
        let can = match &self.document.mode {
            Mode::Steering(own) | Mode::Judging(own, _) => own.agent != agent || time < own.time(),
            Mode::Editing | Mode::Asking(_) => {
                let answer = self.document.fresh_answer();
                answer.is_some_and(|answer| Steering::can_begin(answer, agent, time))
            }
            Mode::Changing(_) | Mode::Comparing(_) | Mode::Stuck(..) => false,
        };
        can.then_some(agent)
    }

    /// The agent that is selected, by its index in the scene.
    pub const fn selected_agent(&self) -> Option<usize> {
        match self.view.selection {
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
        match self.document.mode.changing() {
            Some(changing) => changing.fresh_name(),
            None => fresh_name(self.document.draft.scene()),
        }
    }

    /// Whether there is something on a cell that the tool `Select` moves.
    pub fn can_move(&self, cell: Cell) -> bool {
        self.thing_at(cell).is_some()
    }

    /// What the tool `Select` takes hold of on a cell.
    pub(crate) fn thing_at(&self, cell: Cell) -> Option<Thing> {
        match &self.document.mode {
            Mode::Steering(_) | Mode::Judging(..) => return None,
            Mode::Changing(changing) => return self.thing_in(changing.draft(), cell),
            Mode::Comparing(comparing) | Mode::Stuck(comparing, _) => {
                return self.thing_in(comparing.changing.draft(), cell);
            }
            Mode::Editing | Mode::Asking(_) => {}
        }
        let draft = &self.document.draft;
        // What the scene is made of can only be moved where it is shown.
        if self.world().grid() != draft.grid() {
            return None;
        }
        let standing = self.agent_at(cell);
        let starts = |agent: usize| draft.agents().get(agent).is_some_and(|a| a.start == cell);
        let start = standing.filter(|&agent| starts(agent)).map(Thing::Start);
        start.or_else(|| Thing::lying(draft, cell, self.selected_agent()))
    }

    /// The same in the world that changes: where agents are is settled, and what
    /// waypoints they had, too.
    fn thing_in(&self, world: &Draft, cell: Cell) -> Option<Thing> {
        if self.agent_at(cell).is_some() {
            return None;
        }
        let mut agents = world.agents().iter().enumerate();
        let goal = agents.position(|(index, agent)| self.is_there(index) && agent.goal == cell);
        goal.map(Thing::Goal)
            .or_else(|| Thing::painted(world, cell))
    }
}
