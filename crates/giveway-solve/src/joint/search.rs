//! Dijkstra over joint states, each agent's state being its place, its waypoints
//! and its battery. What is paid are the costs of an objective in their order:
//! each is a sum over steps, so that comparing them in order loses no best plan.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};
use std::rc::Rc;

use giveway_model::Cost;

use super::{
    Ended, Joint, Paid,
    agent::{Move, Single},
};
use crate::{
    budget::{Budget, Stop},
    counterfactual::Precedence,
    single::Task,
};

/// A joint state: those of the agents, and what is used of limited costs.
type States = Rc<(Vec<Single>, [u32; 5])>;

/// The least paid for a state, and the state before it.
struct Reached {
    paid: Paid,
    before: Option<States>,
}

impl Joint<'_> {
    /// # Errors
    /// When the budget is spent.
    pub(super) fn run(
        &self,
        most: usize,
        steps: &mut usize,
        budget: &Budget,
    ) -> Result<Ended, Stop> {
        let mut reached: BTreeMap<States, Reached> = BTreeMap::new();
        let mut heap = BinaryHeap::new();
        for (start, paid) in self.starts() {
            if !self.keeps_limits(paid.used) {
                continue;
            }
            let start = Rc::new((start, paid.used));
            let before = None;
            reached.insert(Rc::clone(&start), Reached { paid, before });
            heap.push(Reverse((paid, start)));
        }
        while let Some(Reverse((paid, states))) = heap.pop() {
            budget.tick()?;
            if reached.get(&states).is_some_and(|best| best.paid < paid) {
                continue;
            }
            if states.0.iter().all(|state| state.has_arrived()) {
                let way = way(&reached, states);
                return Ok(Ended::Best(paid, way));
            }
            let successors = self.successors(&states.0);
            *steps += successors.len();
            budget.spend(successors.len() as u64)?;
            for (next, cost) in successors {
                let paid = paid.and(cost);
                if !self.keeps_limits(paid.used) {
                    continue;
                }
                let next = (next, paid.used);
                if reached.get(&next).is_none_or(|best| paid < best.paid) {
                    let next = Rc::new(next);
                    let before = Some(Rc::clone(&states));
                    reached.insert(Rc::clone(&next), Reached { paid, before });
                    heap.push(Reverse((paid, next)));
                }
            }
            if *steps > most {
                return Ok(Ended::TooMany);
            }
        }
        Ok(Ended::None)
    }

    pub(super) fn task(&self, i: usize) -> &Task {
        &self.problem.tasks[self.agents[i]]
    }

    /// The states at time 0. Who could have stayed where it is pays for going on.
    fn starts(&self) -> Vec<(Vec<Single>, Paid)> {
        let mut joint = vec![(Vec::new(), Paid::default())];
        for i in 0..self.agents.len() {
            let task = self.task(i);
            let Some(state) = task.first() else {
                return Vec::new();
            };
            let first = Single::Going {
                place: state.place,
                mask: state.mask,
                battery: state.battery,
                clock: 0,
                count: 0,
            };
            let choices = self.or_arrived(i, first);
            let mut longer = Vec::new();
            for (head, paid) in joint {
                for &choice in &choices {
                    let mut state: Vec<Single> = head.clone();
                    state.push(choice);
                    let goes_on = self.going_on(task, choice);
                    longer.push((state, paid.and(goes_on)));
                }
            }
            joint = longer;
        }
        joint.retain(|(state, _)| self.is_in_order(state));
        joint
    }

    /// What an agent pays not to have arrived at time 0.
    fn going_on(&self, task: &Task, state: Single) -> Paid {
        if state.has_arrived() {
            return Paid::default();
        }
        self.paid(|cost| match cost {
            Cost::SumOfCosts => task.woken,
            Cost::Waits => task.stood,
            _ => 0,
        })
    }

    /// Whether who has to be somewhere first has been there, if the other is.
    fn is_in_order(&self, state: &[Single]) -> bool {
        let Some(Precedence { first, second, at }) = self.problem.precedence else {
            return true;
        };
        let number = |agent| self.agents.iter().position(|&other| other == agent);
        let (Some(first), Some(second)) = (number(first), number(second)) else {
            return true;
        };
        if self.stands(second, state[second]) != Some(at) {
            return true;
        }
        match state[first] {
            Single::Going { mask, .. } => mask & self.task(first).bit(at) != 0,
            Single::Leaving | Single::Arrived => true,
        }
    }

    /// All joint states one step on, with what the step costs.
    fn successors(&self, state: &[Single]) -> Vec<(Vec<Single>, Paid)> {
        let moves: Vec<Vec<Move>> = (0..state.len()).map(|i| self.moves(i, state[i])).collect();
        let mut found = Vec::new();
        let mut chosen = Vec::new();
        self.combine(&moves, &mut chosen, &mut found);
        found.retain(|(state, _)| self.is_in_order(state));
        found
    }

    fn combine(
        &self,
        moves: &[Vec<Move>],
        chosen: &mut Vec<Move>,
        found: &mut Vec<(Vec<Single>, Paid)>,
    ) {
        let i = chosen.len();
        let Some(choices) = moves.get(i) else {
            let state = chosen.iter().map(|m| m.to).collect();
            // Somebody has not arrived yet.
            let time = self.paid(|cost| u32::from(cost == Cost::Makespan));
            let paid = chosen.iter().fold(time, |paid, m| paid.and(m.cost));
            found.push((state, paid));
            return;
        };
        for &choice in choices {
            let place = self.stands(i, choice.to);
            let free = chosen.iter().enumerate().all(|(j, other)| {
                let meet = place.is_some() && place == self.stands(j, other.to);
                let swap = choice.arc.is_some() && choice.arc == other.arc.map(|arc| arc ^ 1);
                let collide = self.problem.collide(self.agents[i], self.agents[j]);
                !(collide && (meet || swap))
            });
            if free {
                chosen.push(choice);
                self.combine(moves, chosen, found);
                chosen.pop();
            }
        }
    }
}

/// The states up to a last one, from the first on.
fn way(reached: &BTreeMap<States, Reached>, last: States) -> Vec<Vec<Single>> {
    let mut way = Vec::new();
    let mut next = Some(last);
    while let Some(states) = next {
        next = reached.get(&states).and_then(|it| it.before.clone());
        way.push(states.0.clone());
    }
    way.reverse();
    way
}
