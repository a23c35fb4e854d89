//! One robot, one plan, one name in all parts of an answer; nothing is said twice.

use std::collections::BTreeMap;

use giveway_model::check::{Rule, Violation};
use giveway_model::{Cell, Cost, Costs, Plan, Question};
use giveway_solve::explain::{
    AgentDifference, ExplainAnswer, Here, Near, Part, Passing, Variation, VariationKind, Verdict,
};

use super::pays::{card_of, differs, respond};
use super::{asked, question, told};
use crate::ask::card;
use crate::beside::other_title;
use crate::reduce::tests::after;
use crate::{Action, AskAction, State};

/// A wait with robots that it lets pass, and whom it would make late.
fn waits(passing: &[&str], pays: Vec<AgentDifference>) -> String {
    let card = card_of(|answer| {
        answer.question = Question::Wait {
            agent: "A1".to_owned(),
            at: None,
            from: None,
            to: None,
            at_least: None,
        };
        let would_meet = |name: &&str| Violation {
            rule: Rule::Vertex,
            agents: vec!["A1".to_owned(), (*name).to_owned()],
            time: 4,
            cell: Some(Cell::new(1, 1)),
            edge: None,
            broken: None,
            message: String::new(),
        };
        let passes = |name: &&str| Passing {
            agent: (*name).to_owned(),
            cell: Cell::new(1, 1),
            time: 4,
        };
        answer.here = Some(Here {
            agent: "A1".to_owned(),
            passing: passing.iter().map(passes).collect(),
            violations: passing.iter().map(would_meet).collect(),
            words: format!("A1 lets {} pass.", passing.join(" and ")),
        });
        answer.pays = pays;
    });
    let sentence = card.verdict.unwrap().sentence;
    sentence.split_once('\n').unwrap().1.to_owned()
}

/// Who is let pass and who would be late need not be the same: then both are told.
#[test]
fn whoever_is_let_pass_is_told_of_with_who_would_be_late() {
    let late = |name: &str| differs(name, 10, 15);
    let same = waits(&["A2"], vec![late("A2")]);
    assert!(
        same.ends_with("A2 would arrive at 15 instead of 10."),
        "{same}"
    );
    let another = waits(&["A2"], vec![late("A7")]);
    assert!(
        another.ends_with("A7 would arrive at 15 instead of 10. No later than now: A2."),
        "{another}"
    );
    let both = waits(&["A2"], vec![differs("A7", 10, 19), late("A2"), late("A4")]);
    assert!(
        both.ends_with("A7 would arrive at 19 instead of 10. Later, too: A2."),
        "{both}"
    );
}

/// An answer in which A2 waits a step longer at its start than in the plan that is shown, at a
/// makespan so much higher; beside it another way that costs two more than that.
pub(super) fn with_choice(state: &State, more: i64) -> ExplainAnswer {
    let before = told(state);
    let mut plan = before.alternative.clone().unwrap();
    let path = plan.paths.get_mut("A2").unwrap();
    path.insert(0, path[0]);
    let costs = |by: i64| {
        let own = state
            .document
            .answer
            .as_ref()
            .unwrap()
            .solved
            .costs
            .unwrap();
        let makespan = u32::try_from(i64::from(own.makespan) + by).unwrap();
        Costs { makespan, ..own }
    };
    let deltas = |by: i64| BTreeMap::from([(Cost::Makespan, by)]);
    let variation = Variation {
        kind: VariationKind::OtherWay,
        other: None,
        cell: None,
        from: None,
        costs: costs(more + 2),
        deltas: deltas(more + 2),
        pays: vec![differs("A1", 17, 19)],
        plan: Plan::default(),
        text: String::new(),
    };
    ExplainAnswer {
        verdict: if more < 0 {
            Verdict::Improvable
        } else {
            Verdict::Costly
        },
        alternative: Some(plan),
        costs: Some(costs(more)),
        deltas: deltas(more),
        pays: vec![differs("A2", 10, 11)],
        near: Some(Near {
            variations: vec![variation],
            at_most: None,
            words: String::new(),
        }),
        repairs: Vec::new(),
        pending: Vec::new(),
        ..before
    }
}

