//! The text of a document, read with distrust: plans are judged, and a claim is
//! believed only where this browser kept it itself.

use std::collections::BTreeMap;
use std::rc::Rc;

use giveway_model::change::Changes;
use giveway_model::{Agent, Plan, Scene, Version, check};
use giveway_solve::{Limits, SolveAnswer, SolveRequest, Stats, Status};

use super::text::{numbers, unescape};
use super::{
    From, LONGEST, Linked, Source, ask, change, claim, extras, knowledge, plan, scene, steering,
};
use crate::asking::Asking;
use crate::changing::{Changing, Comparing};
use crate::front::Front;
use crate::{Answer, Colours, Document, Draft, Mode};

/// Reads documents; what several have in common is read once.
#[derive(Debug, Default)]
pub(super) struct Reader {
    drafts: BTreeMap<String, Rc<Draft>>,
    answers: BTreeMap<String, Rc<Answer>>,
}

/// The parts of a text by their names.
type Parts<'a> = BTreeMap<&'a str, &'a str>;

/// The parts that make a scene, those that make an answer, those that only
/// this browser writes, and what else a link may hold.
const SCENE: [&str; 5] = ["map", "name", "rules", "costs", "agents"];
const ANSWER: [&str; 7] = [
    "changes",
    "plan",
    "knows",
    "slept",
    "claim",
    "steps",
    "asked-within",
];
const HERE: [&str; 14] = [
    "claim",
    "steps",
    "asked-within",
    "stale",
    "front",
    "report",
    "listed",
    "compared",
    "own",
    "asked",
    "shows-other",
    "told",
    "told-report",
    "ask",
];

const PUBLIC: [&str; 8] = [
    "plan", "knows", "slept", "changes", "time", "ask", "within", "colours",
];

/// Whether a part of a document is read from anywhere.
pub(super) fn is_public(part: &str) -> bool {
    let key = part.split_once('=').map_or(part, |(key, _)| key);
    key == "giveway" || SCENE.contains(&key) || PUBLIC.contains(&key)
}

impl Reader {
    /// Reads a document.
    ///
    /// # Errors
    /// What is wrong with it, as a sentence.
    pub(super) fn read(&mut self, text: &str, from: From) -> Result<Linked, String> {
        if text.len() > LONGEST {
            return Err("It is longer than the page takes.".to_owned());
        }
        let parts = split(text, from)?;
        let draft = self.draft(&parts)?;
        let answer = self.answer(&draft, &parts)?;
        let mut document = Document::answered(draft, answer);
        if let Some(within) = parts.get("within") {
            document.within = Some(within.parse().map_err(|_| broken("within"))?);
        }
        if let Some(text) = parts.get("colours") {
            document.colours = colours(text).ok_or_else(|| broken("colours"))?;
        }
        self.keep(&mut document, &parts)?;
        let time = match parts.get("time") {
            Some(time) => time.parse().map_err(|_| broken("time"))?,
            None => 0,
        };
        let question = match parts.get("ask") {
            Some(text) => Some(ask::read(text).ok_or_else(|| broken("ask"))?),
            None => None,
        };
        let last = document.answer.as_deref().map_or(0, Answer::makespan);
        Ok(Linked {
            time: u32::min(time, last),
            document,
            question,
            source: Source::Link,
        })
    }

    fn draft(&mut self, parts: &Parts<'_>) -> Result<Rc<Draft>, String> {
        let key = joined(parts, &SCENE);
        if let Some(draft) = self.drafts.get(&key) {
            return Ok(Rc::clone(draft));
        }
        let mut read = Scene::default();
        for key in SCENE {
            if let Some(value) = parts.get(key) {
                scene::read(&mut read, key, value).ok_or_else(|| broken(key))?;
            }
        }
        let draft = Draft::new(read).map_err(|faults| {
            let fault = faults.first().map(ToString::to_string);
            format!("Its scene cannot be drawn: {}.", fault.unwrap_or_default())
        })?;
        let draft = Rc::new(draft);
        self.drafts.insert(key, Rc::clone(&draft));
        Ok(draft)
    }

