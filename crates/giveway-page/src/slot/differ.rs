//! What another document has otherwise, in one sentence.

use giveway_model::{Agent, Cell, Ground, Scene, tr};

use crate::Document;
use crate::words::at;

/// What is otherwise there, from what is here: "There (6, 0) is free."
pub(crate) fn difference(here: &Document, there: &Document) -> String {
    let (ours, theirs) = (here.draft.scene(), there.draft.scene());
    let found = map(here, there)
        .into_iter()
        .chain(agents(ours, theirs))
        .chain((ours.rules != theirs.rules).then(|| tr!("the rules are different").to_owned()))
        .chain(
            (ours.objective != theirs.objective).then(|| tr!("the costs are different").to_owned()),
        )
        .chain(
            (here.within != there.within)
                .then(|| tr!("the latest arrival is different").to_owned()),
        )
        .chain(
            (here.colours != there.colours || here.looks != there.looks)
                .then(|| tr!("the colours are different").to_owned()),
        );
    let found: Vec<String> = found.collect();
    match &*found {
        [] => tr!("There the scene is the same, but the plan is not.").to_owned(),
        [one] => tr!("There {one}.", one),
        [one, other] => tr!("There {one}, and {other}.", one, other),
        [one, other, ..] => tr!("There {one}, {other}, and more is different.", one, other),
    }
}

fn map(here: &Document, there: &Document) -> Option<String> {
    let (ours, theirs) = (here.draft.grid(), there.draft.grid());
    let size = (theirs.width(), theirs.height());
    if (ours.width(), ours.height()) != size {
        return Some(tr!(
            "the map is {width} × {height}",
            width = size.0,
            height = size.1
        ));
    }
    let others = theirs.cells();
    let others = others.filter(|&(cell, ground)| ours.ground(cell) != Some(ground));
    let others: Vec<(Cell, Ground)> = others.collect();
    match &*others {
        [] => None,
        &[(cell, ground)] => Some(tr!(
            "{cell} is {ground}",
            cell = at(cell),
            ground = is(ground)
        )),
        &[(one, ground), (other, same)] if ground == same => Some(tr!(
            "{one} and {other} are {ground}",
            one = at(one),
            other = at(other),
            ground = are(ground)
        )),
        &[(one, ground), (other, another)] => Some(tr!(
            "{one} is {ground} and {other} is {another}",
            one = at(one),
            ground = is(ground),
            other = at(other),
            another = is(another)
        )),
        others => Some(tr!(
            "{n} cell is different" | "{n} cells are different" % others.len()
        )),
    }
}

fn is(ground: Ground) -> &'static str {
    match ground {
        Ground::Free => tr!("a cell is" => "free"),
        Ground::Obstacle => tr!("a cell is" => "an obstacle"),
        Ground::Slow => tr!("a cell is" => "in the slow zone"),
        Ground::Charger => tr!("a cell is" => "a charger"),
        Ground::SlowCharger => tr!("a cell is" => "a charger in the slow zone"),
    }
}

fn are(ground: Ground) -> &'static str {
    match ground {
        Ground::Free => tr!("two cells are" => "free"),
        Ground::Obstacle => tr!("two cells are" => "obstacles"),
        Ground::Slow => tr!("two cells are" => "in the slow zone"),
        Ground::Charger => tr!("two cells are" => "chargers"),
        Ground::SlowCharger => tr!("two cells are" => "chargers in the slow zone"),
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
        ([name], []) => return Some(tr!("{name} is one more robot", name)),
        ([], [name]) => return Some(tr!("the robot {name} is missing", name)),
        (more, []) => {
            return Some(tr!(
                "there is {n} more robot" | "there are {n} more robots" % more.len()
            ));
        }
        ([], fewer) => {
            return Some(tr!(
                "{n} robot is missing" | "{n} robots are missing" % fewer.len()
            ));
        }
        _ => return Some(tr!("the robots are others").to_owned()),
    }
    let changed = |agent: &&Agent| {
        let same = among(&ours.agents, &agent.name);
        same.and_then(|index| ours.agents.get(index)) != Some(*agent)
    };
    let changed: Vec<&Agent> = theirs.agents.iter().filter(changed).collect();
    match &*changed {
        [] => None,
        [agent] => Some(tr!("{agent} is different", agent = agent.name)),
        agents => Some(tr!(
            "{n} robot is different" | "{n} robots are different" % agents.len()
        )),
    }
}
