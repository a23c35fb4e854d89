//! Parts of an answer that were not found: it is said, and not left out.

use giveway_solve::explain::{Core, FactGroup, FactGroupKind, Helps, Part, Verdict};

use super::pays::card_of;
use super::{asked, hear, told};
use crate::ask::card;
use crate::sample::reach;

/// The titles with their sentences.
fn missing(card: &crate::ask::Card) -> Vec<(&'static str, &str)> {
    let parts = card.missing.iter();
    parts
        .map(|part| (part.title, part.sentences[0].as_str()))
        .collect()
}

#[test]
fn without_a_small_reason_that_is_said() {
    let card = card_of(|answer| {
        answer.verdict = Verdict::Costly;
        (answer.core, answer.repairs) = (None, Vec::new());
        answer.exhaustive = false;
    });
    assert_eq!(
        missing(&card),
        [
            ("Because of", "No small reason was found yet."),
            ("What would help", "Nothing was found that helps.")
        ]
    );
}

#[test]
fn it_is_told_whether_all_was_tried() {
    let told_of = |exhaustive, pending: Vec<Part>| {
        let card = card_of(|answer| {
            answer.verdict = Verdict::Necessary;
            answer.repairs = Vec::new();
            (answer.exhaustive, answer.pending) = (exhaustive, pending);
        });
        let of_help = missing(&card).into_iter();
        let mut of_help = of_help.filter(|(title, _)| *title == "What would help");
        of_help.next().unwrap().1.to_owned()
    };
    assert_eq!(
        told_of(true, Vec::new()),
        "No change of one or two things in the scene helps."
    );
    assert_eq!(
        told_of(false, vec![Part::Repairs]),
        "The search ended before this was looked for."
    );
}

#[test]
fn what_is_marked_as_helping_is_pointed_to() {
    let told_of = |helps| {
        let card = card_of(|answer| {
            answer.verdict = Verdict::Costly;
            answer.repairs = Vec::new();
            answer.exhaustive = false;
            let group = FactGroup {
                kind: FactGroupKind::Agent,
                agents: vec!["A2".to_owned()],
                cells: Vec::new(),
                facts: Vec::new(),
                text: "A2".to_owned(),
                needed: true,
                helps,
                price: None,
            };
            answer.core = Some(Core {
                facts: Vec::new(),
                groups: vec![group],
                prices: Vec::new(),
                minimal: true,
                reach: reach(None),
                further: Vec::new(),
            });
        });
        let of_help = missing(&card);
        let mut of_help = of_help.iter().filter(|it| it.0 == "What would help");
        of_help.next().unwrap().1.to_owned()
    };
    assert_eq!(told_of(Helps::Yes), "See what is marked as helping above.");
    assert_eq!(told_of(Helps::No), "Nothing was found that helps.");
    assert_eq!(told_of(Helps::Unknown), "Nothing was found that helps.");
}

#[test]
fn nothing_is_missing_where_nothing_is_needed_or_the_search_goes_on() {
    let needless = card_of(|answer| {
        answer.verdict = Verdict::Needless;
        (answer.core, answer.repairs) = (None, Vec::new());
    });
    assert_eq!(needless.missing, []);
    let state = asked();
    let mut answer = told(&state);
    (answer.core, answer.repairs) = (None, Vec::new());
    let looking = card(&hear(&state, answer)).unwrap();
    assert_eq!(looking.missing, [], "it may come yet");
}
