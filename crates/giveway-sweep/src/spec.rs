//! What a sweep combines, as a file of TOML says it.

use giveway_model::{Fault, Objective};
use serde::{Deserialize, Deserializer, Serialize};

use crate::{Agents, Certificates, Clock, Method, PlannerSpec};

/// A sweep: every instance with every number of agents, objective and planner.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Spec {
    /// The instances.
    pub instances: Vec<Instances>,
    /// The objectives, where they are not the instances' own: costs separated by commas.
    #[serde(default)]
    pub objectives: Vec<String>,
    /// The planners of this project; by default the search for the best plan.
    #[serde(default, deserialize_with = "own_methods")]
    pub planners: Vec<Method>,
    /// Planners of others, as commands.
    #[serde(default, rename = "planner")]
    pub commands: Vec<PlannerSpec>,
    /// Seconds for each task.
    #[serde(default)]
    pub time_limit: Option<f64>,
    /// Which clock counts these seconds; by default the one on the wall.
    #[serde(default)]
    pub clock: Clock,
    /// Conflicts of the SAT solver for each task: a budget that is the same on every machine.
    #[serde(default)]
    pub conflict_limit: Option<u64>,
    /// Bytes for each task.
    #[serde(default)]
    pub memory_limit: Option<u64>,
    /// After so many tasks in a row without success, larger numbers of agents of
    /// the same series (instance, objective, planner) are skipped. By default none is.
    #[serde(default)]
    pub skip_after: Option<usize>,
    /// Whether answers of the search get certificates, which are made and checked, and
    /// what one of them may take. By default they get none.
    #[serde(default)]
    pub certificates: Option<Certificates>,
}

/// Reads methods of this project; names of others stand with their commands.
fn own_methods<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Method>, D::Error> {
    #[derive(Deserialize)]
    #[serde(try_from = "String")]
    struct Own(Method);

    impl TryFrom<String> for Own {
        type Error = String;

        fn try_from(text: String) -> Result<Self, String> {
            text.parse().map(Self)
        }
    }

    let own = Vec::<Own>::deserialize(deserializer)?;
    Ok(own.into_iter().map(|Own(method)| method).collect())
}

/// Instances of one kind.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Instances {
    /// Paths from the folder of the spec: scenarios (`.scen`) with their maps beside them, or
    /// instances of the project's own format. `*`, `?` and `**` stand for parts of names.
    pub files: Vec<String>,
    /// How many agents; by default all that a file has.
    #[serde(default)]
    pub agents: Option<Agents>,
}

impl Spec {
    /// Reads a spec.
    ///
    /// # Errors
    /// What is wrong, with its line where the text is no TOML of this shape.
    pub fn read(text: &str) -> Result<Self, Fault> {
        let spec: Self = toml::from_str(text).map_err(|error| told(text, &error))?;
        if spec.instances.is_empty() {
            return Err(Fault::at("instances", "none", "at least one"));
        }
        let certificates = spec.certificates.and_then(|limits| limits.time_limit);
        for (place, limit) in [
            ("time-limit", spec.time_limit),
            ("certificates.time-limit", certificates),
        ] {
            if let Some(limit) = limit.filter(|limit| !limit.is_finite() || *limit < 0.0) {
                return Err(Fault::at(place, limit.to_string(), "seconds from 0"));
            }
        }
        if spec.skip_after == Some(0) {
            let expected = "at least 1 miss; without it nothing is skipped";
            return Err(Fault::at("skip-after", "0", expected));
        }
        spec.objectives()?;
        spec.check_commands()?;
        Ok(spec)
    }

    /// The objectives; `None` is an instance's own.
    ///
    /// # Errors
    /// The first that is none.
    pub(crate) fn objectives(&self) -> Result<Vec<Option<Objective>>, Fault> {
        if self.objectives.is_empty() {
            return Ok(vec![None]);
        }
        let read = |(index, text): (usize, &String)| {
            text.parse().map(Some).map_err(|error| {
                let found = format!("\"{text}\" ({error})");
                Fault::at(format!("objectives[{index}]"), found, "costs with commas")
            })
        };
        self.objectives.iter().enumerate().map(read).collect()
    }

