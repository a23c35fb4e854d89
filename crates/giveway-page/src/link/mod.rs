//! A scene with its plan as one line of text: for a link, and for what the
//! browser keeps. Short, bounded, and read with distrust.
//!
//! ```text
//! giveway=1&map=10.2f6s2f...&name=warehouse&rules=0.0&costs=012&agents=A1.0.0.9.2!10.10;...
//! &plan=2rR...;...&time=7
//! ```

mod claim;
mod plan;
mod preferences;
mod scene;
#[cfg(test)]
mod tests;
mod text;

use std::fmt::Write as _;
use std::rc::Rc;

use giveway_model::{Plan, Scene, check};
use giveway_solve::{SolveAnswer, SolveRequest, Status};

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
    let mut text = scene::write(state.draft.scene());
    if let Some(plan) = state.fresh_answer().and_then(|answer| answer.plan())
        && let Some(plan) = plan::write(state.draft.agents(), plan)
    {
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
    let mut text = write(state);
    if let Some(answer) = state.fresh_answer() {
        text += "&claim=";
        text += &claim::write(&answer.solved);
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
    let (mut plan, mut time, mut claim) = (None, 0, None);
    for (key, value) in parts {
        let broken = || format!("Its part \u{201c}{key}\u{201d} is broken.");
        match key {
            "plan" => plan = Some(value),
            "time" => time = value.parse().map_err(|_| broken())?,
            "claim" if from == From::Here => claim = Some(value),
            _ => scene::read(&mut scene, key, value).ok_or_else(broken)?,
        }
    }
    let draft = Draft::new(scene).map_err(|faults| {
        let fault = faults.first().map(ToString::to_string);
        format!("Its scene cannot be drawn: {}.", fault.unwrap_or_default())
    })?;
    let plan = match plan {
        None => None,
        Some(text) => {
            let plan = plan::read(draft.agents(), text);
            Some(plan.ok_or("Its plan is broken.")?)
        }
    };
    let draft = Rc::new(draft);
    let answer = answer(&draft, plan, claim)?;
    Ok(Linked {
        time: time.min(answer.as_ref().map_or(0, Answer::makespan)),
        answer: answer.map(Rc::new),
        draft,
    })
}

/// The plan as an answer, after the judge passed it.
fn answer(
    draft: &Rc<Draft>,
    plan: Option<Plan>,
    claim: Option<&str>,
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
            let report = check::check(instance, plan);
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
        reason: Some("Whether it is the best is not known here: solve it".to_owned()),
        plan,
        stats: giveway_solve::Stats::default(),
    };
    let has_claim = claim.is_some_and(|claim| claim::read(&mut solved, claim).is_some());
    if solved.plan.is_none() && !has_claim {
        return Ok(None);
    }
    let request = SolveRequest {
        scene: draft.scene().clone(),
        ..SolveRequest::default()
    };
    Ok(Some(Answer::new(
        Rc::clone(draft),
        Rc::new(request),
        solved,
    )))
}
