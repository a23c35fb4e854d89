//! The lesson that is open, and what was done in the step that is shown.

use std::rc::Rc;

use giveway_model::{Agent, Plan, Scene};

use super::{Judge, Proof};
use crate::handin::{Work, answer_words, work_of};
use crate::judge::{Did, Situation};
use crate::lesson::quantity::ValueKind;
use crate::lesson::{Id, Layer, Lesson, Step, Task};
use crate::port::{Board, BoardNumber, BoardPlan, Hand, Pick};

/// The lesson that is open.
#[derive(Clone, Debug, PartialEq)]
pub struct Open {
    /// Its short name.
    pub id: Id,
    /// The lesson.
    pub lesson: Rc<Lesson>,
    /// The step that is shown, from 0.
    pub(super) at: usize,
    /// The number of the board.
    pub(super) board: BoardNumber,
    /// The scene that the step began with.
    pub(super) start: Scene,
    /// The scene on the board.
    pub(super) scene: Scene,
    /// The time shown on the board.
    pub(super) time: u32,
    /// What was done for the task.
    pub(super) did: Did,
    /// The robot that is led, where it is not the first of the task.
    pub(super) leads: Option<String>,
    /// What was pointed at, and is no whole mark yet.
    pub(super) pointed: Option<Pick>,
    /// What the judge of the task does or says.
    pub(super) judge: Judge,
    /// The proof of the plan, where the step shows it.
    pub(super) proof: Proof,
    /// How many hints are shown.
    pub(super) hints: usize,
    /// How often something was judged.
    pub(super) attempts: u32,
    /// Whether the task had been solved before the step was opened.
    pub(super) was_solved: bool,
    /// What had been done for it before.
    pub(super) before: Option<Work>,
}

impl Open {
    /// A lesson at a step with a scene; `None` where it has no such step.
    pub(super) fn at(
        id: Id,
        lesson: Rc<Lesson>,
        at: usize,
        board: BoardNumber,
        scene: Scene,
    ) -> Option<Self> {
        let time = lesson.steps.get(at)?.time;
        Some(Self {
            id,
            lesson,
            at,
            board,
            start: scene.clone(),
            scene,
            time,
            did: Did::default(),
            leads: None,
            pointed: None,
            judge: Judge::Waiting,
            proof: Proof::Unasked,
            hints: 0,
            attempts: 0,
            was_solved: false,
            before: None,
        })
    }

    /// Whether it is tried by who writes it.
    pub fn is_tried(&self) -> bool {
        self.id == Id::tried()
    }

    /// Whether hints, replies and the answer are not shown.
    pub fn hides_answers(&self) -> bool {
        self.lesson.hides_answers
    }

    /// The step that is shown, from 0.
    pub const fn index(&self) -> usize {
        self.at
    }

    /// The step that is shown.
    pub fn step(&self) -> Option<&Step> {
        self.lesson.steps.get(self.at)
    }

    /// Whether it is the last one.
    pub fn is_last(&self) -> bool {
        self.at + 1 >= self.lesson.steps.len()
    }

    /// The scene that the step began with.
    pub const fn start(&self) -> &Scene {
        &self.start
    }

    /// The robots that texts name, each at the place of its look: those that the step began
    /// with, those that came since, and those that join while the plan of the step runs.
    pub fn robots(&self) -> Vec<Agent> {
        let is_new = |agent: &&Agent| {
            let mut before = self.start.agents.iter();
            before.all(|other| other.name != agent.name)
        };
        let came = self.scene.agents.iter().filter(is_new);
        let joining = self.step().into_iter().flat_map(Step::joining);
        let all = self.start.agents.iter().chain(came).chain(joining);
        all.cloned().collect()
    }

    /// The scene on the board.
    pub const fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The time shown on the board.
    pub const fn time(&self) -> u32 {
        self.time
    }

    /// What was done for the task.
    pub const fn did(&self) -> &Did {
        &self.did
    }