    /// Checks the planners of others.
    fn check_commands(&self) -> Result<(), Fault> {
        for (index, spec) in self.commands.iter().enumerate() {
            let place = format!("planner[{index}]");
            let checked = spec.check(self.time_limit.is_some());
            checked.map_err(|fault| fault.of_part(&place))?;
            let mut before = self.commands.iter().take(index);
            if before.any(|other| other.name == spec.name) {
                let found = format!("\"{}\" again", spec.name);
                let expected = "another name for each planner";
                return Err(Fault::at("name", found, expected).of_part(&place));
            }
        }
        Ok(())
    }

    /// The planners, those of others with their commands.
    pub(crate) fn methods(&self) -> Vec<(Method, Option<&PlannerSpec>)> {
        let own = match self.planners.as_slice() {
            [] => vec![Method::Search],
            planners => planners.to_vec(),
        };
        let own = own.into_iter().map(|method| (method, None));
        let commands = self.commands.iter().map(|spec| (spec.method(), Some(spec)));
        own.chain(commands).collect()
    }
}

/// What is wrong with a text, and where.
fn told(text: &str, error: &toml::de::Error) -> Fault {
    let message = error.message().trim_end_matches('.').replace('\n', ", ");
    let (found, expected) = match message.split_once(", expected ") {
        Some((found, "usize" | "u64")) => (found, "a whole number from 0"),
        Some((found, "f64")) => (found, "a number"),
        Some(parts) => parts,
        None => (
            message.as_str(),
            "a sweep: instances, objectives, planners, limits",
        ),
    };
    let found = found.strip_prefix("found ").unwrap_or(found);
    let fault = Fault::at("", found, expected);
    match error.span() {
        Some(span) => {
            let before = text.get(..span.start).unwrap_or(text);
            let line = before.matches('\n').count() + 1;
            let column = before.rsplit('\n').next().unwrap_or("").chars().count() + 1;
            fault.in_text(line, column)
        }
        None => fault,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(text: &str) -> String {
        Spec::read(text).unwrap_err().to_string()
    }

    #[test]
    fn what_is_wrong_is_told_with_its_place() {
        assert!(
            refused("instances = []").contains("instances"),
            "{}",
            refused("instances = []")
        );
        let typo = refused("[[instances]]\nfiles = []\nagent = 3");
        assert!(typo.starts_with("line 3"), "{typo}");
        let objective = refused("objectives = [\"time\"]\n[[instances]]\nfiles = []");
        assert!(objective.contains("objectives[0]"), "{objective}");
        let limit = refused("time-limit = -1.0\n[[instances]]\nfiles = []");
        assert!(limit.contains("time-limit"), "{limit}");
        let limit = "[certificates]\ntime-limit = -1.0\n[[instances]]\nfiles = []";
        assert!(refused(limit).contains("certificates.time-limit"));
        assert!(!refused("é = [").is_empty());
    }

    #[test]
    fn sentences_say_what_is_expected_and_no_type_of_the_program() {
        let instances = "[[instances]]\nfiles = []\n";
        for (line, expected) in [
            (
                "skip-after = 0",
                "skip-after: found 0, expected at least 1 miss",
            ),
            (
                "skip-after = -1",
                "found invalid value: integer `-1`, expected a whole number from 0",
            ),
            (
                "time-limit = nan",
                "time-limit: found NaN, expected seconds from 0",
            ),
            ("time-limit = \"1\"", "expected a number"),
            (
                "planners = [\"x\"]",
                "column 12: found the planner \"x\", expected search, ",
            ),
        ] {
            let said = refused(&format!("{line}\n{instances}"));
            assert!(said.contains(expected), "{said}");
        }
        for agents in ["\"5\"", "-3", "{ to = 7 }", "{ from = 5, stop = 7 }"] {
            let said = refused(&format!("{instances}agents = {agents}"));
            assert!(said.contains("line 3"), "{said}");
            assert!(
                said.contains("found no number of agents, expected 20, "),
                "{said}"
            );
        }
    }
}
