//! The answer: for each time, what each method makes of it.

use giveway_model::{Cell, Constraint, Costs, Version};
use serde::ser::SerializeMap;
use serde::{Deserialize, Serialize, Serializer};

use super::Method;
use crate::SolveAnswer;

/// Why a method had to let agents go their own way, or why there is no plan. In JSON it has
/// its sentence, too, under `text`.
#[derive(Clone, Debug, PartialEq, Eq, borsh::BorshSerialize, borsh::BorshDeserialize)]
pub struct Cause {
    /// The agent.
    pub agent: String,
    /// The kind of cause.
    pub kind: CauseKind,
    /// Where; `None` where it is no cell alone.
    pub cell: Option<Cell>,
    /// Where agents block each other: all of them.
    pub agents: Vec<String>,
    /// The makespan up to which that was shown; `None` where it holds for every horizon.
    pub within: Option<u32>,
    /// The method that holds them; `replan` where no plan at all would do.
    pub method: Method,
    /// Among the agents that block each other, those that the method holds to their paths.
    pub held: Vec<String>,
    /// Whether one of the agents that block each other has a battery.
    pub has_batteries: bool,
    /// The rule of the scene's own that leaves no plan, where it is one. Without it there
    /// would be one; of several that leave none together, the first.
    pub rule: Option<Box<CauseRule>>,
}

/// A rule of the scene's own as a cause.
#[derive(Clone, Debug, PartialEq, Eq, borsh::BorshSerialize, borsh::BorshDeserialize)]
pub struct CauseRule {
    /// Its number, those that changes added after those of the scene.
    pub index: u32,
    /// The rule.
    pub constraint: Constraint,
}

impl Serialize for CauseRule {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut map = to.serialize_map(None)?;
        map.serialize_entry("index", &self.index)?;
        map.serialize_entry("name", &self.constraint.name)?;
        map.end()
    }
}

impl Serialize for Cause {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut map = to.serialize_map(None)?;
        map.serialize_entry("agent", &self.agent)?;
        map.serialize_entry("kind", &self.kind)?;
        map.serialize_entry("cell", &self.cell)?;
        if !self.agents.is_empty() {
            map.serialize_entry("agents", &self.agents)?;
        }
        if let Some(rule) = &self.rule {
            map.serialize_entry("rule", rule)?;
        }
        map.serialize_entry("within", &self.within)?;
        map.serialize_entry("text", &super::words::cause(self))?;
        map.end()
    }
}

/// Why an agent cannot do what a method asks of it.
#[derive(
    Clone,
    Copy,
    Debug,
    PartialEq,
    Eq,
    Serialize,
    Deserialize,
    borsh::BorshSerialize,
    borsh::BorshDeserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum CauseKind {
    /// An obstacle on the rest of its path, its goal or a waypoint.
    Obstacle,
    /// A goal that its path does not end at, or its tunnel does not hold.
    Goal,
    /// A waypoint off its path, or off its tunnel.
    Waypoint,
    /// A rule of the scene's own that it cannot keep.
    Rule,
    /// A battery that does not last.
    Battery,
    /// No way at all.
    NoWay,
    /// Agents that block each other for good.
    Blocked,
}

/// The answer of one method to the changes of one time. The plan runs from time 0, and so do costs and
/// bounds.
#[derive(Clone, Debug, PartialEq, Serialize, borsh::BorshSerialize, borsh::BorshDeserialize)]
pub struct MethodAnswer {
    /// The plan, and what is proved of it.
    #[serde(flatten)]
    pub result: SolveAnswer,
    /// Old agents with the same cells, times and charges.
    pub kept: Vec<String>,
    /// Old agents with the same sequence of cells at other times.
    pub retimed: Vec<String>,
    /// Old agents that go another way.
    pub rerouted: Vec<String>,
    /// Agents that are new at this time.
    pub added: Vec<String>,
    /// Old agents that the method could not hold to what it asks for.
    pub freed: Vec<String>,
    /// Whether it is proved that no fewer agents could be freed.
    pub fewest: bool,
    /// The makespan up to which that is proved; left out where it holds for every horizon.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fewest_within: Option<u32>,
    /// Why agents were freed, or why there is no plan.
    pub cause: Option<Cause>,
    /// Whether it is proved that no plan as good disturbs fewer agents.
    pub closest: bool,
}

/// The answers of the methods, in the order in which they were asked.
#[derive(Clone, Debug, Default, PartialEq, borsh::BorshSerialize, borsh::BorshDeserialize)]
pub struct Methods(pub Vec<(Method, MethodAnswer)>);

impl Methods {
    /// The answer of one method.
    pub fn get(&self, method: Method) -> Option<&MethodAnswer> {
        let found = self.0.iter().find(|(other, _)| *other == method);
        found.map(|(_, answer)| answer)
    }
}

impl Serialize for Methods {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (method, answer) in &self.0 {
            map.serialize_entry(method, answer)?;
        }
        map.end()
    }
}

/// The changes of one time, and how to go on.
#[derive(Clone, Debug, PartialEq, Serialize, borsh::BorshSerialize, borsh::BorshDeserialize)]
pub struct Step {
    /// The time.
    pub at: u32,
    /// The costs of the plan before anything changed.
    pub before: Option<Costs>,
    /// The answers of the methods.
    pub methods: Methods,
    /// The method whose plan is followed from then on; `null` where none has
    /// one, and then nothing later is looked at.
    pub adopted: Option<Method>,
}

/// The answer to a change request.
#[derive(Clone, Debug, PartialEq, Serialize, borsh::BorshSerialize, borsh::BorshDeserialize)]
pub struct ChangeAnswer {
    /// The format's version.
    pub giveway: Version,
    /// The last time at which something changed; `null` where nothing does that
    /// the plan does not know yet.
    pub at: Option<u32>,
    /// The costs of the plan before that.
    pub before: Option<Costs>,
    /// The answers of the methods.
    pub methods: Methods,
    /// The method whose plan is followed; `null` where none has one. What would
    /// help then tells the question `unsolvable` with the same plan and changes
    /// ([`ExplainRequest`](crate::explain::ExplainRequest)); why it is so, the
    /// cause of each method, too.
    pub adopted: Option<Method>,
    /// The earlier times.
    pub history: Vec<Step>,
}

impl ChangeAnswer {
    /// The answer of the method that was adopted last.
    pub fn adopted(&self) -> Option<&MethodAnswer> {
        self.methods.get(self.adopted?)
    }
}
