//! One step of PIBT: from a configuration to the next.
//!
//! Agents choose in the order of their priorities. An agent that wants a cell
//! where another one stands lends that one its priority, so that it chooses at
//! once; where it finds no cell, the first one takes its next best (backtracking).

use fastrand::Rng;

use super::{guide::Guide, swap};
use crate::{AgentId, plain::Plain, terrain::Vertex};

/// An agent lends its priority to another one, which stands in its way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Inheritance {
    /// The agent that lends it.
    pub from: AgentId,
    /// The agent that inherits it.
    pub to: AgentId,
    /// Where the heir stands, and the lender wants to be.
    pub at: Vertex,
}

/// No agent at a vertex.
const NOBODY: u32 = u32::MAX;
/// No vertex for an agent yet.
const UNDECIDED: Vertex = Vertex::MAX;
/// The ways on from a cell: four neighbours, and to stay.
const MOST: usize = 5;

/// The weight of a step nearer to the goal where no guide gives it: more than all the others.
const NEARER: u32 = 64;
/// The cost of hindering another agent, and the most that randomness adds: enough that no agent goes round in
/// circles.
const HINDRANCE: u32 = 3;
const CHANCE: u32 = 12;

/// Makes configurations, again and again in the same memory.
pub(crate) struct Step<'p> {
    plain: &'p Plain<'p>,
    guide: Option<&'p Guide>,
    pub(super) now: Vec<Vertex>,
    next: Vec<Vertex>,
    at_now: Vec<u32>,
    at_next: Vec<u32>,
    rng: Rng,
    chain: Vec<Chooser>,
    /// The inheritances of priority in this step, where they are recorded.
    inherited: Option<Vec<Inheritance>>,
}

/// An agent that is about to choose its next cell.
struct Chooser {
    agent: AgentId,
    /// Where it may go, best first.
    cells: [Vertex; MOST],
    count: usize,
    tried: usize,
    /// An agent that it has to change places with, which follows it.
    follower: Option<AgentId>,
}

impl<'p> Step<'p> {
    /// Without a configuration yet. Random choices follow from the seed.
    pub(crate) fn new(
        plain: &'p Plain<'p>,
        guide: Option<&'p Guide>,
        seed: u64,
        told: bool,
    ) -> Self {
        Self {
            plain,
            guide,
            now: Vec::new(),
            next: Vec::new(),
            at_now: vec![NOBODY; plain.vertices()],
            at_next: vec![NOBODY; plain.vertices()],
            rng: Rng::with_seed(seed),
            chain: Vec::new(),
            inherited: told.then(Vec::new),
        }
    }

    /// Begins a step from a configuration; nobody has chosen yet.
    pub(crate) fn begin(&mut self, now: &[Vertex]) {
        for &v in &self.now {
            self.at_now[v as usize] = NOBODY;
        }
        for &v in &self.next {
            if v != UNDECIDED {
                self.at_next[v as usize] = NOBODY;
            }
        }
        self.now.clear();
        self.now.extend_from_slice(now);
        self.next.clear();
        self.next.resize(now.len(), UNDECIDED);
        for (agent, &v) in now.iter().enumerate() {
            self.at_now[v as usize] = agent as u32;
        }
        if let Some(inherited) = &mut self.inherited {
            inherited.clear();
        }
    }

    /// Gives an agent its next cell, which is its own or a neighbour; false
    /// where it would collide with one that has chosen.
    pub(crate) fn fix(&mut self, agent: AgentId, to: Vertex) -> bool {
        let fits = self.is_free(agent, to);
        if fits {
            self.take(agent, to);
        }
        fits
    }

    /// Lets everybody choose who has not yet, in this order; false where
    /// somebody finds no cell, which only happens where some are fixed.
    pub(crate) fn choose(&mut self, order: &[u32]) -> bool {
        order.iter().all(|&agent| {
            let agent = agent as usize;
            self.next[agent] != UNDECIDED || self.choose_for(agent)
        })
    }

    /// The next configuration, once everybody has chosen.
    pub(crate) fn next(&self) -> &[Vertex] {
        &self.next
    }

    /// The inheritances of priority in this step.
    pub(crate) fn inherited(&self) -> &[Inheritance] {
        self.inherited.as_deref().unwrap_or(&[])
    }

    /// The cost to go of an agent from a vertex: less is better.
    pub(super) fn to_go(&self, agent: AgentId, v: Vertex) -> u32 {
        match self.guide {
            Some(guide) => guide.cost(agent, v),
            None => self.plain.distance(agent, v).saturating_mul(NEARER),
        }
    }

