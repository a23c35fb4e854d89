//! The best plan, by Dijkstra's search over joint states.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, BinaryHeap};

use super::agent::{Mind, Where};
use super::minds::{Minds, Ways};
use super::scene::{RuleScene, Spot};
use super::steps::Way;

/// What the oracle says of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// The costs of the best plan, in the order of the objective.
    Best(Vec<i64>),
    /// There is no plan.
    Impossible,
    /// There are too many joint states.
    Capped,
}

/// States of all agents, and what is paid for them.
pub(super) type Start = (Vec<Mind>, Vec<i64>);

/// Each agent's state, whether the first of each precedence has been there, the time.
pub(super) type Joint = (Vec<u32>, Vec<bool>, i64);

pub(super) struct Search<'a> {
    scene: &'a RuleScene,
    pub(super) minds: Vec<Minds>,
    pub(super) best: BTreeMap<Joint, Vec<i64>>,
    open: BinaryHeap<Reverse<(Vec<i64>, i64, Joint)>>,
}

/// The costs of the best plan; with a horizon, of those of at most that makespan.
pub fn best(scene: &RuleScene, within: Option<i64>, most: usize) -> Answer {
    run(Search::begun(scene), within, most)
}

/// The same from states at a time on, each with its costs so far; and whether the first of
/// each precedence was at its cell before.
pub(super) fn best_from(
    scene: &RuleScene,
    (at, starts, before): (i64, Vec<Start>, &[bool]),
    within: Option<i64>,
    most: usize,
) -> Answer {
    let known = if within.is_some() {
        at
    } else {
        at.min(scene.last + 1)
    };
    run(
        Search::from(scene, (at, known), starts, before),
        within,
        most,
    )
}

fn run(mut search: Search<'_>, within: Option<i64>, most: usize) -> Answer {
    let scene = search.scene;
    let after = scene.last + 1;
    let clip = |time: i64| {
        if within.is_some() {
            time
        } else {
            time.min(after)
        }
    };
    let mut closed = BTreeSet::new();
    while let Some(Reverse((costs, time, joint))) = search.open.pop() {
        if !closed.insert(joint.clone()) {
            continue;
        }
        if closed.len() > most {
            return Answer::Capped;
        }
        let minds: Vec<Mind> = search.minds(&joint.0);
        if scene.is_over(&minds, time) {
            return Answer::Best(costs);
        }
        if Some(time) != within {
            search.expand(&joint, &minds, (&costs, time), clip);
        }
    }
    Answer::Impossible
}

impl<'a> Search<'a> {
    /// A search that knows the joint states at time 0.
    pub(super) fn begun(scene: &'a RuleScene) -> Self {
        let mut starts: Vec<Vec<Mind>> = vec![Vec::new()];
        for agent in 0..scene.agents.len() {
            let each = scene.begin(agent);
            let longer = |head: &Vec<Mind>| -> Vec<Vec<Mind>> {
                let with = |mind: &Mind| [head.clone(), vec![mind.clone()]].concat();
                each.iter().map(with).collect()
            };
            starts = starts.iter().flat_map(longer).collect();
        }
        let none = vec![false; scene.orders().count()];
        let nothing = vec![0; scene.objective.len()];
        let starts = starts.into_iter().map(|minds| (minds, nothing.clone()));
        Search::from(scene, (0, 0), starts.collect(), &none)
    }

    /// A search that knows joint states at a time, which is remembered as another one where
    /// later times are alike, each with its costs so far.
    fn from(
        scene: &'a RuleScene,
        (at, known): (i64, i64),
        starts: Vec<Start>,
        before: &[bool],
    ) -> Self {
        let mut search = Search {
            scene,
            minds: (0..scene.agents.len()).map(|_| Minds::default()).collect(),
            best: BTreeMap::new(),
            open: BinaryHeap::new(),
        };
        for (minds, costs) in starts {
            let refs: Vec<&Mind> = minds.iter().collect();
            if scene.may_be(&refs, at, before) {
                let been = scene.been(&refs, before);
                let numbers = minds.iter().zip(&mut search.minds);
                let numbers = numbers.map(|(mind, minds)| minds.number(mind)).collect();
                search.reach((numbers, been, known), costs, at);
            }
        }
        search
    }

