//! The files that are missing for a scene: a map, or the problem of a solution.

use super::{Missing, Refused};
use crate::Format;
use giveway_model::format::{base_name, stem};
use giveway_model::tr;

/// The file that is missing beside a file without a map: the problem in its makers' own format, else a map,
/// by its name where the file tells it.
pub(super) fn missing(file: String, format: Format, map: Option<&str>) -> Refused {
    if let Some(problem) = problem(format) {
        return Refused::Missing {
            sentence: tr!(
                "{file} is a solution without its problem: open {problem}, which has the map and the robots, together with it.",
                file,
                problem
            ),
            what: Missing::Problem,
            file,
        };
    }
    let map = map
        .map(|map| base_name(map).to_owned())
        .filter(|map| !map.is_empty());
    let sentence = match &map {
        Some(map) => tr!(
            "{file} is for the map {map}: open {map}.map, too.",
            file,
            map = stem(map)
        ),
        None if format == Format::MovingAi => tr!(
            "{file} is a scenario that does not name its map: open the map (.map) that it was made for, too.",
            file
        ),
        None => tr!(
            "{file} does not name its map: open the map (.map) that the plan was made for, too.",
            file
        ),
    };
    Refused::Missing {
        file,
        what: Missing::Map(map),
        sentence,
    }
}

/// The file that holds the problem, where a format has one of its own.
fn problem(format: Format) -> Option<&'static str> {
    match format {
        Format::MultiRobot => Some(tr!("the input file of libMultiRobotPlanning (.yaml)")),
        Format::Asprilo => Some(tr!("its instance (.lp)")),
        Format::Mapfw => Some(tr!("the benchmark of mapfw.nl (.json)")),
        Format::Giveway
        | Format::MovingAi
        | Format::Tracker
        | Format::Paths
        | Format::Result
        | Format::ClassProject
        | Format::Grid
        | Format::League => None,
    }
}