    /// The agent at a vertex now.
    pub(super) fn occupant(&self, v: Vertex) -> Option<AgentId> {
        let agent = self.at_now[v as usize];
        (agent != NOBODY).then_some(agent as usize)
    }

    /// Whether an agent has chosen.
    pub(super) fn has_chosen(&self, agent: AgentId) -> bool {
        self.next[agent] != UNDECIDED
    }

    fn take(&mut self, agent: AgentId, to: Vertex) {
        self.next[agent] = to;
        self.at_next[to as usize] = agent as u32;
    }

    /// Whether nobody is going to be at a vertex, nor comes from it the other
    /// way.
    fn is_free(&self, agent: AgentId, to: Vertex) -> bool {
        let comes = |other| self.next[other] == self.now[agent];
        let blocked = self.occupant(to).is_some_and(comes);
        self.at_next[to as usize] == NOBODY && !blocked
    }

    /// One agent and all that inherit its priority; false where it has to stay
    /// and cannot, or does so for want of anything else.
    fn choose_for(&mut self, agent: AgentId) -> bool {
        self.chain.clear();
        let first = self.chooser(agent);
        self.chain.push(first);
        while let Some(chooser) = self.chain.last_mut() {
            let agent = chooser.agent;
            if chooser.tried == chooser.count {
                // It stays, whoever wanted its cell, and that one goes on trying.
                self.chain.pop();
                self.take(agent, self.now[agent]);
                continue;
            }
            let to = chooser.cells[chooser.tried];
            chooser.tried += 1;
            if !self.is_free(agent, to) {
                continue;
            }
            self.take(agent, to);
            let heir = self.occupant(to).filter(|&other| !self.has_chosen(other));
            if let Some(heir) = heir {
                if let Some(inherited) = &mut self.inherited {
                    let (from, at) = (agent, to);
                    inherited.push(Inheritance { from, to: heir, at });
                }
                let heir = self.chooser(heir);
                self.chain.push(heir);
                continue;
            }
            self.pull_followers();
            return true;
        }
        false
    }

    /// The last of a chain has found its cell, and so have all before it. Who
    /// gets its first wish is followed by the agent that it changes places with.
    fn pull_followers(&mut self) {
        while let Some(chooser) = self.chain.pop() {
            let Some(follower) = chooser.follower else {
                continue;
            };
            let left = self.now[chooser.agent];
            let free = self.at_next[left as usize] == NOBODY;
            if chooser.tried == 1 && free && !self.has_chosen(follower) {
                self.take(follower, left);
            }
        }
    }

    /// How much an agent hinders others at a vertex: whoever is there counts
    /// twice, and whoever stands beside it and would come nearer to its goal by
    /// going there counts once more (Okumura and Nagai 2025).
    fn hindrance(&self, agent: AgentId, v: Vertex) -> u32 {
        let other_at = |v| self.occupant(v).filter(|&other| other != agent);
        let wants = |&u: &Vertex| {
            let nearer = |other| self.to_go(other, v) < self.to_go(other, u);
            other_at(u).is_some_and(nearer)
        };
        let there = u32::from(other_at(v).is_some());
        let beside = self.plain.neighbours(v).iter().copied().filter(wants);
        2 * there + beside.count() as u32
    }

    /// The wishes of an agent: nearer to its goal first, among equals where it
    /// hinders others little, but by chance, too; the other way round where it has to
    /// let another one pass.
    fn chooser(&mut self, agent: AgentId) -> Chooser {
        let at = self.now[agent];
        let neighbours = self.plain.neighbours(at);
        let mut wishes = [(u32::MAX, at); MOST];
        let mut count = 0;
        for &v in neighbours.iter().chain([&at]) {
            let hindrance = self.hindrance(agent, v) * HINDRANCE;
            let cost = self.to_go(agent, v).saturating_add(hindrance);
            wishes[count] = (cost.saturating_add(self.rng.u32(..CHANCE)), v);
            count += 1;
        }
        wishes[..count].sort_unstable();
        let mut cells = wishes.map(|(_, v)| v);
        let follower = swap::follower(self.plain, self, agent, cells[0]);
        if follower.is_some() {
            cells[..count].reverse();
        }
        Chooser {
            agent,
            cells,
            count,
            tried: 0,
            follower,
        }
    }
}
