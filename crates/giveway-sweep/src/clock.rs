//! Which clock a limit in seconds is of.

use giveway_solve::{Host, Progress};
use serde::{Deserialize, Serialize};

/// Which clock a limit in seconds is of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Clock {
    /// The one on the wall: what a person waits.
    #[default]
    Wall,
    /// The time that the processor worked for the task: the same on a machine that does
    /// other things beside it.
    Cpu,
}

impl Clock {
    /// Whether it is the one that nobody has to name.
    #[expect(clippy::trivially_copy_pass_by_ref, reason = "as serde calls it")]
    pub(crate) fn is_wall(&self) -> bool {
        *self == Self::Wall
    }
}

/// A host whose limits are counted by a clock.
pub(crate) struct Clocked<'a> {
    pub(crate) clock: Clock,
    pub(crate) host: &'a dyn Host,
}

impl Host for Clocked<'_> {
    fn wall_seconds(&self) -> f64 {
        match self.clock {
            Clock::Wall => self.host.wall_seconds(),
            Clock::Cpu => self.host.cpu_seconds(),
        }
    }

    fn cpu_seconds(&self) -> f64 {
        self.host.cpu_seconds()
    }

    fn cancelled(&self) -> bool {
        self.host.cancelled()
    }

    fn memory_bytes(&self) -> u64 {
        self.host.memory_bytes()
    }

    fn progress(&self, event: &Progress) {
        self.host.progress(event);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Loaded, RowStatus, Spec, run};

    /// A machine that is busy: a second on the wall each time that somebody looks, and
    /// hardly any of it for this task.
    struct Busy {
        looks: std::cell::Cell<f64>,
    }

    impl Host for Busy {
        fn wall_seconds(&self) -> f64 {
            self.looks.set(self.looks.get() + 1.0);
            self.looks.get()
        }

        fn cpu_seconds(&self) -> f64 {
            0.001 * self.looks.get()
        }

        fn progress(&self, _: &Progress) {}
    }

    #[test]
    fn a_busy_machine_ends_no_task_whose_limit_is_of_cpu_seconds() {
        let map = r##""giveway": 1, "map": ["....", "#.##"]"##;
        let agents = r#"{ "name": "a", "start": [0, 0], "goal": [3, 0] },
                        { "name": "b", "start": [3, 0], "goal": [0, 0] }"#;
        let text = format!("{{ {map}, \"agents\": [{agents}] }}");
        let instance = giveway_model::format::native::read_instance(&text).unwrap();
        let loaded = Loaded::of(instance);
        let status = |clock: &str| {
            let spec = format!("{clock}\ntime-limit = 1\n[[instances]]\nfiles = [\"a.json\"]");
            let spec = Spec::read(&spec).unwrap();
            let files = |file: &str| Ok(vec![file.to_owned()]);
            let tasks = spec.tasks(&files, &|_| Ok(2)).unwrap();
            let looks = std::cell::Cell::new(0.0);
            run(&tasks[0], &loaded, &Busy { looks }).status
        };
        assert_eq!(status("clock = \"cpu\""), RowStatus::Optimal);
        assert_ne!(status("clock = \"wall\""), RowStatus::Optimal);
    }
}
