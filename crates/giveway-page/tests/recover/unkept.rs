//! What cannot be kept or solved is said, and what there is stays.

use giveway_page::slot::{Kind, Lost, Press, Unkept, message};
use giveway_page::{Action, SlotAction, SolveAction, WorkerAction, reduce};
use giveway_solve::Progress;

use super::{edited, link_to, opened, solved, title};

#[test]
fn kept_data_comes_first_and_then_a_link() {
    let linked = reduce(&edited(&opened("mine"), 5), link_to("theirs"));
    let unkept = reduce(&linked, Action::Slot(SlotAction::Unkept(Unkept::Full)));
    assert_eq!(title(&unkept), Some("Your work is not being kept"));
    let lost = reduce(&unkept, Action::Slot(SlotAction::Lose(Lost::Damaged)));
    let told = message(&lost).unwrap();
    assert_eq!((told.kind, told.close), (Kind::Alert, None));
    let presses: Vec<Press> = told
        .buttons
        .into_iter()
        .map(|button| button.press)
        .collect();
    assert_eq!(presses, [Press::Download, Press::StartAfresh]);
    // Editing is free, and does not make it go.
    assert_eq!(message(&edited(&lost, 7)).unwrap().kind, Kind::Alert);
    let settled = reduce(&lost, Action::Slot(SlotAction::Settle));
    assert_eq!(title(&settled), Some("Your work is not being kept"));
    let kept = reduce(&settled, Action::Slot(SlotAction::Kept));
    assert_eq!(title(&kept), Some("Your own scene is kept"));
}

#[test]
fn a_worker_that_breaks_down_leaves_the_best_plan() {
    let plan = solved(&opened("mine")).plan().unwrap().clone();
    let costs = solved(&opened("mine"))
        .document
        .answer
        .as_ref()
        .unwrap()
        .solved
        .costs
        .unwrap();
    let run = reduce(&opened("mine"), Action::Solve(SolveAction::Solve));
    let job = run.work.id().unwrap();
    let event = Progress::Plan {
        costs,
        plan: plan.clone(),
    };
    let run = reduce(&run, Action::Worker(WorkerAction::Progress { job, event }));
    let crash = WorkerAction::Crash {
        job,
        sentence: "It panicked.".to_owned(),
        had_started: true,
    };
    let after = reduce(&run, Action::Worker(crash));
    assert!(after.work.is_idle());
    assert_eq!(after.plan(), Some(&plan));
    let notice = after.view.notice.as_ref().unwrap();
    assert!(
        notice.sentence().contains("started again"),
        "{}",
        notice.sentence()
    );
    assert_eq!(notice.details(), ["It panicked."]);
    // The next job is another one: what the broken worker still tells is not heard.
    let again = reduce(&after, Action::Solve(SolveAction::Solve));
    assert_ne!(again.work.id(), Some(job));
}
