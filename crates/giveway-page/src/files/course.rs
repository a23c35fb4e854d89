//! A scene with its plan, what changed while that ran, and a question: files of the
//! project's own JSON, results of the command included, opened together.

use giveway_formats::Held;
use giveway_model::change::Changes;
use giveway_model::check::check;
use giveway_model::{Fault, Plan, Question, Scene, tr};

use super::{Opened, Reading, faulty, named, refusal};
use crate::link::{self, Linked, Source};
use crate::{Document, Draft, Notice};

/// What a link or files hold together, and what a person should know of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Together {
    /// The document.
    pub linked: Linked,
    /// Sentences.
    pub notes: Vec<String>,
}

impl From<Linked> for Together {
    fn from(linked: Linked) -> Self {
        Self {
            linked,
            notes: Vec::new(),
        }
    }
}

/// What one of the files holds.
enum Holds {
    Scene(Scene),
    Plan(Plan, Vec<String>),
    Changes(Changes),
    Asked(Question),
    Other,
}

fn holds(text: &str) -> Result<Holds, Vec<Fault>> {
    Ok(match giveway_formats::read(text)?.1 {
        Held::Scene(scene, _) => Holds::Scene(scene),
        Held::OwnPlan(plan, notes) => Holds::Plan(plan, notes),
        Held::Changes(changes) => Holds::Changes(changes),
        Held::Asked(question) => Holds::Asked(*question),
        Held::NoPlan(_)
        | Held::Map(..)
        | Held::Scenario(_)
        | Held::Plan(_)
        | Held::Both(..)
        | Held::Problem(_) => Holds::Other,
    })
}

/// The files by what they hold, each with its name.
#[derive(Default)]
struct Files<'a> {
    scenes: Vec<(&'a Opened, Scene)>,
    plans: Vec<(&'a Opened, Plan, Vec<String>)>,
    changes: Vec<(&'a Opened, Changes)>,
    asked: Vec<(&'a Opened, Question)>,
}

/// Reads files of the project's own JSON; `None` where they are of more kinds, or more
/// than one of a kind.
///
/// # Errors
/// What is wrong with a file, or which one is missing.
pub(super) fn read(files: &[(&Opened, &str)]) -> Option<Result<Reading, Notice>> {
    let mut by_kind = Files::default();
    for &(file, text) in files {
        match holds(text) {
            Err(faults) => return Some(Err(faulty(&file.name, &faults))),
            Ok(Holds::Scene(scene)) => by_kind.scenes.push((file, scene)),
            Ok(Holds::Plan(plan, notes)) => by_kind.plans.push((file, plan, notes)),
            Ok(Holds::Changes(changes)) => by_kind.changes.push((file, changes)),
            Ok(Holds::Asked(question)) => by_kind.asked.push((file, question)),
            Ok(Holds::Other) => return None,
        }
    }
    let Files {
        mut scenes,
        plans,
        mut changes,
        mut asked,
    } = by_kind;
    if scenes.len() > 1 || changes.len() > 1 || asked.len() > 1 {
        return None;
    }
    let changes = changes.pop();
    let asked = asked.pop();
    let Some((file, scene)) = scenes.pop() else {
        let (file, why) = if let Some((file, _)) = changes {
            let why = tr!("these are changes: open them together with their scene and plan");
            (file, why)
        } else if let Some((file, ..)) = plans.first() {
            (*file, tr!("it is a plan: open it together with its scene"))
        } else if let Some((file, _)) = asked {
            let why = tr!("it is the answer to a question: open it together with its scene");
            (file, why)
        } else {
            return None;
        };
        return Some(Err(refusal(&file.name, why)));
    };
    let scene = named(scene, &file.name);
    if plans.is_empty() && asked.is_none() {
        return Some(match changes {
            None => Ok(Reading::Scene(Box::new(scene))),
            Some((file, _)) => Err(refusal(
                &file.name,
                tr!("these are changes: open them together with their scene and plan"),
            )),
        });
    }
    let all: Vec<Opened> = files.iter().map(|(file, _)| (*file).clone()).collect();
    Some(
        Draft::new(scene)
            .map_err(|faults| faulty(&file.name, &faults))
            .and_then(|draft| {
                let together = together(draft, &plans, changes, all)?;
                Ok(match (together, asked) {
                    (Reading::Linked(mut it), Some((_, question))) => {
                        it.linked.question = Some(question);
                        Reading::Linked(it)
                    }
                    (reading, _) => reading,
                })
            }),
    )
}

fn together(
    draft: Draft,
    plans: &[(&Opened, Plan, Vec<String>)],
    changes: Option<(&Opened, Changes)>,
    files: Vec<Opened>,
) -> Result<Reading, Notice> {
    let found = |linked: Linked, notes: Vec<String>| {
        Ok(Reading::Linked(Box::new(Together { linked, notes })))
    };
    let Some((file, plan, notes)) = plans.first() else {
        let linked = Linked {
            document: Document::new(draft),
            time: 0,
            question: None,
            source: Source::File,
            was_impossible: false,
            is_checked: true,
        };
        return found(linked, Vec::new());
    };
    let Some((changed, changes)) = changes else {
        let mut names = draft.agents().iter().map(|agent| &agent.name);
        let is_for_it = names.any(|name| plan.paths.contains_key(name));
        let is_legal = |plan: &Plan| {
            draft
                .instance()
                .is_ok_and(|instance| check(instance, plan).is_valid())
        };
        if plans.len() > 1 || (is_for_it && draft.instance().is_ok() && !is_legal(plan)) {
            return Ok(Reading::Illegal(files));
        }
        let linked = link::judged(draft, plan.clone(), None);
        return found(
            linked.map_err(|why| refusal(&file.name, &why))?,
            notes.clone(),
        );
    };
    // Of several plans the one is taken that knows of the changes: the other was there
    // before.
    let mut refused = None;
    for (file, plan, notes) in plans.iter().rev() {
        match link::judged(draft.clone(), plan.clone(), Some(changes.clone())) {
            Ok(linked) => {
                let mut notes = notes.clone();
                let others = plans.iter().filter(|(other, ..)| other.name != file.name);
                notes.extend(others.map(|(other, ..)| {
                    let (other, file) = (&other.name, &file.name);
                    tr!(
                        "{other} is left out: {file} is the plan that knows of the changes.",
                        other,
                        file
                    )
                }));
                return found(linked, notes);
            }
            Err(why) => refused = Some(refused.unwrap_or((file.name.clone(), why))),
        }
    }
    let (name, why) = refused.unwrap_or_default();
    let Ok(linked) = link::changing(draft, plan.clone(), &changes) else {
        return Err(refusal(&name, &why));
    };
    let mut times = changes.by_time().into_iter().map(|(at, _)| at);
    let at = times.next().unwrap_or_default();
    let (changed, file) = (&changed.name, &file.name);
    let mut notes = vec![tr!(
        "{file} does not know of the changes in {changed}. They are listed at time {at}: press Find new plans.",
        file,
        changed,
        at
    )];
    if let Some(next) = times.next() {
        notes.push(tr!(
            "What {changed} changes from time {next} on is left out. Change it once you use a new plan.",
            changed,
            next
        ));
    }
    found(linked, notes)
}
