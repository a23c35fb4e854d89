//! Changes and methods in words.

use giveway_model::tr;
use giveway_model::words::and;
use giveway_solve::change::Method;

use super::costs::values;
use crate::changing::{Changing, Comparing, Tried, count, in_words};
use crate::course::Adopted;
use crate::timeline::work_done;
use crate::{Adapting, Answer};

/// A method by itself: `Near the old paths`.
pub fn method(method: Method) -> &'static str {
    match method {
        Method::Revise => tr!("New times"),
        Method::Tunnel(_) => tr!("Near the old paths"),
        Method::Replan => tr!("Everything new"),
    }
}

/// A method within a sentence, in quotes.
pub fn method_in_words(method: Method) -> String {
    tr!("a method, in a sentence" => "“{name}”", name = self::method(method))
}

/// The method that was adopted within a sentence, with those that found the same plan; nothing
/// where that is not known.
pub fn methods_in_words(step: &Adopted) -> Option<String> {
    let also = step.also.into_iter().flatten();
    let mut methods: Vec<Method> = step.method.into_iter().chain(also).collect();
    methods.sort_by_key(|method| match method {
        Method::Revise => 0,
        Method::Tunnel(_) => 1,
        Method::Replan => 2,
    });
    let names: Vec<String> = methods.into_iter().map(method_in_words).collect();
    (!names.is_empty()).then(|| and(&names))
}

/// While changes are listed.
pub(super) fn changing(changing: &Changing) -> String {
    let at = changing.at;
    match changing.list.as_slice() {
        [] => tr!(
            "The world changes at time {at}: change it with the tools, then find new plans.",
            at
        ),
        _ => {
            tr!(
                "The world changes at time {at}: {n} change listed."
                    | "The world changes at time {at}: {n} changes listed." % count(changing),
                at
            )
        }
    }
}

/// What happens at the time at which the world changes.
pub(super) fn happening(changing: &Changing) -> String {
    let at = changing.at;
    let what = in_words(changing.about.plan(), &changing.list, at);
    tr!("At time {at}: {what}.", at, what)
}

/// While ways to go on are looked for.
pub(super) fn adapting(run: &Adapting) -> String {
    let at = run.changing.at;
    match work_done(run.size).as_str() {
        "" => tr!("Looking for ways to go on from time {at}.", at),
        work => tr!(
            "Looking for ways to go on from time {at}; {work}.",
            at,
            work
        ),
    }
}

/// `At time 2: “New times” has makespan 5; “Near the old paths” and “Everything new” have makespan 4.`
pub(super) fn compared(comparing: &Comparing) -> String {
    let mut parts: Vec<(Option<u32>, Vec<String>)> = Vec::new();
    for Tried { method, told, .. } in &comparing.tried {
        let makespan = told.result.costs.map(|costs| costs.makespan);
        let name = method_in_words(*method);
        match parts.iter_mut().find(|(other, _)| *other == makespan) {
            Some((_, names)) => names.push(name),
            None => parts.push((makespan, vec![name])),
        }
    }
    let parts = parts.iter().map(|(makespan, names)| {
        let (many, names) = (names.len(), and(names));
        match makespan {
            Some(makespan) => tr!(
                "{names} has makespan {makespan}" | "{names} have makespan {makespan}" % many,
                names,
                makespan
            ),
            None => tr!("{names} has no plan" | "{names} have no plan" % many, names),
        }
    });
    let parts: Vec<String> = parts.collect();
    tr!(
        "At time {time}: {parts}.",
        time = comparing.changing.at,
        parts = parts.join("; ")
    )
}

/// Of a plan that went on where the world changed.
pub(super) fn adopted(answer: &Answer) -> String {
    let at = answer.changed_last().unwrap_or(0);
    let objective = &answer.draft.scene().objective;
    let costs = answer.solved.costs.map(|costs| values(objective, &costs));
    let costs = costs.unwrap_or_default();
    let steps = answer.course.as_deref().map(|course| &course.steps);
    let method = steps.and_then(|steps| methods_in_words(steps.last()?));
    match method {
        Some(way) => tr!(
            "The world changed at time {at}; the plan went on with {way}: {costs}.",
            at,
            way,
            costs
        ),
        None => tr!(
            "The world changed at time {at}; the plan went on: {costs}.",
            at,
            costs
        ),
    }
}
