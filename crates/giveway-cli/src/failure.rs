//! Why the command could not answer, and how that is said.

use std::io;

use clap::{CommandFactory, error::ErrorKind};
use giveway_model::Fault;

use crate::{
    args::Args,
    exit::Exit,
    output::{plain, stream},
};

/// So many faults are told one by one; the rest is counted.
const TOLD: usize = 20;

/// Why the command could not answer.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The input is wrong: the name of the file, and at least one fault.
    Input {
        /// The file, as the person wrote it.
        file: String,
        /// What is wrong with it.
        faults: Vec<Fault>,
    },
    /// What was asked cannot be answered: sentences.
    Refused(Vec<String>),
    /// The command line is wrong: a sentence without its full stop.
    Usage(String),
    /// A result could not be written.
    Output {
        /// The file, or "standard output".
        target: String,
        /// What the system said.
        error: io::Error,
    },
}

impl Failure {
    /// A fault of a file as a whole, or at a place that the fault names.
    pub(crate) fn input(file: impl Into<String>, fault: Fault) -> Self {
        Self::Input {
            file: file.into(),
            faults: vec![fault],
        }
    }

    /// A file that could not be written.
    pub(crate) fn output(target: impl Into<String>, error: io::Error) -> Self {
        Self::Output {
            target: target.into(),
            error,
        }
    }

    /// What is wrong, a line each.
    pub(crate) fn lines(&self) -> Vec<String> {
        match self {
            Self::Input { file, faults } => fault_lines(file, faults),
            Self::Refused(sentences) => {
                let told = sentences.iter().take(TOLD);
                let mut lines: Vec<String> = told.map(|line| plain::text(line)).collect();
                if sentences.len() > TOLD {
                    lines.push(format!("and {} more", sentences.len() - TOLD));
                }
                lines
            }
            Self::Usage(sentence) => vec![plain::text(sentence)],
            Self::Output { target, error } => vec![format!("{target}: cannot write: {error}")],
        }
    }

    /// Says on standard error what is wrong.
    pub(crate) fn tell(&self) -> Exit {
        if let Self::Usage(sentence) = self {
            let error = Args::command().error(ErrorKind::ArgumentConflict, sentence);
            // Where standard error is closed there is nobody to tell.
            let _ = error.print();
            return Exit::Usage;
        }
        stream::error_lines(&self.lines());
        Exit::Wrong
    }
}

/// One line a fault.
fn fault_lines(file: &str, faults: &[Fault]) -> Vec<String> {
    let mut lines: Vec<String> = faults
        .iter()
        .take(TOLD)
        .map(|fault| plain::text(&format!("{file}: {fault}")))
        .collect();
    if faults.len() > TOLD {
        lines.push(format!(
            "{}: and {} more",
            plain::text(file),
            faults.len() - TOLD
        ));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faults_beyond_the_twentieth_are_counted() {
        let faults = vec![Fault::at("agents", "a", "b"); 23];
        let lines = fault_lines("x.json", &faults);
        assert_eq!(lines.len(), 21);
        assert_eq!(lines[0], "x.json: agents: found a, expected b");
        assert_eq!(lines[20], "x.json: and 3 more");
    }

    #[test]
    fn a_fault_is_one_line_whatever_the_file_is_called() {
        let lines = fault_lines("a\nb\u{1b}[1m", &[Fault::at("", "x", "y")]);
        assert_eq!(lines, ["a\\nb\\u{1b}[1m: found x, expected y"]);
    }
}
