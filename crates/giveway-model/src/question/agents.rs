//! The agents and times that a question names.

use super::Question;

impl Question {
    /// The agent that the question is about, if it is about one.
    pub fn agent(&self) -> Option<&str> {
        match self {
            Self::Wait { agent, .. }
            | Self::Charge { agent, .. }
            | Self::NoCharge { agent, .. }
            | Self::Visit { agent, .. }
            | Self::Move { agent, .. }
            | Self::NoMove { agent, .. }
            | Self::Slow { agent, .. }
            | Self::Order { agent, .. }
            | Self::Arrival { agent }
            | Self::Length { agent, .. }
            | Self::Yield { agent, .. } => Some(agent),
            Self::NoVisit { agent, .. }
            | Self::Charges { agent }
            | Self::Moves { agent }
            | Self::Waits { agent } => agent.as_deref(),
            Self::Rule { rule } => rule.single_agent(),
            Self::Makespan | Self::SumOfCosts | Self::Penalty | Self::Unsolvable | Self::Plan => {
                None
            }
        }
    }

    /// The agent whose arrival is asked about.
    pub fn arriving(&self) -> Option<&str> {
        if let Self::Arrival { agent } = self {
            Some(agent)
        } else {
            None
        }
    }

    /// All agents that the question names.
    pub fn agents(&self) -> impl Iterator<Item = &str> {
        let (one, others) = match self {
            Self::Yield { to, .. } => (self.agent(), vec![to.as_str()]),
            Self::Rule { rule } => (None, rule.named_agents().collect()),
            Self::Wait { .. }
            | Self::Charge { .. }
            | Self::NoCharge { .. }
            | Self::Visit { .. }
            | Self::NoVisit { .. }
            | Self::Move { .. }
            | Self::NoMove { .. }
            | Self::Slow { .. }
            | Self::Order { .. }
            | Self::Arrival { .. }
            | Self::Length { .. }
            | Self::Makespan
            | Self::SumOfCosts
            | Self::Penalty
            | Self::Charges { .. }
            | Self::Moves { .. }
            | Self::Waits { .. }
            | Self::Unsolvable
            | Self::Plan => (self.agent(), Vec::new()),
        };
        one.into_iter().chain(others)
    }

    /// The times that the question names, in time steps: of a wait its begin and its end.
    pub fn times_mut(&mut self) -> Vec<&mut Option<u32>> {
        match self {
            Self::Wait { from, to, .. } => vec![from, to],
            Self::Charge { time, .. }
            | Self::Visit { time, .. }
            | Self::Move { time, .. }
            | Self::NoMove { time, .. } => vec![time],
            Self::NoCharge { .. }
            | Self::NoVisit { .. }
            | Self::Slow { .. }
            | Self::Order { .. }
            | Self::Yield { .. }
            | Self::Arrival { .. }
            | Self::Length { .. }
            | Self::Makespan
            | Self::SumOfCosts
            | Self::Penalty
            | Self::Charges { .. }
            | Self::Moves { .. }
            | Self::Waits { .. }
            | Self::Rule { .. }
            | Self::Unsolvable
            | Self::Plan => Vec::new(),
        }
    }
}
