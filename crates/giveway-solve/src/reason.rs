//! Why an answer has no plan or no proof, as data. Sentences of it are made where it is
//! shown ([`words::reason`](crate::words::reason)).

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::{Assumption, Constraint, Cost};
use serde::{Serialize, Serializer};

use crate::{budget::Stop, change::Cause};

/// Why an answer has no plan or no proof. In JSON it is a sentence.
///
/// ```
/// use giveway_solve::{Reason, words};
/// let reason = Reason::Clash { agents: vec!["A1".into(), "A2".into()] };
/// assert_eq!(words::reason(&reason), "A1 and A2 cannot both arrive.");
/// assert_eq!(serde_json::to_value(&reason).unwrap(), "A1 and A2 cannot both arrive.");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, BorshSerialize, BorshDeserialize)]
pub enum Reason {
    /// The search ended early.
    Stopped(Stop),
    /// A person stopped the search on the page, which kept what was known.
    StoppedByPerson,
    /// An agent cannot do its task, even alone.
    Alone {
        /// The agent.
        agent: String,
        /// The rules of the scene's own without which it could: none of them can be left out.
        /// Empty where it could not without rules, either, or that is not known.
        rules: Vec<Constraint>,
    },
    /// An agent has more waypoints than can be planned for.
    ManyWaypoints {
        /// The agent.
        agent: String,
    },
    /// Agents that cannot all arrive; all of the scene where none is named.
    Clash {
        /// The agents.
        agents: Vec<String>,
    },
    /// A method cannot go on after a change.
    Cause(Box<Cause>),
    /// The time before the change is longer than the horizon.
    PastTooLong,
    /// A planner that looks one step ahead made all its steps.
    StepsOver {
        /// The steps.
        steps: u32,
        /// The agents at their goals.
        arrived: u32,
        /// All agents.
        of: u32,
    },
    /// A planner's search came to its end without a plan of the makespan that is allowed.
    SearchEnded,
    /// A planner proved its cost up to a makespan only.
    LeastWithin {
        /// The cost.
        cost: Cost,
        /// The makespan, in steps.
        within: u32,
    },
    /// Another plan is known to be better.
    Beaten,
    /// The plan may break rules that are left out.
    LeftOutRules,
    /// A better plan was found that may break rules that are left out.
    BetterLeftOutRules,
    /// There is no plan for the goals that were chosen of those that the file leaves open.
    ChosenGoals,
    /// The costs of a legal plan depend on the goals that the file leaves open.
    OpenGoals,
    /// The file has keys that may change the problem.
    UnknownKeys {
        /// The keys.
        keys: Vec<Assumption>,
    },
}

impl From<Stop> for Reason {
    fn from(stop: Stop) -> Self {
        Self::Stopped(stop)
    }
}

impl Serialize for Reason {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.serialize_str(&crate::words::reason(self))
    }
}
