//! What is run: the two tables of `tests/data/mmapf/expected.md`.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::{fs, io};

use giveway_model::{Cost, Objective};
use giveway_tests::known;

/// Rows that share an objective, and become one table.
pub(crate) struct Group {
    /// The heading of the table.
    pub(crate) title: &'static str,
    /// The objective; its costs are columns.
    pub(crate) objective: Objective,
    /// The rows, in the order of `expected.md`.
    pub(crate) rows: Vec<Row>,
}

/// One run of the command.
pub(crate) struct Row {
    /// What the row is called in the table.
    pub(crate) name: String,
    /// The instance.
    pub(crate) file: PathBuf,
    /// How many agents of it, where not all.
    pub(crate) agents: Option<usize>,
    /// What is minimised.
    pub(crate) objective: Objective,
    /// The optima that are known.
    pub(crate) known: Vec<(Cost, u32)>,
}

/// All that is run.
///
/// # Errors
/// Where a file of `tests/data` is missing.
pub(crate) fn groups() -> Result<Vec<Group>, Box<dyn Error>> {
    Ok(vec![graded()?, graded_by_sum()?, standard()?])
}

fn graded() -> io::Result<Group> {
    let objective = Objective::default();
    let mut rows = Vec::new();
    for row in known::rows() {
        let mut known = vec![(Cost::Makespan, row.makespan)];
        known.extend(row.sum_of_costs.map(|value| (Cost::SumOfCosts, value)));
        known.extend(row.charges.map(|value| (Cost::Charges, value)));
        rows.push(graded_row(&row.name, &objective, known)?);
    }
    Ok(Group {
        title: "Graded instances: makespan, then sum of costs, then charges",
        objective,
        rows,
    })
}

fn graded_by_sum() -> Result<Group, Box<dyn Error>> {
    let objective: Objective = "sum-of-costs,makespan,charges".parse()?;
    let mut rows = Vec::new();
    for row in known::rows() {
        if let Some(value) = row.sum_of_costs_first {
            let known = vec![(Cost::SumOfCosts, value)];
            rows.push(graded_row(&row.name, &objective, known)?);
        }
    }
    Ok(Group {
        title: "Graded instances: sum of costs, then makespan, then charges",
        objective,
        rows,
    })
}

fn graded_row(name: &str, objective: &Objective, known: Vec<(Cost, u32)>) -> io::Result<Row> {
    let (stem, file) = graded_file(name)?;
    Ok(Row {
        name: stem,
        file,
        agents: None,
        objective: objective.clone(),
        known,
    })
}

/// The file of a short name such as `A01`, and its name without the ending.
pub(crate) fn graded_file(name: &str) -> io::Result<(String, PathBuf)> {
    let beginning = format!("{name}_");
    for entry in fs::read_dir(data("mmapf"))? {
        let path = entry?.path();
        let stem = path.file_stem().and_then(|stem| stem.to_str());
        if let Some(stem) = stem.filter(|stem| stem.starts_with(&beginning)) {
            return Ok((stem.to_owned(), path.clone()));
        }
    }
    Err(io::Error::new(
        io::ErrorKind::NotFound,
        format!("tests/data/mmapf has no file for {name}"),
    ))
}

fn standard() -> Result<Group, Box<dyn Error>> {
    let objective: Objective = "sum-of-costs".parse()?;
    let row = |row: known::ScenarioRow| Row {
        name: format!("{}, {} agents", row.map, row.agents),
        file: data(&format!("movingai/{}-random-1.scen", row.map)),
        agents: Some(row.agents),
        objective: objective.clone(),
        known: vec![(Cost::SumOfCosts, row.sum_of_costs)],
    };
    let rows = known::scenario_rows().into_iter().map(row).collect();
    Ok(Group {
        title: "Standard scenarios: sum of costs",
        objective,
        rows,
    })
}

/// A place under `tests/data`.
pub(crate) fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../data")
        .join(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_row_has_its_file() {
        for group in groups().unwrap() {
            assert!(!group.rows.is_empty(), "{}", group.title);
            for row in group.rows {
                assert!(row.file.is_file(), "{}", row.file.display());
            }
        }
    }
}
