//! Where the page stands: one badge and one sentence.

use std::rc::Rc;

use giveway_model::{Objective, words::capital};
use giveway_solve::Status;
use giveway_solve::words::{headline, known};

use super::costs::values;
use crate::front::Front;
use crate::{Answer, Asking, Mode, Solving, State, Task, proof};

/// What stands before the sentence: an icon and one word, never a colour alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Badge {
    /// No answer yet.
    Draft,
    /// The scene has a fault.
    Faulty,
    /// The solver works.
    Solving,
    /// It works on a question.
    Asking,
    /// It checks a proof.
    Checking,
    /// What changes in the world is being listed.
    Changing,
    /// It looks for ways to go on.
    Adapting,
    /// Ways to go on are side by side; how many.
    Compared(u8),
    /// An agent is led by hand.
    Steering,
    /// A plan that went on where the world changed.
    Adopted,
    /// A plan, with a proof that none is better.
    Proved,
    /// No plan, with a proof.
    Impossible,
    /// The budget ran out.
    Stopped,
    /// An answer to what the scene was before.
    Stale,
    /// A plan from elsewhere of which nothing was proved here.
    Shared,
}

impl Badge {
    /// The word on it.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Draft => "Draft",
            Self::Faulty => "Problem",
            Self::Solving => "Solving",
            Self::Asking => "Asking",
            Self::Checking => "Checking",
            Self::Changing => "Changing",
            Self::Adapting => "Looking",
            Self::Compared(1) => "1 answer",
            Self::Compared(2) => "2 answers",
            Self::Compared(_) => "3 answers",
            Self::Steering => "Steering",
            Self::Adopted => "Adopted",
            Self::Proved => "Proved",
            Self::Impossible => "Impossible",
            Self::Stopped => "Stopped",
            Self::Stale => "Stale",
            Self::Shared => "Shared",
        }
    }

    /// Its icon.
    pub const fn icon(self) -> &'static str {
        match self {
            Self::Draft | Self::Changing => "change",
            Self::Shared => "share",
            Self::Compared(_) => "compare",
            Self::Steering => "steer",
            Self::Adopted => "check",
            Self::Solving | Self::Adapting | Self::Stopped => "clock",
            Self::Asking => "question",
            Self::Checking => "search",
            Self::Proved => "proved",
            Self::Impossible => "cancel",
            Self::Faulty | Self::Stale => "warning",
        }
    }

    /// Its class in the style sheet.
    pub const fn class(self) -> &'static str {
        match self {
            Self::Draft | Self::Adopted | Self::Shared => "plain",
            Self::Solving
            | Self::Asking
            | Self::Checking
            | Self::Changing
            | Self::Adapting
            | Self::Compared(_)
            | Self::Steering => "info",
            Self::Proved => "proved",
            Self::Impossible | Self::Faulty => "bad",
            Self::Stopped | Self::Stale => "warn",
        }
    }
}

/// Where the page stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Standing {
    /// The badge.
    pub badge: Badge,
    /// The sentence, to be understood without the badge.
    pub sentence: String,
    /// The sentence beside the badge, which says its first word already; `None` where
    /// it is the same.
    pub beside: Option<String>,
}

impl Standing {
    fn new(badge: Badge, sentence: String) -> Self {
        Self {
            badge,
            sentence,
            beside: None,
        }
    }

    /// The sentence beside the badge.
    pub fn beside_badge(&self) -> &str {
        self.beside.as_deref().unwrap_or(&self.sentence)
    }
}

/// Where the page stands.
///
/// ```
/// use giveway_page::{Draft, State, words};
/// let standing = words::standing(&State::new(Draft::default()));
/// assert_eq!(standing.sentence, "No plan yet.");
/// ```
pub fn standing(state: &State) -> Standing {
    let say = Standing::new;
    if let Some(task) = state.work.task() {
        return working(state, task);
    }
    if let Some(placing) = state.placing() {
        let at = crate::words::at(placing.start);
        let name = state.next_name();
        let sentence = format!("{name} starts at {at}. Now choose its goal.");
        return say(Badge::Draft, sentence);
    }
    match &state.document.mode {
        Mode::Changing(changing) => say(Badge::Changing, super::change::changing(changing)),
        Mode::Comparing(comparing) | Mode::Stuck(comparing, _) if comparing.preview().is_none() => {
            say(Badge::Impossible, super::change::compared(comparing))
        }
        Mode::Comparing(comparing) | Mode::Stuck(comparing, _) => {
            let count = u8::try_from(comparing.tried.len()).unwrap_or(u8::MAX);
            say(Badge::Compared(count), super::change::compared(comparing))
        }
        Mode::Steering(own) | Mode::Judging(own, _) => {
            say(Badge::Steering, super::steering::steering(own))
        }
        Mode::Editing | Mode::Asking(_) => resting(state),
    }
}

