//! What was done for a task, laid on the lesson that the lecturer has.

use giveway_model::{Plan, Scene, tr};

use super::{Answer, NoFit, Work};
use crate::judge::{Did, Outsider, Situation, Verdict, Why, may_bring, words};
use crate::lesson::task::Lead;
use crate::lesson::{Lesson, Step, Task};

/// What was done for a task of a lesson, for the judges and to be looked at.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// The scene that the step began with.
    pub start: Scene,
    /// The scene on the board.
    pub scene: Scene,
    /// What was done.
    pub did: Did,
    /// The plan on the board: the one that was made by leading robots, else the step's.
    pub plan: Option<Plan>,
}

/// Why what a file says fits no step of the lesson.
#[derive(Clone, Debug, PartialEq)]
pub enum Misfit {
    /// The lesson has no such step, or it has no task.
    NoTask,
    /// Nothing was answered.
    NoAnswer,
    /// The task is of another kind.
    OtherKind,
    /// Edits do not fit the scene.
    Edits(NoFit),
    /// The board is none that the steps before can leave.
    Board(Option<Why>),
}

impl Misfit {
    /// It as a sentence.
    pub fn sentence(&self) -> String {
        match self {
            Self::NoTask => tr!("The lesson has no task at this step.").to_owned(),
            Self::NoAnswer => tr!("Nothing was answered.").to_owned(),
            Self::OtherKind => tr!("The answer is one to another kind of task.").to_owned(),
            Self::Edits(no_fit) => no_fit.sentence(),
            Self::Board(None) => tr!("This step begins with the board of the lesson.").to_owned(),
            Self::Board(Some(why)) => {
                let verdict = Verdict::not_like_this(why.clone());
                let said = words::said(&verdict, &Step::default());
                let said = said.text.plain();
                tr!(
                    "The board is none that the steps before can leave: {said}",
                    said
                )
            }
        }
    }
}

impl Shown {
    /// What was done for the task of a step.
    ///
    /// # Errors
    /// Where it does not fit the lesson.
    pub fn of(work: &Work, lesson: &Lesson) -> Result<Self, Misfit> {
        let answer = work.answer.as_ref().ok_or(Misfit::NoAnswer)?;
        Self::of_answer(answer, work, lesson)
    }

    /// The same for another answer on the same board.
    ///
    /// # Errors
    /// Where it does not fit the lesson.
    pub(crate) fn of_answer(answer: &Answer, work: &Work, lesson: &Lesson) -> Result<Self, Misfit> {
        let step = lesson.steps.get(work.step).ok_or(Misfit::NoTask)?;
        let task = step.task.as_ref().ok_or(Misfit::NoTask)?;
        let own = lesson.scene(work.step).ok_or(Misfit::NoTask)?;
        if !answer.is_for(task) {
            return Err(Misfit::OtherKind);
        }
        let board = work.board.of(own).map_err(Misfit::Edits)?;
        // A board with which the step can begin, else one that was edited in this step.
        let brought = may_bring(lesson, work.step, &board);
        let (start, scene) = match (answer, brought) {
            (Answer::Edits(edits), Ok(())) => {
                let scene = edits.of(&board).map_err(Misfit::Edits)?;
                (board, scene)
            }
            (_, Ok(())) => (board.clone(), board),
            (Answer::Edits(_), Err(outsider)) => return Err(misfit(outsider)),
            (_, Err(_)) if !step.tools.is_empty() => (own.clone(), board),
            (_, Err(outsider)) => return Err(misfit(outsider)),
        };
        let did = did(answer, task, step, &scene);
        let plan = match &did {
            Did::Led(plan) => Some(plan.clone()),
            _ => step.plan.clone(),
        };
        Ok(Self {
            start,
            scene,
            did,
            plan,
        })
    }

    /// It as the judges have it.
    pub const fn situation<'a>(&'a self, step: &'a Step) -> Situation<'a> {
        Situation {
            step,
            start: &self.start,
            scene: &self.scene,
        }
    }
}

fn misfit(outsider: Outsider) -> Misfit {
    match outsider {
        Outsider::NoStep => Misfit::NoTask,
        Outsider::Own => Misfit::Board(None),
        Outsider::Edits(why) => Misfit::Board(Some(why)),
    }
}

fn did(answer: &Answer, task: &Task, step: &Step, scene: &Scene) -> Did {
    match answer {
        Answer::Value { value } => Did::Guessed(value.clone()),
        Answer::Shown {} => Did::Revealed,
        Answer::Marks { marks } => Did::Marked(marks.clone()),
        Answer::Choice { choice } => Did::Chose(*choice),
        Answer::Order { order } => Did::Ordered(order.clone()),
        Answer::NoOrder {} => Did::NoOrder,
        Answer::Method { method } => Did::Went(*method),
        Answer::Edits(_) => Did::Edits,
        Answer::Paths { paths, charges } => {
            let led = match task {
                Task::Lead(Lead { robots, .. }) => robots.as_slice(),
                _ => &[],
            };
            let mut plan = Plan::default();
            for agent in &scene.agents {
                let name = &agent.name;
                let given = step.plan.as_ref().filter(|_| !led.contains(name));
                let given = given.filter(|given| !given.path(name).is_empty());
                let path = given.map_or_else(
                    || vec![Some(agent.start)],
                    |given| given.path(name).to_vec(),
                );
                plan.paths.insert(name.clone(), path);
                if let Some(times) = given
                    .map(|given| given.charges(name))
                    .filter(|it| !it.is_empty())
                {
                    plan.charges.insert(name.clone(), times.to_vec());
                }
            }
            // Paths of others are for the judge to refuse.
            plan.paths.extend(paths.clone());
            plan.charges.extend(charges.clone());
            Did::Led(plan)
        }
    }
}
