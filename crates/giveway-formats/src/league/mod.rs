//! Results of the League of Robot Runners, 2023, 2024 and 2026.
//!
//! ```text
//! { "actionModel": "MAPF_T" | "MAPF",
//!   "version": "2024 LoRR" | "2026 LoRR",              not in 2023
//!   "start": [[ROW, COLUMN, "E" | "S" | "W" | "N" | "N/A"], ..],
//!   "actualPaths": ["F,R,F,W", ..],                      2023, 2024: a letter a step
//!                  ["[(0,14,55,0,0):(C 10,F 20)]..", ..]  2026: letters for so many ticks
//!   "tasks": [[ID, ROW, COLUMN], ..],                    2023
//!            [[ID, RELEASE, [ROW, COLUMN, ..]], ..],     2024, 2026: errands
//!   "events": [[[TASK, TIME, "finished"], ..], ..],      2023: a list for each robot
//!             [[TIME, ROBOT, TASK, ERRANDS], ..],        2024, 2026: so many are done
//!   "AllValid", "errors", "sumOfCost", "makespan", .. }
//! ```
//!
//! Rows and columns count from 0. In the action model `MAPF_T`, `F` goes ahead, `R`
//! turns clockwise, `C` counterclockwise; in `MAPF`, `U` raises the row, `D` lowers
//! it, and `R` goes to the right. `W` and `T` wait. In 2026 a move or a turn takes
//! `agentMaxCounter` ticks, which a wait may interrupt. A start that looks to the
//! south is written `[ROW, COLUMN, "S", "W"]` by the makers' own program.
//!
//! `sumOfCost` is the number of steps in which robots had a task, `makespan` the
//! largest of these of one robot (2026: the ticks that were simulated): both count
//! to the end of the simulation, so they differ from costs that count arrivals.
//!
//! Source: the Start-Kit of the League (`saveResults`, its action model) and its
//! viewer `PlanViz`.

mod errands;
mod fields;
mod problem;
mod read;
mod steps;
mod ticks;
mod turning;
mod write;

use giveway_model::format::locate::Fields;

pub use problem::Problem;
pub(super) use problem::{Texts, scene};
pub(super) use read::read;
pub(super) use write::write;

/// Whether a text is a JSON object with the keys of a result, of its summary or of a
/// problem.
pub(super) fn sniff(text: &str) -> bool {
    let keys = ["\"actualPaths\"", "\"teamSize\"", "\"mapFile\""];
    text.trim_start().starts_with('{')
        && keys.iter().any(|key| text.contains(key))
        && serde_json::from_str::<Fields<'_>>(text).is_ok_and(|fields| {
            fields.has("actualPaths")
                || is_summary(&fields)
                || (fields.has("mapFile") && fields.has("agentFile"))
        })
}

/// Whether an object has keys of a result, and neither paths nor files.
fn is_summary(fields: &Fields<'_>) -> bool {
    let results = ["actionModel", "makespan", "numTaskFinished", "sumOfCost"];
    fields.has("teamSize")
        && !fields.has("actualPaths")
        && !fields.has("mapFile")
        && results.into_iter().any(|key| fields.has(key))
}
