//! Numbers of agents, as a spec writes them.

use giveway_model::Fault;
use serde::{Deserialize, Serialize};

/// Numbers of agents.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(
    untagged,
    expecting = "found no number of agents, expected 20, [5, 10] or { from = 5, to = 100, step = 5 }"
)]
pub enum Agents {
    /// One number.
    One(usize),
    /// Each of these.
    Each(Vec<usize>),
    /// From a number to another one, both among them.
    Range(Range),
}

/// Numbers at equal distances.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Range {
    /// The first.
    pub from: usize,
    /// The last, where the step meets it; by default all that a scenario has.
    #[serde(default)]
    pub to: Option<usize>,
    /// From one to the next.
    #[serde(default = "one")]
    pub step: usize,
}

const fn one() -> usize {
    1
}

/// More numbers of agents than anybody wants, and more tasks than a folder can hold.
const MOST: usize = 10_000_000;

impl Agents {
    /// The numbers, in their order; none where a file has fewer agents than the first of
    /// them. `most` tells how many agents a file has.
    ///
    /// # Errors
    /// When there is none, one is 0, or a step is 0; when a file tells no number.
    pub(crate) fn numbers(
        &self,
        most: &dyn Fn() -> Result<usize, Fault>,
    ) -> Result<Vec<usize>, Fault> {
        let fault = |found: String, expected: &str| Err(Fault::at("agents", found, expected));
        let numbers: Vec<usize> = match self {
            Self::One(number) => vec![*number],
            Self::Each(numbers) => numbers.clone(),
            Self::Range(Range { step: 0, .. }) => {
                return fault("the step 0".to_owned(), "at least 1");
            }
            Self::Range(Range { from, to, step }) => {
                let last = to.map_or_else(most, Ok)?;
                (*from..=last).step_by(*step).take(MOST + 1).collect()
            }
        };
        let open = matches!(self, Self::Range(Range { to: None, .. }));
        if numbers.is_empty() && !open {
            return fault("no number".to_owned(), "at least one");
        }
        if numbers.contains(&0) {
            return fault("0 agents".to_owned(), "at least 1");
        }
        if numbers.len() > MOST {
            return fault(format!("more than {MOST} numbers"), "fewer");
        }
        Ok(numbers)
    }
}

#[cfg(test)]
mod tests {
    use crate::Spec;

    #[test]
    fn numbers_of_agents_are_written_in_three_ways() {
        let numbers = |text: &str| {
            let text = format!("[[instances]]\nfiles = []\nagents = {text}");
            Spec::read(&text).unwrap().instances[0]
                .agents
                .clone()
                .unwrap()
                .numbers(&|| Ok(12))
        };
        assert_eq!(numbers("7").unwrap(), [7]);
        assert_eq!(numbers("[3, 1]").unwrap(), [3, 1]);
        assert_eq!(
            numbers("{ from = 5, to = 16, step = 5 }").unwrap(),
            [5, 10, 15]
        );
        assert_eq!(numbers("{ from = 2, to = 4 }").unwrap(), [2, 3, 4]);
        assert_eq!(numbers("{ from = 5, step = 5 }").unwrap(), [5, 10]);
        assert!(numbers("{ from = 13 }").unwrap().is_empty());
        for wrong in [
            "[]",
            "0",
            "{ from = 1, to = 2, step = 0 }",
            "{ from = 2, to = 1 }",
        ] {
            assert!(numbers(wrong).is_err(), "{wrong}");
        }
    }
}
