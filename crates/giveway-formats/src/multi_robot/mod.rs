//! Scenarios and schedules of libMultiRobotPlanning, in YAML.
//!
//! ```text
//! map:                              statistics:
//!   dimensions: [WIDTH, HEIGHT]       cost: 12
//!   obstacles:                        makespan: 7
//!     - [X, Y]                      schedule:
//! agents:                             agent0:
//!   - name: agent0                      - x: 0
//!     start: [X, Y]                       y: 0
//!     goal: [X, Y]                        t: 0
//! ```
//!
//! Cells count from 0, the column first. Instead of a goal an agent may have
//! `potentialGoals`, a list: it goes to any of them. The states of a schedule are in
//! ascending time; where one is left out, as the planner with safe intervals does,
//! the agent waits before its next move. The agents of a schedule are those of the scenario by
//! name; the programs number them, `agent0` and so on, in the order of the scenario. `cost` is
//! the sum of arrivals, `makespan` the largest; both may stand outside `statistics`.
//! `dynamic_obstacles` are obstacles that move (`moving`).
//!
//! Source: the programs of the library (`example/cbs.cpp`, `cbs_ta.cpp`,
//! `mapf_prioritized_sipp.cpp`) and its tests.

mod lines;
mod moving;
mod read;
mod scenario;
mod schedule;
#[cfg(test)]
mod tests;
mod write;

pub(super) use read::read;
pub(super) use write::write;

use super::yaml;

/// Whether a text has a line `schedule:`, or lines `map:` and `agents:`; else whether it has
/// these keys in another way of writing YAML, or in JSON.
pub(super) fn sniff(text: &str) -> bool {
    let (mut has_map, mut has_agents) = (false, false);
    let has_lines = text.lines().any(|line| {
        has_map |= line.starts_with("map:");
        has_agents |= line.starts_with("agents:");
        line.starts_with("schedule:") || (has_map && has_agents)
    });
    if has_lines && !text.trim_start().starts_with(['{', '[']) {
        return true;
    }
    let words = ["schedule", "dimensions"];
    if text.contains("\"giveway\"") || !words.iter().any(|word| text.contains(word)) {
        return false;
    }
    let keys = yaml::keys(text).unwrap_or_default();
    let has = |key: &str| keys.iter().any(|own| own == key);
    let is_scenario = has("map") && has("agents") && text.contains("dimensions");
    has("schedule") || is_scenario
}
