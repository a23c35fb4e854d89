//! Random actions keep what must always hold.

use std::rc::Rc;

use fastrand::Rng;
use giveway_course::learner::{Action, AskNumber, Effect, Judge, Learner, Stage, reduce};
use giveway_course::lesson::{Id, Lesson, Value};
use giveway_course::port::{BoardNumber, Happened, Lit, Pick, ToPage};
use giveway_model::Cell;
use giveway_solve::{Request, Response, SilentHost, serve};

use super::super::shipped;
use super::{id, said};

/// What is left of an effect in the outer world of a random test.
struct World {
    board: BoardNumber,
    asked: Vec<(AskNumber, Request)>,
}

fn random(rng: &mut Rng, learner: &Learner, world: &World, lessons: &[(Id, Rc<Lesson>)]) -> Action {
    let number = match rng.u8(0..5) {
        0 => BoardNumber(rng.u32(0..20)),
        _ => world.board,
    };
    let cell = Cell::new(rng.u32(0..7), rng.u32(0..4));
    match if learner.open.is_none() {
        0
    } else {
        rng.u8(0..40)
    } {
        0 => {
            let (id, lesson) = rng.choice(lessons).unwrap();
            Action::Open {
                id: id.clone(),
                lesson: lesson.clone(),
                at: rng.bool().then(|| rng.usize(0..9)),
            }
        }
        1 | 2 => Action::Next,
        3..6 | 14 | 15 => Action::Choose(rng.usize(0..4)),
        6 => Action::Back,
        7 => Action::Go(rng.usize(0..9)),
        8..12 => {
            let what = match (rng.u8(0..7), &learner.open) {
                (0, _) => Happened::Time(rng.u32(0..20)),
                (1, Some(open)) => {
                    let mut scene = open.scene().clone();
                    let (x, y) = (cell.x as usize, cell.y as usize);
                    if let Some(row) = scene.map.get_mut(y)
                        && x < row.len()
                    {
                        row.replace_range(x..=x, rng.choice(["#", ".", "+", "~"]).unwrap());
                    }
                    Happened::Board(Box::new(scene))
                }
                (2, _) => Happened::Led(Box::default()),
                (3, _) => Happened::Changed("revise".parse().unwrap()),
                (6, _) => Happened::Leads("A2".to_owned()),
                (4, _) if rng.u8(0..9) == 0 => Happened::Closed,
                _ => Happened::Picked(Pick {
                    cell,
                    time: rng.u32(0..5),
                    robots: ["A1", "A2"]
                        .iter()
                        .filter(|_| rng.bool())
                        .map(|n| (*n).to_owned())
                        .collect(),
                }),
            };
            said(number, what)
        }
        12 => Action::Guess(Value::Number(rng.u32(4..10))),
        13 => Action::Guess(Value::Cell(cell)),
        16 => Action::Order(vec!["A1".into(), "A2".into()]),
        17 => Action::NoOrder,
        19 if rng.bool() => Action::CheckProof,
        20 if rng.bool() => Action::ChangeByte,
        18 if rng.bool() => Action::Lead("A2".to_owned()),
        18 => Action::Hint,
        19 => Action::ShowEvidence,
        20 => Action::TakeBack,
        21 => Action::Afresh,
        22 => Action::Light(rng.bool().then_some(Lit::Cell(cell))),
        23 => Action::Failed {
            number: AskNumber(rng.u32(0..50)),
            sentence: "It broke.".into(),
        },
        _ => match world
            .asked
            .last()
            .filter(|_| rng.u8(0..4) > 0)
            .or_else(|| rng.choice(&world.asked))
        {
            // Answers come late, twice, or to another question.
            Some((number, request)) => Action::Answered {
                number: *number,
                response: Box::new(match (rng.u8(0..4), request) {
                    (0, _) => {
                        Response::Refused(giveway_solve::Refusal::Scene { faults: Vec::new() })
                    }
                    (_, Request::Solve(request)) if request.scene.agents.len() < 5 => {
                        serve(&Request::Solve(request.clone()), &SilentHost)
                    }
                    (_, Request::Plan(_) | Request::Change(_)) => serve(request, &SilentHost),
                    _ => Response::Refused(giveway_solve::Refusal::Scene { faults: Vec::new() }),
                }),
            },
            None => Action::Time(3),
        },
    }
}

#[test]
fn random_actions_keep_the_invariants() {
    let names = [
        "two-robots-one-cell",
        "room-to-pass",
        "one-after-the-other",
        "when-the-world-changes",
    ];
    let lessons: Vec<(Id, Rc<Lesson>)> = names
        .iter()
        .map(|name| (id(name), Rc::new(shipped::lesson(name))))
        .collect();
    let mut solved = 0;
    for seed in 0..120 {
        let mut rng = Rng::with_seed(seed);
        let mut learner = Learner::default();
        let mut world = World {
            board: BoardNumber(0),
            asked: Vec::new(),
        };
        for _ in 0..300 {
            let action = random(&mut rng, &learner, &world, &lessons);
            let told = format!("seed {seed}: {action:?}");
            let (next, effects) = reduce(learner.clone(), action.clone());
            assert_eq!(
                reduce(learner, action),
                (next.clone(), effects.clone()),
                "{told}"
            );
            learner = next;
            for effect in &effects {
                match effect {
                    Effect::Page(page) => {
                        assert_eq!(ToPage::from_bytes(&page.to_bytes()).as_ref(), Ok(page));
                        if let ToPage::Open(board) = page {
                            assert!(board.number > world.board, "{told}");
                            world.board = board.number;
                        }
                        if let ToPage::StartAfresh(number) = page {
                            assert!(*number > world.board, "{told}");
                            world.board = *number;
                        }
                    }
                    Effect::Ask { number, request } => {
                        let latest = world.asked.last().map(|(number, _)| *number);
                        assert!(latest.is_none_or(|latest| latest < *number), "{told}");
                        world.asked.push((*number, (**request).clone()));
                        // About the step that is open, or else one that was left.
                        let judge = learner.open.as_ref().map(|open| open.judge().clone());
                        let is_more = told.contains(": Answered");
                        assert!(
                            matches!(judge, Some(Judge::Looking(_))) || is_more,
                            "{told}"
                        );
                    }
                    Effect::Keep(progress) => assert_eq!(*progress, learner.progress, "{told}"),
                    Effect::Forget | Effect::FocusNext => {}
                }
            }
            if let Some(open) = &learner.open {
                assert!(open.index() < open.lesson.steps.len(), "{told}");
                let step = open.step().unwrap();
                assert!(open.hints().len() <= step.hints.len(), "{told}");
                let is_waiting = matches!(open.judge(), Judge::Waiting);
                assert!(step.task.is_some() || is_waiting, "{told}");
                assert_ne!(learner.progress.stage(&open.id), Stage::New, "{told}");
                solved += usize::from(open.is_solved());
            }
        }
    }
    assert!(solved > 50, "{solved}");
}
