//! A class's hand-ins judged anew: every solution, every wrong answer, names, order, limits.

mod under_way;

use std::collections::BTreeSet;
use std::rc::Rc;

use giveway_course::grade::csv::csv;
use giveway_course::grade::{Claim, Class, Given, Judgement, Next, Order, Reason, Report, Row};
use giveway_course::handin::{Answer, Work, write};
use giveway_course::lesson::{Lesson, Value};
use giveway_solve::{Request, SilentHost, serve};

use super::handins::{handed, solved, work};
use super::shipped;
use super::tasks::answers;

/// The lessons of the course.
pub(crate) fn course() -> Vec<Given> {
    let lessons = shipped::lessons().into_iter();
    let given =
        |(name, lesson): (String, Lesson)| Given::new(name.parse().unwrap(), Rc::new(lesson));
    lessons.map(given).collect()
}

/// Judges all; how often the solver was asked.
pub(crate) fn judge(class: &mut Class) -> Vec<Request> {
    let mut asked = Vec::new();
    loop {
        match class.step() {
            Next::Ask { number, request } => {
                let response = serve(&request, &SilentHost);
                asked.push(*request);
                class.answered(number, response);
            }
            Next::Again => {}
            Next::Done => return asked,
        }
    }
}

fn room() -> (Lesson, Class) {
    let lesson = shipped::lesson("room-to-pass");
    let given = Given::new("room-to-pass".parse().unwrap(), Rc::new(lesson.clone()));
    (lesson, Class::new([given]))
}

#[test]
fn solutions_are_solved_and_wrong_answers_are_not() {
    let mut class = Class::new(course());
    let mut all = Vec::new();
    for (name, lesson) in shipped::lessons() {
        for answered in answers(&name, &lesson) {
            let file = all.len().to_string();
            // What is right is not claimed, and what is wrong is.
            let work = work(&lesson, &answered, !answered.is_right);
            class.add(
                &file,
                None,
                &write(&handed(&name, &lesson, &file, vec![work])),
            );
            all.push(answered);
        }
    }
    let requests = judge(&mut class);
    let limits = requests.iter().map(|request| match request {
        Request::Solve(request) => &request.limits,
        Request::Explain(request) => &request.limits,
        Request::Audit(request) => &request.limits,
        Request::Freedom(request) => &request.limits,
        Request::Plan(request) => &request.limits,
        Request::Change(request) => &request.limits,
        Request::Price(request) => &request.limits,
        Request::Delays(request) => &request.limits,
        other => panic!("{other:?}"),
    });
    for limits in limits {
        assert!(limits.seconds.is_none() && limits.work.is_some());
    }
    let different: BTreeSet<Vec<u8>> = requests
        .iter()
        .map(|it| borsh::to_vec(it).unwrap())
        .collect();
    assert_eq!(
        different.len(),
        requests.len(),
        "a question was asked twice"
    );
    for (file, answered) in class.files().iter().zip(&all) {
        let place = format!(
            "{}, step {}, {:?}",
            answered.lesson, answered.step, answered.did
        );
        let mut tasks = file.tasks().iter();
        let task = tasks.find(|task| task.step == answered.step).unwrap();
        assert_eq!(
            task.is_solved(),
            answered.is_right,
            "{place}: {:?}",
            task.judgement()
        );
        let is_false = task.claim() == Claim::False;
        assert_eq!(
            is_false,
            !answered.is_right,
            "{place}: {:?}",
            task.judgement()
        );
    }
    let wrong = all.iter().filter(|answered| !answered.is_right).count();
    assert_eq!(class.false_claims(), wrong);
    let report = serde_json::to_value(Report::of(&class, Order::Name)).unwrap();
    assert_eq!(report["false_claims"], wrong);
    let rows = csv(&class, Order::Name).lines().count();
    let tasks: usize = class.files().iter().map(|file| file.tasks().len()).sum();
    assert_eq!(rows, tasks + 1);
}

fn value(number: u32) -> Answer {
    Answer::Value {
        value: Value::Number(number),
    }
}

fn guess(first: Option<u32>, last: u32, solved: bool) -> Work {
    Work {
        step: 1,
        answer: Some(value(last)),
        first: first.map(value),
        solved,
        tries: 1,
        ..Work::default()
    }
}

