//! The verdict of an answer, and who pays for the other plan.

use giveway_model::{Cell, Cost, Question};
use giveway_solve::Response;
use giveway_solve::explain::{AgentDifference, ExplainAnswer, Here, How, Verdict};

use super::{asked, id, question, told};
use crate::ask::{Card, card};
use crate::reduce::tests::after;
use crate::{Action, AskAction, State, WorkerAction};

pub(super) fn differs(agent: &str, arrival: u32, other: u32) -> AgentDifference {
    AgentDifference {
        agent: agent.to_owned(),
        arrival,
        other,
        more_waits: i64::from(other) - i64::from(arrival),
        other_way: false,
    }
}

pub(super) fn respond(state: &State, answer: ExplainAnswer) -> State {
    let response = Box::new(Response::Explained(Box::new(answer)));
    let job = id(state);
    after(
        state,
        [Action::Worker(WorkerAction::Respond { job, response })],
    )
}

/// The card of an answer that was changed.
pub(super) fn card_of(change: impl FnOnce(&mut ExplainAnswer)) -> Card {
    let state = asked();
    let mut answer = told(&state);
    answer.pending = Vec::new();
    change(&mut answer);
    card(&respond(&state, answer)).unwrap()
}

fn words(sentence: &str) -> usize {
    sentence.split_whitespace().count()
}

#[test]
fn a_costly_answer_says_what_it_costs_and_who_is_late() {
    let card = card_of(|answer| answer.pays = vec![differs("A2", 10, 15), differs("A1", 17, 16)]);
    let verdict = card.verdict.unwrap();
    assert_eq!(verdict.title, "It would cost 1 charge");
    assert_eq!(verdict.badge.word, "Costly");
    assert_eq!(
        verdict.sentence,
        "If A1 did not charge at (6, 2) at time 9, A2 would arrive at 15 instead of 10."
    );
    assert_eq!(verdict.claim.as_deref(), Some("proved"));
}

#[test]
fn the_sentence_is_never_long() {
    let long = "a robot whose name has so many words that the sentence would not fit at all";
    let many = || (0..9).map(|n| differs(&format!("B{n}"), 10, 20)).collect();
    let card = card_of(|answer| {
        answer.pays = many();
        answer.pays[0].agent = long.to_owned();
    });
    let sentence = card.verdict.unwrap().sentence;
    assert!(words(&sentence) <= 30, "{sentence}");
    assert!(sentence.starts_with(long), "{sentence}");
    let card = card_of(|answer| answer.pays = many());
    let sentence = card.verdict.unwrap().sentence;
    assert!(words(&sentence) <= 30, "{sentence}");
    assert!(
        sentence
            .ends_with("B0 would arrive at 20 instead of 10. 8 others would arrive later, too."),
        "{sentence}"
    );
}

#[test]
fn a_needless_answer_says_how() {
    let wait = Question::Wait {
        agent: "A1".to_owned(),
        at: None,
        from: None,
        to: None,
        at_least: None,
    };
    let title = |how: &[How], question: &Question| {
        let card = card_of(|answer| {
            answer.verdict = Verdict::Needless;
            answer.deltas.insert(Cost::Charges, 0);
            answer.question = question.clone();
            answer.how = how.to_vec();
            answer.pays = vec![differs("A1", 17, 17), differs("A2", 10, 15)];
        });
        let verdict = card.verdict.unwrap();
        assert_eq!(verdict.claim.as_deref(), Some("same cost"));
        // Where the title says what could be instead, the word would say that nothing had to be.
        let is_said = verdict.title != "Another plan that costs the same does without it";
        assert_eq!(verdict.badge.word, if is_said { "" } else { "Needless" });
        verdict.title
    };
    assert_eq!(title(&[How::Free], &wait), "It need not wait at all");
    assert_eq!(title(&[How::Elsewhere], &wait), "It could wait elsewhere");
    assert_eq!(
        title(&[How::OtherWay], &wait),
        "It could drive around instead"
    );
    assert_eq!(
        title(&[How::OtherWay, How::Elsewhere], &wait),
        "It could go another way and wait there"
    );
    assert_eq!(
        title(&[How::Others, How::Elsewhere], &wait),
        "A2 could wait instead"
    );
    assert_eq!(title(&[How::Free], &question()), "It was for nothing");
    let sooner = Question::Arrival {
        agent: "A1".to_owned(),
    };
    assert_eq!(title(&[How::OtherWay], &sooner), "It could arrive sooner");
    let there = Question::NoVisit {
        agent: Some("A1".to_owned()),
        at: Cell::new(1, 1),
    };
    assert_eq!(title(&[How::Elsewhere], &there), "It could do so");
    assert_eq!(title(&[How::Others], &there), "A2 could wait instead");
    // An answer of an older program tells no how.
    assert_eq!(
        title(&[], &wait),
        "Another plan that costs the same does without it"
    );
}

#[test]
fn nobody_is_late_and_that_is_said() {
    let card = card_of(|answer| answer.pays = vec![differs("A1", 17, 17)]);
    let verdict = card.verdict.unwrap();
    assert_eq!(
        verdict.sentence,
        "If A1 did not charge at (6, 2) at time 9, nobody would arrive later."
    );
    let pays = card.pays.unwrap();
    assert_eq!(pays.summary, None, "all arrive as before");
    assert_eq!(
        pays.robots.len(),
        1,
        "it differs, though it arrives as before"
    );
    assert_eq!(
        pays.rest.as_deref(),
        Some("The other robot moves as before.")
    );
}

