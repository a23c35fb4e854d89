//! The commands, one file each.

mod audit;
mod change;
mod check;
mod compare;
mod convert;
mod delays;
mod explain;
mod freedom;
mod grade;
mod manual;
mod order;
mod otherwise;
mod picture;
mod price;
mod proof;
mod report;
mod sizing;
mod solve;
mod sweep;
mod verify;

use crate::{
    args::{Args, Command},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input::is_standard_input,
};
use giveway_model::Fault;
use giveway_solve::Refusal;

/// Runs the command that the command line asks for.
pub(crate) fn run(args: &Args, clock: Clock) -> Result<Exit, Failure> {
    match &args.command {
        Command::Solve(solve) => solve::run(solve, &args.common, clock),
        Command::Check(check) => check::run(check, &args.common, clock),
        Command::Change(change) => change::run(change, &args.common, clock),
        Command::Audit(audit) => audit::run(audit, &args.common, clock),
        Command::Compare(compare) => compare::run(compare, &args.common),
        Command::Explain(explain) => explain::run(explain, &args.common, clock),
        Command::Freedom(freedom) => freedom::run(freedom, &args.common, clock),
        Command::Order(order) => order::run(order, &args.common, clock),
        Command::Price(price) => price::run(price, &args.common, clock),
        Command::Sizing(sizing) => sizing::run(sizing, &args.common, clock),
        Command::Convert(convert) => convert::run(convert, &args.common),
        Command::Picture(picture) => picture::run(picture, &args.common, clock),
        Command::Report(report) => report::run(report, &args.common, clock),
        Command::Verify(verify) => verify::run(verify, &args.common),
        Command::Grade(grade) => grade::run(grade, &args.common, clock),
        Command::Sweep(sweep) => sweep::run(sweep, &args.common),
        Command::Table(table) => sweep::table(table),
        Command::Completions { shell } => manual::completions(*shell),
        Command::Man { command } => manual::man(command.as_deref()),
    }
}

/// At most one of some files is read from standard input.
fn one_standard_input<'a>(
    files: impl IntoIterator<Item = &'a std::path::PathBuf>,
) -> Result<(), Failure> {
    let files = files.into_iter();
    if files.filter(|path| is_standard_input(path)).count() > 1 {
        return Err(Failure::Usage(
            "found - for two files, expected it for one of them".to_owned(),
        ));
    }
    Ok(())
}

/// What the service's refusal is to the command.
fn refused(refusal: Refusal, file: &std::path::Path) -> Failure {
    match refusal {
        Refusal::Scene { faults } => Failure::Input {
            file: file.to_string_lossy().into_owned(),
            faults,
        },
        Refusal::Request { fault } => Failure::Usage(fault.to_string()),
        refusal => Failure::Refused(refusal.sentences()),
    }
}

/// A response to another request than was made, which no service gives.
fn unexpected(file: &std::path::Path) -> Failure {
    Failure::input(
        file.to_string_lossy(),
        Fault::at(
            "",
            "a response to another request",
            "the answer to the request",
        ),
    )
}
