//! One thing to do: an instance, how many of its agents, an objective, a planner, a budget.

use std::collections::{BTreeMap, BTreeSet};

use giveway_model::{Fault, Objective};
use giveway_solve::Limits;
use serde::{Deserialize, Serialize};

use crate::{Clock, Method, PlannerSpec, Shard, Spec};

/// One thing to do.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Task {
    /// The path of its instance, from the folder of the spec.
    pub instance: String,
    /// The first so many agents; `None`: all of them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub agents: Option<usize>,
    /// The objective, where it is not the instance's own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub objective: Option<Objective>,
    /// Who plans.
    pub planner: Method,
    /// Its command, where it is a planner of others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub command: Option<PlannerSpec>,
    /// The budget.
    #[serde(default)]
    pub limits: Limits,
    /// Which clock counts its seconds, and those of the certificate.
    #[serde(default, skip_serializing_if = "Clock::is_wall")]
    pub clock: Clock,
    /// What a certificate may take, where one is wanted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub certificate: Option<Limits>,
}

impl Task {
    /// What tells it from all other tasks, in a line: the same task has the same name in
    /// every run of a sweep, and another one where the budget is another.
    pub fn name(&self) -> String {
        let mut name = self.series();
        let mut add = |key: &str, value: Option<String>| {
            if let Some(value) = value {
                name.extend([" ", key, "=", &value]);
            }
        };
        let seconds = match self.clock {
            Clock::Wall => "seconds",
            Clock::Cpu => "cpu-seconds",
        };
        let text = |number: Option<u64>| number.map(|number| number.to_string());
        add("agents", self.agents.map(|agents| agents.to_string()));
        add(seconds, self.limits.seconds.map(|limit| limit.to_string()));
        add("conflicts", text(self.limits.conflicts));
        add("bytes", text(self.limits.memory_bytes));
        if let Some(limits) = self.certificate {
            let limit = limits.seconds.map(|limit| limit.to_string());
            add("certificate", Some("yes".to_owned()));
            add("certificate-seconds", limit);
            add("certificate-bytes", text(limits.memory_bytes));
        }
        name
    }

    /// What it has in common with tasks of other numbers of agents.
    pub fn series(&self) -> String {
        let mut series = format!("{} planner={}", self.instance, self.planner);
        if let Some(spec) = &self.command {
            series.extend([" command=", &spec.fingerprint()]);
        }
        if let Some(objective) = &self.objective {
            series.extend([" objective=", &objective.to_string()]);
        }
        series
    }
}

impl Spec {
    /// Every task, the smallest numbers of agents of all instances first: so a sweep that
    /// is cut off has done what was easy. `files` gives the paths that a pattern stands
    /// for, in their order, and `most` how many agents one of them has.
    ///
    /// # Errors
    /// When a pattern stands for nothing, or a number of agents is wrong.
    pub fn tasks(
        &self,
        files: &dyn Fn(&str) -> Result<Vec<String>, Fault>,
        most: &dyn Fn(&str) -> Result<usize, Fault>,
    ) -> Result<Vec<Task>, Fault> {
        let limits = Limits {
            seconds: self.time_limit,
            conflicts: self.conflict_limit,
            memory_bytes: self.memory_limit,
            ..Limits::default()
        };
        let certificate = self.certificates.map(Limits::from);
        let mut tasks = Vec::new();
        for (index, instances) in self.instances.iter().enumerate() {
            let place = format!("instances[{index}]");
            for pattern in &instances.files {
                let paths = files(pattern).map_err(|fault| fault.of_part(&place))?;
                if paths.is_empty() {
                    let found = format!("\"{pattern}\", which is no file");
                    return Err(Fault::at(
                        format!("{place}.files"),
                        found,
                        "a file, or a pattern of files",
                    ));
                }
                for path in paths {
                    let numbers = match &instances.agents {
                        None => vec![None],
                        Some(agents) => {
                            let numbers = agents.numbers(&|| most(&path));
                            let numbers = numbers.map_err(|fault| fault.of_part(&place))?;
                            numbers.into_iter().map(Some).collect()
                        }
                    };
                    for agents in numbers {
                        for objective in self.objectives()? {
                            for (planner, command) in self.methods() {
                                let wanted = certificate.filter(|_| planner == Method::Search);
                                tasks.push(Task {
                                    instance: path.clone(),
                                    agents,
                                    objective: objective.clone(),
                                    planner,
                                    command: command.cloned(),
                                    limits,
                                    clock: self.clock,
                                    certificate: wanted,
                                });
                            }
                        }
                    }
                }
            }
        }
        tasks.sort_by_key(|task| task.agents); // stable: the spec's order otherwise
        let mut known = BTreeSet::new();
        tasks.retain(|task| known.insert(task.name()));
        Ok(tasks)
    }

