//! Where the page stands: one badge and one sentence.

mod badge;
mod bounds;
mod resting;

use giveway_model::words::capital;
use giveway_model::{AtGoal, Constraint, Rules, assumption, tr};
use giveway_solve::explain::Part;

use crate::certificate;
use crate::inside::by_hand;
use crate::words::{change, question, steering};
use crate::{
    Activity, Asking, State, Task, ask, audit, freedom, grow, ledger, order, proof, sizing,
};

pub use badge::Badge;

use bounds::solving;
use resting::resting;

/// Rules other than the usual ones, a sentence each: an answer holds for them.
fn rules(rules: Rules) -> Vec<String> {
    let mut said = Vec::new();
    if rules.at_goal == AtGoal::Vanish {
        said.push(tr!("Robots leave the map at their goals.").to_owned());
    }
    if let floor @ 1.. = rules.battery_floor {
        said.push(tr!("No battery may fall below {floor}.", floor));
    }
    said
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
    /// How many rules of the scene's own are in force: `5 rules`.
    pub rules: Option<String>,
}

impl Standing {
    pub(crate) fn new(badge: Badge, sentence: String) -> Self {
        let sentence = if sentence.contains(['"', '\u{201e}', '\u{201c}']) {
            crate::words::unnested(&sentence)
        } else {
            sentence
        };
        Self {
            badge,
            sentence,
            beside: None,
            rules: None,
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
    if let Some(job) = state.intake.job() {
        let badge = if job.is_reading() {
            Badge::Reading
        } else {
            Badge::Saving
        };
        return say(badge, job.sentence.clone());
    }
    if let Some(looked) = sizing::looked(state) {
        return say(Badge::Found, looked);
    }
    if state.is_by_hand()
        && let Some(standing) = by_hand::status(state)
    {
        return standing;
    }
    let of_lesson = |lesson| resting::of_lesson(lesson, state);
    if let Some(standing) = state.lesson().and_then(of_lesson) {
        return standing;
    }
    if let Some(audit) = state.document.mode.audit()
        && state.document.mode.asking().is_none()
        && !state.has_gesture()
    {
        return say(audit::badge(audit), audit::sentence(audit));
    }
    let task = state
        .work
        .task()
        .filter(|task| !matches!(task, Task::Look(_) | Task::Price(..) | Task::Order(_)));
    if let Some(task) = task {
        return working(state, task);
    }
    if let Some(placing) = state.placing() {
        let at = crate::words::at(placing.start);
        let name = state.next_name();
        let sentence = tr!("{name} starts at {at}. Now choose its goal.", name, at);
        return say(Badge::Draft, sentence);
    }
    if state
        .view
        .fleet
        .as_ref()
        .is_some_and(|fleet| !fleet.has_goals())
    {
        // On a phone the card of these robots is below the fold.
        let sentence = tr!("The robots start there. Now drag over the cells where they go.");
        return say(Badge::Draft, sentence.to_owned());
    }
    if let Some(late) = order::status(state) {
        return say(Badge::Late, late);
    }
    if let Some(smaller) = grow::sentence(state) {
        return say(Badge::Draft, smaller);
    }
    match &state.document.mode.activity {
        Activity::Changing(changing) => say(Badge::Changing, change::changing(changing)),
        Activity::Comparing(comparing) if comparing.preview().is_none() => {
            say(Badge::Impossible, change::compared(comparing))
        }
        Activity::Comparing(comparing) => {
            let count = u8::try_from(comparing.tried.len()).unwrap_or(u8::MAX);
            say(Badge::Compared(count), change::compared(comparing))
        }
        Activity::Steering(own) => say(
            Badge::Steering,
            steering::steering(own, state.lesson().is_none()),
        ),
        Activity::Auditing(audit) => say(audit::badge(audit), audit::sentence(audit)),
        Activity::Editing => {
            let mut standing = resting(state);
            let scene = state.document.draft.scene();
            let rules = state.document.answer.as_ref().map(|_| rules(scene.rules));
            let rules = rules.into_iter().flatten();
            for said in rules.chain(assumption::sentences(&scene.assumptions)) {
                standing.sentence += " ";
                standing.sentence += &said;
            }
            let number = state.freedom().and_then(|freedom| freedom.count());
            let such = number.map(freedom::such_plans);
            standing.sentence += such.as_deref().unwrap_or_default();
            let causes = state
                .document
                .mode
                .asking()
                .and_then(|asking| ask::other_causes(asking));
            standing.sentence += causes.as_deref().unwrap_or_default();
            // The number is a button of its own beside the sentence.
            standing.rules = own_rules(&scene.constraints);
            standing
        }
    }
}

/// The sentence that stands once a question is answered, while more of its answer is looked for.
pub fn later(state: &State) -> Option<String> {
    state.is_looking().then(|| resting(state).sentence)
}

/// How many rules of the scene's own are in force; the inspector lists them.
fn own_rules(rules: &[Constraint]) -> Option<String> {
    match rules.iter().filter(|rule| !rule.off).count() {
        0 => None,
        some => Some(tr!("{n} rule" | "{n} rules" % some)),
    }
}

/// Where the page stands while something runs.
fn working(state: &State, task: &Task) -> Standing {
    let say = Standing::new;
    match task {
        Task::Solve(run) => {
            let known = solving(run);
            if let Some(planner) = run.planner {
                let title = planner.title();
                return say(
                    Badge::Solving,
                    tr!("{title} is planning: {known}", title, known),
                );
            }
            Standing {
                beside: Some(capital(&known)),
                ..say(Badge::Solving, tr!("Solving: {known}", known))
            }
        }
        Task::Explain(_) => {
            let asking = state.document.mode.asking();
            let sentence = asking.map_or_else(String::new, |asking| asked(asking));
            say(Badge::Asking, sentence)
        }
        Task::Certify(run) => say(Badge::Checking, proof::doing(run.at.as_ref())),
        Task::Export(run) => say(Badge::Checking, certificate::doing(run)),
        Task::Change(run) => say(Badge::Adapting, change::adapting(run)),
        Task::Look(_) | Task::Price(..) | Task::Order(_) => resting(state),
        Task::Freedom(_) => say(Badge::Counting, freedom::doing(state).unwrap_or_default()),
        Task::Delays(_) => say(Badge::Counting, ledger::doing(state).to_owned()),
        Task::Sizing(_) => say(Badge::Counting, sizing::doing(state)),
    }
}

/// `Asking: why does A1 wait at (3, 1)?`, and how far the answer is.
fn asked(asking: &Asking) -> String {
    let question = question(asking.question());
    let told = asking.told.as_deref();
    if told.is_none_or(|told| told.pending.contains(&Part::Verdict)) {
        return question;
    }
    tr!(
        "{question} The verdict is there; reasons and repairs follow.",
        question
    )
}
