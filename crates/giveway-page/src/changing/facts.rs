//! What is listed, and what has changed before, in words.

use giveway_model::change::{ConstraintRef, What};
use giveway_model::{Constraint, Fault, tr};

use super::Changing;
use super::breakdown::{Breakdown, breakdowns};
use super::entries::{Entry, entries, in_words};
use super::listed::whose;
use super::meets::meets;
use crate::course::Course;
use crate::words::change;
use crate::{Answer, State};

/// What the inspector tells while the world changes.
#[derive(Clone, Debug, PartialEq)]
pub struct Facts {
    /// The time, in steps.
    pub at: u32,
    /// What is listed.
    pub list: Vec<Listed>,
    /// The rules of the scene that are in force and not removed: each with its index, the icon
    /// of its kind, and its sentence.
    pub rules: Vec<(usize, &'static str, String)>,
    /// What would go wrong if everyone went on as planned, in sentences.
    pub meets: Vec<String>,
    /// The breakdowns among what is listed.
    pub breakdowns: Vec<Breakdown>,
    /// What would go wrong without them.
    pub warnings: Vec<String>,
    /// Whether the methods have answered.
    pub is_compared: bool,
    /// The first plan and how it went on.
    pub history: Vec<Past>,
}

/// A listed change.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Listed {
    /// Its place in the list.
    pub index: usize,
    /// The index of the agent whose it is.
    pub agent: Option<usize>,
    /// The icon of what is no agent's.
    pub icon: &'static str,
    /// What changes: `A4 joins at (0, 2)`.
    pub text: String,
    /// What else there is to know.
    pub detail: Option<String>,
}

/// A time of the history.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Past {
    /// The time.
    pub at: u32,
    /// What was: `A3 joins at (2, 2)`.
    pub text: String,
    /// What was made of it: `revise: makespan 4, sum of costs 12`.
    pub detail: Option<String>,
}

/// What there is to tell while the world changes; `None` while it does not.
pub fn facts(state: &State) -> Option<Facts> {
    let changing = state.document.mode.changing()?;
    let compared = state.document.mode.comparing();
    let mut past = history(&changing.about);
    past.push(Past {
        at: changing.at,
        text: match changing.list.as_slice() {
            [] => tr!("Nothing is listed yet").to_owned(),
            list => in_words(changing.about.plan(), list, changing.at),
        },
        detail: Some(match compared {
            None => tr!("no answers yet").to_owned(),
            Some(compared) => {
                tr!("{n} answer, none adopted yet"
                    | "{n} answers, none adopted yet" % compared.tried.len())
            }
        }),
    });
    let meets = meets(changing);
    let rules = &state.document.draft.scene().constraints;
    let is_removed = |index: usize| changing.removes_rule(index);
    let in_force = rules.iter().enumerate();
    let in_force = in_force.filter(|(index, rule)| !rule.off && !is_removed(*index));
    Some(Facts {
        rules: in_force
            .map(|(index, rule)| (index, rule.kind_name(), rule.sentence()))
            .collect(),
        at: changing.at,
        list: list(changing, rules),
        warnings: meets
            .iter()
            .filter(|(index, _)| !changing.is_breakdown(*index))
            .map(|(_, text)| text.clone())
            .collect(),
        meets: meets.into_iter().map(|(_, text)| text).collect(),
        breakdowns: breakdowns(changing),
        is_compared: compared.is_some(),
        history: past,
    })
}

/// How many changes are listed, as they are told.
pub(crate) fn count(changing: &Changing) -> usize {
    entries(changing.about.plan(), &changing.list, changing.at).len()
}

