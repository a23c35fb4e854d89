//! The progress line: one line on standard error, written over and over.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io::{self, IsTerminal, Write};

use giveway_model::words::{count, value};
use giveway_model::{Cost, Costs, Objective};
use giveway_solve::words::known;
use giveway_solve::{Host, Progress};

use crate::{clock::Clock, interrupt, output::plain};

/// A command that answers faster shows no progress at all.
const FIRST_SECONDS: f64 = 0.3;
/// The line is written at most this often.
const EVERY_SECONDS: f64 = 0.1;

/// The surroundings that the command lends to the solver: its clock, and, on a
/// terminal, a line that tells how far it is.
pub(crate) struct CommandHost {
    clock: Clock,
    line: Option<RefCell<SearchLine>>,
}

impl CommandHost {
    /// A host with a progress line, unless `quiet` or standard error is no
    /// terminal. From now on Ctrl-C ends the search, whose best plan is told.
    pub(crate) fn new(clock: Clock, quiet: bool, objective: Objective) -> Self {
        interrupt::listen();
        let shown = !quiet && io::stderr().is_terminal();
        Self {
            clock,
            line: shown.then(|| {
                RefCell::new(SearchLine {
                    line: Line::new(),
                    known: Known::new(objective),
                })
            }),
        }
    }

    /// Takes the line away; the answer may be written now.
    pub(crate) fn finish(self) {
        if let Some(line) = self.line {
            line.into_inner().line.clear();
        }
    }

    fn refresh(&self) {
        if let Some(line) = &self.line {
            let SearchLine { line, known } = &mut *line.borrow_mut();
            let seconds = self.clock.wall_seconds();
            line.show(seconds, || known.words(seconds));
        }
    }
}

impl Host for CommandHost {
    fn wall_seconds(&self) -> f64 {
        self.clock.wall_seconds()
    }

    fn cpu_seconds(&self) -> f64 {
        self.clock.cpu_seconds()
    }

    /// Asked often, also while nothing becomes known: the seconds go on.
    fn cancelled(&self) -> bool {
        self.refresh();
        interrupt::happened()
    }

    fn progress(&self, event: &Progress) {
        if let Some(line) = &self.line {
            line.borrow_mut().known.learn(event);
            self.refresh();
        }
    }
}

/// The line of a search, with what it tells.
struct SearchLine {
    line: Line,
    known: Known,
}

/// The line while one thing after the other is done.
pub(crate) struct StepLine {
    clock: Clock,
    line: Option<Line>,
}

impl StepLine {
    /// A line, unless `quiet` or standard error is no terminal.
    pub(crate) fn new(clock: Clock, quiet: bool) -> Self {
        let shown = !quiet && io::stderr().is_terminal();
        let line = shown.then(Line::new);
        Self { clock, line }
    }

    /// Tells what is done now.
    pub(crate) fn show(&mut self, words: impl FnOnce() -> String) {
        if let Some(line) = &mut self.line {
            line.show(self.clock.wall_seconds(), words);
        }
    }

    /// Takes the line away.
    pub(crate) fn clear(self) {
        if let Some(line) = self.line {
            line.clear();
        }
    }
}

/// The line on the terminal.
struct Line {
    next_seconds: f64,
    shown_columns: usize,
}

impl Line {
    const fn new() -> Self {
        Self {
            next_seconds: FIRST_SECONDS,
            shown_columns: 0,
        }
    }

    fn show(&mut self, seconds: f64, words: impl FnOnce() -> String) {
        if seconds < self.next_seconds {
            return;
        }
        self.next_seconds = seconds + EVERY_SECONDS;
        let columns = terminal_size::terminal_size_of(io::stderr())
            .map_or(80, |(width, _)| usize::from(width.0));
        let text = plain::cut(&words(), columns.saturating_sub(2));
        let new_columns = plain::width(&text);
        write_now(&format!(
            "\r{}",
            plain::pad_right(&text, self.shown_columns)
        ));
        self.shown_columns = new_columns;
    }

    fn clear(&self) {
        if self.shown_columns > 0 {
            write_now(&format!("\r{}\r", " ".repeat(self.shown_columns)));
        }
    }
}

/// A terminal that is gone takes no line, and misses none.
fn write_now(text: &str) {
    let mut out = io::stderr().lock();
    let _ = out.write_all(text.as_bytes()).and_then(|()| out.flush());
}

/// What became known so far.
struct Known {
    objective: Objective,
    best: Option<Costs>,
    bounds: BTreeMap<Cost, u32>,
    conflicts: u64,
}

impl Known {
    const fn new(objective: Objective) -> Self {
        Self {
            objective,
            best: None,
            bounds: BTreeMap::new(),
            conflicts: 0,
        }
    }

    fn learn(&mut self, event: &Progress) {
        match event {
            Progress::Bound { cost, at_least } => {
                self.bounds.insert(*cost, *at_least);
            }
            Progress::Plan { costs, .. } => self.best = Some(*costs),
            Progress::Size { conflicts, .. } => self.conflicts = *conflicts,
            Progress::Explained { .. }
            | Progress::Freedom { .. }
            | Progress::Priced { .. }
            | Progress::Delays { .. }
            | Progress::Sized { .. }
            | Progress::Traced { .. }
            | Progress::Certifying { .. }
            | Progress::Exporting { .. } => {}
        }
    }

    /// `12.3 s: makespan 23 (at least 18), 3 charges; 4000 conflicts`.
    fn words(&self, seconds: f64) -> String {
        let known = match &self.best {
            Some(costs) => self.interval(costs),
            None => known(&self.objective, &self.bounds, None),
        };
        let known = if known.is_empty() { "working" } else { &known };
        let conflicts = count(self.conflicts, "conflict");
        format!("{seconds:.1} s: {known}; {conflicts}")
    }

    /// The best plan's costs, each with its bound where that is lower.
    fn interval(&self, best: &Costs) -> String {
        let parts: Vec<String> = self
            .objective
            .costs()
            .iter()
            .map(|&cost| {
                let n = best.get(cost);
                let said = value(cost, n);
                match self.bounds.get(&cost) {
                    Some(bound) if *bound < n => format!("{said} (at least {bound})"),
                    Some(_) => format!("{said} (proved)"),
                    None => said,
                }
            })
            .collect();
        parts.join(", ")
    }
}

#[cfg(test)]
mod tests {
    use giveway_model::Plan;

    use super::*;

    #[test]
    fn the_line_tells_bounds_and_the_best_plan() {
        let mut known = Known::new(Objective::default());
        assert_eq!(known.words(0.25), "0.2 s: working; 0 conflicts");
        known.learn(&Progress::Bound {
            cost: Cost::Makespan,
            at_least: 18,
        });
        assert_eq!(
            known.words(1.0),
            "1.0 s: makespan is at least 18; 0 conflicts"
        );
        known.learn(&Progress::Plan {
            costs: Costs {
                makespan: 20,
                sum_of_costs: 40,
                ..Costs::default()
            },
            plan: Plan::default(),
        });
        known.learn(&Progress::Size {
            variables: 1,
            clauses: 2,
            conflicts: 7,
        });
        assert_eq!(
            known.words(2.0),
            "2.0 s: makespan 20 (at least 18), sum of costs 40, 0 charges; 7 conflicts"
        );
    }
}
