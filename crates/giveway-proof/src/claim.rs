//! A claim of a certificate: there is no plan of some kind.

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use giveway_model::message::read_map;
use giveway_model::{Condition, Cost, Instance, sorting, tr, words};
use serde::{Deserialize, Serialize};

use crate::{condition, escape, plain};

/// The claim that no plan of an instance keeps all of these limits.
///
/// ```
/// use giveway_model::Cost;
/// use giveway_proof::Claim;
/// let claim = Claim::at_most([(Cost::Makespan, 18), (Cost::Charges, 2)]);
/// assert_eq!(
///     claim.sentence(),
///     "There is no plan with makespan at most 18 and charges at most 2."
/// );
/// ```
#[derive(
    Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, BorshSerialize, BorshDeserialize,
)]
#[serde(deny_unknown_fields)]
pub struct Claim {
    /// The costs that such a plan would have at most; none of them: any plan.
    #[borsh(deserialize_with = "read_map")]
    pub most: BTreeMap<Cost, u32>,
    /// The horizon that the claim is limited to: the makespan up to which
    /// plans are meant. `null` where it holds for plans of any makespan.
    pub within: Option<u32>,
    /// The condition on such a plan beside its costs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub condition: Option<Condition>,
}

impl Claim {
    /// The claim about plans with at most these costs, whatever the horizon.
    pub fn at_most(most: impl IntoIterator<Item = (Cost, u32)>) -> Self {
        Self {
            most: sorting::map(most),
            ..Self::default()
        }
    }

    /// The same claim about plans of at most this makespan.
    #[must_use]
    pub fn within(mut self, last: Option<u32>) -> Self {
        self.within = last;
        self
    }

    /// The claim in words.
    pub fn sentence(&self) -> String {
        let limits: Vec<String> = self
            .most
            .iter()
            .map(|(cost, most)| tr!("{cost} at most {most}", cost = words::name(*cost), most))
            .collect();
        let of = self.within.map_or(String::new(), |last| {
            tr!(" of makespan at most {last}", last)
        });
        let with = match limits.as_slice() {
            [] => String::new(),
            limits => tr!(" with {limits}", limits = words::and(limits)),
        };
        let like = self.condition.as_ref().map_or(String::new(), |it| {
            tr!(" in which {what}", what = condition::words(it))
        });
        escape::text(&tr!("There is no plan{of}{with}{like}.", of, with, like))
    }

    /// The makespan beyond which no plan is of the kind, so that a formula up
    /// to it says it all; `None` where there is no such makespan.
    ///
    /// A limit of the sum of costs is one of the makespan: the others need at
    /// least their grid distances.
    pub fn horizon(&self, instance: &Instance) -> Option<u32> {
        let makespan = self.most.get(&Cost::Makespan).copied();
        let by_sum = self.most.get(&Cost::SumOfCosts).map(|&sum| {
            let least: Vec<u32> = instance
                .agents()
                .iter()
                .map(|agent| {
                    // Without a goal it may rest where it starts.
                    let goal = agent.goal?;
                    plain::grid_distance(instance.grid(), agent.start, goal)
                })
                .map(Option::unwrap_or_default)
                .collect();
            let all = least.iter().fold(0u32, |sum, &own| sum.saturating_add(own));
            let others = all - least.iter().copied().max().unwrap_or(0);
            sum.saturating_sub(others)
        });
        [makespan, by_sum, self.within].into_iter().flatten().min()
    }
}

#[cfg(test)]
mod tests {
    use giveway_model::format::native;

    use super::*;

    #[test]
    fn sentences_name_limits_and_horizon() {
        assert_eq!(Claim::default().sentence(), "There is no plan.");
        assert_eq!(
            Claim::default().within(Some(38)).sentence(),
            "There is no plan of makespan at most 38."
        );
        let claim = Claim::at_most([(Cost::Waits, 0), (Cost::Moves, 3), (Cost::Makespan, 9)]);
        assert_eq!(
            claim.sentence(),
            "There is no plan with makespan at most 9, moves at most 3 and waits at most 0."
        );
    }

    #[test]
    fn a_sum_of_costs_limits_the_makespan() {
        let instance = native::read_instance(
            r#"{ "giveway": 1, "map": ["......"], "agents": [
                { "name": "a", "start": [0, 0], "goal": [2, 0] },
                { "name": "b", "start": [1, 0], "goal": [5, 0] }] }"#,
        )
        .unwrap();
        // a alone may take 7 - 4 = 3, b alone 7 - 2 = 5.
        let claim = Claim::at_most([(Cost::SumOfCosts, 7)]);
        assert_eq!(claim.horizon(&instance), Some(5));
        assert_eq!(claim.clone().within(Some(4)).horizon(&instance), Some(4));
        assert_eq!(Claim::at_most([(Cost::Moves, 7)]).horizon(&instance), None);
    }
}
