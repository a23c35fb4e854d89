//! One row: the command as a process of its own, its answer and its cost.

use std::env;
use std::error::Error;
use std::io::Read;
use std::path::PathBuf;
use std::process::{self, Stdio};

use giveway_model::Cost;
use giveway_solve::{SolveAnswer, Status};
use wait4::Wait4;

use crate::rows::Row;

/// The command under measurement.
pub(crate) struct Command {
    program: PathBuf,
    /// Wall seconds for each row.
    time_limit: u32,
}

/// What a row came to.
pub(crate) struct Outcome<'a> {
    pub(crate) row: &'a Row,
    pub(crate) answer: SolveAnswer,
    /// CPU seconds of the whole process, reading and writing included.
    pub(crate) cpu_seconds: f64,
    /// The most memory that the process held at once, in bytes, by the system.
    pub(crate) peak_bytes: u64,
}

impl Command {
    /// The command `giveway` in the folder of this program, where cargo puts
    /// both of them.
    ///
    /// # Errors
    /// Where it was not built.
    pub(crate) fn beside_this_program(time_limit: u32) -> Result<Self, Box<dyn Error>> {
        let program =
            env::current_exe()?.with_file_name(format!("giveway{}", env::consts::EXE_SUFFIX));
        if !program.is_file() {
            let place = program.display();
            return Err(format!("{place} is missing: `./x bench` builds it").into());
        }
        Ok(Self {
            program,
            time_limit,
        })
    }

    /// Runs the command with these words to its end, which must be a good one;
    /// the CPU seconds of the process.
    ///
    /// # Errors
    /// Where it cannot be run or does not end well.
    pub(crate) fn seconds(&self, words: &[&str]) -> Result<f64, Box<dyn Error>> {
        self.seconds_with_status(words, 0)
    }

    /// The same of a call that ends with another exit status.
    ///
    /// # Errors
    /// Where it cannot be run or ends otherwise.
    pub(crate) fn seconds_with_status(
        &self,
        words: &[&str],
        status: i32,
    ) -> Result<f64, Box<dyn Error>> {
        let mut command = process::Command::new(&self.program);
        command.args(words);
        command.stdin(Stdio::null()).stdout(Stdio::null());
        let ended = command.spawn()?.wait4()?;
        if ended.status.code() != Some(status) {
            return Err(format!("giveway {}: {}", words.join(" "), ended.status).into());
        }
        Ok((ended.rusage.utime + ended.rusage.stime).as_secs_f64())
    }

    /// The standard output of the command with these words.
    ///
    /// # Errors
    /// Where it cannot be run or does not end well.
    pub(crate) fn output(&self, words: &[&str]) -> Result<String, Box<dyn Error>> {
        let ended = process::Command::new(&self.program).args(words).output()?;
        if !ended.status.success() {
            return Err(format!("giveway {}: {}", words.join(" "), ended.status).into());
        }
        Ok(String::from_utf8(ended.stdout)?)
    }

    /// Runs one row to its end.
    ///
    /// # Errors
    /// Where the process cannot be run or does not answer as documented.
    pub(crate) fn run<'a>(&self, row: &'a Row) -> Result<Outcome<'a>, Box<dyn Error>> {
        let mut command = process::Command::new(&self.program);
        command.args(["solve", "--quiet", "--format", "json"]);
        command.arg(&row.file);
        command.args(["--objective", &row.objective.to_string()]);
        command.args(["--time-limit", &self.time_limit.to_string()]);
        if let Some(agents) = row.agents {
            command.args(["--agents", &agents.to_string()]);
        }
        let mut child = command
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .spawn()?;
        let mut text = String::new();
        if let Some(mut stdout) = child.stdout.take() {
            stdout.read_to_string(&mut text)?;
        }
        let ended = child.wait4()?;
        let answer = serde_json::from_str(&text)
            .map_err(|error| format!("{}: {}, {error}", row.name, ended.status))?;
        let used = ended.rusage;
        Ok(Outcome {
            row,
            answer,
            cpu_seconds: (used.utime + used.stime).as_secs_f64(),
            peak_bytes: used.maxrss,
        })
    }
}

impl Outcome<'_> {
    /// A line for the terminal while the others run.
    pub(crate) fn line(&self) -> String {
        format!(
            "{} for {}: {}, {:.2} s",
            self.row.name,
            self.row.objective,
            self.status(),
            self.cpu_seconds
        )
    }

    /// The status in a word.
    pub(crate) fn status(&self) -> &'static str {
        match self.answer.status {
            Status::Optimal => "optimal",
            Status::Feasible => "feasible",
            Status::Impossible => "impossible",
            Status::Unknown => "unknown",
        }
    }

    /// The value of a cost and how much of it is proved: `35`; `31 to 35` where
    /// the bound is lower; `<= 35` where there is none yet; `-` without a plan.
    pub(crate) fn cost(&self, cost: Cost) -> String {
        let Some(costs) = self.answer.costs else {
            return "-".to_owned();
        };
        let value = costs.get(cost);
        match self.answer.bounds.get(&cost) {
            Some(&bound) if bound == value => value.to_string(),
            Some(bound) => format!("{bound} to {value}"),
            None => format!("<= {value}"),
        }
    }

    /// Where the answer contradicts what is known.
    pub(crate) fn faults(&self) -> Vec<String> {
        let mut faults = Vec::new();
        for &(cost, value) in &self.row.known {
            let found = self.answer.costs.map(|costs| costs.get(cost));
            let bound = self.answer.bounds.get(&cost);
            let differs = self.answer.status == Status::Optimal && found != Some(value);
            if differs
                || self.answer.status == Status::Impossible
                || bound.is_some_and(|&bound| bound > value)
            {
                let (name, status, found) = (&self.row.name, self.status(), self.cost(cost));
                faults.push(format!(
                    "{name}: {status} with {cost} {found}, expected {value}"
                ));
            }
        }
        faults
    }
}
