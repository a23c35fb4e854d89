//! Why there is no plan.

use giveway_model::words::and;
use giveway_model::{Question, tr};

use super::{heads::witness_title, joined::because, verdict::help, violations::would};
use crate::explain::{
    Verdict,
    answer::{Class, Core, Repair, WitnessEntry},
    unsolvable::of_class,
};

/// Why there is no plan, in words; `within` where it is known up to a makespan.
pub(crate) fn unsolvable(
    within: Option<u32>,
    witness: &[WitnessEntry],
    core: Option<&Core>,
    repairs: &[Repair],
) -> String {
    let within = within.map_or_else(
        String::new,
        |n| tr!("a plan" => " with a makespan of at most {n}", n),
    );
    let mut sentences = vec![tr!("There is no plan{within}.", within)];
    sentences.extend(because(core, Verdict::Necessary));
    for class in [
        Class::Collision,
        Class::Obstacle,
        Class::Battery,
        Class::Waypoint,
    ] {
        let violations = of_class(witness, class);
        let Some(first) = violations.first().and_then(|v| v.agents.first()) else {
            continue;
        };
        let phrases: Vec<String> = violations
            .chunk_by(|a, b| a.agents.first() == b.agents.first())
            .filter_map(|own| {
                let agent = own.first()?.agents.first().unwrap_or(first);
                Some(tr!(
                    "{agent} would {would}",
                    agent,
                    would = would(agent, own, None)
                ))
            })
            .collect();
        sentences.push(tr!(
            "{title}: {all}.",
            title = witness_title(&Question::Unsolvable, Some(class)),
            all = and(&phrases)
        ));
    }
    sentences.extend(help(repairs, None));
    sentences.join(" ")
}
