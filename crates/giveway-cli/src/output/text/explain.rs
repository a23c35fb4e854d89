//! The answer of `explain` as text.

use std::fmt::Write as _;

use anstyle::AnsiColor;
use giveway_model::{
    Cost, Costs, Instance, Objective, Plan,
    change::History,
    check::{costs, costs_over_time},
    question::{sentence, to_words},
    words::name,
};
use giveway_solve::explain::{
    Core, ExplainAnswer, FactGroup, GroupMark, Helps, Verdict, alone_sentence, facts_claim,
    facts_title, helps_mark, price_clause, verdict_word, witness_title,
};
use giveway_solve::words::reach;

use super::{bold, paint, solve::work, title};
use crate::output::{map, plain, table, words};

/// So many things of a kind are told one by one; the rest is counted.
const TOLD: usize = 20;
/// More facts are told in groups.
const FEW_FACTS: usize = 7;

/// The question, the answer in words, the costs side by side, both plans, the
/// reasons.
pub(crate) fn explain(
    instance: &Instance,
    plan: Option<&Plan>,
    answer: &ExplainAnswer,
    columns: usize,
) -> String {
    let before = plan.and_then(|plan| costs(instance, plan));
    let map = map::draw(instance, columns);
    let plans = plan.map(|plan| plans(instance, plan, answer, columns));
    whole(instance, before, answer, map, plans.unwrap_or_default())
}

/// The same where the world changed while the plan ran; the map is the last.
pub(crate) fn explain_over_time(
    instance: &Instance,
    history: &History,
    plan: &Plan,
    answer: &ExplainAnswer,
    columns: usize,
) -> String {
    let before = costs_over_time(history, plan);
    let map = map::draw_over_time(instance, history, columns);
    let mut plans = table::draw_over_time(history, plan, columns);
    if let Some(other) = &answer.alternative {
        let other = table::draw_over_time(history, other, columns);
        let _ = write!(plans, "\n{}:\n{other}", bold("The other plan"));
    }
    whole(instance, before, answer, map, plans)
}

fn whole(
    instance: &Instance,
    before: Option<Costs>,
    answer: &ExplainAnswer,
    map: String,
    plans: String,
) -> String {
    let mut parts = vec![title(instance), verdict(answer)];
    let after = answer.costs.filter(|_| answer.alternative.is_some());
    if let (Some(before), Some(after)) = (before, after) {
        parts.push(cost_table(instance, &before, &after));
    }
    parts.extend([map, plans]);
    let violations = answer.violations.iter().flatten();
    let broken: Vec<&str> = violations.map(|v| v.message.as_str()).collect();
    parts.push(listed(&witness_title(&answer.question, None), &broken));
    for entries in answer.witness.chunk_by(|a, b| a.class == b.class) {
        let title = witness_title(&answer.question, entries[0].class);
        let would: Vec<&str> = entries
            .iter()
            .map(|entry| entry.violation.message.as_str())
            .collect();
        parts.push(listed(&title, &would));
    }
    let sets = answer.core.iter().flat_map(Core::sets).enumerate();
    parts.extend(sets.map(|(set, core)| {
        let title = facts_title(answer.verdict, core, set > 0);
        if core.facts.len() > FEW_FACTS && !core.groups.is_empty() {
            groups(answer, core, title)
        } else {
            facts(answer, (core, before, instance.objective()), title)
        }
    }));
    let alone: Vec<String> = answer.alone.iter().map(alone_sentence).collect();
    let alone: Vec<&str> = alone.iter().map(String::as_str).collect();
    parts.push(listed("What some robots alone need", &alone));
    let mut repairs: Vec<&str> = answer.repairs.iter().map(|r| r.text.as_str()).collect();
    let further = format!("{} more would help, too.", answer.further_repairs);
    repairs.extend((answer.further_repairs > 0).then_some(further.as_str()));
    parts.push(listed("What would help", &repairs));
    let near = answer.near.iter().flat_map(|near| &near.variations);
    let near: Vec<&str> = near.map(|it| it.text.as_str()).collect();
    parts.push(listed("Small changes", &near));
    parts.push(work(&answer.stats));
    parts.retain(|part| !part.is_empty());
    parts.join("\n")
}

/// A set of facts, those that help with a mark, others with what is left without them, and what is
/// claimed of it.
fn facts(
    answer: &ExplainAnswer,
    (core, before, objective): (&Core, Option<Costs>, &Objective),
    title: &str,
) -> String {
    let left = |place: u32, helps| {
        let price = core.prices.iter().find(|price| price.fact == place)?;
        Some(price_clause((price, helps), before.as_ref()?, objective))
    };
    let marked = (0..).zip(&core.facts).map(|(place, fact)| {
        let mark = helps_mark(&answer.question, answer.verdict, core, fact);
        let mark = mark.map(str::to_owned);
        let mark = mark.or_else(|| left(place, fact.helps).filter(|_| fact.helps != Helps::Yes));
        let mark = mark.map_or_else(String::new, |mark| format!(" ({mark})"));
        format!("{}{mark}", fact.text)
    });
    let marked: Vec<String> = marked.collect();
    let marked: Vec<&str> = marked.iter().map(String::as_str).collect();
    let mut text = listed(title, &marked);
    if !text.is_empty() {
        let claim = facts_claim(&answer.question, answer.verdict, core);
        let _ = writeln!(text, "{claim}");
    }
    text
}