    pub(super) fn minds(&self, numbers: &[u32]) -> Vec<Mind> {
        let each = self.minds.iter().zip(numbers);
        each.map(|(minds, &number)| minds.all[number as usize].clone())
            .collect()
    }

    fn reach(&mut self, joint: Joint, costs: Vec<i64>, time: i64) {
        if self.best.get(&joint).is_none_or(|best| costs < *best) {
            self.best.insert(joint.clone(), costs.clone());
            self.open.push(Reverse((costs, time, joint)));
        }
    }

    fn expand(
        &mut self,
        joint: &Joint,
        minds: &[Mind],
        (costs, time): (&[i64], i64),
        clip: impl Fn(i64) -> i64,
    ) {
        for (to, costs, _) in self.steps(joint, minds, (costs, time), clip) {
            self.reach(to, costs, time + 1);
        }
    }

    /// The steps from a joint state: where each leads, the costs up to there, who charges.
    pub(super) fn steps(
        &mut self,
        joint: &Joint,
        minds: &[Mind],
        (costs, time): (&[i64], i64),
        clip: impl Fn(i64) -> i64,
    ) -> Vec<(Joint, Vec<i64>, Vec<bool>)> {
        let mut steps = Vec::new();
        let is_live = |mind: &Mind| matches!(mind.place, Where::At(_) | Where::On(..));
        let live: i64 = minds.iter().map(|mind| i64::from(is_live(mind))).sum();
        if live == 0 {
            return steps;
        }
        let paid = minds.iter().enumerate().filter(|(_, mind)| is_live(mind));
        let penalty: i64 = paid
            .map(|(a, mind)| self.scene.penalty(a, mind, time))
            .sum();
        let ways: Vec<Ways> = (0..minds.len())
            .map(|a| self.minds[a].ways(self.scene, a, (joint.0[a], clip(time))))
            .collect();
        let mut choices: Vec<Vec<usize>> = vec![Vec::new()];
        for each in &ways {
            let longer = |head: &Vec<usize>| -> Vec<Vec<usize>> {
                (0..each.len())
                    .map(|i| [head.clone(), vec![i]].concat())
                    .collect()
            };
            choices = choices.iter().flat_map(longer).collect();
        }
        for choice in choices {
            let taken: Vec<&(u32, Way)> =
                ways.iter().zip(&choice).map(|(all, &i)| &all[i]).collect();
            let edges: BTreeSet<(Spot, Spot)> =
                taken.iter().filter_map(|(_, way)| way.edge).collect();
            if edges.iter().any(|&(from, to)| edges.contains(&(to, from))) {
                continue;
            }
            let next: Vec<&Mind> = taken.iter().map(|(_, way)| &way.to).collect();
            if !self.scene.may_be(&next, clip(time + 1), &joint.1) {
                continue;
            }
            let sum = |which: usize| taken.iter().map(|(_, way)| way.costs[which]).sum::<i64>();
            let more = |cost: &str| match cost {
                "makespan" => 1,
                "sum-of-costs" => live,
                "charges" => sum(0),
                "moves" => sum(1),
                "waits" => sum(2),
                _ => penalty,
            };
            let objective = self.scene.objective.iter();
            let costs: Vec<i64> = objective
                .zip(costs)
                .map(|(cost, paid)| paid + more(cost))
                .collect();
            let been = self.scene.been(&next, &joint.1);
            let numbers = taken.iter().map(|(number, _)| *number).collect();
            let charges = taken.iter().map(|(_, way)| way.costs[0] > 0).collect();
            steps.push(((numbers, been, clip(time + 1)), costs, charges));
        }
        steps
    }
}
