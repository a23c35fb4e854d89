//! From a dropped plan to a verdict, and on to a better plan.

use std::rc::Rc;

use super::{BEST, BEST_PATHS, LEGAL, LEGAL_PATHS, MEETING, SCENE, audit, dropped, fresh};
use crate::audit::{AuditAction, facts};
use crate::intake::protocol::{ReportKind, Task};
use crate::tests::answered as answer;
use crate::{
    Action, AskAction, Edit, Phase, SolveAction, State, ViewAction, WorkerAction, link, reduce,
    words,
};

fn act(state: &State, action: AuditAction) -> State {
    reduce(state, Action::Audit(action))
}

#[test]
fn an_illegal_plan_is_shown_and_told() {
    let state = dropped(&fresh(), &[("hall.json", SCENE), ("paths.json", MEETING)]);
    assert_eq!(
        words::standing(&state).sentence,
        "paths.json breaks a rule once. As it stands it would cost 4."
    );
    let told = facts(&state).unwrap();
    assert_eq!(told.verdict.word, "Not legal");
    assert_eq!(told.verdict.detail, "1 collision");
    assert_eq!(told.extent, "2 robots, times 0 to 2");
    let [violation] = told.violations.as_slice() else {
        panic!("{:?}", told.violations)
    };
    assert_eq!(violation.text, "A1 and A2 are both at (1, 0)");
    assert_eq!((violation.time, violation.is_now), (1, false));
    assert_eq!(told.find.as_deref(), Some("Find a legal plan"));
    // It plays as it is, and is no plan of the scene.
    assert_eq!(state.last_time(), 2);
    assert!(state.document.plan().is_none() && state.plan().is_some());
    // The search runs by itself.
    assert!(
        state
            .work
            .solving()
            .is_some_and(|run| run.request.start.is_none())
    );
    let state = answer(&state);
    let told = facts(&state).unwrap();
    assert_eq!(
        told.verdict.sentence,
        "It costs 4, and every legal plan costs at least 6. So it had to break a rule."
    );
    assert_eq!(state.phase(), Phase::Auditing);
    // Ours is beside it, never in its place unasked.
    assert!(Rc::ptr_eq(
        state.shown().unwrap(),
        &audit(&state).plan.answer
    ));
    let state = act(&state, AuditAction::Find);
    let wide = reduce(&state, Action::View(ViewAction::SetWide(true)));
    assert_eq!(wide.beside(), audit(&wide).ours.as_ref());
    assert_eq!(
        facts(&wide).unwrap().take.as_deref(),
        Some("Use the legal plan")
    );
    let taken = act(&wide, AuditAction::Take);
    assert!(taken.document.mode.is_editing());
    assert_eq!(words::standing(&taken).sentence.get(..8), Some("Optimal:"));
    let back = reduce(&taken, Action::Undo);
    assert_eq!(back.document, wide.document);
}

#[test]
fn a_legal_plan_is_measured_against_the_bound() {
    let state = dropped(
        &fresh(),
        &[("hall.json", SCENE), ("paths.txt", LEGAL_PATHS)],
    );
    assert!(
        state
            .work
            .solving()
            .is_some_and(|run| run.request.start.is_some())
    );
    let state = answer(&state);
    let told = facts(&state).unwrap();
    assert_eq!(told.verdict.word, "Legal");
    assert_eq!(
        told.verdict.sentence,
        "16.7 % above the best. There is a plan that costs 6, and this one costs 7."
    );
    assert_eq!(
        told.stands,
        Some((85, "Proved up to 6. The gap is 1.".to_owned()))
    );
    assert_eq!(told.costs[0].difference(), "+1");
    // All that can be asked of our plans can be asked of it.
    let question = crate::ask::offers(&state)[0].offers[0].question.clone();
    let asked = reduce(&state, Action::Ask(AskAction::Ask(question)));
    assert!(
        asked.document.mode.audit().is_some() && asked.document.mode.asking().is_some(),
        "{:?}",
        asked.view.notice
    );
    let left = reduce(&asked, Action::Ask(AskAction::Close));
    assert_eq!(left.document, state.document);
}

#[test]
fn the_best_plan_is_said_to_be_the_best() {
    let state = dropped(&fresh(), &[("hall.json", SCENE), ("paths.txt", BEST_PATHS)]);
    let told = facts(&answer(&state)).unwrap();
    assert_eq!(told.verdict.word, "No plan is better");
    assert_eq!(told.verdict.detail, "proved");
    assert_eq!((told.find, told.compared), (None, None));
}