    fn answer(
        &mut self,
        draft: &Rc<Draft>,
        parts: &Parts<'_>,
    ) -> Result<Option<Rc<Answer>>, String> {
        let key = joined(parts, &SCENE) + &joined(parts, &ANSWER);
        if let Some(answer) = self.answers.get(&key) {
            return Ok(Some(Rc::clone(answer)));
        }
        let changes = match parts.get("changes") {
            None => None,
            Some(text) => {
                let changes = change::read(text, draft.agents().len());
                Some(changes.ok_or_else(|| broken("changes"))?)
            }
        };
        let plan = match parts.get("plan") {
            None => None,
            Some(text) => {
                let mut agents: Vec<Agent> = draft.agents().to_vec();
                let mut times = Plan::default();
                if let Some(changes) = &changes {
                    agents.extend(change::joined(changes));
                    change::put_times(&mut times, changes);
                }
                if let Some(text) = parts.get("knows") {
                    times.knows = Some(knowledge::read(text).ok_or_else(|| broken("knows"))?);
                }
                if let Some(text) = parts.get("slept") {
                    let slept = knowledge::read_slept(&agents, text);
                    times.slept = slept.ok_or_else(|| broken("slept"))?;
                }
                let plan = plan::read(&agents, text, times);
                Some(plan.ok_or("Its plan is broken.")?)
            }
        };
        let answer = answer(draft, plan, changes, parts)?.map(Rc::new);
        if let Some(answer) = &answer {
            self.answers.insert(key, Rc::clone(answer));
        }
        Ok(answer)
    }

    /// What only this browser's own text tells.
    fn keep(&mut self, document: &mut Document, parts: &Parts<'_>) -> Result<(), String> {
        if let Some(text) = parts.get("stale") {
            let text = unescape(text).ok_or_else(|| broken("stale"))?;
            document.answer = self.read(&text, From::Here)?.document.answer;
        }
        let Some(about) = document.answer.clone() else {
            let of_an_answer = ["front", "report", "listed", "compared", "own", "asked"];
            let found = of_an_answer.iter().find(|key| parts.contains_key(*key));
            return found.map_or(Ok(()), |key| Err(broken(key)));
        };
        if let Some(text) = parts.get("front") {
            let told = extras::read(text).ok_or_else(|| broken("front"))?;
            let front = Front::new(Rc::clone(&document.draft), &about.request, told);
            let mut points = front.points.iter();
            // The plan shown is the very one of the front.
            if let Some(point) = points.find(|point| point.plan() == about.plan()) {
                document.answer = Some(Rc::clone(point));
            }
            document.found_front = Some(Rc::new(front));
        }
        if let Some(text) = parts.get("report") {
            let report = extras::read(text).ok_or_else(|| broken("report"))?;
            document.checked = Some((about.clone(), Rc::new(report)));
        }
        document.mode = mode(&about, parts)?;
        Ok(())
    }
}

/// The parts of a text, of the version that is read.
fn split(text: &str, from: From) -> Result<Parts<'_>, String> {
    let mut all = text.split('&').filter_map(|part| part.split_once('='));
    match all.next() {
        Some(("giveway", "1")) => {}
        Some(("giveway", version)) => {
            let version: String = version.chars().take(20).collect();
            return Err(format!(
                "It is of version {version}; this page reads version 1."
            ));
        }
        _ => return Err("It holds no scene of Giveway.".to_owned()),
    }
    let mut parts = Parts::new();
    for (key, value) in all {
        let is_known = PUBLIC.contains(&key)
            || SCENE.contains(&key)
            || (from == From::Here && HERE.contains(&key));
        if !is_known || parts.insert(key, value).is_some() {
            return Err(broken(key));
        }
    }
    Ok(parts)
}

fn broken(key: &str) -> String {
    let key: String = key.chars().take(20).collect();
    format!("Its part \u{201c}{key}\u{201d} is broken.")
}

/// Some parts as one text, to be recognised by.
fn joined(parts: &Parts<'_>, keys: &[&str]) -> String {
    let mut text = String::new();
    for key in keys {
        text.push('&');
        text += parts.get(key).copied().unwrap_or("-");
    }
    text
}

fn colours(text: &str) -> Option<Colours> {
    let numbers = numbers(text)?;
    numbers.try_into().ok().map(Colours::from_numbers)
}

