//! A scene with its plan as one line of text: for a link, and for what the
//! browser keeps. Short, bounded, and read with distrust.
//!
//! ```text
//! giveway=1&map=10.2f6s2f...&name=warehouse&rules=0.0&costs=012&agents=A1.0.0.9.2!10.10;...
//! &plan=2rR...;...&time=7&ask=wait;A2!at.3.1
//! ```

mod ask;
mod change;
mod claim;
mod plan;
mod preferences;
mod scene;
mod steering;
#[cfg(test)]
mod tests;
mod text;

use std::fmt::Write as _;
use std::rc::Rc;

use giveway_model::change::Changes;
use giveway_model::{Agent, Plan, Question, Scene, check};
use giveway_solve::{SolveAnswer, SolveRequest, Status};

use crate::changing::Changing;
use crate::steering::Steering;
use crate::{Action, Answer, Draft, Notice, State};

pub use preferences::{prefer, preferences};

/// The longest text that is read, in bytes.
pub const LONGEST: usize = 1_000_000;

/// What a link holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Linked {
    /// The scene; it can be drawn, and is a sound one where it came with a plan.
    pub(crate) draft: Rc<Draft>,
    /// The plan, judged, with what is claimed of it.
    pub(crate) answer: Option<Rc<Answer>>,
    /// The time shown, in steps.
    pub(crate) time: u32,
    /// What was changing in the world, where the browser kept that.
    pub(crate) changing: Option<Rc<Changing>>,
    /// The plan of one's own, where the browser kept one.
    pub(crate) steering: Option<Rc<Steering>>,
    /// The question that was asked of the plan, or why there is none.
    pub(crate) question: Option<Question>,
}

/// Whose text it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum From {
    /// From anywhere: what it claims of a plan is not believed.
    Anywhere,
    /// From this browser, which kept it for the page.
    Here,
}

/// The state as the part of a link after `#`.
///
/// ```
/// use giveway_page::{Draft, State, link};
/// let text = link::write(&State::new(Draft::default()));
/// assert_eq!(text, "giveway=1&map=1.f&rules=0.0&costs=012&agents=");
/// assert!(link::read(&text, link::From::Anywhere).is_ok());
/// ```
pub fn write(state: &State) -> String {
    let mut text = write_plan(state);
    let asking = state.asking.as_deref().filter(|_| !state.is_stale());
    if let Some(asking) = asking {
        text += ASK;
        text += &ask::write(asking.question());
    }
    text
}

/// What comes before the question, which is the last part of a link.
const ASK: &str = "&ask=";

/// HTML that shows the scene of a link inside another page: a question is not
/// asked there.
///
/// ```
/// use giveway_page::link::embed;
/// let html = embed("https://example.org/#giveway=1&map=1.f", "5 < 6");
/// assert!(html.contains("src=\"https://example.org/?embed#giveway=1&amp;map=1.f\""));
/// assert!(html.contains("title=\"Giveway: 5 &lt; 6\""));
/// ```
pub fn embed(link: &str, name: &str) -> String {
    let text = |text: &str| {
        let text = text.replace('&', "&amp;").replace('"', "&quot;");
        text.replace('<', "&lt;").replace('>', "&gt;")
    };
    let link = link.split(ASK).next().unwrap_or_default();
    let link = text(&link.replacen('#', "?embed#", 1));
    let name = text(name);
    format!(
        "<iframe src=\"{link}\" title=\"Giveway: {name}\" width=\"640\" height=\"480\" \
         loading=\"lazy\" style=\"border: 0\"></iframe>"
    )
}

fn write_plan(state: &State) -> String {
    let mut text = scene::write(state.draft.scene());
    if let Some(answer) = state.fresh_answer()
        && let Some(plan) = answer.plan()
        && let Some(plan) = plan::write(answer.agents(), plan)
    {
        if let Some(course) = &answer.course {
            text += "&changes=";
            text += &change::write(&course.changes.changes);
        }
        text += "&plan=";
        text += &plan;
        if state.playback.time > 0 {
            let _ = write!(text, "&time={}", state.playback.time);
        }
    }
    text
}

