//! A question as a person says it.

use super::Question;
use crate::{Cell, tr};

/// The question as a sentence for people.
///
/// ```
/// use giveway_model::{Cell, Question, question::sentence};
/// let ask = Question::NoVisit { agent: None, at: Cell::new(3, 1) };
/// assert_eq!(sentence(&ask), "Why does nobody pass (3, 1)?");
/// ```
#[expect(
    clippy::too_many_lines,
    reason = "a sentence for each kind of question"
)]
pub fn sentence(question: &Question) -> String {
    match question {
        Question::Wait {
            agent,
            at: cell,
            at_least,
            ..
        } => {
            let place = place(*cell);
            match at_least {
                Some(_) => tr!("Why does {agent} wait so long{place}?", agent, place),
                None => tr!("Why does {agent} wait{place}?", agent, place),
            }
        }
        Question::Charge {
            agent,
            at: cell,
            time,
        } => {
            tr!(
                "Why does {agent} charge{place}{when}?",
                agent,
                place = place(*cell),
                when = when(*time)
            )
        }
        Question::NoCharge { agent, at: cell } => {
            tr!("Why does {agent} not charge at {cell}?", agent, cell)
        }
        Question::Visit {
            agent,
            at: cell,
            time,
        } => tr!(
            "Why does {agent} pass {cell}{when}?",
            agent,
            cell,
            when = when(*time)
        ),
        Question::NoVisit {
            agent: Some(agent),
            at: cell,
        } => tr!("Why does {agent} not pass {cell}?", agent, cell),
        Question::NoVisit {
            agent: None,
            at: cell,
        } => tr!("Why does nobody pass {cell}?", cell),
        Question::Move {
            agent,
            from_cell,
            to_cell,
            time,
        } => tr!(
            "Why does {agent} go from {from_cell} to {to_cell}{when}?",
            agent,
            from_cell,
            to_cell,
            when = when(*time)
        ),
        Question::NoMove {
            agent,
            from_cell,
            to_cell,
            time,
        } => tr!(
            "Why does {agent} not go from {from_cell} to {to_cell}{when}?",
            agent,
            from_cell,
            to_cell,
            when = when(*time)
        ),
        Question::Slow {
            agent,
            from_cell,
            to_cell,
        } => {
            let over = from_cell.zip(*to_cell);
            let over = over.map(|(u, v)| tr!("something done" => " over {u} and {v}", u, v));
            tr!(
                "Why does {agent} take the slow way{over}?",
                agent,
                over = over.unwrap_or_default()
            )
        }
        Question::Order {
            agent,
            first,
            second,
        } => tr!(
            "Why does {agent} visit {first} before {second}?",
            agent,
            first,
            second
        ),
        Question::Arrival { agent } => tr!("Why does {agent} not arrive sooner?", agent),
        Question::Length {
            agent,
            fewer_than: None,
        } => tr!("Why is the path of {agent} this long?", agent),
        Question::Length {
            agent,
            fewer_than: Some(moves),
        } => tr!(
            "Why does {agent} not make fewer than {moves} moves?",
            agent,
            moves
        ),
        Question::Makespan => tr!("Why does it take this long?").to_owned(),
        Question::SumOfCosts => tr!("Why is the sum of costs not less?").to_owned(),
        Question::Penalty => tr!("Why is the penalty not less?").to_owned(),
        Question::Charges { agent: Some(agent) } => {
            tr!("Why does {agent} not charge fewer times?", agent)
        }
        Question::Charges { agent: None } => tr!("Why are there not fewer charges?").to_owned(),
        Question::Moves { agent: Some(agent) } => {
            tr!("Why does {agent} not make fewer moves?", agent)
        }
        Question::Moves { agent: None } => tr!("Why are there not fewer moves?").to_owned(),
        Question::Waits { agent: Some(agent) } => tr!("Why does {agent} not wait less?", agent),
        Question::Waits { agent: None } => tr!("Why are there not fewer waits?").to_owned(),
        Question::Yield {
            agent,
            to,
            at: cell,
        } => tr!(
            "Why does {agent} give way to {to} at {cell}?",
            agent,
            to,
            cell
        ),
        Question::Rule { rule } => {
            tr!("Why is it not so: \"{rule}\"?", rule = rule.sentence())
        }
        Question::Unsolvable => tr!("Why is there no plan?").to_owned(),
        Question::Plan => tr!("Is this plan the best?").to_owned(),
    }
}

fn place(cell: Option<Cell>) -> String {
    cell.map_or_else(
        String::new,
        |cell| tr!("something done" => " at {cell}", cell),
    )
}

fn when(time: Option<u32>) -> String {
    time.map_or_else(
        String::new,
        |time| tr!("something done" => " at time {time}", time),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(ask: &Question, expect: &str) {
        assert_eq!(sentence(ask), expect);
    }

    #[test]
    fn questions_read_as_they_are_asked() {
        let agent = || "A1".to_owned();
        let (u, v) = (Cell::new(6, 2), Cell::new(6, 1));
        let wait = |at_least| Question::Wait {
            agent: agent(),
            at: Some(u),
            from: Some(1),
            to: Some(4),
            at_least,
        };
        check(&wait(None), "Why does A1 wait at (6, 2)?");
        check(&wait(Some(3)), "Why does A1 wait so long at (6, 2)?");
        let charge = Question::Charge {
            agent: agent(),
            at: Some(u),
            time: Some(9),
        };
        check(&charge, "Why does A1 charge at (6, 2) at time 9?");
        let go = Question::Move {
            agent: agent(),
            from_cell: u,
            to_cell: v,
            time: None,
        };
        check(&go, "Why does A1 go from (6, 2) to (6, 1)?");
        let slow = Question::Slow {
            agent: agent(),
            from_cell: Some(u),
            to_cell: Some(v),
        };
        check(
            &slow,
            "Why does A1 take the slow way over (6, 2) and (6, 1)?",
        );
        let order = Question::Order {
            agent: agent(),
            first: u,
            second: v,
        };
        check(&order, "Why does A1 visit (6, 2) before (6, 1)?");
        let give_way = Question::Yield {
            agent: agent(),
            to: "A2".to_owned(),
            at: u,
        };
        check(&give_way, "Why does A1 give way to A2 at (6, 2)?");
        let charges = |agent| Question::Charges { agent };
        check(&charges(None), "Why are there not fewer charges?");
        check(
            &charges(Some(agent())),
            "Why does A1 not charge fewer times?",
        );
        check(&Question::Unsolvable, "Why is there no plan?");
    }
}
