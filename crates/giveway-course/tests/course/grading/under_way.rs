//! A class that is judged: cancelled, gone on with, undecided, without a solver.

use std::rc::Rc;

use giveway_course::grade::{Class, Given, Judgement, Next, Order};
use giveway_course::handin::{Work, write};
use giveway_course::learner::AskNumber;
use giveway_solve::{Response, SilentHost, serve};

use super::super::handins::{handed, solved};
use super::super::judges;
use super::{guess, judge, room};

/// A class that is judged up to the next question.
trait StepToAsk {
    fn step_to_ask(&mut self) -> Next;
}

impl StepToAsk for Class {
    fn step_to_ask(&mut self) -> Next {
        loop {
            match self.step() {
                Next::Again => {}
                next => return next,
            }
        }
    }
}

#[test]
fn it_is_cancelled_and_gone_on_with() {
    let (lesson, mut class) = room();
    class.add("x", None, &write(&solved("room-to-pass", &lesson, "Ada")));
    let Next::Ask { number, request } = class.step_to_ask() else {
        panic!("nothing to ask");
    };
    // The question stays until it is answered, and answers to others are dropped.
    assert_eq!(
        class.step_to_ask(),
        Next::Ask {
            number,
            request: request.clone()
        }
    );
    class.answered(AskNumber(number.0 + 1), serve(&request, &SilentHost));
    assert_eq!(class.progress().done, 0);
    class.cancel();
    assert_eq!(class.step(), Next::Done);
    assert!(class.is_cancelled());
    class.answered(number, serve(&request, &SilentHost));
    class.go_on();
    assert!(!class.is_cancelled());
    judge(&mut class);
    let progress = class.progress();
    assert_eq!((progress.done, progress.all), (3, 3));
    assert_eq!(class.rows(0, Order::Name)[0].solved(), 3);
}

#[test]
fn what_is_not_decided_is_no_false_claim_and_gets_more_work() {
    let (lesson, mut class) = room();
    class.allow_work(1);
    class.add("x", None, &write(&solved("room-to-pass", &lesson, "Ada")));
    judge(&mut class);
    let undecided = |class: &Class| {
        let rows = class.rows(0, Order::Name);
        let tasks = rows[0].tasks().iter();
        tasks
            .filter(|task| matches!(task.judgement(), Some(Judgement::Undecided(_))))
            .count()
    };
    assert!(undecided(&class) > 0);
    assert_eq!(class.false_claims(), 0);
    for _ in 0..9 {
        class.go_on();
        judge(&mut class);
    }
    assert_eq!(undecided(&class), 0);
    assert_eq!(class.rows(0, Order::Name)[0].solved(), 3);
    assert!(class.work() > 1);
}

#[test]
fn a_solver_that_breaks_down_decides_nothing() {
    let (lesson, mut class) = room();
    class.add("x", None, &write(&solved("room-to-pass", &lesson, "Ada")));
    while let Next::Ask { number, .. } = class.step_to_ask() {
        class.failed(number, "It broke.".into());
    }
    assert_eq!(class.false_claims(), 0);
    let rows = class.rows(0, Order::Name);
    let judgement = rows[0].tasks()[0].judgement().unwrap();
    assert_eq!(judgement.reason(&lesson.steps[1]), "It broke.");
    class.go_on();
    judge(&mut class);
    assert_eq!(class.rows(0, Order::Name)[0].solved(), 3);
}

/// Sixty hand-ins of five tasks take as many questions as there are different answers.
#[test]
fn a_class_takes_few_questions() {
    let task =
        serde_json::json!({ "kind": "predict", "what": { "is": "cost", "cost": "makespan" } });
    let open = judges::scene(&["....", "...."], &[("A1", [0, 0], [3, 0])]);
    let mut lesson = judges::lesson(&open, &serde_json::json!({}), &task);
    let step = lesson.steps[0].clone();
    lesson.steps = vec![step; 5];
    let given = Given::new("own-1".parse().unwrap(), Rc::new(lesson.clone()));
    let mut class = Class::new([given]);
    for student in 0..60 {
        let who = format!("Student {student}");
        let works = (0..5).map(|step| Work {
            step,
            ..guess(None, student % 5, student % 5 == 3)
        });
        let made = handed("own-1", &lesson, &who, works.collect());
        class.add(&who, None, &write(&made));
    }
    let mut asked = 0;
    let mut answer: Option<Response> = None;
    loop {
        match class.step() {
            Next::Ask { number, request } => {
                asked += 1;
                let response = answer.get_or_insert_with(|| serve(&request, &SilentHost));
                class.answered(number, response.clone());
            }
            Next::Again => {}
            Next::Done => break,
        }
    }
    assert_eq!(asked, 1);
    assert_eq!(class.false_claims(), 0);
    assert_eq!(class.shares(0)[4].solved, 12);
}
