//! What a learner hands in: what is in it, that a mail survives it, and that it is small.

mod text;

use std::rc::Rc;

use giveway_course::handin::{Answer, Edits, HandIn, Shown, Work, hand_in, read, write};
use giveway_course::judge::Did;
use giveway_course::learner::{Action, Effect, Learner, Progress, reduce};
use giveway_course::lesson::{Id, Lesson, Task, Value};
use giveway_course::port::{BoardNumber, FromPage, Happened, ToPage};
use giveway_model::{Cell, Scene};
use giveway_solve::{SilentHost, serve};

use super::tasks::{Answered, answers};
use super::{judges, shipped};

/// What was done for a task, as a file has it.
pub(crate) fn work(lesson: &Lesson, answered: &Answered, solved: bool) -> Work {
    let start = lesson.scene(answered.step).unwrap();
    let answer = match answered.did.clone() {
        Did::Edits => Answer::Edits(Edits::between(start, &answered.scene)),
        Did::Led(plan) => {
            let Some(Task::Lead(task)) = &lesson.steps[answered.step].task else {
                panic!("{}", answered.lesson);
            };
            let mut paths = plan.paths;
            paths.retain(|name, _| task.robots.contains(name));
            let charges = plan.charges;
            Answer::Paths { paths, charges }
        }
        Did::Guessed(value) => Answer::Value { value },
        Did::Revealed => Answer::Shown {},
        Did::Marked(marks) => Answer::Marks { marks },
        Did::Chose(choice) => Answer::Choice { choice },
        Did::Ordered(order) => Answer::Order { order },
        Did::NoOrder => Answer::NoOrder {},
        Did::Went(method) => Answer::Method { method },
    };
    Work {
        step: answered.step,
        answer: Some(answer),
        solved,
        tries: 1,
        ..Work::default()
    }
}

/// A hand-in of a lesson with these works.
pub(crate) fn handed(name: &str, lesson: &Lesson, who: &str, works: Vec<Work>) -> HandIn {
    let id: Id = name.parse().unwrap();
    let mut made = hand_in(&Progress::default(), &id, lesson, who);
    made.tasks = works;
    made
}

/// The solutions of a lesson, claimed to be solved.
pub(crate) fn solved(name: &str, lesson: &Lesson, who: &str) -> HandIn {
    let answers = answers(name, lesson);
    let right = answers.iter().filter(|answered| answered.is_right);
    let works = right.map(|answered| work(lesson, answered, true)).collect();
    handed(name, lesson, who, works)
}

/// A learner who does something after something else, each answered by the solver.
struct Student {
    learner: Learner,
    board: BoardNumber,
    kept: Option<Progress>,
}

impl Student {
    fn new() -> Self {
        Self {
            learner: Learner::default(),
            board: BoardNumber::default(),
            kept: None,
        }
    }

    fn does(&mut self, action: Action) {
        let (mut learner, mut effects) = reduce(std::mem::take(&mut self.learner), action);
        loop {
            let mut next = Vec::new();
            for effect in effects {
                match effect {
                    Effect::Page(ToPage::Open(board)) => self.board = board.number,
                    Effect::Page(ToPage::StartAfresh(number)) => self.board = number,
                    Effect::Keep(progress) => self.kept = Some(progress),
                    Effect::Ask { number, request } => {
                        let response = Box::new(serve(&request, &SilentHost));
                        let action = Action::Answered { number, response };
                        let (after, more) = reduce(learner, action);
                        learner = after;
                        next.extend(more);
                    }
                    Effect::Page(_) | Effect::Forget | Effect::FocusNext => {}
                }
            }
            if next.is_empty() {
                break;
            }
            effects = next;
        }
        self.learner = learner;
    }

    fn says(&mut self, what: Happened) {
        let number = self.board;
        self.does(Action::Page(FromPage { number, what }));
    }