/// What was being done with the plan.
fn mode(about: &Rc<Answer>, parts: &Parts<'_>) -> Result<Mode, String> {
    let own = match parts.get("own") {
        Some(text) => Some(Rc::new(
            steering::read(about, text).ok_or_else(|| broken("own"))?,
        )),
        None => None,
    };
    let changing = match parts.get("listed") {
        Some(text) => Some(Rc::new(
            listed(about, text).ok_or_else(|| broken("listed"))?,
        )),
        None => None,
    };
    let comparing = match (&changing, parts.get("compared")) {
        (Some(changing), Some(text)) => Some(Rc::new(
            compared(changing, text).ok_or_else(|| broken("compared"))?,
        )),
        _ => None,
    };
    let asking = match parts.get("asked") {
        Some(text) => {
            let question = ask::read(text).ok_or_else(|| broken("asked"))?;
            let limits = Limits::default();
            let asking = match (&own, &changing) {
                (Some(own), _) => Asking::about(&own.answer, question, limits),
                (None, Some(changing)) => Asking::stuck(changing, limits),
                (None, None) => Asking::about(about, question, limits),
            };
            Some(Rc::new(told(asking, parts)?))
        }
        None => None,
    };
    Ok(match (own, changing, comparing, asking) {
        (Some(own), _, _, Some(asking)) => Mode::Judging(own, asking),
        (Some(own), _, _, None) => Mode::Steering(own),
        (None, _, Some(comparing), Some(asking)) => Mode::Stuck(comparing, asking),
        (None, _, Some(comparing), None) => Mode::Comparing(comparing),
        (None, Some(changing), None, _) => Mode::Changing(changing),
        (None, None, None, Some(asking)) => Mode::Asking(asking),
        (None, None, None, None) => Mode::Editing,
    })
}

/// What was being listed.
fn listed(about: &Rc<Answer>, text: &str) -> Option<Changing> {
    let (at, list) = text.split_once('!')?;
    let changing = Changing::begin(about, at.parse().ok()?)?;
    let list = change::read(list, about.agents().len())?.changes;
    let list = list.into_iter().map(|change| change.what).collect();
    changing.with(list).ok()
}

fn compared(changing: &Rc<Changing>, text: &str) -> Option<Comparing> {
    let (chosen, told) = text.split_once('!')?;
    let chosen: usize = chosen.parse().ok()?;
    let mut comparing = Comparing::new(changing, extras::read(told)?)?;
    comparing.chosen = chosen.checked_sub(1);
    Some(comparing)
}

/// A question with what was told of it.
fn told(mut asking: Asking, parts: &Parts<'_>) -> Result<Asking, String> {
    if let Some(told) = parts.get("told") {
        asking.learn(extras::read(told).ok_or_else(|| broken("told"))?);
    }
    if let Some(text) = parts.get("told-report") {
        let report = extras::read(text).ok_or_else(|| broken("told-report"))?;
        asking.report = Some(Rc::new(report));
    }
    asking.shows_other = parts.get("shows-other") == Some(&"1") && asking.other.is_some();
    Ok(asking)
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
    let answer = answer(&draft, Some(plan), changes, &Parts::new())?;
    Ok(Linked {
        document: Document::answered(draft, answer.map(Rc::new)),
        time: 0,
        question: None,
        source: Source::File,
    })
}

/// The plan as an answer, after the judge passed it.
fn answer(
    draft: &Rc<Draft>,
    plan: Option<Plan>,
    changes: Option<Changes>,
    parts: &Parts<'_>,
) -> Result<Option<Answer>, String> {
    let instance = match (draft.instance(), &plan) {
        (Ok(instance), _) => instance,
        (Err(_), None) => return Ok(None),
        (Err(faults), Some(_)) => {
            let fault = faults.first().map(ToString::to_string);
            return Err(format!(
                "The file has a plan, but its scene is not valid: {}.",
                fault.unwrap_or_default()
            ));
        }
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
        giveway: Version,
        status: Status::Feasible,
        costs,
        bounds: BTreeMap::new(),
        within: None,
        complete: false,
        reason: None,
        plan,
        stats: Stats::default(),
    };
    let claim = parts.get("claim");
    let has_claim = claim.is_some_and(|claim| claim::read(&mut solved, claim).is_some());
    if solved.plan.is_none() && !has_claim {
        return Ok(None);
    }
    let within = match parts.get("asked-within") {
        Some(text) => Some(text.parse().map_err(|_| broken("asked-within"))?),
        None => None,
    };
    let request = SolveRequest {
        scene: draft.scene().clone(),
        within,
        ..SolveRequest::default()
    };
    let (draft, request) = (Rc::clone(draft), Rc::new(request));
    let mut answer = match changes {
        None => Answer::new(draft, request, solved),
        Some(changes) => {
            let steps = parts.get("steps").copied().unwrap_or_default();
            let steps = change::read_steps(steps, &changes);
            Answer::over_time(draft, request, solved, changes, steps)
                .map_err(|_| "Its changes do not fit its plan.")?
        }
    };
    answer.is_shared = !has_claim;
    Ok(Some(answer))
}