#[test]
fn what_is_necessary_has_no_colour_of_what_is_broken() {
    let card = card_of(|answer| {
        answer.verdict = Verdict::Necessary;
        answer.alternative = None;
        answer.costs = None;
    });
    let verdict = card.verdict.unwrap();
    assert_eq!(verdict.title, "There is no other way");
    assert_eq!(verdict.badge.class, "necessary");
    assert_eq!(
        verdict.sentence,
        "There is no plan in which A1 does not charge at (6, 2) at time 9."
    );
    assert_eq!(card.pays, None);
}

/// What the plan shows was said before the verdict, and stays above it.
#[test]
fn what_the_plan_shows_keeps_its_place() {
    let card = card_of(|answer| {
        answer.here = Some(Here {
            agent: "A1".to_owned(),
            passing: Vec::new(),
            violations: Vec::new(),
            words: "A1 lets A2 pass.".to_owned(),
        });
        answer.pays = vec![differs("A2", 10, 15)];
    });
    let sentence = card.verdict.unwrap().sentence;
    let (here, late) = sentence.split_once('\n').unwrap();
    assert_eq!(here, "A1 lets A2 pass.");
    assert!(
        late.ends_with("A2 would arrive at 15 instead of 10."),
        "{late}"
    );
}

/// A better plan is told by what it saves, not by who is later in it.
#[test]
fn a_better_plan_says_what_it_saves() {
    let card = card_of(|answer| {
        answer.question = Question::Makespan;
        answer.verdict = Verdict::Improvable;
        answer.deltas = [(Cost::Makespan, -2), (Cost::Charges, 1)].into();
        answer.costs.as_mut().unwrap().makespan -= 2;
        answer.pays = vec![differs("A2", 10, 15)];
    });
    let verdict = card.verdict.unwrap();
    assert_eq!(verdict.title, "All can be done 2 steps sooner");
    let saved = "All robots could be done at 16 instead of 18.";
    assert_eq!(verdict.sentence, saved);
    let charges = card_of(|answer| {
        answer.verdict = Verdict::Improvable;
        answer.deltas = [(Cost::Makespan, 0), (Cost::Charges, -1)].into();
        answer.costs.as_mut().unwrap().charges = 2;
    });
    let saved = "There could be 2 charges instead of 3.";
    assert_eq!(charges.verdict.unwrap().sentence, saved);
}

/// A step more is a step of a cost, which is named.
#[test]
fn a_price_names_its_cost() {
    let title = |cost: Cost, n: i64| {
        let card = card_of(|answer| {
            answer.deltas = [(Cost::Makespan, 0), (Cost::Charges, 0)].into();
            answer.deltas.insert(cost, n);
        });
        card.verdict.unwrap().title
    };
    assert_eq!(title(Cost::Makespan, 1), "1 step more until all are done");
    assert_eq!(title(Cost::SumOfCosts, 3), "3 steps more in all");
}

#[test]
fn a_repair_says_what_it_changes() {
    let card = card_of(|answer| answer.repairs[0].costs.makespan -= 3);
    let difference = card.repairs[0].difference.clone().unwrap();
    assert_eq!(difference, ("\u{2212}3 steps".to_owned(), true));
}

#[test]
fn costs_come_first_in_the_order_of_the_objective() {
    let pays = card_of(|_| {}).pays.unwrap();
    let titles: Vec<&str> = pays.costs.iter().map(|row| row.title.as_str()).collect();
    assert_eq!(titles, ["Makespan", "Sum of costs", "Charges"]);
    let charges = &pays.costs[2];
    assert_eq!((charges.this, charges.other), (3, 4));
    assert_eq!(
        charges.aloud(),
        "Charges: 3 here, 4 in the other plan, 1 more"
    );
    assert_eq!(pays.rest.as_deref(), Some("All robots arrive as before."));
    assert_eq!(pays.hidden, 0);
}

#[test]
fn a_table_is_unfolded_once() {
    let state = respond(&asked(), {
        let mut answer = told(&asked());
        answer.pending = Vec::new();
        answer
    });
    let unfolded = after(&state, [Action::Ask(AskAction::Unfold)]);
    assert!(unfolded.document.mode.asking().unwrap().is_unfolded);
    assert_eq!(card(&unfolded).unwrap().pays.unwrap().hidden, 0);
}

#[test]
fn a_plan_that_is_not_proved_best_is_a_bound() {
    let card = card_of(|answer| {
        answer.verdict = Verdict::Unknown;
        answer.pays = vec![differs("A2", 10, 15), differs("A1", 17, 16)];
    });
    let verdict = card.verdict.unwrap();
    assert_eq!(verdict.title, "At most 1 charge more");
    assert_eq!(verdict.claim.as_deref(), Some("not proved"));
    assert!(
        verdict
            .sentence
            .ends_with("A2 would arrive at 15 or sooner, not at 10.")
    );
    let nothing = card_of(|answer| {
        answer.verdict = Verdict::Unknown;
        answer.alternative = None;
        answer.costs = None;
    });
    let verdict = nothing.verdict.unwrap();
    let open = "It is not known whether it could be otherwise";
    assert_eq!((verdict.title.as_str(), verdict.claim), (open, None));
}
