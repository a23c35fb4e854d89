//! What another document has otherwise, in one sentence.

use giveway_model::{Agent, Cell, Ground, Scene};

use crate::Document;
use crate::words::{at, count};

/// What is otherwise there, from what is here: "There (6, 0) is free."
pub(crate) fn difference(here: &Document, there: &Document) -> String {
    let (ours, theirs) = (here.draft.scene(), there.draft.scene());
    let found = map(here, there)
        .into_iter()
        .chain(agents(ours, theirs))
        .chain((ours.rules != theirs.rules).then(|| "the rules are different".to_owned()))
        .chain((ours.objective != theirs.objective).then(|| "the costs are different".to_owned()))
        .chain((here.within != there.within).then(|| "the latest arrival is different".to_owned()))
        .chain((here.colours != there.colours).then(|| "the colours are different".to_owned()));
    let found: Vec<String> = found.collect();
    match &*found {
        [] => "There the scene is the same, but the plan is not.".to_owned(),
        [one] => format!("There {one}."),
        [one, other] => format!("There {one}, and {other}."),
        [one, other, ..] => format!("There {one}, {other}, and more is different."),
    }
}

fn map(here: &Document, there: &Document) -> Option<String> {
    let (ours, theirs) = (here.draft.grid(), there.draft.grid());
    let size = (theirs.width(), theirs.height());
    if (ours.width(), ours.height()) != size {
        return Some(format!("the map is {} \u{d7} {}", size.0, size.1));
    }
    let others = theirs.cells();
    let others = others.filter(|&(cell, ground)| ours.ground(cell) != Some(ground));
    let others: Vec<(Cell, Ground)> = others.collect();
    match &*others {
        [] => None,
        &[(cell, ground)] => Some(format!("{} is {}", at(cell), is(ground))),
        &[(one, ground), (other, same)] if ground == same => {
            Some(format!("{} and {} are {}", at(one), at(other), are(ground)))
        }
        &[(one, ground), (other, another)] => Some(format!(
            "{} is {} and {} is {}",
            at(one),
            is(ground),
            at(other),
            is(another)
        )),
        others => Some(format!("{} are different", count(others.len(), "cell"))),
    }
}

const fn is(ground: Ground) -> &'static str {
    match ground {
        Ground::Free => "free",
        Ground::Obstacle => "an obstacle",
        Ground::Slow => "in the slow zone",
        Ground::Charger => "a charger",
        Ground::SlowCharger => "a charger in the slow zone",
    }
}

const fn are(ground: Ground) -> &'static str {
    match ground {
        Ground::Free => "free",
        Ground::Obstacle => "obstacles",
        Ground::Slow => "in the slow zone",
        Ground::Charger => "chargers",
        Ground::SlowCharger => "chargers in the slow zone",
    }
}

fn agents(ours: &Scene, theirs: &Scene) -> Option<String> {
    let among = |agents: &[Agent], name: &str| agents.iter().position(|agent| agent.name == name);
    let without = |these: &[Agent], those: &[Agent]| -> Vec<String> {
        let others = these.iter().filter(|one| among(those, &one.name).is_none());
        others.map(|agent| agent.name.clone()).collect()
    };
    let more = without(&theirs.agents, &ours.agents);
    let fewer = without(&ours.agents, &theirs.agents);
    match (&*more, &*fewer) {
        ([], []) => {}
        ([name], []) => return Some(format!("{name} is one more robot")),
        ([], [name]) => return Some(format!("the robot {name} is missing")),
        (more, []) => return Some(format!("there are {}", count(more.len(), "more robot"))),
        ([], fewer) => return Some(format!("{} are missing", count(fewer.len(), "robot"))),
        _ => return Some("the robots are others".to_owned()),
    }
    let changed = |agent: &&Agent| {
        let same = among(&ours.agents, &agent.name);
        same.and_then(|index| ours.agents.get(index)) != Some(*agent)
    };
    let changed: Vec<&Agent> = theirs.agents.iter().filter(changed).collect();
    match &*changed {
        [] => None,
        [agent] => Some(format!("{} is different", agent.name)),
        agents => Some(format!("{} are different", count(agents.len(), "robot"))),
    }
}
