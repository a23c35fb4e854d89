//! A planner of others as the spec of a sweep names it.

use giveway_model::Fault;
use giveway_proof::bundle::fingerprint;
use serde::{Deserialize, Serialize};

use super::command::{Command, Placeholder};
use crate::Method;

/// A planner of others: a command that reads a map and a scenario and writes a plan.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlannerSpec {
    /// Its name in tables, without blanks.
    pub name: String,
    /// The command, as words: quotes hold a word together, and no shell reads it. `{map}`,
    /// `{scen}`, `{agents}`, `{seconds}` and `{out}` stand for what a task has.
    pub command: String,
    /// A few words about it, for tables: its version, its settings.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub about: Option<String>,
}

/// The longest name, in letters: it stands beside its curve.
const LONGEST_NAME: usize = 40;
/// So many digits of the command's fingerprint are in the names of its tasks.
const DIGITS: usize = 12;

impl PlannerSpec {
    /// The method that tasks of this planner have.
    pub(crate) fn method(&self) -> Method {
        Method::Command(self.name.clone())
    }

    /// The beginning of the fingerprint of its command. With another command a task is
    /// another task, which is done anew.
    pub(crate) fn fingerprint(&self) -> String {
        let mut digits = fingerprint(self.command.as_bytes());
        digits.truncate(DIGITS);
        digits
    }

    /// Checks the name and the command.
    ///
    /// # Errors
    /// What is wrong, with its place in the planner.
    pub(crate) fn check(&self, has_time_limit: bool) -> Result<(), Fault> {
        if let Some(expected) = wrong_name(&self.name) {
            let found = format!("\"{}\"", self.name);
            return Err(Fault::at("name", found, expected));
        }
        let wrong = |found: &str, expected: &str| Err(Fault::at("command", found, expected));
        let command = Command::read(&self.command)
            .map_err(|(found, expected)| Fault::at("command", found, expected))?;
        if !command.uses(Placeholder::Out) {
            return wrong(
                "no {out}",
                "{out} where the command takes the file that it writes",
            );
        }
        if !command.uses(Placeholder::Map) && !command.uses(Placeholder::Scen) {
            return wrong(
                "neither {map} nor {scen}",
                "the files that the command reads",
            );
        }
        if !has_time_limit {
            let found = "a planner of others and no time-limit";
            return Err(Fault::at(
                "",
                found,
                "a time-limit, after which it is ended",
            ));
        }
        Ok(())
    }
}

/// What is expected of a name where this is none. Names of tasks are split at blanks and at
/// `=`, and the planners here have their names already.
pub(crate) fn wrong_name(name: &str) -> Option<&'static str> {
    let is_free = |c: char| !c.is_whitespace() && !c.is_control() && c != '=';
    if name.is_empty() || name.chars().count() > LONGEST_NAME || !name.chars().all(is_free) {
        return Some("1 to 40 letters without blanks and =");
    }
    let is_own = name.parse::<Method>().is_ok();
    is_own.then_some("a name that no planner of Giveway has")
}

#[cfg(test)]
mod tests {
    use crate::Spec;

    fn refused(planner: &str) -> String {
        let spec = format!("{planner}\n[[instances]]\nfiles = [\"a.scen\"]");
        Spec::read(&spec).unwrap_err().to_string()
    }

    #[test]
    fn names_and_commands_are_checked() {
        let limit = "time-limit = 5\n[[planner]]\n";
        for (planner, expected) in [
            (
                "name = \"a b\"\ncommand = \"x {map} {out}\"",
                "planner[0].name: found \"a b\"",
            ),
            (
                "name = \"a=b\"\ncommand = \"x {map} {out}\"",
                "without blanks and =",
            ),
            (
                "name = \"\"\ncommand = \"x {map} {out}\"",
                "1 to 40 letters",
            ),
            (
                "name = \"lacam\"\ncommand = \"x {map} {out}\"",
                "that no planner of Giveway has",
            ),
            (
                "name = \"x\"\ncommand = \"x {map}\"",
                "planner[0].command: found no {out}",
            ),
            (
                "name = \"x\"\ncommand = \"x {out}\"",
                "found neither {map} nor {scen}",
            ),
            (
                "name = \"x\"\ncommand = \"x {map} {file} {out}\"",
                "found {file}",
            ),
            (
                "name = \"x\"\ncommand = \"x 'a {map} {out}\"",
                "without its end",
            ),
            ("name = \"x\"\ncommand = \"\"", "found no word"),
        ] {
            let said = refused(&format!("{limit}{planner}"));
            assert!(said.contains(expected), "{said}");
        }
        let said = refused("[[planner]]\nname = \"x\"\ncommand = \"x {map} {out}\"");
        assert!(said.contains("and no time-limit"), "{said}");
        let twice = "[[planner]]\nname = \"x\"\ncommand = \"x {map} {out}\"\n".repeat(2);
        let said = refused(&format!("time-limit = 5\n{twice}"));
        assert!(
            said.contains("planner[1].name: found \"x\" again"),
            "{said}"
        );
    }

    #[test]
    fn another_command_makes_another_task() {
        let names = |command: &str| {
            let spec = format!(
                "time-limit = 5\n[[planner]]\nname = \"x\"\ncommand = \"{command}\"\n\
                 [[instances]]\nfiles = [\"a.scen\"]"
            );
            let spec = Spec::read(&spec).unwrap();
            let files = |file: &str| Ok(vec![file.to_owned()]);
            let tasks = spec.tasks(&files, &|_| Ok(2)).unwrap();
            tasks.iter().map(crate::Task::name).collect::<Vec<_>>()
        };
        let [first, other] = [names("x {map} {out}"), names("x -v {map} {out}")];
        assert_eq!(first[0], "a.scen planner=search seconds=5");
        assert_eq!(first[0], other[0]);
        assert!(
            first[1].starts_with("a.scen planner=x command="),
            "{first:?}"
        );
        assert_ne!(first[1], other[1]);
        assert_eq!(first, names("x {map} {out}"));
    }
}
