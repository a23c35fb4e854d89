//! Reads a `.scen`.

use crate::lines::{Line, decimal, lines};
use giveway_model::format::text::without_mark;
use giveway_model::words::Later;
use giveway_model::{Cell, Fault, tr, tr_later};

/// The agents of a scenario, in the order of its lines.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scenario {
    /// One route a line.
    pub routes: Vec<Route>,
    /// Whether the file does not say its version.
    pub lacks_version: bool,
}

impl Scenario {
    /// A remark on the file, a sentence.
    pub fn note(&self) -> Option<String> {
        self.lacks_version.then(|| {
            tr!("The scenario has no line \"version 1\" at its beginning; it is read as version 1.").to_owned()
        })
    }

    /// The name of the map of the first line, as it is written: often a file
    /// beside the scenario, sometimes with folders before it. `None` where there
    /// are no lines.
    pub fn map_name(&self) -> Option<&str> {
        self.routes.first().map(|route| route.map.as_str())
    }
}

/// A line of a scenario: one agent's start and goal.
#[derive(Clone, Debug, PartialEq)]
pub struct Route {
    /// The number of the line in the file, from 1.
    pub line: usize,
    /// The bucket: an octile length divided by 4, of no meaning here.
    pub bucket: u32,
    /// The map's file name.
    pub map: String,
    /// The map's width in cells.
    pub width: u32,
    /// The map's height in cells.
    pub height: u32,
    /// Where the agent starts.
    pub start: Cell,
    /// Where it goes.
    pub goal: Cell,
    /// The length of a shortest path with diagonals: no bound for 4-connected
    /// paths.
    pub octile: f64,
}

const COLUMNS: Later =
    tr_later!("nine columns: bucket, map, width, height, start x, start y, goal x, goal y, length");

/// Whether a text is a scenario by a look at its first line.
pub fn is_scenario(text: &str) -> bool {
    let text = without_mark(text).trim_start();
    text.starts_with("version ") || lines(text).next().is_some_and(is_route)
}

/// Whether a line is a route by its columns: numbers, but for the name of a map.
fn is_route(line: Line<'_>) -> bool {
    let columns = line.columns(9);
    let [bucket, map, numbers @ ..] = columns.as_slice() else {
        return false;
    };
    let is_number = |part: &str| decimal(part).is_some();
    columns.len() == 9
        && is_number(bucket)
        && !is_number(map)
        && numbers.iter().all(|part| is_number(part))
}

/// Reads a scenario. Blank lines are skipped.
///
/// # Errors
/// When the first line is neither `version 1` or `version 1.0` nor a route, or a line has not
/// the nine columns. The fault has a line and a column.
///
/// ```
/// use giveway_formats::movingai::read_scenario;
/// use giveway_model::Cell;
/// let scenario = read_scenario("version 1\n0\tempty.map\t8\t6\t1\t0\t2\t5\t5.41\n").unwrap();
/// assert_eq!(scenario.map_name(), Some("empty.map"));
/// assert_eq!((scenario.routes[0].width, scenario.routes[0].height), (8, 6));
/// assert_eq!(scenario.routes[0].goal, Cell::new(2, 5));
/// ```
pub fn read_scenario(text: &str) -> Result<Scenario, Fault> {
    let mut lines = lines(text).filter(|line| !line.text.is_empty());
    let Some(first) = lines.next() else {
        return Err(Fault::at(
            "",
            tr_later!("an empty file"),
            tr_later!("\"version 1\" and a line for each robot"),
        )
        .in_text(1, 1));
    };
    let lacks_version = is_route(first);
    if !lacks_version {
        read_version(first)?;
    }
    let first = lacks_version.then_some(first);
    let routes = first.into_iter().chain(lines).map(read_route);
    Ok(Scenario {
        routes: routes.collect::<Result<_, _>>()?,
        lacks_version,
    })
}

fn read_version(line: Line<'_>) -> Result<(), Fault> {
    let is_one = line
        .text
        .strip_prefix("version")
        .and_then(|number| decimal(number.trim()))
        .is_some_and(|number| (number - 1.0).abs() < f64::EPSILON);
    if is_one {
        Ok(())
    } else {
        Err(line.fault(line.text, tr_later!("\"version 1\"")))
    }
}

fn read_route(line: Line<'_>) -> Result<Route, Fault> {
    let columns = line.columns(9);
    let &[bucket, map, width, height, sx, sy, gx, gy, octile] = columns.as_slice() else {
        let found = match columns.len() {
            1 => return Err(line.fault(line.text, COLUMNS)),
            n => tr!("{n} columns", n),
        };
        return Err(line.fault_saying(line.text, found, COLUMNS));
    };
    let whole = |part| line.number::<u32>(part, || tr!("a whole number from 0").to_owned());
    let length = decimal(octile).ok_or_else(|| line.fault(octile, tr_later!("a length")))?;
    Ok(Route {
        line: line.number,
        bucket: whole(bucket)?,
        map: map.to_owned(),
        width: whole(width)?,
        height: whole(height)?,
        start: Cell::new(whole(sx)?, whole(sy)?),
        goal: Cell::new(whole(gx)?, whole(gy)?),
        octile: length,
    })
}
