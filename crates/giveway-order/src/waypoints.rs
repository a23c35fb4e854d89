//! Way-points: each agent's visits in metres, seconds and headings.

use std::fmt::Write as _;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::constraint::Heading;
use giveway_model::{Cell, Units};
use serde::{Deserialize, Serialize};

use crate::{AgentOrder, Order};

/// A visit in the world: the middle of the cell, with the origin at the bottom left corner of
/// the map, `x` to the right and `y` up. Without units a cell counts as a metre and a step as a
/// second.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct Waypoint {
    /// The agent's name.
    pub agent: String,
    /// The number of the visit, from 0.
    pub visit: u32,
    /// The cell.
    pub cell: Cell,
    /// To the right, in metres.
    pub x: f64,
    /// Up, in metres.
    pub y: f64,
    /// When it arrives, in seconds.
    pub arrives: f64,
    /// When it begins to leave, in seconds; `null` where it stays.
    pub leaves: Option<f64>,
    /// Where it faces as it arrives, in degrees counterclockwise from the right: 0, 90 (up), 180
    /// or -90. At its first cell it is the heading of the scene, else that of its first move;
    /// `null` where there is neither.
    pub heading: Option<i32>,
}

/// Where the middles of cells are, and how long steps take.
#[derive(Clone, Copy, Debug)]
pub(crate) struct World {
    /// The rows of the map.
    height: u32,
    units: Option<Units>,
}

/// A length or a time in 10,000ths of its unit, so that half a cell of whole millimetres is exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Exact(u64);

impl Exact {
    pub(crate) const fn number(self) -> f64 {
        self.0 as f64 / 10_000.0
    }

    /// The exact number: `1.25`.
    fn text(self) -> String {
        let (whole, rest) = (self.0 / 10_000, self.0 % 10_000);
        if rest == 0 {
            return whole.to_string();
        }
        let rest = format!("{rest:04}");
        format!("{whole}.{}", rest.trim_end_matches('0'))
    }
}

impl World {
    pub(crate) const fn new(height: u32, units: Option<Units>) -> Self {
        Self { height, units }
    }

    /// The middle of a cell: to the right, and up.
    pub(crate) fn middle(self, cell: Cell) -> (Exact, Exact) {
        let side = self.units.map_or(1000, |units| units.cell.thousandths());
        let half = |halves: u64| Exact(halves.saturating_mul(u64::from(side)) * 5);
        let up = u64::from(self.height.saturating_sub(cell.y));
        let right = u64::from(cell.x) * 2 + 1;
        (half(right), half((up * 2).saturating_sub(1)))
    }

    /// The time after so many steps.
    pub(crate) fn time(self, steps: u32) -> Exact {
        let step = self.units.map_or(1000, |units| units.step.thousandths());
        Exact(u64::from(steps) * u64::from(step) * 10)
    }

    /// The speed in metres a second over a cell in so many steps, where there are units.
    pub(crate) fn speed(self, steps: u32) -> Option<f64> {
        let units = self.units?;
        let time = f64::from(units.step.thousandths()) * f64::from(steps.max(1));
        Some(f64::from(units.cell.thousandths()) / time)
    }
}

/// Degrees counterclockwise from the right.
const fn degrees(heading: Heading) -> i32 {
    match heading {
        Heading::East => 0,
        Heading::North => 90,
        Heading::West => 180,
        Heading::South => -90,
    }
}

/// The heading of an agent as it arrives at each of its visits.
fn headings(agent: &AgentOrder) -> Vec<Option<i32>> {
    let visits = agent.visits.iter().zip(agent.visits.iter().skip(1));
    let mut moves = visits.map(|(from, to)| Heading::of(from.cell, to.cell));
    let mut headings: Vec<Option<Heading>> = vec![None];
    headings.extend(&mut moves);
    if let [first, rest @ ..] = headings.as_mut_slice() {
        *first = agent.heading.or_else(|| rest.first().copied().flatten());
    }
    headings.into_iter().map(|it| it.map(degrees)).collect()
}

/// The way-points of all agents, in their order; `height` is the number of rows of the map.
///
/// ```
/// use giveway_model::{change::{Changes, History}, format::native};
/// use giveway_order::{OrderGraph, waypoints};
/// let instance = native::read_instance(r#"{ "giveway": 1, "map": ["..", ".."],
///     "units": { "cell": 0.8, "step": 1.5 },
///     "agents": [{ "name": "A1", "start": [0, 1], "goal": [0, 0] }] }"#).unwrap();
/// let plan = native::read_plan(
///     r#"{ "giveway": 1, "paths": { "A1": [[0, 1], [0, 0]] } }"#).unwrap();
/// let history = History::new(&instance);
/// let changes = Changes::default();
/// let order = OrderGraph::new(&history, &changes, &plan).unwrap().order();
/// let points = waypoints(&order, 2, instance.to_scene().units);
/// assert_eq!((points[1].x, points[1].y), (0.4, 1.2));
/// assert_eq!((points[1].arrives, points[1].heading), (1.5, Some(90)));
/// ```
pub fn waypoints(order: &Order, height: u32, units: Option<Units>) -> Vec<Waypoint> {
    let world = World::new(height, units);
    let agents = order.agents.iter();
    let points = agents.flat_map(|agent| {
        let visits = agent.visits.iter().zip(headings(agent)).zip(0..);
        visits.map(move |((visit, heading), number)| {
            let (x, y) = world.middle(visit.cell);
            Waypoint {
                agent: agent.agent.clone(),
                visit: number,
                cell: visit.cell,
                x: x.number(),
                y: y.number(),
                arrives: world.time(visit.arrives).number(),
                leaves: visit.leaves.map(|leaves| world.time(leaves).number()),
                heading,
            }
        })
    });
    points.collect()
}

/// The way-points as a table of comma-separated values: a row a visit. The head says the
/// units: metres and seconds, or cells and steps where the scene has no units.
pub fn csv(order: &Order, height: u32, units: Option<Units>) -> String {
    let world = World::new(height, units);
    let (length, time) = match units {
        Some(_) => ("m", "s"),
        None => ("cells", "steps"),
    };
    let mut text = format!(
        "agent,visit,column,row,x_{length},y_{length},arrives_{time},leaves_{time},heading_deg\n"
    );
    for agent in &order.agents {
        for ((visit, heading), number) in agent.visits.iter().zip(headings(agent)).zip(0..) {
            let (x, y) = world.middle(visit.cell);
            let leaves = visit.leaves.map(|leaves| world.time(leaves).text());
            let _ = writeln!(
                text,
                "{},{number},{},{},{},{},{},{},{}",
                giveway_model::csv::text(&agent.agent),
                visit.cell.x,
                visit.cell.y,
                x.text(),
                y.text(),
                world.time(visit.arrives).text(),
                leaves.unwrap_or_default(),
                heading.map_or(String::new(), |degrees| degrees.to_string()),
            );
        }
    }
    text
}
