//! Instances with known answers, and the tables that tell them.

use std::fs;
use std::path::PathBuf;

use giveway_formats::movingai;
use giveway_model::format::native;
use giveway_model::{Instance, Plan};

/// A row of the table of `mmapf`; what is open is `None`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The short name, such as `A01`.
    pub name: String,
    /// The least makespan.
    pub makespan: u32,
    /// The least sum of costs at that makespan.
    pub sum_of_costs: Option<u32>,
    /// The fewest charges at these two.
    pub charges: Option<u32>,
    /// The least sum of costs whatever the makespan.
    pub sum_of_costs_first: Option<u32>,
}

/// A line of the table of standard scenarios.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ScenarioRow {
    /// The name of the map.
    pub map: String,
    /// How many agents of the first scenario.
    pub agents: usize,
    /// Their least sum of costs.
    pub sum_of_costs: u32,
}

fn path(name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "data", name].iter().collect()
}

fn read(name: &str) -> String {
    fs::read_to_string(path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// An instance in the project's own format, such as `seed/warehouse.json`.
pub fn instance(name: &str) -> Instance {
    native::read_instance(&read(name)).unwrap_or_else(|faults| panic!("{name}: {faults:?}"))
}

/// A plan, such as `seed/warehouse.plan.json`.
pub fn plan(name: &str) -> Plan {
    native::read_plan(&read(name)).unwrap_or_else(|fault| panic!("{name}: {fault}"))
}

/// The instance of a row of `mmapf` by its short name.
pub fn mmapf(name: &str) -> Instance {
    let files = fs::read_dir(path("mmapf")).unwrap();
    let mut names = files.map(|file| file.unwrap().file_name().into_string().unwrap());
    let file = names.find(|file| file.starts_with(&format!("{name}_")));
    instance(&format!("mmapf/{}", file.unwrap()))
}

/// The first agents of the first random scenario of a standard map.
pub fn scenario(map: &str, agents: usize) -> Instance {
    let grid = movingai::read_map(&read(&format!("movingai/{map}.map"))).unwrap();
    let lines = read(&format!("movingai/{map}-random-1.scen"));
    let scenario = movingai::read_scenario(&lines).unwrap();
    Instance::new(movingai::to_scene(map, &grid, &scenario, Some(agents)).unwrap()).unwrap()
}

/// The rows of the first table of `mmapf/expected.md`.
pub fn rows() -> Vec<Row> {
    let table = read("mmapf/expected.md");
    let mut rows = Vec::new();
    for line in table.lines() {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        if let [_, name, makespan, sum_of_costs, charges, _, first, _] = cells.as_slice()
            && let Some(makespan) = leading_number(makespan)
        {
            rows.push(Row {
                name: (*name).to_owned(),
                makespan,
                sum_of_costs: leading_number(sum_of_costs),
                charges: leading_number(charges),
                sum_of_costs_first: leading_number(first),
            });
        }
    }
    rows
}

/// The lines of the second table of `mmapf/expected.md`.
pub fn scenario_rows() -> Vec<ScenarioRow> {
    let table = read("mmapf/expected.md");
    let mut rows = Vec::new();
    for line in table.lines() {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let [_, map, values, _] = cells.as_slice() else {
            continue;
        };
        for value in values.split(", ") {
            if let Some((agents, sum_of_costs)) = value.split_once(": ")
                && let Some(agents) = leading_number(agents)
                && let Some(sum_of_costs) = leading_number(sum_of_costs)
            {
                rows.push(ScenarioRow {
                    map: (*map).to_owned(),
                    agents: agents as usize,
                    sum_of_costs,
                });
            }
        }
    }
    rows
}

/// The number at the beginning of a text such as `239 (SAT)`.
fn leading_number(text: &str) -> Option<u32> {
    let end = text
        .find(|c: char| !c.is_ascii_digit())
        .unwrap_or(text.len());
    text.get(..end)?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::{Row, ScenarioRow, rows, scenario_rows};

    #[test]
    fn the_tables_are_read_in_full() {
        let rows = rows();
        assert_eq!(rows.len(), 40);
        let row = |name: &str| rows.iter().find(|row| row.name == name).unwrap().clone();
        let expected = Row {
            name: "A05".to_owned(),
            makespan: 31,
            sum_of_costs: Some(254),
            charges: Some(10),
            sum_of_costs_first: Some(239),
        };
        assert_eq!(row("A05"), expected);
        assert_eq!(row("A11").sum_of_costs, None);
        assert_eq!(row("A15").charges, None);
        assert_eq!(row("B01").sum_of_costs_first, None);

        let scenarios = scenario_rows();
        assert_eq!(scenarios.len(), 28);
        let marked = ScenarioRow {
            map: "room-32-32-4".to_owned(),
            agents: 45,
            sum_of_costs: 1282,
        };
        assert!(scenarios.contains(&marked));
    }
}
