//! Reasons why a search ended without a plan or a proof, in sentences.

use giveway_model::words::{and, name};
use giveway_model::{Constraint, assumption, tr};

use crate::{Reason, change};

/// A reason as a sentence, in the language that is spoken.
pub fn reason(reason: &Reason) -> String {
    match reason {
        Reason::Stopped(stop) => stop.sentence().to_owned(),
        Reason::StoppedByPerson => tr!("You stopped the search").to_owned(),
        Reason::Alone { agent, rules } if rules.is_empty() => {
            tr!("{name} cannot do its task, even alone.", name = agent)
        }
        Reason::Alone { agent, rules } => tr!(
            "{name} cannot do its task, even alone, because of {rules}.",
            name = agent,
            rules = called(rules)
        ),
        Reason::ManyWaypoints { agent } => {
            tr!(
                "{name} has more waypoints than can be planned for.",
                name = agent
            )
        }
        Reason::Clash { agents } => clash(agents),
        Reason::Cause(cause) => change::words::cause(cause),
        Reason::PastTooLong => {
            tr!("What has already happened takes longer than that.").to_owned()
        }
        Reason::StepsOver { steps, arrived, of } => tr!(
            "After {n} step {arrived} of {all} robots were at their goals, and the planner ended."
                | "After {n} steps {arrived} of {all} robots were at their goals, and the planner ended."
                % *steps,
            arrived,
            all = of
        ),
        Reason::SearchEnded => {
            tr!("The planner's search came to its end without a plan that fits.").to_owned()
        }
        Reason::LeastWithin { cost, within } => tr!(
            "No plan of makespan at most {n} has a smaller {cost}; a longer one might.",
            n = within,
            cost = name(*cost)
        ),
        Reason::Beaten => tr!("There is a better plan").to_owned(),
        Reason::LeftOutRules => tr!(
            "Rules of the file's problem are left out, and this plan may break them. What every plan costs at least holds with them, too."
        )
        .to_owned(),
        Reason::BetterLeftOutRules => tr!(
            "Rules of the file's problem are left out of the search, so it is open whether a plan that keeps them costs as little as the bound."
        )
        .to_owned(),
        Reason::ChosenGoals => tr!(
            "There is no plan for the goals that were chosen here. Another choice that the file allows may have one."
        )
        .to_owned(),
        Reason::OpenGoals => {
            tr!("The file leaves goals open: what a legal plan costs depends on which are chosen.")
                .to_owned()
        }
        Reason::UnknownKeys { keys } => assumption::sentences(keys).join(" "),
    }
}

/// Agents that cannot all arrive, as a sentence; all of the scene where none is named.
pub(crate) fn clash<S: AsRef<str>>(agents: &[S]) -> String {
    let names: Vec<&str> = agents.iter().map(AsRef::as_ref).collect();
    match names.as_slice() {
        [] => tr!("The robots cannot all arrive.").to_owned(),
        [one] => tr!("{one} cannot arrive.", one),
        [one, two] => tr!("{one} and {two} cannot both arrive.", one, two),
        names => tr!("{robots} cannot all arrive.", robots = and(names)),
    }
}

/// Rules of a scene's own by what they are called, as a list.
pub(crate) fn called(rules: &[Constraint]) -> String {
    let rules: Vec<String> = rules.iter().map(Constraint::called).collect();
    and(&rules)
}