#[test]
fn the_best_plan_is_among_what_it_could_do() {
    let state = respond(&asked(), with_choice(&asked(), 1));
    let shown = card(&state).unwrap();
    let rows: Vec<_> = shown
        .could
        .iter()
        .map(|row| {
            (
                row.index,
                row.text.as_str(),
                row.difference.as_str(),
                row.is_chosen,
            )
        })
        .collect();
    assert_eq!(
        rows,
        [
            (None, "The best that was found", "+1 in the makespan", true),
            (
                Some(0),
                "Go another way",
                "at most +3 in the makespan",
                false
            )
        ]
    );
    assert_eq!(shown.could[0].detail, "A2 arrives at 11, 1 later");
    let which = |state: &State| card(state).unwrap().other.unwrap().which.unwrap();
    assert_eq!(which(&state), "the best that was found");
    let chosen = after(&state, [Action::Ask(AskAction::Choose(Some(0)))]);
    assert_eq!(which(&chosen), "Go another way");
    assert_eq!(other_title(&chosen), "The other plan: Go another way");
    let chosen = card(&chosen).unwrap();
    assert!(!chosen.could[0].is_chosen && chosen.could[1].is_chosen);
    // The verdict is about the best one, and does not call it the other plan.
    assert_eq!(chosen.verdict, shown.verdict);
    assert!(!shown.verdict.unwrap().sentence.contains("other plan"));
}

#[test]
fn what_the_plan_shows_is_said_once() {
    let here = "On its quickest way to do so, A1 would meet A2 at (6, 1) at time 10.";
    let said = |near: &str| {
        let card = card_of(|answer| {
            answer.question = Question::Makespan;
            answer.verdict = Verdict::Unknown;
            answer.pending = vec![Part::Verdict];
            (answer.alternative, answer.costs) = (None, None);
            answer.here = Some(Here {
                agent: "A1".to_owned(),
                passing: Vec::new(),
                violations: Vec::new(),
                words: here.to_owned(),
            });
            answer.words = format!("{here} {near}").trim_end().to_owned();
        });
        card.verdict.unwrap().sentence
    };
    assert_eq!(said(""), here);
    assert_eq!(said("None of them."), format!("{here}\nNone of them."));
}

#[test]
fn what_it_could_do_says_how_the_robot_goes() {
    let own = |more_waits: i64| AgentDifference {
        more_waits,
        other_way: true,
        ..differs("A1", 17, 17)
    };
    let shown = |question: &Question, more_waits: i64| {
        let mut answer = with_choice(&asked(), 1);
        answer.question = question.clone();
        answer.pays.push(own(more_waits));
        let near = answer.near.as_mut().unwrap();
        near.variations[0].pays = vec![own(more_waits)];
        let could = card(&respond(&asked(), answer)).unwrap().could;
        (could[0].detail.clone(), could[1].text.clone())
    };
    let is = |detail: &str, text: &str| {
        let late = "A2 arrives at 11, 1 later";
        (format!("{detail}; {late}"), text.to_owned())
    };
    let less = is("A1 goes another way", "Go another way");
    assert_eq!(shown(&question(), -2), less);
    let more = "A1 goes another way and waits more";
    assert_eq!(shown(&question(), 2), is(more, "Go another way"));
    // Where it is asked why it waits, it matters that it waits all the same.
    let wait = Question::Wait {
        agent: "A1".to_owned(),
        at: None,
        from: None,
        to: None,
        at_least: None,
    };
    assert_eq!(shown(&wait, -2), less);
    let there = "Go another way and wait there";
    assert_eq!(shown(&wait, 2), is(more, there));
}