/// What is listed.
fn list(changing: &Changing, rules: &[Constraint]) -> Vec<Listed> {
    let entries = entries(changing.about.plan(), &changing.list, changing.at);
    let row = |entry: Entry| {
        let index = *entry.changes.first()?;
        let listed = listed(changing, index, changing.list.get(index)?, rules);
        let stays = matches!(changing.list.get(index)?, What::StopAgent { .. });
        Some(match (stays, entry.changes.len()) {
            (true, _) => Listed {
                text: entry.text(),
                detail: Some(tr!("it stays there as an obstacle").to_owned()),
                ..listed
            },
            (false, 1) => listed,
            (false, _) => Listed {
                text: entry.text(),
                ..listed
            },
        })
    };
    entries.into_iter().filter_map(row).collect()
}

fn listed(changing: &Changing, index: usize, what: &What, rules: &[Constraint]) -> Listed {
    let name = whose(what);
    let mut agents = changing.draft().agents().iter();
    let (text, detail) = what.sentence();
    let (text, detail) = match what {
        What::RemoveConstraint {
            constraint: ConstraintRef::Index(rule),
        } => match rules.get(*rule as usize) {
            Some(rule) => (tr!("Rule removed").to_owned(), Some(rule.sentence())),
            None => (text, detail),
        },
        _ => (text, detail),
    };
    Listed {
        index,
        agent: name.and_then(|name| agents.position(|agent| agent.name == name)),
        icon: match what {
            What::AddObstacle { .. } | What::RemoveObstacle { .. } | What::MoveObstacle { .. } => {
                "obstacle"
            }
            What::SetSlow { .. } | What::SetNormal { .. } => "slow",
            What::AddCharger { .. } | What::RemoveCharger { .. } => "charger",
            What::AddConstraint { .. } | What::RemoveConstraint { .. } => "lock",
            _ => "agent",
        },
        text,
        detail,
    }
}

/// The first plan and how it went on; nothing where nothing has changed.
pub fn history(answer: &Answer) -> Vec<Past> {
    let Some(course) = answer.course.as_deref() else {
        return Vec::new();
    };
    let costs = |costs: Option<giveway_model::Costs>| {
        costs.map(|costs| {
            let (makespan, sum) = (costs.makespan, costs.sum_of_costs);
            tr!("makespan {makespan}, sum of costs {sum}", makespan, sum)
        })
    };
    let first = course.steps.first().and_then(|step| step.before);
    let mut past = vec![Past {
        at: 0,
        text: tr!("First plan").to_owned(),
        detail: costs(first),
    }];
    for step in &course.steps {
        let method = change::methods_in_words(step);
        past.push(Past {
            at: step.at,
            text: in_words(answer.plan(), &changes_of(course, step.at), step.at),
            detail: match (method, costs(step.after)) {
                (Some(method), Some(costs)) => Some(format!("{method}: {costs}")),
                (method, costs) => method.or(costs),
            },
        });
    }
    past
}

fn changes_of(course: &Course, at: u32) -> Vec<What> {
    let changes = course.changes.changes.iter();
    changes
        .filter(|change| change.at == at)
        .map(|change| change.what.clone())
        .collect()
}

/// Why a change is refused, as a sentence.
pub(crate) fn contradiction(fault: &Fault) -> String {
    let Fault {
        found, expected, ..
    } = fault;
    tr!(
        "This contradicts the world: found {found}, expected {expected}.",
        found,
        expected
    )
}

/// What becomes of an agent in the plan that is previewed: `new times`, `joins at
/// 2`; `None` while none is, and for one that is removed.
pub fn fate(state: &State, name: &str) -> Option<String> {
    let compared = state.document.mode.comparing()?;
    let changing = &compared.changing;
    let told = &compared.tried.get(compared.chosen?)?.told;
    let is_in = |names: &[String]| names.iter().any(|other| other == name);
    if is_in(&told.added) {
        return Some(tr!("joins at {time}", time = changing.at));
    }
    let fates = [
        (tr!("behind a robot" => "as before"), &told.kept),
        (tr!("behind a robot" => "new times"), &told.retimed),
        (tr!("behind a robot" => "new path"), &told.rerouted),
    ];
    let found = fates.iter().find(|(_, names)| is_in(names));
    found.map(|(fate, _)| (*fate).to_owned())
}
