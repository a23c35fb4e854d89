//! What is lost in all, and what is proved of it.

use giveway_model::tr;
use giveway_solve::delays::{DelaysAnswer, words};

use crate::ask::{Badge, VerdictPart};

/// The verdict of a ledger.
pub(super) fn verdict(told: &DelaysAnswer) -> VerdictPart {
    if told.reason.is_some() || told.costs.is_none() {
        let word = tr!("There is no ledger of this plan");
        return part("clock", "unknown", word.to_owned(), told.words.clone());
    }
    let lost = told.delay;
    if lost == 0 {
        let title = tr!("No step is lost").to_owned();
        return part("proved", "necessary", title, sentence(told));
    }
    let proof = told.proof.as_ref();
    let saved = proof.map_or(0, |proof| lost.saturating_sub(proof.at_most));
    let proved = proof.map_or(0, |proof| proof.at_least.min(lost));
    let nobody = tr!("{n} step lost" | "{n} steps lost" % lost);
    let (icon, class, title) = if saved > 0 && proved + saved < lost {
        (
            "compare",
            "needless",
            tr!("{lost}, at least {saved} to be saved", lost = nobody, saved),
        )
    } else if saved > 0 {
        (
            "compare",
            "needless",
            tr!("{lost}, {saved} to be saved", lost = nobody, saved),
        )
    } else if proved == lost {
        (
            "proved",
            "necessary",
            tr!("{lost}, none to be saved", lost = nobody),
        )
    } else if proved > 0 {
        let open = lost - proved;
        (
            "clock",
            "unknown",
            tr!(
                "{proved} of {lost} are proved, {open} open",
                proved,
                lost,
                open
            ),
        )
    } else {
        ("clock", "unknown", nobody)
    };
    part(icon, class, title, sentence(told))
}

/// What the robots need alone and here, and what is proved of the difference.
fn sentence(told: &DelaysAnswer) -> String {
    let sum = told.costs.map_or(0, |costs| costs.sum_of_costs);
    let mut sentences = Vec::new();
    if let Some(since) = told.since {
        sentences.push(tr!("This is about the plan from time {since} on.", since));
    }
    sentences.push(if told.delay == 0 {
        words::total(told)
    } else {
        tr!(
            "Alone the {robots} robots need {alone} steps in all, here {sum}.",
            robots = told.agents.len(),
            alone = told.alone,
            sum
        )
    });
    sentences.extend(words::proof(told));
    sentences.join(" ")
}

const fn part(
    icon: &'static str,
    class: &'static str,
    title: String,
    sentence: String,
) -> VerdictPart {
    VerdictPart {
        badge: Badge {
            word: "",
            icon,
            class,
        },
        title,
        claim: None,
        pieces: Vec::new(),
        sentence,
    }
}
