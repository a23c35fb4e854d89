//! The states of one agent by number, and the steps from each.

use std::collections::BTreeMap;
use std::rc::Rc;

use super::agent::Mind;
use super::scene::RuleScene;
use super::steps::Way;

/// The states of one agent by number, each with its steps at a time.
#[derive(Default)]
pub(super) struct Minds {
    pub(super) all: Vec<Mind>,
    numbers: BTreeMap<Mind, u32>,
    ways: BTreeMap<(u32, i64), Ways>,
}

/// Steps, each with the number of the state that it leads to.
pub(super) type Ways = Rc<Vec<(u32, Way)>>;

impl Minds {
    pub(super) fn number(&mut self, mind: &Mind) -> u32 {
        if let Some(&number) = self.numbers.get(mind) {
            return number;
        }
        let number = self.all.len() as u32;
        self.all.push(mind.clone());
        self.numbers.insert(mind.clone(), number);
        number
    }

    pub(super) fn ways(&mut self, scene: &RuleScene, agent: usize, key: (u32, i64)) -> Ways {
        if let Some(ways) = self.ways.get(&key) {
            return Rc::clone(ways);
        }
        let mind = self.all[key.0 as usize].clone();
        let ways = scene.ways(agent, &mind, key.1).into_iter();
        let ways: Vec<(u32, Way)> = ways.map(|way| (self.number(&way.to), way)).collect();
        let ways = Rc::new(ways);
        self.ways.insert(key, Rc::clone(&ways));
        ways
    }
}
