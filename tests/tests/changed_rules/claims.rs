//! What an answer claims of the rules that it names, against the oracle.

use giveway_solve::explain::{Edit, ExplainAnswer, FactKind, Helps};
use giveway_tests::rules_oracle::Answer;
use serde_json::{Value, json};

use super::Seen;
use super::case::Case;

/// Takes a rule away at the time of the change.
fn without(rule: u32, at: u32, changes: &mut Vec<Value>) {
    changes.push(json!({ "change": "remove-constraint", "at": at, "index": rule }));
}

/// Gives a number of a rule another value, in the scene or in the change that adds it.
fn set(rule: u32, key: &str, value: u32, scene: &mut Value, changes: &mut [Value]) {
    let rules = scene["constraints"].as_array_mut().unwrap();
    let count = rules.len();
    if let Some(rule) = rules.get_mut(rule as usize) {
        rule[key] = json!(value);
        return;
    }
    let mut added = changes
        .iter_mut()
        .filter(|it| it["change"] == "add-constraint");
    let added = added.nth(rule as usize - count).unwrap();
    added["constraint"][key] = json!(value);
}

/// The key of the last time of a rule, and its value.
fn last_time(case: &Case, rule: u32) -> (&'static str, u32) {
    let rules = case.scene["constraints"].as_array().unwrap();
    let own = rules.get(rule as usize);
    let mut added = case
        .changes
        .iter()
        .filter(|it| it["change"] == "add-constraint");
    let rule = own.unwrap_or_else(|| &added.next().unwrap()["constraint"]);
    let key = if rule["kind"] == "arrive" { "by" } else { "to" };
    (key, rule[key].as_u64().unwrap() as u32)
}

/// Whether the oracle has a plan that is good enough; `None` where it cannot tell.
fn is_there(answer: &Answer, most: Option<&[i64]>) -> Option<bool> {
    match answer {
        Answer::Capped => None,
        Answer::Impossible => Some(false),
        Answer::Best(costs) => Some(most.is_none_or(|most| {
            // Without its only rule that costs, the objective is shorter.
            let count = costs.len().min(most.len());
            costs[..count] <= most[..count]
        })),
    }
}

/// Rules that help and that do not, sets of facts, and repairs.
#[allow(clippy::too_many_lines, reason = "one claim after the other")]
pub(super) fn check(
    case: &Case,
    rules: &[Value],
    answer: &ExplainAnswer,
    most: Option<&[i64]>,
    seen: &mut Seen,
) {
    let what = || format!("{answer:?}\n{rules:?}\n{}", case.told);
    let Some(core) = &answer.core else { return };
    for facts in [&core.facts]
        .into_iter()
        .chain(core.further.iter().map(|it| &it.facts))
    {
        for fact in facts.iter().filter(|it| it.kind == FactKind::Constraint) {
            let rule = fact.index.unwrap();
            let is_added = rule as usize >= case.scene["constraints"].as_array().unwrap().len();
            assert_eq!(fact.time, is_added.then_some(case.at), "{}", what());
            let best = case.best_after(rules, |_, changes| without(rule, case.at, changes));
            let Some(known) = is_there(&best, most) else {
                continue;
            };
            match fact.helps {
                Helps::Yes => {
                    assert!(known, "rule {rule} helps {best:?}\n{}", what());
                    seen.note("a rule helps");
                    if is_added {
                        seen.note("an added rule helps");
                    }
                }
                Helps::No => {
                    let within = core.reach.within().map(i64::from);
                    let is_late = matches!((&best, within), (Answer::Best(costs), Some(within))
                        if costs[0] > within);
                    assert!(
                        !known || is_late,
                        "rule {rule} does not help {best:?}\n{}",
                        what()
                    );
                    seen.note("a rule does not help");
                }
                Helps::Unknown => seen.note("unknown whether a rule helps"),
            }
        }
        // With no more rules than these, there is none.
        let named: Vec<u32> = facts.iter().filter_map(|fact| fact.index).collect();
        let others = |scene: &mut Value, changes: &mut Vec<Value>| {
            let own = scene["constraints"].as_array().unwrap().len() as u32;
            let added = changes.iter().filter(|it| it["change"] == "add-constraint");
            let count = own + added.count() as u32;
            for rule in (0..count).filter(|rule| !named.contains(rule)) {
                without(rule, case.at, changes);
            }
        };
        let best = case.best_after(rules, others);
        let within = core.reach.within().map(i64::from);
        let is_late =
            matches!((&best, within), (Answer::Best(costs), Some(within)) if costs[0] > within);
        assert!(
            is_late || is_there(&best, most) != Some(true),
            "only {named:?} {best:?}\n{}",
            what()
        );
    }
    for repair in &answer.repairs {
        let [edit] = &repair.edits[..] else { continue };
        let (kind, best, less) = match edit {
            Edit::SwitchOff { index, .. } => {
                let best = case.best_after(rules, |_, changes| without(*index, case.at, changes));
                ("off", best, None)
            }
            Edit::AllowMore { index, most, .. } => {
                let with = |most: u32| {
                    case.best_after(rules, |scene, changes| {
                        set(*index, "most", most, scene, changes);
                    })
                };
                ("more", with(*most), most.checked_sub(1).map(with))
            }
            Edit::GiveUntil { index, to, .. } => {
                let (key, today) = last_time(case, *index);
                let with = |to: u32| {
                    case.best_after(rules, |scene, changes| {
                        set(*index, key, to, scene, changes);
                    })
                };
                let less = to.checked_sub(1).filter(|&less| less > today);
                ("until", with(*to), less.map(with))
            }
            Edit::RemoveObstacle { .. }
            | Edit::AddCharger { .. }
            | Edit::Battery { .. }
            | Edit::BatteryFloor { .. }
            | Edit::Deadline { .. }
            | Edit::MakeNormal { .. }
            | Edit::DropWaypoint { .. }
            | Edit::Vanish
            | Edit::LeaveOut { .. } => continue,
        };
        if let Some(less) = less.filter(|_| repair.least) {
            assert_ne!(
                is_there(&less, most),
                Some(true),
                "least {edit:?}\n{}",
                what()
            );
        }
        let Answer::Best(best) = best else {
            assert_ne!(best, Answer::Impossible, "{edit:?}\n{}", what());
            continue;
        };
        let told = case.costs_of(&repair.costs);
        let told = &told[..best.len().min(told.len())];
        let best = &best[..told.len()];
        assert!(best <= told, "{edit:?} {best:?}\n{}", what());
        if answer.exhaustive {
            assert_eq!(best, told, "{edit:?}\n{}", what());
        }
        seen.note(kind);
    }
}