    fn opens(&mut self, name: &str, lesson: &Rc<Lesson>, at: usize) {
        let (id, lesson, at) = (name.parse().unwrap(), lesson.clone(), Some(at));
        self.does(Action::Open { id, lesson, at });
    }
}

fn painted(scene: &Scene, x: usize, y: usize) -> Happened {
    let mut scene = scene.clone();
    scene.map[y].replace_range(x..=x, "#");
    Happened::Board(Box::new(scene))
}

#[test]
fn what_was_done_is_kept_with_its_tries_and_handed_in() {
    let name = "room-to-pass";
    let lesson = Rc::new(shipped::lesson(name));
    let mut student = Student::new();
    student.opens(name, &lesson, 1);
    for guess in [7, 8, 9, 7] {
        student.does(Action::Guess(Value::Number(guess)));
    }
    student.opens(name, &lesson, 2);
    student.does(Action::Choose(0));
    student.opens(name, &lesson, 3);
    let start = lesson.scene(3).unwrap();
    student.says(painted(start, 4, 0));
    student.says(Happened::Board(Box::new(start.clone())));
    student.says(painted(start, 3, 1));
    // It comes back from what the browser keeps.
    let kept = student.kept.unwrap().write();
    let progress = Progress::read(&kept).unwrap();
    let id: Id = name.parse().unwrap();
    let made = hand_in(&progress, &id, &lesson, "  Ada \u{202e}\n Lovelace ");
    assert_eq!(made.name.as_deref(), Some("Ada Lovelace"));
    let [guessed, chosen, edited] = made.tasks.as_slice() else {
        panic!("{made:?}");
    };
    let number = |value| {
        Some(Answer::Value {
            value: Value::Number(value),
        })
    };
    assert_eq!((guessed.step, guessed.tries, guessed.solved), (1, 3, true));
    assert_eq!(guessed.answer, number(9));
    assert_eq!(guessed.first, number(7));
    assert_eq!(chosen.answer, Some(Answer::Choice { choice: 0 }));
    assert_eq!((edited.tries, edited.solved), (2, true));
    let Some(Answer::Edits(edits)) = &edited.answer else {
        panic!("{edited:?}");
    };
    assert_eq!(edits.cells.len(), 1);
    assert_eq!(
        edits.of(start).unwrap(),
        Shown::of(edited, &lesson).unwrap().scene
    );
    let text = write(&made);
    assert_eq!(read(&text).unwrap(), made);
    assert!(text.contains("\"step\": 2"), "{text}");
    // What is about other steps, or steps that were edited since, is not handed in.
    let mut other = Lesson::clone(&lesson);
    other.steps[3].edits = Some(2);
    assert_eq!(hand_in(&progress, &id, &other, "").tasks.len(), 2);
    assert_eq!(hand_in(&progress, &id, &other, " ").name, None);
}

#[test]
fn progress_that_was_kept_before_is_read() {
    let kept = r#"{"giveway":1,"lessons":{"room-to-pass":{"step":3,"seen":true,"solved":[1],"texts":[7],"tasks":3}}}"#;
    let progress = Progress::read(kept).unwrap();
    let lesson = shipped::lesson("room-to-pass");
    let id: Id = "room-to-pass".parse().unwrap();
    assert!(hand_in(&progress, &id, &lesson, "").tasks.is_empty());
    assert_eq!(progress.write(), kept);
}

/// Two tabs: what was solved in one of them is handed in from the other.
#[test]
fn answers_of_another_tab_come_in() {
    let name = "room-to-pass";
    let lesson = Rc::new(shipped::lesson(name));
    let [mut one, mut other] = [Student::new(), Student::new()];
    one.opens(name, &lesson, 1);
    one.does(Action::Guess(Value::Number(9)));
    other.opens(name, &lesson, 1);
    other.does(Action::Guess(Value::Number(7)));
    other.does(Action::Guess(Value::Number(8)));
    other.opens(name, &lesson, 2);
    other.does(Action::Choose(0));
    let theirs = other.learner.progress.clone();
    other.does(Action::Kept(one.learner.progress.clone()));
    one.does(Action::Kept(theirs));
    let id: Id = name.parse().unwrap();
    let [one, other] = [one, other].map(|it| hand_in(&it.learner.progress, &id, &lesson, ""));
    assert_eq!(one, other);
    let solved: Vec<bool> = one.tasks.iter().map(|work| work.solved).collect();
    assert_eq!(solved, [true, false]);
}

