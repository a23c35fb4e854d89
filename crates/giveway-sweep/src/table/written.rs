//! What is made of rows, by its name.

use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::together::completed;
use super::{Axes, Curve, Sheet, all, cactus, optima, planners, plot, success, summary};
use crate::Row;

/// What a table or a plot shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Show {
    /// How many tasks of each map, objective, planner and number of agents ended how.
    #[default]
    Summary,
    /// Every row.
    Rows,
    /// The bounds of every row that was tried, and its certificate.
    Optima,
    /// The success rate against the number of agents.
    Success,
    /// How many tasks succeeded within how many CPU seconds each.
    Cactus,
    /// Planners beside what is proved: what each solved, how fast, how far from the best.
    Planners,
}

/// How it is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Written {
    /// A table for people and for pages.
    #[default]
    Markdown,
    /// Comma-separated values.
    Csv,
    /// A plot.
    Svg,
    /// A page with table and plots, of planners.
    Html,
}

impl FromStr for Show {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Ok(match text {
            "summary" => Self::Summary,
            "rows" => Self::Rows,
            "optima" => Self::Optima,
            "success" => Self::Success,
            "cactus" => Self::Cactus,
            "planners" => Self::Planners,
            _ => {
                return Err(format!(
                    "found \"{text}\", expected summary, rows, optima, success, cactus or planners"
                ));
            }
        })
    }
}

impl FromStr for Written {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Ok(match text {
            "markdown" => Self::Markdown,
            "csv" => Self::Csv,
            "svg" => Self::Svg,
            "html" => Self::Html,
            _ => {
                return Err(format!(
                    "found \"{text}\", expected markdown, csv, svg or html"
                ));
            }
        })
    }
}

/// Makes a table or a plot.
///
/// # Errors
/// When a table is wanted as a plot, or as a page that is none of planners, as a sentence.
pub fn write(rows: &[Row], show: Show, to: Written) -> Result<String, String> {
    let rows = &completed(rows);
    match show {
        Show::Summary => sheet(&summary(rows), to),
        Show::Rows => sheet(&all(rows), to),
        Show::Optima => sheet(&optima(rows), to),
        Show::Success => drawn(&success(rows), Axes::Success, to),
        Show::Cactus => drawn(&cactus(rows), Axes::Cactus, to),
        Show::Planners => Ok(beside_proofs(rows, to)),
    }
}

fn beside_proofs(rows: &[Row], to: Written) -> String {
    let comparisons = planners::comparisons(rows);
    match to {
        Written::Markdown => planners::text(&comparisons),
        Written::Csv => planners::sheet(&comparisons).csv(),
        Written::Svg => planners::both(&comparisons),
        Written::Html => planners::page(&comparisons),
    }
}

fn drawn(curves: &[Curve], axes: Axes, to: Written) -> Result<String, String> {
    let (x, y) = match axes {
        Axes::Success => ("agents", "success rate"),
        Axes::Cactus => ("successful tasks", "CPU s each"),
    };
    match to {
        Written::Svg => plot(curves, axes),
        to => sheet(&Sheet::of_curves(curves, x, y), to),
    }
}

fn sheet(sheet: &Sheet, to: Written) -> Result<String, String> {
    match to {
        Written::Markdown => Ok(sheet.markdown()),
        Written::Csv => Ok(sheet.csv()),
        Written::Svg => Err(
            "Found svg for a table, expected markdown or csv; success, cactus and planners are drawn."
                .to_owned(),
        ),
        Written::Html => Err(
            "Found html, expected markdown or csv; only planners are written as a page.".to_owned(),
        ),
    }
}