/// The state as this browser keeps it: a link, with what was proved.
pub fn keep(state: &State) -> String {
    let mut text = write_plan(state);
    if let Some(answer) = state.fresh_answer() {
        text += "&claim=";
        text += &claim::write(&answer.solved);
        if let Some(course) = &answer.course {
            text += "&steps=";
            text += &change::write_steps(&course.steps);
        }
    }
    if let Some(changing) = &state.changing {
        let changes = changing.changes().changes;
        let listed = changes.len().saturating_sub(changing.list.len());
        let listed = change::write(changes.get(listed..).unwrap_or_default());
        let _ = write!(text, "&listed={}!{listed}", changing.at);
    }
    if let Some(own) = state.steering.as_deref().and_then(steering::write) {
        text += "&own=";
        text += &own;
    }
    text
}

/// Reads what [`write()`] or [`keep`] wrote.
///
/// # Errors
/// Why it cannot be read, in sentences.
pub fn read(text: &str, from: From) -> Result<Linked, Notice> {
    parse(text, from).map_err(|why| Notice {
        sentence: "The link cannot be opened; the scene stays as it is.".to_owned(),
        details: vec![why],
    })
}

/// What happens when a link is opened.
pub fn open(text: &str) -> Action {
    match read(text, From::Anywhere) {
        Ok(linked) => Action::OpenLink(Box::new(linked)),
        Err(notice) => Action::Refuse(notice),
    }
}

fn parse(text: &str, from: From) -> Result<Linked, String> {
    if text.len() > LONGEST {
        return Err("It is longer than the page takes.".to_owned());
    }
    let mut parts = text.split('&').filter_map(|part| part.split_once('='));
    match parts.next() {
        Some(("giveway", "1")) => {}
        Some(("giveway", version)) => {
            let version: String = version.chars().take(20).collect();
            return Err(format!(
                "It is of version {version}; this page reads version 1."
            ));
        }
        _ => return Err("It holds no scene of Giveway.".to_owned()),
    }
    let mut scene = Scene::default();
    let (mut plan, mut time) = (None, 0);
    let mut kept = Kept::default();
    let (mut changes, mut question) = (None, None);
    for (key, value) in parts {
        let broken = || format!("Its part \u{201c}{key}\u{201d} is broken.");
        match key {
            "plan" => plan = Some(value),
            "time" => time = value.parse().map_err(|_| broken())?,
            "changes" => changes = Some(value),
            "ask" => question = Some(ask::read(value).ok_or_else(broken)?),
            "claim" if from == From::Here => kept.claim = Some(value),
            "steps" if from == From::Here => kept.steps = Some(value),
            "listed" if from == From::Here => kept.listed = Some(value),
            "own" if from == From::Here => kept.own = Some(value),
            _ => scene::read(&mut scene, key, value).ok_or_else(broken)?,
        }
    }
    let draft = Draft::new(scene).map_err(|faults| {
        let fault = faults.first().map(ToString::to_string);
        format!("Its scene cannot be drawn: {}.", fault.unwrap_or_default())
    })?;
    let changes = match changes {
        None => None,
        Some(text) => {
            let changes = change::read(text, draft.agents().len());
            Some(changes.ok_or("Its part \u{201c}changes\u{201d} is broken.")?)
        }
    };
    let plan = match plan {
        None => None,
        Some(text) => {
            let mut agents: Vec<Agent> = draft.agents().to_vec();
            let mut times = Plan::default();
            if let Some(changes) = &changes {
                agents.extend(change::joined(changes));
                change::put_times(&mut times, changes);
            }
            let plan = plan::read(&agents, text, times);
            Some(plan.ok_or("Its plan is broken.")?)
        }
    };
    let draft = Rc::new(draft);
    let answer = answer(&draft, plan, changes, &kept)?.map(Rc::new);
    let changing = answer
        .as_ref()
        .and_then(|answer| listed(answer, kept.listed?));
    let own = answer
        .as_ref()
        .and_then(|answer| steering::read(answer, kept.own?));
    Ok(Linked {
        steering: own.map(Rc::new),
        time: time.min(answer.as_deref().map_or(0, Answer::makespan)),
        answer,
        changing: changing.map(Rc::new),
        question,
        draft,
    })
}