    /// Whether anything was done that can be taken back.
    pub fn has_done(&self) -> bool {
        // The others go as the plan of the step has it.
        let led = match self.step().and_then(|step| step.task.as_ref()) {
            Some(Task::Lead(task)) => task.robots.as_slice(),
            _ => &[],
        };
        let is_led = |plan: &Plan| led.iter().any(|name| plan.path(name).len() > 1);
        let did = match &self.did {
            Did::Edits => false,
            Did::Marked(marks) => !marks.is_empty(),
            Did::Led(plan) => is_led(plan),
            _ => true,
        };
        did || self.scene != self.start || self.pointed.is_some()
    }

    /// The robot that is led, by its name; the first of the task at first.
    pub fn leads(&self) -> Option<&str> {
        let first = || match self.step()?.task.as_ref()? {
            Task::Lead(task) => task.robots.first(),
            _ => None,
        };
        self.leads.as_ref().or_else(first).map(String::as_str)
    }

    /// What was pointed at, and is no whole mark yet.
    pub const fn pointed(&self) -> Option<&Pick> {
        self.pointed.as_ref()
    }

    /// What the judge of the task does or says.
    pub const fn judge(&self) -> &Judge {
        &self.judge
    }

    /// The proof of the plan, where the step shows it.
    pub fn proof(&self) -> Option<&Proof> {
        let shows = |step: &Step| step.show.contains(&Layer::Proof) && step.plan.is_some();
        self.step().filter(|step| shows(step)).map(|_| &self.proof)
    }

    /// The hints that are shown.
    pub fn hints(&self) -> &[crate::lesson::Text] {
        let hints = self.step().map_or(&[][..], |step| &step.hints);
        hints.get(..self.hints).unwrap_or(hints)
    }

    /// How often something was judged.
    pub const fn attempts(&self) -> u32 {
        self.attempts
    }

    /// Whether the task is solved.
    pub fn is_solved(&self) -> bool {
        self.judge
            .verdict()
            .is_some_and(crate::judge::Verdict::is_solved)
    }

    /// Whether the task had been solved before the step was opened, and nothing was done
    /// in it since.
    pub fn was_solved(&self) -> bool {
        self.was_solved && self.judge == Judge::Waiting && !self.has_done()
    }

    /// The last answer that was given before the step was opened, in words, as long as
    /// nothing was done in it since.
    pub fn answer_before(&self) -> Option<String> {
        let is_untouched = self.judge == Judge::Waiting && !self.has_done();
        let work = self.before.as_ref().filter(|_| is_untouched)?;
        let answer = work.answer.as_ref()?;
        Some(answer_words(answer, self.at, &self.lesson))
    }

    /// Where the learner is, for the judges.
    pub(super) fn situation(&self) -> Option<Situation<'_>> {
        Some(Situation {
            step: self.step()?,
            start: &self.start,
            scene: &self.scene,
        })
    }

    /// What was done for the task, as it is kept.
    pub(super) fn work(&self) -> Option<Work> {
        work_of(&self.lesson, self.at, self.situation()?, &self.did)
    }

    /// The board of the step.
    pub(super) fn as_board(&self) -> Option<Board> {
        let step = self.step()?;
        let plan = match (&step.plan, &step.task) {
            (Some(plan), _) => BoardPlan::Given(plan.clone()),
            (None, Some(Task::Predict(_))) => BoardPlan::Hidden,
            (None, _) if step.solved => BoardPlan::Best,
            (None, _) => BoardPlan::None,
        };
        let hand = match &step.task {
            Some(Task::Lead(task)) => Hand::Leads(task.robots.clone()),
            Some(Task::Spot(_)) => Hand::Points,
            Some(Task::Predict(task)) => match task.what.kind() {
                ValueKind::Robot | ValueKind::Cell => Hand::Points,
                ValueKind::Number | ValueKind::Rule => Hand::Looks,
            },
            _ => Hand::Looks,
        };
        Some(Board {
            number: self.board,
            scene: self.scene.clone(),
            plan,
            changes: step.changes().cloned(),
            time: step.time,
            playing: step.playing,
            tools: step.tools.clone(),
            edits: step.edits,
            cells: step.cells.clone(),
            show: step.show.clone(),
            hand,
        })
    }
}