#[test]
fn two_plans_of_one_scene_are_compared() {
    let files = [
        ("hall.json", SCENE),
        ("one.json", LEGAL),
        ("two.json", BEST),
    ];
    let state = answer(&dropped(&fresh(), &files));
    let state = reduce(&state, Action::View(ViewAction::SetWide(true)));
    let state = act(&state, AuditAction::Compare(true));
    let told = facts(&state).unwrap();
    assert_eq!(told.plans.len(), 2);
    assert_eq!(
        state.beside().unwrap().solved.costs.unwrap().sum_of_costs,
        6
    );
    let other = act(&state, AuditAction::Choose(1));
    assert_eq!(facts(&other).unwrap().file, "two.json");
    assert_eq!(
        other.beside().unwrap().solved.costs.unwrap().sum_of_costs,
        7
    );
}

#[test]
fn an_edit_leaves_the_audit_and_undo_brings_it_back() {
    let state = dropped(&fresh(), &[("hall.json", SCENE), ("paths.json", MEETING)]);
    let edited = reduce(&state, Action::Edit(Edit::Resize(4, 2)));
    assert!(edited.document.mode.is_editing());
    assert!(edited.work.is_idle() && edited.shown().is_none());
    let back = reduce(&edited, Action::Undo);
    assert_eq!(back.document, state.document);
    let left = act(&state, AuditAction::Leave);
    assert!(left.document.mode.is_editing());
}

#[test]
fn a_search_that_is_stopped_keeps_what_it_knows() {
    let state = dropped(&fresh(), &[("hall.json", SCENE), ("paths.json", MEETING)]);
    let event = giveway_solve::Progress::Bound {
        cost: giveway_model::Cost::SumOfCosts,
        at_least: 5,
    };
    let job = state.work.id().unwrap();
    let state = reduce(
        &state,
        Action::Worker(WorkerAction::Progress { job, event }),
    );
    let sentence = "It costs 4, and every legal plan costs at least 5. So it had to break a rule.";
    assert_eq!(facts(&state).unwrap().verdict.sentence, sentence);
    let state = reduce(&state, Action::Solve(SolveAction::Cancel));
    assert!(state.work.is_idle());
    assert_eq!(facts(&state).unwrap().verdict.sentence, sentence);
}

#[test]
fn a_report_tells_it_and_links_back() {
    let state = dropped(&fresh(), &[("hall.json", SCENE), ("<b>.json", MEETING)]);
    let written = |kind| {
        let task = Task::Report {
            kind,
            kept: link::keep_moment(&state.moment()),
            bounds: std::collections::BTreeMap::new(),
            link: "https://example.org/#giveway=1".to_owned(),
        };
        match crate::intake::work(task) {
            crate::intake::protocol::Reply::Written(mut files, _) => files.remove(0).1,
            other => panic!("{other:?}"),
        }
    };
    let html = written(ReportKind::Html);
    assert!(
        html.contains("&lt;b&gt;.json on hall") && !html.contains("<b>"),
        "{html}"
    );
    assert!(
        html.contains("href=\"https://example.org/#giveway=1\""),
        "{html}"
    );
    let markdown = written(ReportKind::Markdown);
    assert!(
        markdown.contains("**Not legal: 1 collision.**"),
        "{markdown}"
    );
    let json: serde_json::Value = serde_json::from_str(&written(ReportKind::Json)).unwrap();
    assert_eq!(json["status"], "illegal");
    assert_eq!(json["violations"][0]["rule"], "vertex");
    assert_eq!(json["costs"]["sum-of-costs"], 4);
}

#[test]
fn another_rule_judges_the_plan_again() {
    let state = dropped(
        &fresh(),
        &[("hall.json", SCENE), ("paths.json", LEGAL_PATHS)],
    );
    let state = answer(&state);
    assert!(audit(&state).ours.is_some());
    let vanish = reduce(
        &state,
        Action::Edit(Edit::AtGoal(giveway_model::AtGoal::Vanish)),
    );
    assert!(vanish.document.mode.audit().is_some());
    let judged = audit(&vanish);
    assert!(judged.plan.is_legal() && judged.ours.is_none());
    assert!(vanish.work.solving().is_some());
    let floor = reduce(&vanish, Action::Edit(Edit::BatteryFloor(2)));
    assert!(floor.document.mode.audit().is_some());
    // Another world is another question.
    let named = reduce(&floor, Action::Edit(Edit::Resize(9, 9)));
    assert!(named.document.mode.is_editing());
}