/// What only this browser's own text tells.
#[derive(Clone, Copy, Debug, Default)]
struct Kept<'a> {
    claim: Option<&'a str>,
    steps: Option<&'a str>,
    listed: Option<&'a str>,
    own: Option<&'a str>,
}

/// What was being listed when the page was left; what does not fit is left out.
fn listed(answer: &Rc<Answer>, text: &str) -> Option<Changing> {
    let (at, list) = text.split_once('!')?;
    let changing = Changing::begin(answer, at.parse().ok()?)?;
    let list = change::read(list, answer.agents().len())?.changes;
    let list = list.into_iter().map(|change| change.what).collect();
    changing.with(list).ok()
}

/// A plan with the changes around it, as files tell it, judged.
///
/// # Errors
/// What is wrong with it, as a sentence.
pub(crate) fn judged(draft: Draft, plan: Plan, changes: Option<Changes>) -> Result<Linked, String> {
    let draft = Rc::new(draft);
    let changes = changes.filter(|changes| !changes.changes.is_empty());
    if let Some(changes) = &changes {
        // By way of a link's text, which is bounded.
        let text = change::write(&changes.changes);
        change::read(&text, draft.agents().len())
            .ok_or("It has more changes than the page takes.")?;
    }
    let answer = answer(&draft, Some(plan), changes, &Kept::default())?;
    Ok(Linked {
        draft,
        answer: answer.map(Rc::new),
        time: 0,
        changing: None,
        steering: None,
        question: None,
    })
}

/// The plan as an answer, after the judge passed it.
fn answer(
    draft: &Rc<Draft>,
    plan: Option<Plan>,
    changes: Option<Changes>,
    kept: &Kept<'_>,
) -> Result<Option<Answer>, String> {
    let Ok(instance) = draft.instance() else {
        return match plan {
            Some(_) => Err("It has a plan for a scene that has none.".to_owned()),
            None => Ok(None),
        };
    };
    let costs = match &plan {
        None => None,
        Some(plan) => {
            let report = match &changes {
                None => check::check(instance, plan),
                Some(changes) => {
                    check::check_changes(instance, changes, plan).map_err(|faults| {
                        let fault = faults.first().map(ToString::to_string);
                        format!("Its changes do not fit: {}.", fault.unwrap_or_default())
                    })?
                }
            };
            if let Some(violation) = report.violations.first() {
                return Err(format!("Its plan breaks a rule: {}", violation.message));
            }
            report.costs
        }
    };
    let mut solved = SolveAnswer {
        giveway: giveway_model::Version,
        status: Status::Feasible,
        costs,
        bounds: std::collections::BTreeMap::new(),
        within: None,
        complete: false,
        // It also stands inside another page, which solves nothing.
        reason: Some("Whether it is the best is known once it is solved".to_owned()),
        plan,
        stats: giveway_solve::Stats::default(),
    };
    let has_claim = kept
        .claim
        .is_some_and(|claim| claim::read(&mut solved, claim).is_some());
    if solved.plan.is_none() && !has_claim {
        return Ok(None);
    }
    let request = SolveRequest {
        scene: draft.scene().clone(),
        ..SolveRequest::default()
    };
    let (draft, request) = (Rc::clone(draft), Rc::new(request));
    let answer = match changes {
        None => Answer::new(draft, request, solved),
        Some(changes) => {
            let steps = change::read_steps(kept.steps.unwrap_or_default(), &changes);
            Answer::over_time(draft, request, solved, changes, steps)
                .map_err(|_| "Its changes do not fit its plan.")?
        }
    };
    Ok(Some(answer))
}
