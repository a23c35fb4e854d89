//! The arguments of `giveway sizing`.

use std::path::PathBuf;
use std::str::FromStr;

use clap::Args as ClapArgs;
use giveway_model::{Battery, Cell, Objective};

use super::{Source, seconds, whole};

/// How many robots a floor bears.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
For each number of robots a plan of its own, solved as by solve: when the last one arrives, how late
the robots are on average against alone, and what is proved. The first robots are the same in every
plan. With --starts and --goals robots are drawn onto the floor in the place of its own; without
them they are those of the instance, in their order.

Examples
  giveway sizing floor.json --robots 4..16/4
  giveway sizing depot.json --robots 4..44/4 --starts 1,1..1,22 --goals 38,1..38,22 --back \\
      --waypoints 2 --battery 80/60 --seconds 5 --csv
  giveway sizing depot.json --robots 4..16/4 --beside depot-with-a-charger-more.json
  giveway sizing floor.json --robots 2..8 --starts 0,0..0,7 --goals 9,0..9,7 --save drawn.json
  giveway solve drawn.json --agents 6")]
pub(crate) struct Sizing {
    #[command(flatten)]
    pub(crate) source: Source,
    /// The numbers of robots: from, to, and how many more each time
    #[arg(long, value_name = "FROM..TO/BY")]
    pub(crate) robots: Numbers,
    /// The cells at which robots start, from one to another
    #[arg(long, value_name = "X,Y..X,Y", requires = "goals")]
    pub(crate) starts: Option<Row>,
    /// The cells of their goals, from one to another
    #[arg(long, value_name = "X,Y..X,Y", requires = "starts")]
    pub(crate) goals: Option<Row>,
    /// Every second robot goes the other way
    #[arg(long, requires = "starts")]
    pub(crate) back: bool,
    /// So many waypoints for each robot, drawn of the cells beside obstacles
    #[arg(long, value_name = "N", default_value_t = 0, requires = "starts", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) waypoints: u32,
    /// What each battery holds, and its level at the start [default: none; it starts full]
    #[arg(long, value_name = "CAPACITY/LEVEL", requires = "starts")]
    pub(crate) battery: Option<Charge>,
    /// The number of the draw: another one gives other waypoints and another order of robots
    #[arg(long, value_name = "N", default_value_t = 1, requires = "starts", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) draw: u32,
    /// Another floor for the same robots, compared by the sum of costs
    #[arg(long, value_name = "FILE")]
    pub(crate) beside: Option<PathBuf>,
    /// The costs to minimise, the most important first [default: the instance's own, or
    /// makespan,sum-of-costs,charges]
    #[arg(long, value_name = "LIST")]
    pub(crate) objective: Option<Objective>,
    /// Look only at plans of at most this makespan
    #[arg(long, value_name = "N", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) within: Option<u32>,
    /// Stop each solve after so many seconds; 0.5 is allowed
    #[arg(long, value_name = "SECONDS", default_value_t = 5.0, value_parser = seconds, allow_negative_numbers = true)]
    pub(crate) seconds: f64,
    /// Write a table for spreadsheets
    #[arg(long, conflicts_with = "format")]
    pub(crate) csv: bool,
    /// Write the floor with all robots that are drawn into a file: what `solve --agents N` finds
    /// for it can be set beside the plan of N robots
    #[arg(long, value_name = "FILE", requires = "starts")]
    pub(crate) save: Option<PathBuf>,
}

/// Numbers of robots: `4..44/4`, `4..8` or `16`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Numbers {
    from: u32,
    to: u32,
    by: u32,
}

impl Numbers {
    /// The numbers, ascending.
    pub(crate) fn all(self) -> Vec<u32> {
        (self.from..=self.to).step_by(self.by as usize).collect()
    }
}

impl FromStr for Numbers {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (range, by) = text.split_once('/').unwrap_or((text, "1"));
        let (from, to) = range.split_once("..").unwrap_or((range, range));
        let number = |text: &str| text.parse::<u32>().ok().filter(|&n| n > 0);
        match (number(from), number(to), number(by)) {
            (Some(from), Some(to), Some(by)) if from <= to => Ok(Self { from, to, by }),
            _ => Err(format!(
                "found \"{text}\", expected numbers from 1 such as 4..44/4, the first not above the last"
            )),
        }
    }
}

/// A row of cells: `1,1..1,22`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Row(pub(crate) Cell, pub(crate) Cell);

impl FromStr for Row {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (from, to) = text.split_once("..").unwrap_or((text, text));
        let cell = |text: &str| {
            let (x, y) = text.split_once(',')?;
            Some(Cell::new(x.trim().parse().ok()?, y.trim().parse().ok()?))
        };
        match (cell(from), cell(to)) {
            (Some(from), Some(to)) => Ok(Self(from, to)),
            _ => Err(format!(
                "found \"{text}\", expected two cells such as 1,1..1,22"
            )),
        }
    }
}

/// A battery: `80/60`, or `80` for a full one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Charge(pub(crate) Battery);

impl FromStr for Charge {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (capacity, level) = text.split_once('/').unwrap_or((text, text));
        match (capacity.parse::<u32>(), level.parse::<u32>()) {
            (Ok(capacity), Ok(initial)) if capacity > 0 && initial <= capacity => {
                Ok(Self(Battery { capacity, initial }))
            }
            _ => Err(format!(
                "found \"{text}\", expected a capacity above 0 and a level up to it, such as 80/60"
            )),
        }
    }
}