/// Where the page stands while something runs.
fn working(state: &State, task: &Task) -> Standing {
    let say = Standing::new;
    match task {
        Task::Solve(run) => {
            let known = solving(run);
            Standing {
                beside: Some(capital(&known)),
                ..say(Badge::Solving, format!("Solving: {known}"))
            }
        }
        Task::Explain(_) => {
            let asking = state.document.mode.asking();
            let sentence = asking.map_or_else(String::new, |asking| asked(asking));
            say(Badge::Asking, sentence)
        }
        Task::Certify(run) => say(Badge::Checking, proof::doing(run)),
        Task::Change(run) => say(Badge::Adapting, super::change::adapting(run)),
    }
}

/// Where the page stands with a scene and its plan, if it has one.
fn resting(state: &State) -> Standing {
    let say = Standing::new;
    if let Some(problem) = state.document.draft.problems().first()
        && state.document.fresh_answer().is_none()
    {
        let fault = format!("This cannot be solved: {}", problem.sentence);
        return say(Badge::Faulty, fault);
    }
    let Some(answer) = &state.document.answer else {
        return say(Badge::Draft, "No plan yet.".to_owned());
    };
    if state.document.is_stale() {
        let what = match answer.plan() {
            Some(_) => "The scene has changed since this plan. Solve again.",
            None => "The scene has changed. Solve again.",
        };
        return say(Badge::Stale, what.to_owned());
    }
    if answer.course.is_some() {
        let badge = match answer.solved.status {
            Status::Optimal => Badge::Adopted,
            _ => Badge::Stopped,
        };
        return say(badge, super::change::adopted(answer));
    }
    if let Some(front) = state.document.own_front() {
        return on_front(front, answer);
    }
    if answer.is_shared {
        return say(Badge::Shared, shared(answer));
    }
    let badge = match answer.solved.status {
        Status::Optimal => Badge::Proved,
        Status::Impossible => Badge::Impossible,
        Status::Feasible | Status::Unknown => Badge::Stopped,
    };
    say(badge, answered(answer))
}

/// `On the Pareto front of 3 plans: makespan 18, sum of costs 35.`
fn on_front(front: &Front, answer: &Rc<Answer>) -> Standing {
    let plans = super::count(front.points.len(), "plan");
    let costs = front.name(front.place_of(answer).unwrap_or_default());
    let (badge, what) = if front.is_whole() {
        (
            Badge::Proved,
            format!("On the Pareto front of {plans}: {costs}."),
        )
    } else {
        (
            Badge::Stopped,
            format!("On the Pareto front, {plans} so far: {costs}."),
        )
    };
    Standing::new(badge, what)
}

/// `Not checked yet whether it is the best: makespan 18.`
fn shared(answer: &Answer) -> String {
    let objective = &answer.draft.scene().objective;
    let costs = answer.solved.costs;
    let costs = costs.map_or_else(String::new, |costs| values(objective, &costs));
    format!("This plan was shared: {costs}. Nobody has checked here whether it is the best.")
}

/// `Asking: why does A1 wait at (3, 1)?`, and how far the answer is.
fn asked(asking: &Asking) -> String {
    let question = super::question(asking.question());
    if asking.told.is_none() {
        return question;
    }
    format!("{question} The verdict is there; reasons and repairs follow.")
}

/// `makespan is at least 17, the best plan so far has 20.`
fn solving(run: &Solving) -> String {
    let known = known(objective(run), &run.bounds, run.best.as_ref());
    if known.is_empty() {
        return match &run.best {
            Some(costs) => format!("a plan with {}.", values(objective(run), costs)),
            None => "no bound yet.".to_owned(),
        };
    }
    format!("{known}.")
}

fn objective(run: &Solving) -> &Objective {
    let asked = run.request.objective.as_ref();
    asked.unwrap_or(&run.request.scene.objective)
}

fn answered(answer: &Answer) -> String {
    let objective = &answer.draft.scene().objective;
    headline(objective, &answer.solved).to_string()
}
