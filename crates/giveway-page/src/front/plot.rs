//! A front as a plot of its first two costs.

use giveway_model::Costs;

use super::Front;
use crate::words;

/// Where the points are on a plot, whole units from its upper left.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Plot {
    /// The points: the first cost to the right, the second upwards.
    pub points: Vec<(u32, u32)>,
    /// The least and the greatest value of the first cost, as they stand below.
    pub across: [u32; 2],
    /// Those of the second one, as they stand on the left.
    pub up: [u32; 2],
    /// The names of both costs.
    pub titles: [&'static str; 2],
}

impl Plot {
    /// The room for the points, in units: width and height.
    pub const ROOM: (u32, u32) = (260, 120);
}

impl Front {
    /// The plot of the first two costs.
    pub fn plot(&self) -> Plot {
        let [first, second, ..] = self.costs[..] else {
            return Plot::default();
        };
        let all = || self.points.iter().filter_map(|point| point.solved.costs);
        let span = |cost| {
            let values = || all().map(|costs| costs.get(cost));
            [values().min().unwrap_or(0), values().max().unwrap_or(0)]
        };
        let (across, up) = (span(first), span(second));
        let share = |value: u32, [least, most]: [u32; 2], room: u32| match most - least {
            0 => room / 2,
            span => (value - least) * room / span,
        };
        let (width, height) = Plot::ROOM;
        let place = |costs: Costs| {
            let x = share(costs.get(first), across, width);
            (x, height - share(costs.get(second), up, height))
        };
        Plot {
            points: all().map(place).collect(),
            across,
            up,
            titles: [words::title(first), words::title(second)],
        }
    }
}
