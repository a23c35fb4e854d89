//! Why the work stopped early, in a sentence.

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::tr;

/// Times that are followed step by step. The sentence of [`Stop::LateTimes`] names it.
pub(crate) const MOST_TIMES: u32 = 20_000;

/// Why the work stopped early.
#[derive(Clone, Copy, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub enum Stop {
    /// The seconds ran out.
    Time,
    /// The conflicts ran out.
    Conflicts,
    /// The work ran out.
    Work,
    /// The memory ran out.
    Memory,
    /// There were more sets of agents to compare than are looked at.
    Sets,
    /// A condition is about times that are later than those that are followed step by step.
    LateTimes,
    /// An agent has more waypoints than can be planned for.
    ManyWaypoints,
    /// The person asked to stop.
    Cancelled,
    /// A plan and a proved bound contradict each other: a fault of the program,
    /// reported instead of an answer that might be wrong.
    Contradiction,
}

impl Stop {
    /// The stop as a sentence.
    pub fn sentence(self) -> &'static str {
        match self {
            Self::Time => tr!("The time limit was reached."),
            Self::Conflicts => tr!("The conflict limit was reached."),
            Self::Work => tr!("The work limit was reached."),
            Self::Memory => {
                tr!("The memory limit was reached. Fewer robots or a smaller map need less.")
            }
            Self::Sets => tr!("There were too many sets of robots to free to compare them all."),
            Self::LateTimes => {
                tr!(
                    "This asks about a time after 20,000, which is later than the search looks at step by step."
                )
            }
            Self::ManyWaypoints => tr!("A robot has more waypoints than can be planned for."),
            Self::Cancelled => tr!("The search was cancelled."),
            Self::Contradiction => {
                tr!("A plan and a bound contradicted each other, which is a fault of this program.")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{MOST_TIMES, Stop};

    #[test]
    fn the_sentence_names_the_last_time_that_is_followed() {
        let (thousands, rest) = (MOST_TIMES / 1000, MOST_TIMES % 1000);
        let time = format!("a time after {thousands},{rest:03},");
        assert!(Stop::LateTimes.sentence().contains(&time), "{time}");
    }
}
