//! What a question contrasts the plan with, as clauses.

use giveway_model::question::{self, Contrast};
use giveway_model::{Cost, Question, tr};

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
            would: tr!("If ..." => "the {cost} were below {below}", cost = name, below),
            does: tr!("a plan in which ..." => "the {cost} is below {below}", cost = name, below),
        })
    };
    let moves = |agent: &str, below: u32| {
        Some(Contrast {
            would: tr!("If ..." => "{agent} made fewer than {below} moves", agent, below),
            does: tr!(
                "a plan in which ..." => "{agent} makes fewer than {below} moves",
                agent,
                below
            ),
        })
    };
    let charges = |agent: &str, below: u32| {
        Some(Contrast {
            would: tr!("If ..." => "{agent} made fewer than {below} charges", agent, below),
            does: tr!(
                "a plan in which ..." => "{agent} makes fewer than {below} charges",
                agent,
                below
            ),
        })
    };
    let waits = |agent: &str, below: u32| {
        Some(Contrast {
            would: tr!("If ..." => "{agent} made fewer than {below} waits", agent, below),
            does: tr!(
                "a plan in which ..." => "{agent} makes fewer than {below} waits",
                agent,
                below
            ),
        })
    };
    let own = |agent: &str, cost: Cost| Some(own_costs(instance, agent, plan)?.get(cost));
    match question {
        Question::Arrival { agent } => {
            let time = past.time(own(agent, Cost::Makespan)?);
            Some(Contrast {
                would: tr!("If ..." => "{agent} arrived before time {time}", agent, time),
                does: tr!("a plan in which ..." => "{agent} arrives before time {time}", agent, time),
            })
        }
        Question::Length {
            agent,
            fewer_than: Some(most),
        } => moves(agent, *most),
        Question::Length { agent, .. } | Question::Moves { agent: Some(agent) } => {
            moves(agent, own(agent, Cost::Moves)?)
        }
        Question::Charges { agent: Some(agent) } => charges(agent, own(agent, Cost::Charges)?),
        Question::Waits { agent: Some(agent) } => waits(agent, own(agent, Cost::Waits)?),
        Question::Makespan => whole(Cost::Makespan),
        Question::SumOfCosts => whole(Cost::SumOfCosts),
        Question::Charges { agent: None } => whole(Cost::Charges),
        Question::Moves { agent: None } => whole(Cost::Moves),
        Question::Waits { agent: None } => whole(Cost::Waits),
        _ => None,
    }
}
