//! Which tasks are skipped, since those before them were too hard.

use std::collections::BTreeMap;

use crate::{Row, RowStatus, Spec, Task};

/// How the tasks of each series went so far.
#[derive(Clone, Debug)]
pub struct Patience {
    after: Option<usize>,
    misses: BTreeMap<String, usize>,
}

impl Patience {
    /// That of a sweep, before its first task.
    pub fn of(spec: &Spec) -> Self {
        Self {
            after: spec.skip_after,
            misses: BTreeMap::new(),
        }
    }

    /// Whether a task is not to be tried.
    pub fn skips(&self, task: &Task) -> bool {
        let misses = self.misses.get(&task.series()).copied().unwrap_or(0);
        self.after.is_some_and(|after| misses >= after)
    }

    /// Whether a row says what there is to know of a task: one that was skipped, and is not
    /// to be skipped now, is to be tried; so is one whose instance could not be read, which
    /// may be there now.
    pub fn accepts(&self, task: &Task, row: &Row) -> bool {
        let is_tried = !matches!(row.status, RowStatus::Skipped | RowStatus::Error);
        is_tried || self.skips(task)
    }

    /// Notes how a task ended. Where there was no instance, no planner missed anything.
    pub fn note(&mut self, task: &Task, row: &Row) {
        if self.after.is_some() && row.status != RowStatus::Error {
            let misses = self.misses.entry(task.series()).or_default();
            *misses = if row.is_success() { 0 } else { *misses + 1 };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::RowStatus::{Feasible, Optimal, Unknown};

    #[test]
    fn a_series_is_given_up_after_so_many_misses_in_a_row() {
        let spec =
            "skip-after = 2\n[[instances]]\nfiles = [\"a\", \"b\"]\nagents = { from = 1, to = 5 }";
        let spec = Spec::read(spec).unwrap();
        let tasks = spec
            .tasks(&|file| Ok(vec![file.to_owned()]), &|_| Ok(5))
            .unwrap();
        let mut patience = Patience::of(&spec);
        let of = |file: &str| {
            tasks
                .iter()
                .filter(move |task| task.instance == file)
                .collect::<Vec<_>>()
        };
        let ends = [Unknown, Optimal, Feasible, Unknown];
        for (task, status) in of("a").into_iter().zip(ends) {
            assert!(!patience.skips(task));
            patience.note(task, &Row::bare(task, status, None));
            patience.note(task, &Row::error(task, String::new()));
        }
        assert!(patience.skips(of("a")[4]));
        assert!(!patience.skips(of("b")[4]));
        for (task, accepted) in [(of("a")[4], true), (of("b")[4], false)] {
            assert_eq!(patience.accepts(task, &Row::skipped(task)), accepted);
            let error = Row::error(task, String::new());
            assert_eq!(patience.accepts(task, &error), accepted);
            assert!(patience.accepts(task, &Row::bare(task, Unknown, None)));
        }
    }
}
