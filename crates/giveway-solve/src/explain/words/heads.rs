//! Words and headings around an answer to a question.

use giveway_model::{Question, tr};

use crate::explain::{Class, Core, ExplainAnswer, Fact, GroupMark, Helps, Verdict};

/// The verdict in a word.
pub fn verdict_word(answer: &ExplainAnswer) -> &'static str {
    if answer.valid == Some(false) {
        return tr!("a verdict" => "Against the rules");
    }
    match (&answer.question, answer.verdict) {
        (Question::Unsolvable, Verdict::Necessary) => tr!("a verdict" => "Impossible"),
        (Question::Plan, Verdict::Needless) => tr!("a verdict" => "Optimal"),
        (_, Verdict::Needless) => tr!("a verdict" => "Needless"),
        (_, Verdict::Improvable) => tr!("a verdict" => "Improvable"),
        (_, Verdict::Costly) => tr!("a verdict" => "Costly"),
        (_, Verdict::Necessary) => tr!("a verdict" => "Necessary"),
        (_, Verdict::Unknown) => tr!("a verdict" => "Not known"),
    }
}

/// The heading of a witness, or of the rules that a plan breaks. Where there is no plan, they are of one
/// class, all rules of which may be broken.
pub fn witness_title(question: &Question, class: Option<Class>) -> String {
    match (question, class) {
        (_, Some(Class::Collision)) => {
            tr!("If robots could pass through each other, only this would go wrong").to_owned()
        }
        (_, Some(Class::Obstacle)) => {
            tr!("If robots could pass through obstacles, only this would go wrong").to_owned()
        }
        (_, Some(Class::Battery)) => {
            tr!("If batteries did not matter, only this would go wrong").to_owned()
        }
        (_, Some(Class::Waypoint)) => {
            tr!("If waypoints could be skipped, only this would go wrong").to_owned()
        }
        (Question::Wait { agent, .. }, None) => tr!("If {agent} did not wait", agent),
        (Question::Plan, None) => tr!("What is against the rules").to_owned(),
        (_, None) => tr!("What would go wrong if only this changed").to_owned(),
    }
}

/// The heading of a set of facts: `further` sets say that they are not the first.
pub fn facts_title(verdict: Verdict, core: &Core, is_further: bool) -> &'static str {
    match (verdict, is_single(core), is_further) {
        (Verdict::Costly, true, false) => tr!("This fact rules out such a plan at no higher cost"),
        (Verdict::Costly, true, true) => {
            tr!("This fact rules out such a plan at no higher cost, too")
        }
        (Verdict::Costly, false, false) => {
            tr!("These facts together rule out such a plan at no higher cost")
        }
        (Verdict::Costly, false, true) => {
            tr!("These facts together rule out such a plan at no higher cost, too")
        }
        (_, true, false) => tr!("This fact rules it out"),
        (_, true, true) => tr!("This fact rules it out, too"),
        (_, false, false) => tr!("These facts together rule it out"),
        (_, false, true) => tr!("These facts together rule it out, too"),
    }
}

const fn is_single(core: &Core) -> bool {
    core.facts.len() == 1
}

/// The claim of a set of facts: that it suffices, whether each of its facts is needed for that, and which of
/// them help when they alone are left out. The task of the agent of the question is never left out: it is
/// named where there is one.
pub fn facts_claim(question: &Question, verdict: Verdict, core: &Core) -> String {
    let set = match (core.minimal, is_single(core), question.agent()) {
        (false, _, _) => perhaps_needed(core).to_owned(),
        (true, true, None) => tr!("This fact alone rules it out.").to_owned(),
        (true, true, Some(agent)) => tr!(
            "Given the task of {agent}, this fact alone rules it out.",
            agent
        ),
        (true, false, None) => {
            tr!("These facts alone rule it out, and each of them is needed for that.").to_owned()
        }
        (true, false, Some(agent)) => tr!(
            "Given the task of {agent}, these facts alone rule it out, and each of them is needed for that.",
            agent
        ),
    };
    let alone = alone(question, verdict, core).map(|sentence| format!(" {sentence}"));
    format!("{set}{}", alone.unwrap_or_default())
}

/// The claim of a set that is not shown minimal, in accord with the marks of its groups.
fn perhaps_needed(core: &Core) -> &'static str {
    let is_open = |mark| mark == GroupMark::Open;
    let open = core.groups.iter().filter(|it| is_open(it.mark())).count();
    match (core.groups.len(), open) {
        (1.., 0) => tr!(
            "These facts alone rule it out. Each group is needed for that; of a group, some facts may not be."
        ),
        (groups, open) if open < groups => tr!(
            "These facts alone rule it out. The marked groups are needed for that; the others may not be."
        ),
        _ => tr!("These facts alone rule it out; some of them may not be needed."),
    }
}

/// The effect of leaving out one fact of a set, as a sentence about all of them.
fn alone(question: &Question, verdict: Verdict, core: &Core) -> Option<&'static str> {
    let count = |helps| core.facts.iter().filter(|fact| fact.helps == helps).count();
    let (single, costly) = (is_single(core), verdict == Verdict::Costly);
    match [Helps::Yes, Helps::No, Helps::Unknown].map(count) {
        [0, 0, 0] => None,
        [_, 0, 0] => Some(match (question, single) {
            (_, true) if costly => tr!("Without it, such a plan costs no more than this one."),
            (_, false) if costly => {
                tr!("Without any one of them, such a plan costs no more than this one.")
            }
            (Question::Unsolvable, true) => tr!("Without it there is a plan."),
            (Question::Unsolvable, false) => tr!("Without any one of them there is a plan."),
            (_, true) => tr!("Without it there is such a plan."),
            (_, false) => tr!("Without any one of them there is such a plan."),
        }),
        [_, _, 0] => no_help(core),
        [0, ..] if single => Some(tr!("It is not known whether leaving it out helps.")),
        [0, ..] => Some(tr!(
            "It is not known for all of them whether leaving out only that one helps."
        )),
        _ => Some(tr!(
            "It is not known for all of the others whether leaving out only that one helps."
        )),
    }
}

/// The sentence that leaving out one fact of a set, or one of those without a mark, does not help, where that
/// is so.
pub(super) fn no_help(core: &Core) -> Option<&'static str> {
    let count = |helps| core.facts.iter().filter(|fact| fact.helps == helps).count();
    if count(Helps::Unknown) > 0 {
        return None;
    }
    match [Helps::Yes, Helps::No].map(count) {
        [_, 0] => None,
        [0, 1] => Some(tr!(
            "Leaving it out does not help, since other facts rule it out, too."
        )),
        [0, ..] => Some(tr!(
            "Leaving out only one of them does not help, since other facts rule it out, too."
        )),
        [_, 1] => Some(tr!(
            "Leaving out only the other one does not help, since other facts rule it out, too."
        )),
        _ => Some(tr!(
            "Leaving out only one of the others does not help, since other facts rule it out, too."
        )),
    }
}

/// The mark of a fact that helps when it alone is left out; none where this holds for all facts of its set,
/// since its claim says so.
pub fn helps_mark(
    question: &Question,
    verdict: Verdict,
    core: &Core,
    fact: &Fact,
) -> Option<&'static str> {
    let helps = |fact: &Fact| fact.helps == Helps::Yes;
    (helps(fact) && !core.facts.iter().all(helps)).then(|| match (question, verdict) {
        (_, Verdict::Costly) => tr!("without it, such a plan costs no more"),
        (Question::Unsolvable, _) => tr!("without it there is a plan"),
        _ => tr!("without it there is such a plan"),
    })
}
