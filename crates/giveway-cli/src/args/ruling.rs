//! The rules of the problem, where a person sets others than the files.

use clap::{Args as ClapArgs, ValueEnum};
use giveway_model::{AtGoal, Rules};

use super::whole;

/// The rules that a person chose.
#[derive(Clone, Copy, Debug, Default, ClapArgs)]
pub(crate) struct Ruling {
    /// Whether robots stay at their goals or vanish there [default: as the instance says; files of
    /// other makers: stay]
    #[arg(long, value_enum, value_name = "RULE")]
    pub(crate) at_goal: Option<Goal>,
    /// The level below which no battery may fall before its robot arrives [default: as the instance
    /// says; files of other makers: 0]
    #[arg(long, value_name = "N", value_parser = whole::<u32>, allow_negative_numbers = true)]
    pub(crate) floor: Option<u32>,
}

/// What becomes of a robot at its goal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Goal {
    /// It remains there and blocks the cell
    Stay,
    /// It is gone one step after its arrival
    Vanish,
}

impl Ruling {
    /// Sets the chosen rules.
    pub(crate) fn set(self, rules: &mut Rules) {
        rules.at_goal = self.at_goal().unwrap_or(rules.at_goal);
        rules.battery_floor = self.floor.unwrap_or(rules.battery_floor);
    }

    /// What becomes of robots at their goals, where that was chosen.
    pub(crate) fn at_goal(self) -> Option<AtGoal> {
        self.at_goal.map(|goal| match goal {
            Goal::Stay => AtGoal::Stay,
            Goal::Vanish => AtGoal::Vanish,
        })
    }

    /// The options that were chosen, with their values.
    pub(crate) fn chosen(self) -> Vec<(&'static str, String)> {
        let goal = self.at_goal.map(|goal| match goal {
            Goal::Stay => "stay".to_owned(),
            Goal::Vanish => "vanish".to_owned(),
        });
        let floor = self.floor.map(|floor| floor.to_string());
        let all = [("at-goal", goal), ("floor", floor)].into_iter();
        all.filter_map(|(option, value)| Some((option, value?)))
            .collect()
    }

    /// The chosen rules, a sentence each.
    pub(crate) fn notes(self) -> Vec<String> {
        let goal = self.at_goal.map(|goal| match goal {
            Goal::Stay => "Rule: robots stay at their goals (--at-goal stay).".to_owned(),
            Goal::Vanish => "Rule: robots vanish at their goals (--at-goal vanish).".to_owned(),
        });
        let floor = self.floor;
        let floor = floor.map(|n| format!("Rule: no battery may fall below {n} (--floor {n})."));
        goal.into_iter().chain(floor).collect()
    }
}