    /// The tasks of a shard: every N-th. Where tasks may be skipped, every N-th series is,
    /// whole, since who skips must know how the tasks before ended.
    pub fn part(&self, tasks: &[Task], shard: Shard) -> Vec<Task> {
        let chosen = tasks.iter().enumerate();
        if self.skip_after.is_none() {
            let own = chosen.filter(|(index, _)| shard.has(*index));
            return own.map(|(_, task)| task.clone()).collect();
        }
        let mut series = BTreeMap::new();
        let mut is_own = |task: &&Task| {
            let next = series.len();
            shard.has(*series.entry(task.series()).or_insert(next))
        };
        tasks.iter().filter(|task| is_own(task)).cloned().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPEC: &str = r#"
        objectives = ["makespan", "sum-of-costs,makespan"]
        planners = ["search", "cbs"]
        time-limit = 2.5
        [[instances]]
        files = ["b.scen", "*.scen"]
        agents = [2, 1]
        [[instances]]
        files = ["own.json"]
    "#;

    fn tasks(spec: &Spec) -> Vec<Task> {
        let files = |pattern: &str| {
            let names = match pattern {
                "*.scen" => vec!["a.scen", "b.scen"],
                "none" => vec![],
                one => vec![one],
            };
            Ok(names.into_iter().map(str::to_owned).collect())
        };
        spec.tasks(&files, &|_| Ok(2)).unwrap()
    }

    #[test]
    fn everything_is_combined_once_and_easy_tasks_come_first() {
        let spec = Spec::read(SPEC).unwrap();
        let tasks = tasks(&spec);
        assert_eq!(tasks.len(), 4 + 2 * 2 * 4);
        assert_eq!(
            tasks[5].name(),
            "b.scen planner=cbs objective=makespan agents=1 seconds=2.5"
        );
        let numbers: Vec<_> = tasks.iter().map(|task| task.agents).collect();
        assert!(numbers.is_sorted(), "{numbers:?}");
        let text = serde_json::to_string(&tasks[5]).unwrap();
        assert_eq!(serde_json::from_str::<Task>(&text).unwrap(), tasks[5]);
    }

    #[test]
    fn shards_have_every_task_once_and_series_whole_where_tasks_may_be_skipped() {
        let mut spec = Spec::read(SPEC).unwrap();
        let all = tasks(&spec);
        for skip_after in [None, Some(1)] {
            spec.skip_after = skip_after;
            let shards = (1..=3).map(|index| spec.part(&all, Shard::new(index, 3).unwrap()));
            let shards: Vec<Vec<Task>> = shards.collect();
            let mut names: Vec<String> = shards.iter().flatten().map(Task::name).collect();
            names.sort();
            let mut expected: Vec<String> = all.iter().map(Task::name).collect();
            expected.sort();
            assert_eq!(names, expected);
            let series =
                |shard: &Vec<Task>| shard.iter().map(Task::series).collect::<BTreeSet<_>>();
            let whole = series(&shards[0]).is_disjoint(&series(&shards[1]));
            assert_eq!(whole, skip_after.is_some());
        }
    }

    #[test]
    fn all_agents_of_each_file_may_be_meant_and_limits_belong_to_the_name() {
        let text = "clock = \"cpu\"\ntime-limit = 3\nplanners = [\"search\", \"cbs\"]\n\
            [certificates]\nmemory-limit = 7\n\
            [[instances]]\nfiles = [\"a\", \"bcd\"]\nagents = { from = 1, step = 2 }";
        let spec = Spec::read(text).unwrap();
        let files = |file: &str| Ok(vec![file.to_owned()]);
        let tasks = spec.tasks(&files, &|file| Ok(file.len())).unwrap();
        let names: Vec<String> = tasks.iter().map(Task::name).collect();
        let search = "agents=1 cpu-seconds=3 certificate=yes certificate-bytes=7";
        assert_eq!(names[0], format!("a planner=search {search}"));
        assert_eq!(names[1], "a planner=cbs agents=1 cpu-seconds=3");
        assert_eq!(names.len(), 2 * (1 + 2));
        let text = serde_json::to_string(&tasks[0]).unwrap();
        assert_eq!(serde_json::from_str::<Task>(&text).unwrap(), tasks[0]);
    }

    #[test]
    fn a_pattern_for_nothing_is_refused() {
        let spec = Spec::read("[[instances]]\nfiles = [\"x*\"]").unwrap();
        let fault = spec
            .tasks(&|_| Ok(Vec::new()), &|_| Ok(2))
            .unwrap_err()
            .to_string();
        assert!(fault.contains("instances[0].files"), "{fault}");
    }
}
