//! What sets of robots alone need: the title, the sentence and the table.

use giveway_model::{Cost, Question};
use giveway_solve::explain::{ExplainAnswer, SubsetBound, Verdict};

use super::pays::respond;
use super::{solved, told};
use crate::ask::{Card, Piece, TightRow, card};
use crate::reduce::tests::after;
use crate::{Action, AskAction};

/// The card of an answer without another plan to a question about the whole plan of the warehouse.
fn card_of(question: &Question, alone: Vec<SubsetBound>) -> Card {
    let state = after(&solved(), [Action::Ask(AskAction::Ask(question.clone()))]);
    let costs = told(&state).costs;
    let answer = ExplainAnswer {
        question: question.clone(),
        verdict: Verdict::Necessary,
        costs: None,
        alternative: None,
        repairs: Vec::new(),
        pending: Vec::new(),
        alone,
        ..told(&state)
    };
    assert_eq!(costs.unwrap().makespan, 18);
    card(&respond(&state, answer)).unwrap()
}

fn bound(agents: &[&str], cost: Cost, [own, least, here]: [u32; 3]) -> SubsetBound {
    SubsetBound {
        agents: agents.iter().map(|&name| name.to_owned()).collect(),
        cost,
        own,
        least,
        here,
    }
}

fn told_of(row: &TightRow) -> (String, u32, &str, bool) {
    let text = |piece: &Piece| match piece {
        Piece::Text(text) => text.clone(),
        Piece::Robot(_, name) => name.clone(),
        Piece::Cell(cell) => cell.to_string(),
    };
    let robots = row.robots.iter().map(text).collect();
    (robots, row.need, row.beside.as_str(), row.is_all)
}

#[test]
fn the_robots_that_alone_need_as_much_are_title_and_sentence() {
    let cost = Cost::Makespan;
    let alone = vec![
        bound(&["A1"], cost, [18, 18, 18]),
        bound(&["A2"], cost, [9, 9, 10]),
    ];
    let card = card_of(&Question::Makespan, alone);
    let verdict = card.verdict.unwrap();
    assert_eq!(verdict.title, "A1 alone needs 18");
    assert_eq!(
        verdict.sentence,
        "A1 alone needs 18 steps, whatever the other robot does."
    );
    let tight = card.tight.unwrap();
    assert_eq!(tight.counted, "need");
    let rows: Vec<_> = tight.rows.iter().map(told_of).collect();
    assert_eq!(
        rows,
        [
            ("A1".to_owned(), 18, "as the plan", true),
            ("A2".to_owned(), 9, "9 less", false)
        ]
    );
}

#[test]
fn all_robots_together_are_no_reason() {
    let all = bound(&["A1", "A2"], Cost::Makespan, [16, 18, 18]);
    let verdict = card_of(&Question::Makespan, vec![all]).verdict.unwrap();
    assert_eq!(verdict.title, "They cannot all be done sooner");
}

#[test]
fn a_sum_tells_what_robots_lose_together() {
    let cost = Cost::SumOfCosts;
    let alone = vec![
        bound(&["A1", "A2"], cost, [20, 24, 27]),
        bound(&["A1"], cost, [10, 10, 10]),
    ];
    let card = card_of(&Question::SumOfCosts, alone);
    assert_eq!(card.verdict.unwrap().title, "The sum cannot be less");
    let tight = card.tight.unwrap();
    assert_eq!(tight.counted, "lose");
    let rows: Vec<_> = tight.rows.iter().map(told_of).collect();
    assert_eq!(
        rows,
        [("A1 and A2".to_owned(), 4, "of 7 here", false)],
        "who loses nothing is left out"
    );
}

#[test]
fn when_the_robot_arrives_that_is_asked_about_comes_first() {
    let question = Question::Arrival {
        agent: "A1".to_owned(),
    };
    let state = after(&solved(), [Action::Ask(AskAction::Ask(question.clone()))]);
    let mut answer = ExplainAnswer {
        question,
        verdict: Verdict::Necessary,
        costs: None,
        alternative: None,
        pending: Vec::new(),
        ..told(&state)
    };
    answer.repairs[0].arrival = Some(14);
    let card = card(&respond(&state, answer)).unwrap();
    assert_eq!(card.verdict.unwrap().title, "A1 cannot arrive sooner");
    let offered = &card.repairs[0];
    assert!(
        offered.costs.starts_with("A1 arrives at 14; "),
        "{}",
        offered.costs
    );
    let (by, is_less) = offered.difference.clone().unwrap();
    assert!(is_less && by.contains('3'), "{by}");
}
