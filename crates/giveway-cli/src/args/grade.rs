//! The arguments of `giveway grade`.

use std::path::PathBuf;

use clap::{Args as ClapArgs, ValueEnum};
use giveway_course::grade;

use super::whole;

/// A class's hand-ins, each judged anew.
#[derive(Debug, ClapArgs)]
#[command(after_help = "\
A FILE is what the page saves at the end of a lesson (Hand in), also where a mail has quoted it;
or a list of links to hand-ins, one a line. What a file claims is not believed: every answer is
judged again by the solver and the checker, against the lessons of the course and those given
with --lesson, never against one that a file brings. Tries are the file's own word, and a name
cannot be checked. Of two files of one name the later one counts, by the date of the file; of
equal dates the one that is given last.

A claim is false where a file says that a task is solved, and it is not. The exit status is 1 if
there is one, or if no file could be judged.

Examples
  giveway grade handed-in/*.json
  giveway grade handed-in/*.json --lesson my-lesson.json --csv > class.csv
  giveway grade links.txt --order name --format json")]
pub(crate) struct Grade {
    /// Hand-ins, or lists of links to them; or - for standard input
    #[arg(value_name = "FILE", required = true)]
    pub(crate) files: Vec<PathBuf>,
    /// A lesson of your own against which files are judged (may be given several times)
    #[arg(long = "lesson", value_name = "FILE")]
    pub(crate) lessons: Vec<PathBuf>,
    /// In which order students stand
    #[arg(long, value_enum, default_value_t, value_name = "ORDER")]
    pub(crate) order: GradeOrder,
    /// Write a table for spreadsheets: a row for each student and task
    #[arg(long, conflicts_with = "format")]
    pub(crate) csv: bool,
    /// Let the solver do so many units of work for each question (see `giveway help solve`)
    #[arg(long, value_name = "N", default_value_t = grade::FIRST_WORK, value_parser = whole::<u64>, allow_negative_numbers = true)]
    pub(crate) work_limit: u64,
}

/// In which order students stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum GradeOrder {
    /// Whom to look at first: a false claim, then fewest solved, then the name
    #[default]
    First,
    /// By name
    Name,
}

impl From<GradeOrder> for grade::Order {
    fn from(order: GradeOrder) -> Self {
        match order {
            GradeOrder::First => Self::LookAtFirst,
            GradeOrder::Name => Self::Name,
        }
    }
}