/// The board that the step before left goes along, and lays out again.
#[test]
fn a_board_that_was_edited_before_goes_along() {
    let task = serde_json::json!({ "kind": "paint", "until": { "is": "solvable" } });
    let open = judges::scene(&["....", "...."], &[("A1", [0, 0], [3, 0])]);
    let mut lesson = judges::lesson(&open, &serde_json::json!({ "tools": ["obstacle"] }), &task);
    let mut step = lesson.steps[0].clone();
    step.scene = None;
    step.tools.clear();
    step.task = Some(
        serde_json::from_value(serde_json::json!(
            { "kind": "predict", "say": "Say.", "what": { "is": "cost", "cost": "makespan" } }
        ))
        .unwrap(),
    );
    lesson.steps.push(step);
    let lesson = Rc::new(lesson);
    let mut student = Student::new();
    student.opens("own-1", &lesson, 0);
    student.says(painted(lesson.scene(0).unwrap(), 1, 0));
    student.does(Action::Next);
    student.does(Action::Guess(Value::Number(5)));
    let id: Id = "own-1".parse().unwrap();
    let made = hand_in(&student.learner.progress, &id, &lesson, "");
    let work = made.work(1).unwrap();
    assert!(work.solved);
    assert_eq!(work.board.cells.len(), 1);
    let shown = Shown::of(work, &lesson).unwrap();
    assert_eq!(shown.scene.map[0], ".#..");
    assert_eq!(shown.start, shown.scene);
    // A board on which more was done than the step allows is not gone on with.
    student.opens("own-1", &lesson, 0);
    let mut scene = lesson.scene(0).unwrap().clone();
    scene.agents[0].goal = Some(giveway_model::Cell::new(1, 0));
    student.says(Happened::Board(Box::new(scene)));
    student.does(Action::Next);
    let open = student.learner.open.as_ref().unwrap();
    assert_eq!(open.scene(), lesson.scene(0).unwrap());
    // Not one that the steps before cannot leave.
    let mut other = work.clone();
    other.board.robots = vec![giveway_model::Agent::new(
        "A1",
        giveway_model::Cell::new(3, 0),
        Some(giveway_model::Cell::new(3, 0)),
    )];
    assert!(Shown::of(&other, &lesson).is_err());
}

#[test]
fn who_leads_a_robot_on_after_a_rule_was_broken_makes_no_other_try() {
    let name = "rules-of-the-road";
    let lesson = Rc::new(shipped::lesson(name));
    let mut student = Student::new();
    student.opens(name, &lesson, 2);
    let planned = lesson.steps[2].plan.clone().unwrap();
    let way = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (2, 3)];
    let led = |steps: usize| {
        let mut plan = planned.clone();
        let path = way.iter().take(steps).map(|&(x, y)| Some(Cell::new(x, y)));
        plan.paths.insert("A1".to_owned(), path.collect());
        Happened::Led(Box::new(plan))
    };
    let tries = |student: &Student| {
        let id: Id = name.parse().unwrap();
        let made = hand_in(&student.learner.progress, &id, &lesson, "");
        made.tasks.first().map(|work| (work.tries, work.solved))
    };
    // It enters the zone while A2 is in it, and drives on.
    for steps in 2..=6 {
        student.says(led(steps));
    }
    assert_eq!(tries(&student), Some((1, false)));
    // Taken back, and into the zone again.
    for steps in [3, 4, 5] {
        student.says(led(steps));
    }
    assert_eq!(tries(&student), Some((2, false)));
}