/// A set of many facts in its groups, each with its mark and its price.
fn groups(answer: &ExplainAnswer, core: &Core, title: &str) -> String {
    let mut text = format!("{}:\n", bold(title));
    for (number, group) in (1..).zip(&core.groups) {
        let _ = writeln!(
            text,
            "  {number} {}{}",
            plain::text(&group.text),
            mark(core, group)
        );
    }
    let claim = facts_claim(&answer.question, answer.verdict, core);
    let _ = writeln!(text, "{claim}");
    text
}

/// How many facts a group has, whether they are needed, and what helps, with its price.
fn mark(core: &Core, group: &FactGroup) -> String {
    let mut marks = Vec::new();
    let count = group.facts.len();
    marks.extend((count > 1).then(|| format!("{count} facts")));
    marks.extend(match group.mark() {
        GroupMark::Helps | GroupMark::Needed => Some("needed".to_owned()),
        GroupMark::Open => None,
    });
    let fact = |place: u32| {
        core.facts
            .get(place as usize)
            .map(|fact| fact.text.as_str())
    };
    let told = match (&group.price, group.helps) {
        (Some(price), _) => {
            let at_most = if price.proved { "" } else { "at most " };
            let costs = price.costs;
            let without = fact(price.fact).filter(|_| count > 1).unwrap_or("it");
            let still = match group.mark() {
                GroupMark::Helps => "",
                GroupMark::Needed | GroupMark::Open => "still ",
            };
            Some(format!(
                "without \"{without}\": {still}makespan {at_most}{}, sum of costs {at_most}{}",
                costs.makespan, costs.sum_of_costs
            ))
        }
        (None, Helps::Yes) => Some("would help".to_owned()),
        (None, Helps::No | Helps::Unknown) => None,
    };
    marks.extend(told.map(|told| plain::text(&told)));
    if marks.is_empty() {
        return String::new();
    }
    format!(" ({})", marks.join("; "))
}

/// The question and the verdict, with the reach of the claim.
fn verdict(answer: &ExplainAnswer) -> String {
    let colour = match answer.verdict {
        _ if answer.valid == Some(false) => AnsiColor::Red,
        Verdict::Needless | Verdict::Improvable => AnsiColor::Green,
        Verdict::Costly | Verdict::Unknown => AnsiColor::Yellow,
        Verdict::Necessary => AnsiColor::Red,
    };
    let word = paint(colour.on_default().bold(), verdict_word(answer));
    let asked = format!(
        "{} ({})",
        sentence(&answer.question),
        to_words(&answer.question)
    );
    let asked = plain::text(&asked);
    if has_no_verdict(answer) {
        return format!("{asked}\n{}\n", plain::text(&answer.words));
    }
    let mut text = format!("{asked}\n{word}");
    if answer.words.is_empty() {
        text += ".\n";
    } else {
        let _ = writeln!(text, ": {}", plain::text(&answer.words));
    }
    if let Some(reach) = reach(answer.reach) {
        let _ = writeln!(text, "{reach}");
    }
    text
}

/// Whether the answer has only what the plan shows and what is near.
fn has_no_verdict(answer: &ExplainAnswer) -> bool {
    let here = answer.here.iter().map(|here| &here.words);
    let near = answer.near.iter().map(|near| &near.words);
    let mut quick = here.chain(near).filter(|words| !words.is_empty());
    answer.verdict == Verdict::Unknown
        && quick.any(|words| answer.words.starts_with(words.as_str()))
}

/// All five costs of both plans, those of the objective first.
fn cost_table(instance: &Instance, before: &Costs, after: &Costs) -> String {
    let objective = instance.objective().costs();
    let others = Cost::USUAL.iter().filter(|cost| !objective.contains(cost));
    let mut text = format!(
        "{:<14}{:>10}{:>12}{:>12}\n",
        "cost", "this plan", "other plan", "difference"
    );
    for &cost in objective.iter().chain(others) {
        let (a, b) = (before.get(cost), after.get(cost));
        let more = i64::from(b) - i64::from(a);
        let more = if more == 0 {
            "-".to_owned()
        } else {
            format!("{more:+}")
        };
        let name = plain::pad_right(name(cost), 14);
        let _ = writeln!(text, "{name}{a:>10}{b:>12}{more:>12}");
    }
    text
}

/// The plan that is asked about, the other one beside it.
fn plans(instance: &Instance, plan: &Plan, answer: &ExplainAnswer, columns: usize) -> String {
    match &answer.alternative {
        None => table::draw(instance, plan, columns),
        Some(other) => {
            let beside = table::beside(instance, plan, other, columns);
            let best = if answer.closest {
                "No equally good plan is closer to this one.\n"
            } else {
                ""
            };
            format!("{beside}{best}")
        }
    }
}

/// Some sentences below a heading; nothing where there are none.
fn listed(heading: &str, sentences: &[&str]) -> String {
    if sentences.is_empty() {
        return String::new();
    }
    let mut text = format!("{}:\n", bold(heading));
    for sentence in sentences.iter().take(TOLD) {
        let _ = writeln!(text, "  {}", words::sentence(sentence));
    }
    if sentences.len() > TOLD {
        let more = sentences.len() - TOLD;
        let _ = writeln!(text, "  and {more} more; --format json shows them all");
    }
    text
}
