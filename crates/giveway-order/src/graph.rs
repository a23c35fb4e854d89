//! The order of a plan as a graph of events.

use giveway_model::change::{Changes, History};
use giveway_model::{Cell, Plan};

use crate::events::{Event, Time, Way, ways};
use crate::links::{EventLink, link};
use crate::times::Timing;
use crate::units::{Unit, units};
use crate::{AgentOrder, Link, LinkEnd, NoOrder, Order, Rotation, RotationMove, Shift, Visit};

/// The order of a plan: who must begin to leave a cell before who begins to come.
///
/// An agent begins a move when the plan has it, when it has arrived (and turned), and when the
/// agent before it in the cell begins to leave or has begun to: whichever is the latest. Agents
/// that rotate go together.
///
/// ```
/// use giveway_model::{change::{Changes, History}, format::native};
/// use giveway_order::OrderGraph;
/// let instance = native::read_instance(r#"{ "giveway": 1, "map": ["...", ".#."], "agents": [
///     { "name": "A1", "start": [0, 0], "goal": [2, 1] },
///     { "name": "A2", "start": [0, 1], "goal": [1, 0] }] }"#).unwrap();
/// let plan = native::read_plan(r#"{ "giveway": 1, "paths": {
///     "A1": [[0, 0], [1, 0], [2, 0], [2, 1]], "A2": [[0, 1], [0, 0], [1, 0]] } }"#).unwrap();
/// let history = History::new(&instance);
/// let changes = Changes::default();
/// let order = OrderGraph::new(&history, &changes, &plan).unwrap().order();
/// assert_eq!(order.links.len(), 2);
/// assert_eq!(order.without_slack(), 2);
/// ```
#[derive(Debug)]
pub struct OrderGraph<'a> {
    pub(crate) history: &'a History,
    pub(crate) changes: &'a Changes,
    pub(crate) plan: &'a Plan,
    pub(crate) ways: Vec<Way<'a>>,
    pub(crate) events: Vec<Event>,
    pub(crate) units: Vec<Unit>,
    links: Vec<EventLink>,
    /// When each event begins without lateness.
    pub(crate) begins: Vec<Time>,
}

impl<'a> OrderGraph<'a> {
    /// The order of a plan that breaks no rule, in the world that it runs in; `changes` are those
    /// that the history was made of.
    ///
    /// # Errors
    /// Where moves would wait for each other for ever: a slow move may begin a step before its
    /// end is left, which no order alone allows.
    pub fn new(
        history: &'a History,
        changes: &'a Changes,
        plan: &'a Plan,
    ) -> Result<Self, NoOrder> {
        let (ways, mut events) = ways(history, changes, plan);
        let links = link(history, &ways, &mut events);
        let mut graph = Self {
            history,
            changes,
            plan,
            ways,
            events,
            units: Vec::new(),
            links,
            begins: Vec::new(),
        };
        graph.units = units(&graph.events).map_err(|circle| NoOrder {
            moves: circle
                .iter()
                .filter_map(|&it| graph.event_move(it))
                .collect(),
        })?;
        graph.begins = graph.timing().begins(&|event| graph.planned(event));
        Ok(graph)
    }

    /// The world in which the events are timed.
    pub(crate) fn timing(&self) -> Timing<'_> {
        Timing {
            history: self.history,
            ways: &self.ways,
            events: &self.events,
            units: &self.units,
        }
    }

    pub(crate) fn planned(&self, event: usize) -> Time {
        self.events.get(event).map_or(0, |it| it.planned)
    }

    pub(crate) fn begin(&self, event: usize) -> Time {
        self.begins.get(event).copied().unwrap_or(0)
    }

    /// The order as plain data.
    pub fn order(&self) -> Order {
        let mut later: Vec<Shift> = (0..self.events.len())
            .filter_map(|event| self.shift(event))
            .collect();
        giveway_model::sorting::sort_by_key(&mut later, |it| it.planned);
        let rotations = self.units.iter().filter(|unit| unit.len() > 1);
        let mut rotations: Vec<Rotation> = rotations.filter_map(|it| self.rotation(it)).collect();
        giveway_model::sorting::sort_by_key(&mut rotations, |it| it.time);
        Order {
            agents: self.ways.iter().map(|way| self.agent(way)).collect(),
            links: self.links.iter().filter_map(|it| self.link(it)).collect(),
            rotations,
            later,
        }
    }

    fn agent(&self, way: &Way<'_>) -> AgentOrder {
        let timing = self.timing();
        let charges = way.trajectory.charges;
        let visits = (way.first..)
            .zip(&way.stays)
            .zip(0..)
            .map(|((event, stay), number)| {
                let arrives = timing.arrives(event, self.begin(event));
                let leaves = way.first + number + 1 < way.first + way.events();
                Visit {
                    cell: stay.cell,
                    comes: (number > 0).then(|| step(self.begin(event))),
                    arrives: step(arrives),
                    leaves: leaves.then(|| step(self.begin(event + 1))),
                    stands: leaves
                        .then(|| self.events.get(event + 1))
                        .flatten()
                        .map_or(0, |it| step(it.stands)),
                    charges: charges
                        .iter()
                        .any(|time| (stay.arrives..=stay.leaves).contains(time)),
                }
            });
        AgentOrder {
            agent: way.name().to_owned(),
            heading: way.trajectory.timeline.agent.heading,
            visits: visits.collect(),
            end: way.end,
        }
    }

    fn link(&self, link: &EventLink) -> Option<Link> {
        let leaves = self.events.get(link.leaves)?;
        let comes = self.events.get(link.comes)?;
        let first = self.timing().left(link.leaves, &self.begins);
        let second = self.begin(link.comes);
        Some(Link {
            cell: link.cell,
            first: LinkEnd {
                agent: self.ways.get(leaves.agent)?.name().to_owned(),
                visit: leaves.visit.saturating_sub(1) as u32,
                time: step(first),
            },
            second: LinkEnd {
                agent: self.ways.get(comes.agent)?.name().to_owned(),
                visit: comes.visit as u32,
                time: step(second),
            },
            gap: step(link.gap),
            slack: step(second - first - link.gap),
        })
    }

    /// A rotation, from the agent that enters to the one that leaves.
    fn rotation(&self, unit: &Unit) -> Option<Rotation> {
        let moves = unit.iter().filter_map(|&event| self.event_move(event));
        Some(Rotation {
            time: step(self.begin(*unit.first()?)),
            moves: moves.collect(),
        })
    }

    fn shift(&self, event: usize) -> Option<Shift> {
        let (planned, begins) = (self.planned(event), self.begin(event));
        let shifted = self.event_move(event)?;
        (planned < begins).then(|| Shift {
            agent: shifted.agent,
            cell: shifted.cell,
            planned: step(planned),
            begins: step(begins),
        })
    }

    fn event_move(&self, event: usize) -> Option<RotationMove> {
        let it = self.events.get(event)?;
        let way = self.ways.get(it.agent)?;
        let last = way.stays.last().map(|stay| stay.cell);
        let cell: Option<Cell> = it.enters.or(last);
        Some(RotationMove {
            agent: way.name().to_owned(),
            visit: it.visit as u32,
            cell: cell?,
        })
    }
}

/// A time as it is written.
pub(crate) fn step(time: Time) -> u32 {
    u32::try_from(time.max(0)).unwrap_or(u32::MAX)
}
