//! What a question contrasts the plan with, as clauses.

use giveway_model::question::{self, Contrast};
use giveway_model::{Cost, Question};

use super::{costs::name, verdict::Telling};
use crate::explain::own_plan::own_costs;

/// The contrast of a question about a plan; `None` where it has none.
pub(crate) fn contrast(telling: &Telling) -> Option<Contrast> {
    let question = telling.past.told_question(telling.question);
    question::contrast(&question).or_else(|| of_cost(telling))
}

/// The contrast of a question about a number.
fn of_cost(telling: &Telling) -> Option<Contrast> {
    let Telling {
        question,
        instance,
        plan,
        past,
        ..
    } = *telling;
    let whole = |cost: Cost| {
        let below = past.told_costs(instance, plan)?.get(cost);
        let name = name(cost);
        Some(Contrast {
            would: format!("the {name} were below {below}"),
            does: format!("the {name} is below {below}"),
        })
    };
    let fewer = |agent: &str, below: u32, things: &str| {
        Some(Contrast {
            would: format!("{agent} made fewer than {below} {things}"),
            does: format!("{agent} makes fewer than {below} {things}"),
        })
    };
    let own = |agent: &str, cost: Cost| Some(own_costs(instance, agent, plan)?.get(cost));
    match question {
        Question::Arrival { agent } => {
            let time = past.time(own(agent, Cost::Makespan)?);
            Some(Contrast {
                would: format!("{agent} arrived before time {time}"),
                does: format!("{agent} arrives before time {time}"),
            })
        }
        Question::Length {
            agent,
            fewer_than: Some(most),
        } => fewer(agent, *most, "moves"),
        Question::Length { agent, .. } | Question::Moves { agent: Some(agent) } => {
            fewer(agent, own(agent, Cost::Moves)?, "moves")
        }
        Question::Charges { agent: Some(agent) } => {
            fewer(agent, own(agent, Cost::Charges)?, "charges")
        }
        Question::Waits { agent: Some(agent) } => fewer(agent, own(agent, Cost::Waits)?, "waits"),
        Question::Makespan => whole(Cost::Makespan),
        Question::SumOfCosts => whole(Cost::SumOfCosts),
        Question::Charges { agent: None } => whole(Cost::Charges),
        Question::Moves { agent: None } => whole(Cost::Moves),
        Question::Waits { agent: None } => whole(Cost::Waits),
        _ => None,
    }
}
