//! What a plan knows of changes, in a link: the last time that it takes into
//! account, and agent by agent the times that each slept through at its goal.

use std::collections::BTreeMap;
// Writing to a string cannot fail.
use std::fmt::Write as _;

use giveway_model::{Agent, Plan};

use super::change::{LATEST, TIMES};
use super::text::numbers;

/// The parts that tell it; empty where there is nothing to tell.
pub(super) fn write(agents: &[Agent], plan: &Plan) -> String {
    let mut text = String::new();
    if let Some(knows) = plan.knows {
        let _ = write!(text, "&knows={knows}");
    }
    if plan.slept.values().any(|slept| !slept.is_empty()) {
        let one = |agent: &Agent| {
            let times = plan.slept(&agent.name).as_flattened().iter();
            times.map(u32::to_string).collect::<Vec<_>>().join(".")
        };
        text += "&slept=";
        text += &agents.iter().map(one).collect::<Vec<_>>().join(";");
    }
    text
}

/// The last time that a text tells; `None` where it is none.
pub(super) fn read(text: &str) -> Option<u32> {
    text.parse().ok().filter(|&knows: &u32| knows <= LATEST)
}

/// The times that a text tells, by the agents' names; `None` where it is none.
pub(super) fn read_slept(agents: &[Agent], text: &str) -> Option<BTreeMap<String, Vec<[u32; 2]>>> {
    let mut all = BTreeMap::new();
    let mut texts = text.split(';');
    for agent in agents {
        let own = texts.next()?;
        if own.is_empty() {
            continue;
        }
        let times = numbers(own)?;
        let (slept, []) = times.as_chunks::<2>() else {
            return None;
        };
        let is_right = |&[from, to]: &[u32; 2]| from < to && to <= LATEST;
        if slept.len() > TIMES || !slept.iter().all(is_right) {
            return None;
        }
        all.insert(agent.name.clone(), slept.to_vec());
    }
    texts.next().is_none().then_some(all)
}
