//! What all best plans share, cut off at many places: all that is told then is also in the whole
//! answer, and what is missing is said to be open.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "a test that cannot go on ends with a panic"
)]

use std::cell::Cell;

use giveway_model::{Instance, format::native};
use giveway_solve::freedom::{
    Farthest, FreedomAnswer, FreedomPart, FreedomRequest, Known, PlanCount,
};
use giveway_solve::{Host, Progress, Request, Response, Status, serve};

/// Five robots, some best plans, and cells that cost something to close.
const SCENE: &str = r#"{ "giveway": 1,
    "map": ["......", ".#.##.", "......", ".##.#.", "......"],
    "agents": [
        { "name": "A1", "start": [0, 0], "goal": [5, 4] },
        { "name": "A2", "start": [5, 0], "goal": [0, 4] },
        { "name": "A3", "start": [2, 2], "goal": [5, 2] },
        { "name": "A4", "start": [0, 4], "goal": [2, 0] },
        { "name": "A5", "start": [3, 4], "goal": [0, 2] }
    ] }"#;

/// A person who stops it when it has asked so often whether to go on.
struct Impatient {
    left: Cell<u64>,
    told: Cell<u32>,
}

impl Host for Impatient {
    fn wall_seconds(&self) -> f64 {
        0.0
    }

    fn cancelled(&self) -> bool {
        let left = self.left.get();
        self.left.set(left.saturating_sub(1));
        left == 0
    }

    fn progress(&self, event: &Progress) {
        if let Progress::Freedom { answer } = event {
            assert!(!answer.pending.is_empty());
            self.told.set(self.told.get() + 1);
        }
    }
}

fn ask(instance: &Instance, patience: u64) -> (FreedomAnswer, Impatient) {
    let host = Impatient {
        left: Cell::new(patience),
        told: Cell::new(0),
    };
    let request = Request::Freedom(FreedomRequest {
        scene: instance.to_scene(),
        ..FreedomRequest::default()
    });
    match serve(&request, &host) {
        Response::Freedom(answer) => (*answer, host),
        other => panic!("expected an answer, got {other:?}"),
    }
}

#[test]
fn a_part_of_an_answer_is_a_part_of_the_whole() {
    let instance = native::read_instance(SCENE).unwrap();
    let (whole, host) = ask(&instance, u64::MAX);
    assert_eq!(whole.status, Status::Optimal);
    assert!(whole.is_settled() && whole.pending.is_empty());
    assert!(host.told.get() > 4, "told {} times", host.told.get());
    let all = u64::MAX - host.left.get();
    let mut pending = Vec::new();
    for part in 0..40 {
        let (answer, _) = ask(&instance, all * part / 40);
        if answer.status == Status::Optimal {
            assert!(!answer.pending.is_empty() && answer.reason.is_some());
            assert_eq!(answer.plan, whole.plan, "the search is the same");
            expect_part(&answer, &whole);
            pending.push(answer.pending.clone());
        }
    }
    pending.dedup();
    assert!(
        pending.len() > 2,
        "it was cut off in several parts: {pending:?}"
    );
}

fn expect_part(answer: &FreedomAnswer, whole: &FreedomAnswer) {
    let agrees = |part: Known, whole: Known| part == Known::Open || part == whole;
    for (name, visits) in answer.backbone.iter().flatten() {
        let all = &whole.backbone.as_ref().unwrap()[name];
        assert_eq!(visits.len(), all.len());
        for (visit, all) in visits.iter().zip(all) {
            assert!(agrees(visit.always, all.always), "{name}: {visit:?}");
            assert!(agrees(visit.only, all.only), "{name}: {visit:?}");
        }
    }
    if !answer.pending.contains(&FreedomPart::Backbone) {
        assert_eq!(answer.backbone, whole.backbone);
    }
    if !answer.pending.contains(&FreedomPart::Slack) {
        assert_eq!(answer.slack, whole.slack);
    }
    if let Some(plans) = &answer.plans {
        let all = whole.plans.as_ref().unwrap();
        match plans.number {
            PlanCount::AtLeast(n) => assert!(n <= all.number.number()),
            number => assert_eq!(number, all.number),
        }
    }
    let cells = whole.critical.as_ref().unwrap();
    for (it, all) in answer.critical.iter().flatten().zip(cells) {
        assert!(it.closed.is_open() || it.closed == all.closed, "{it:?}");
    }
    if let Some(Farthest::Found { differs, most, .. }) = &answer.farthest {
        let Some(Farthest::Found { differs: all, .. }) = &whole.farthest else {
            panic!("{:?}", whole.farthest);
        };
        assert!(differs == all || (differs < all && !most.is_proved()));
    }
}
