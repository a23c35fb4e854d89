//! Several robots said in a sentence: so many along a row, their goals along another one, as
//! many back, waypoints at random. The same sentence always gives the same robots.

mod rows;
mod waypoints;

use crate::{Agent, Battery, Cell, Grid, MAX_AGENTS};

pub use rows::straight;

use waypoints::Waypoints;

/// Robots that start along a row of cells and have their goals along another one.
///
/// ```
/// use giveway_model::{Cell, Grid, fleet::Fleet};
/// let grid = Grid::from_rows(&["....", "....", "...."]).unwrap();
/// let fleet = Fleet {
///     goals: Some((Cell::new(3, 0), Cell::new(3, 2))),
///     back: true,
///     ..Fleet::along(Cell::new(0, 0), Cell::new(0, 2))
/// };
/// let agents = fleet.agents(&grid, &[]);
/// assert_eq!(agents.len(), 6);
/// assert_eq!(agents[3].start, Cell::new(3, 0));
/// // Mixed, the first of them are as many there as back.
/// let mixed = fleet.mixed(&grid);
/// assert_eq!(mixed[0].start, mixed[1].goal.unwrap());
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fleet {
    /// Where they start: from a cell to another one, in one of eight directions.
    pub starts: (Cell, Cell),
    /// Where they go; `None` while that is not known.
    pub goals: Option<(Cell, Cell)>,
    /// From one robot of the row to the next, in cells.
    pub every: u32,
    /// So many along the row, evenly, instead of one every few cells.
    pub count: Option<u32>,
    /// Whether as many go the other way.
    pub back: bool,
    /// How many waypoints each has, drawn of the cells beside obstacles.
    pub waypoints: u32,
    /// Their battery.
    pub battery: Option<Battery>,
    /// The number of the draw: the seed of all that is drawn.
    pub draw: u32,
}

/// A start and a goal.
type Way = (Cell, Option<Cell>);

impl Fleet {
    /// A robot on each cell of a row, which go nowhere yet.
    pub const fn along(from: Cell, to: Cell) -> Self {
        Self {
            starts: (from, to),
            goals: None,
            every: 1,
            count: None,
            back: false,
            waypoints: 0,
            battery: None,
            draw: 1,
        }
    }

    /// The robots, as many as there are free starts and goals for beside those that are there:
    /// first all that go there, then those that come back. Until it is known where they go,
    /// they have no goals.
    pub fn agents(&self, grid: &Grid, there: &[Agent]) -> Vec<Agent> {
        let ways = self.ways(grid, there).concat();
        self.named(ways, grid, there)
    }

    /// The robots of a floor without any other one, in an order that is drawn: of each number
    /// of first ones half go there, half come back. A robot is the same however many follow.
    pub fn mixed(&self, grid: &Grid) -> Vec<Agent> {
        let [go, come] = self.ways(grid, &[]);
        let mut order: Vec<usize> = (0..go.len()).collect();
        fastrand::Rng::with_seed(self.draw.into()).shuffle(&mut order);
        let both = |place: usize| [go.get(place), come.get(place)];
        let ways = order.into_iter().flat_map(both).flatten();
        self.named(ways.copied().collect(), grid, &[])
    }

    /// The robots by their ways, with names, waypoints and battery.
    fn named(&self, ways: Vec<Way>, grid: &Grid, there: &[Agent]) -> Vec<Agent> {
        let room = MAX_AGENTS.saturating_sub(there.len());
        let names = fresh_names(there, ways.len().min(room));
        let mut waypoints = Waypoints::of(grid, &ways, self.draw);
        let agent = |(name, (start, goal)): (String, Way)| Agent {
            waypoints: goal.map_or_else(Vec::new, |_| waypoints.draw(start, self.waypoints)),
            name,
            start,
            goal,
            battery: self.battery,
            heading: None,
        };
        names.into_iter().zip(ways).map(agent).collect()
    }
}

/// So many names that none of the agents has, of the least free numbers: `A1`, `A2`.
pub fn fresh_names(agents: &[Agent], count: usize) -> Vec<String> {
    let names = agents.iter().map(|agent| agent.name.as_str());
    let taken: std::collections::BTreeSet<&str> = names.collect();
    let names = (1..=agents.len() + count).map(|number| format!("A{number}"));
    let free = names.filter(|name| !taken.contains(name.as_str()));
    free.take(count).collect()
}
