//! The benchmark: the built command on instances with known answers, a process
//! a row, so that memory is measured by the system and not by the solver.
//!
//! `./x bench` builds the command and this program and runs all rows, which
//! writes `docs/benchmarks.md`; with words behind it only the rows whose names
//! hold one of them, and the tables are only printed. `./x bench --proofs` makes
//! and checks certificates instead, `./x bench --questions` answers questions,
//! `./x bench --changes` goes on where agents join others, `./x bench --crowds` looks
//! at plans and bounds of crowds after some seconds, `./x bench --rules` adds rules to scenes,
//! `./x bench --gates` sends robots through one passage, `./x bench --floor` asks about plans on
//! warehouse floors.
#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program for a terminal"
)]

mod changes;
mod crowds;
mod document;
mod floor;
mod gates;
mod proofs;
mod questions;
mod rows;
mod rules;
mod run;
mod table;

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;

use crate::rows::Group;
use crate::run::{Command, Outcome};

/// Runs the command on the instances of tests/data and tabulates its work
#[derive(Debug, Parser)]
#[expect(clippy::struct_excessive_bools, reason = "options of a command line")]
struct Args {
    /// Only the rows whose names hold one of these; nothing is written then
    #[arg(value_name = "PART")]
    parts: Vec<String>,
    /// Wall seconds for each row
    #[arg(long, value_name = "SECONDS", default_value_t = 30)]
    time_limit: u32,
    /// Only the certificates; their table is written
    #[arg(long)]
    proofs: bool,
    /// Only the questions; their table is written
    #[arg(long)]
    questions: bool,
    /// Only agents that join others; their table is written
    #[arg(long)]
    changes: bool,
    /// Only crowds; their table is written
    #[arg(long)]
    crowds: bool,
    /// Only scenes with rules of their own; their table is written
    #[arg(long)]
    rules: bool,
    /// Only robots that all pass one passage; their table is written
    #[arg(long)]
    gates: bool,
    /// Only questions on warehouse floors: the depot, and so many random floors; their table is
    /// written
    #[arg(long, value_name = "FLOORS", num_args = 0..=1, default_missing_value = "20")]
    floor: Option<u64>,
    /// With --floor: the scenes of this folder, by name, instead of random floors
    #[arg(long, value_name = "FOLDER")]
    scenes: Option<PathBuf>,
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let args = Args::parse();
    let command = Command::beside_this_program(args.time_limit)?;
    if args.proofs {
        document::put(&document::PROOFS, &proofs::table(&command)?)?;
        eprintln!("written to docs/benchmarks.md");
        return Ok(ExitCode::SUCCESS);
    }
    if args.questions {
        document::put(&document::QUESTIONS, &questions::table()?)?;
        eprintln!("written to docs/benchmarks.md");
        return Ok(ExitCode::SUCCESS);
    }
    if args.changes {
        let table = changes::table(f64::from(args.time_limit))?;
        document::put(&document::CHANGES, &table)?;
        eprintln!("written to docs/benchmarks.md");
        return Ok(ExitCode::SUCCESS);
    }
    if args.crowds {
        let table = crowds::table(&args.parts)?;
        println!("{table}");
        if args.parts.is_empty() {
            document::put(&document::CROWDS, &table)?;
            eprintln!("written to docs/benchmarks.md");
        }
        return Ok(ExitCode::SUCCESS);
    }
    if args.rules {
        let table = rules::table(&command, &args.parts)?;
        println!("{table}");
        if args.parts.is_empty() {
            document::put(&document::RULES, &table)?;
            eprintln!("written to docs/benchmarks.md");
        }
        return Ok(ExitCode::SUCCESS);
    }
    if args.gates {
        let table = gates::table(&command, &args.parts)?;
        println!("{table}");
        if args.parts.is_empty() {
            document::put(&document::GATES, &table)?;
            eprintln!("written to docs/benchmarks.md");
        }
        return Ok(ExitCode::SUCCESS);
    }
    if let Some(floors) = args.floor {
        let scenes = args.scenes.as_deref();
        let table = floor::table((floors, scenes), f64::from(args.time_limit))?;
        println!("{table}");
        document::put(&document::FLOOR, &table)?;
        eprintln!("written to docs/benchmarks.md");
        return Ok(ExitCode::SUCCESS);
    }
    let mut text = String::new();
    let mut faults = Vec::new();
    for group in rows::groups()? {
        let outcomes = run_group(&command, &group, &args.parts)?;
        faults.extend(outcomes.iter().flat_map(Outcome::faults));
        if !outcomes.is_empty() {
            text.push_str(&table::section(&group, &outcomes));
        }
    }
    println!("{text}");
    for fault in &faults {
        eprintln!("{fault}");
    }
    if !faults.is_empty() {
        return Ok(ExitCode::FAILURE);
    }
    if args.parts.is_empty() {
        document::put(&document::TABLES, &text)?;
        eprintln!("written to docs/benchmarks.md");
    }
    Ok(ExitCode::SUCCESS)
}

fn run_group<'a>(
    command: &Command,
    group: &'a Group,
    parts: &[String],
) -> Result<Vec<Outcome<'a>>, Box<dyn Error>> {
    let is_wanted = |name: &str| parts.is_empty() || parts.iter().any(|part| name.contains(part));
    let mut outcomes = Vec::new();
    for row in group.rows.iter().filter(|row| is_wanted(&row.name)) {
        let outcome = command.run(row)?;
        eprintln!("{}", outcome.line());
        outcomes.push(outcome);
    }
    Ok(outcomes)
}