fn titles<'a>(rows: &'a [Row<'_>]) -> Vec<&'a str> {
    rows.iter().map(Row::title).collect()
}

#[test]
fn the_later_file_of_a_name_counts() {
    let (lesson, mut class) = room();
    let mut add = |file: &str, who: &str, date: Option<u64>, number: u32| {
        let made = handed(
            "room-to-pass",
            &lesson,
            who,
            vec![guess(None, number, false)],
        );
        class.add(file, date, &write(&made));
    };
    add("a-new", "Ada", Some(9), 9);
    add("a-old", "ada ", Some(5), 7);
    add("b-1", "Bo", Some(5), 7);
    add("b-2", "Bo", Some(5), 9);
    add("c-1", "Cy", None, 7);
    add("c-2", "Cy", None, 9);
    add("d", "", Some(1), 9);
    add("e", "", Some(1), 9);
    judge(&mut class);
    let rows = class.rows(0, Order::Name);
    assert_eq!(titles(&rows), ["Ada", "Bo", "Cy", "d", "e"]);
    let files: Vec<&str> = rows.iter().map(|row| row.file().file.as_str()).collect();
    assert_eq!(files, ["a-new", "b-2", "c-2", "d", "e"]);
    let counts: Vec<usize> = rows.iter().map(|row| row.files().len()).collect();
    assert_eq!(counts, [2, 2, 2, 1, 1]);
    assert!(rows.iter().all(|row| row.solved() == 1));
    assert_eq!(class.progress().all, 5 * 3);
}

#[test]
fn whom_to_look_at_comes_first() {
    let (lesson, mut class) = room();
    let mut add = |who: &str, works: Vec<Work>| {
        let made = handed("room-to-pass", &lesson, who, works);
        class.add(who, None, &write(&made));
    };
    add("Student 10", vec![guess(None, 9, true)]);
    add("Student 9", vec![guess(None, 9, true)]);
    add("Student 1", vec![guess(Some(7), 9, true)]);
    add("Student 2", vec![guess(None, 7, true)]);
    add("Student 3", vec![]);
    let claims_nothing = Work {
        step: 2,
        solved: true,
        ..Work::default()
    };
    add("Student 4", vec![guess(Some(7), 8, false), claims_nothing]);
    class.add("x.pdf", None, "%PDF-1.7");
    let other = shipped::lesson("batteries");
    class.add(
        "other",
        None,
        &write(&solved("batteries", &other, "Student 5")),
    );
    judge(&mut class);
    let rows = class.rows(0, Order::LookAtFirst);
    let first = [
        "Student 2",
        "Student 4",
        "Student 3",
        "Student 1",
        "Student 9",
        "Student 10",
    ];
    assert_eq!(titles(&rows), first);
    assert_eq!(class.false_claims(), 2);
    let share = class.shares(0)[0];
    assert_eq!((share.solved, share.not_solved, share.not_tried), (3, 2, 1));
    assert_eq!((share.false_claims, share.all()), (1, 6));
    let wrong = class.wrong(0);
    let counts: Vec<(usize, &Answer)> = wrong.iter().map(|it| (it.count, &it.answer)).collect();
    assert_eq!(counts, [(3, &value(7)), (1, &value(8))]);
    assert!(wrong[0].reply.is_some());
    let unread: Vec<_> = class
        .files()
        .iter()
        .filter_map(|file| file.unread())
        .collect();
    assert_eq!(unread.len(), 2);
    assert!(
        unread[1]
            .words()
            .starts_with("of another lesson, \"Batteries\""),
        "{}",
        unread[1].words()
    );
    // A lesson that comes later takes its files up.
    class.give(Given::new("batteries".parse().unwrap(), Rc::new(other)));
    judge(&mut class);
    let rows = class.rows(1, Order::Name);
    assert_eq!(rows[0].solved(), rows[0].tasks().len());
    assert_eq!(class.tables(), [0, 1]);
}

#[test]
fn another_edition_is_told() {
    let (mut lesson, mut class) = room();
    lesson.steps[3].edits = Some(2);
    class.add("x", None, &write(&solved("room-to-pass", &lesson, "Ada")));
    let words = class.files()[0].unread().unwrap().words();
    assert!(words.starts_with("of another edition"), "{words}");
}

#[test]
fn no_cell_of_the_table_is_a_formula() {
    let (lesson, mut class) = room();
    let order = Answer::Order {
        order: vec!["@SUM(A1)".into()],
    };
    let works = vec![Work {
        step: 1,
        answer: Some(order),
        solved: true,
        tries: 1,
        ..Work::default()
    }];
    class.add(
        "+cmd.json",
        None,
        &write(&handed("room-to-pass", &lesson, "=1+1", works)),
    );
    class.add("-2.json", None, "nothing");
    judge(&mut class);
    let table = csv(&class, Order::Name);
    assert!(table.contains("not solved,solved,1,'@SUM(A1)"), "{table}");
    assert!(
        table.contains("'+cmd.json\r\n") && table.contains("'-2.json\r\n"),
        "{table}"
    );
    let judgement = class.rows(0, Order::Name)[0].tasks()[0]
        .judgement()
        .cloned();
    assert!(matches!(
        judgement,
        Some(Judgement::NotSolved(Reason::Misfit(_)))
    ));
}
