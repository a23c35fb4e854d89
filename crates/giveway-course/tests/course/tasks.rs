//! For each task of the course: its solution is accepted, the untouched start is not,
//! and plausible wrong answers are refused with the reply that fits. The real solver
//! judges.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use giveway_course::judge::words::said;
use giveway_course::judge::{Did, Judging, Mark, Situation, Verdict, begin, conclude};
use giveway_course::lesson::{Lesson, Value};
use giveway_model::{Agent, Cell, Path, Plan, Scene};
use giveway_solve::{CheckRequest, Request, SilentHost, serve};
use serde::Deserialize;

use super::shipped;

/// What is done for a task, as a file of solutions has it.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
struct Doing {
    paint: Option<Painting>,
    lead: Option<BTreeMap<String, Path>>,
    guess: Option<Value>,
    marks: Option<Vec<Marking>>,
    choose: Option<usize>,
    order: Option<Vec<String>>,
    no_order: bool,
    went: Option<String>,
}

#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case", default)]
struct Painting {
    set: Vec<(u32, u32, String)>,
    robots: Vec<Agent>,
    gone: Vec<String>,
    goals: BTreeMap<String, Cell>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Marking {
    time: u32,
    robots: Vec<String>,
    cells: Vec<Cell>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Solution {
    solved: Doing,
    refused: Vec<Refused>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Refused {
    did: Doing,
    says: String,
}

fn solutions(lesson: &str) -> BTreeMap<usize, Solution> {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/solutions");
    let path = path.join(format!("{lesson}.json"));
    let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

fn painted(start: &Scene, painting: Painting) -> Scene {
    let mut scene = start.clone();
    for (x, y, ground) in painting.set {
        let row = &mut scene.map[y as usize];
        let mut cells: Vec<char> = row.chars().collect();
        cells[x as usize] = ground.chars().next().unwrap();
        *row = cells.into_iter().collect();
    }
    scene
        .agents
        .retain(|agent| !painting.gone.contains(&agent.name));
    scene.agents.extend(painting.robots);
    for (name, goal) in painting.goals {
        let agent = scene.agents.iter_mut().find(|agent| agent.name == name);
        agent.unwrap().goal = Some(goal);
    }
    scene
}

/// What was done, and the scene that is on the board then.
fn did(start: &Scene, doing: Doing) -> (Scene, Did) {
    let scene = painted(start, doing.paint.unwrap_or_default());
    let did = if let Some(paths) = doing.lead {
        let plan = Plan {
            paths,
            ..Plan::default()
        };
        Did::Led(plan)
    } else if let Some(value) = doing.guess {
        Did::Guessed(value)
    } else if let Some(marks) = doing.marks {
        let mark = |mark: Marking| Mark {
            time: mark.time,
            robots: mark.robots,
            cells: mark.cells,
        };
        Did::Marked(marks.into_iter().map(mark).collect())
    } else if let Some(answer) = doing.choose {
        Did::Chose(answer)
    } else if let Some(order) = doing.order {
        Did::Ordered(order)
    } else if doing.no_order {
        Did::NoOrder
    } else if let Some(method) = doing.went {
        Did::Went(method.parse().unwrap())
    } else {
        Did::Edits
    };
    (scene, did)
}

/// The verdict, with the solver's own answers.
pub(crate) fn judged(lesson: &Lesson, step: usize, scene: &Scene, did: &Did) -> Verdict {
    let start = lesson.scene(step).unwrap();
    let situation = Situation {
        step: &lesson.steps[step],
        start,
        scene,
    };
    match begin(situation, did).unwrap() {
        Judging::Verdict(verdict) => *verdict,
        Judging::Ask(requests) => {
            let serve = |request| serve(request, &SilentHost);
            let responses: Vec<_> = requests.iter().map(serve).collect();
            conclude(situation, did, &responses).unwrap()
        }
    }
}

/// All that is wrong with the tasks of a lesson.
fn complaints(name: &str, lesson: &Lesson) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut solutions = solutions(name);
    for (index, step) in lesson.steps.iter().enumerate() {
        let Some(task) = &step.task else {
            continue;
        };
        let place = format!("{name}, step {index} ({})", task.kind());
        let Some(solution) = solutions.remove(&index) else {
            complaints.push(format!("{place}: no solution"));
            continue;
        };
        let start = lesson.scene(index).unwrap();
        let tell = |verdict: &Verdict| {
            let said = said(verdict, step);
            format!("{}: {}", said.head, said.text.plain())
        };
        let (scene, done) = did(start, solution.solved);
        let verdict = judged(lesson, index, &scene, &done);
        if !verdict.is_solved() {
            complaints.push(format!(
                "{place}: the solution is refused: {}",
                tell(&verdict)
            ));
        }
        if judged(lesson, index, start, &Did::Edits).is_solved() {
            complaints.push(format!("{place}: the start is accepted"));
        }
        if solution.refused.len() < 2 {
            complaints.push(format!("{place}: fewer than two wrong answers"));
        }
        for wrong in solution.refused {
            let shown = format!("{:?}", wrong.did);
            let (scene, done) = did(start, wrong.did);
            let verdict = judged(lesson, index, &scene, &done);
            let told = tell(&verdict);
            if verdict.is_solved() || !told.contains(&wrong.says) {
                complaints.push(format!(
                    "{place}: {shown} gets \"{told}\", not \"{}\"",
                    wrong.says
                ));
            }
        }
    }
    let left = solutions.keys();
    complaints.extend(left.map(|index| format!("{name}: step {index} has no task")));
    complaints
}

/// Calls for the solution of each task of the course.
pub(crate) fn each_solution(mut call: impl FnMut(&str, Situation<'_>, &Did)) {
    for (name, lesson) in shipped::lessons() {
        for (index, solution) in solutions(&name) {
            let start = lesson.scene(index).unwrap();
            let (scene, done) = did(start, solution.solved);
            let situation = Situation {
                step: &lesson.steps[index],
                start,
                scene: &scene,
            };
            call(&format!("{name}, step {index}"), situation, &done);
        }
    }
}

/// What was done for the task of a step: the scene on the board, and the answer.
pub(crate) struct Answered {
    pub(crate) lesson: String,
    pub(crate) step: usize,
    pub(crate) scene: Scene,
    pub(crate) did: Did,
    /// Whether it is the solution, or one of the wrong answers.
    pub(crate) is_right: bool,
}

/// The solution of each task of a lesson, and its wrong answers.
pub(crate) fn answers(name: &str, lesson: &Lesson) -> Vec<Answered> {
    let mut all = Vec::new();
    for (step, solution) in solutions(name) {
        let start = lesson.scene(step).unwrap();
        let wrong = solution.refused.into_iter().map(|wrong| (wrong.did, false));
        for (doing, is_right) in std::iter::once((solution.solved, true)).chain(wrong) {
            let (scene, did) = did(start, doing);
            all.push(Answered {
                lesson: name.to_owned(),
                step,
                scene,
                did,
                is_right,
            });
        }
    }
    all
}

/// A request that no task makes.
pub(crate) fn check_request(situation: Situation<'_>) -> Request {
    Request::Check(CheckRequest {
        scene: situation.scene.clone(),
        ..CheckRequest::default()
    })
}

#[test]
fn solutions_are_accepted_and_wrong_answers_get_the_reply_that_fits() {
    let only = std::env::var("GIVEWAY_LESSON").ok();
    let mut all = Vec::new();
    for (name, lesson) in shipped::lessons() {
        if only.as_ref().is_none_or(|only| *only == name) {
            all.extend(complaints(&name, &lesson));
        }
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}

/// A reply is the data of a lesson; whether an answer is right is not: every answer that
/// is right says so by its claim, where it has one, and no wrong answer is accepted.
#[test]
fn no_answer_is_disputed_by_the_solver() {
    for (name, lesson) in shipped::lessons() {
        for (index, step) in lesson.steps.iter().enumerate() {
            let Some(giveway_course::lesson::Task::Choose(task)) = &step.task else {
                continue;
            };
            let scene = lesson.scene(index).unwrap();
            for (answer, choice) in task.answers.iter().enumerate() {
                let verdict = judged(&lesson, index, scene, &Did::Chose(answer));
                let said = said(&verdict, step);
                let place = format!("{name}, step {index}, answer {answer}");
                assert_eq!(verdict.is_solved(), choice.right, "{place}: {said:?}");
                assert_eq!(said.text, choice.reply, "{place}: {said:?}");
            }
        }
    }
}
