//! Questions on warehouse floors of a real size: when each layer of the answer is there, and how
//! large its reason is.

mod scenes;

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;

use cpu_time::ProcessTime;
use giveway_model::{Instance, Plan, Question, format::native, question::to_words};
use giveway_solve::explain::{
    ExplainAnswer, ExplainRequest, FactKind, Layer, MOST_GROUPS, Part, Verdict,
};
use giveway_solve::{
    Host, Limits, Progress, Reach, Request, Response, SolveAnswer, SolveRequest, Status, serve,
};
use giveway_tests::questions;

use crate::rows::data;

/// Questions about each plan, the first of them about its makespan, and the seed that draws the
/// others.
const QUESTIONS: usize = 10;
const SEED: u64 = 4;
/// CPU seconds for a plan.
const SECONDS: f64 = 30.0;
/// CPU seconds within which a layer is to be there.
const HERE: f64 = 0.1;
const NEAR: f64 = 1.0;
const WHOLE: f64 = 3.0;

const HEAD: &str = "\
| floor | robots | plan, CPU s | here, most | near, most | verdict, median | in 3 s | proved | \
reason | robots | obstacles | groups, most |
| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
";

/// Notes when each part of an answer is there, in CPU seconds.
#[derive(Default)]
struct Watch {
    begin: Cell<f64>,
    parts: RefCell<BTreeMap<Part, f64>>,
}

fn now() -> f64 {
    ProcessTime::try_now().map_or(0.0, |time| time.as_duration().as_secs_f64())
}

impl Host for Watch {
    fn wall_seconds(&self) -> f64 {
        now()
    }

    fn progress(&self, event: &Progress) {
        let Progress::Explained { answer } = event else {
            return;
        };
        let mut parts = self.parts.borrow_mut();
        for part in [Part::Here, Part::Near, Part::Verdict, Part::Core] {
            if !answer.pending.contains(&part) {
                parts
                    .entry(part)
                    .or_insert_with(|| now() - self.begin.get());
            }
        }
    }
}

/// What one answer came to.
struct Asked {
    here: f64,
    near: f64,
    verdict: f64,
    answer: ExplainAnswer,
}

impl Asked {
    /// The robots and the share of the obstacles among the facts of the reason.
    fn size(&self, instance: &Instance) -> Option<(f64, f64)> {
        let core = self.answer.core.as_ref()?;
        let mut robots: Vec<&String> = core.facts.iter().flat_map(|it| &it.agents).collect();
        robots.sort();
        robots.dedup();
        let facts = core.facts.iter();
        let obstacles = facts.filter(|fact| fact.kind == FactKind::Obstacle).count();
        let cells = instance.grid().cells();
        let all = cells.filter(|(_, ground)| !ground.is_vertex()).count();
        Some((
            robots.len() as f64,
            100.0 * obstacles as f64 / all.max(1) as f64,
        ))
    }
}

/// The table: the depot, and random floors by seeds from 1, with so many CPU seconds for each
/// answer.
///
/// # Errors
/// Where a scene cannot be read, or a question is not answered.
pub(crate) fn table(floors: u64, seconds: f64) -> Result<String, Box<dyn Error>> {
    let depot = native::read_instance(&fs::read_to_string(data("depot/depot.json"))?);
    let depot = depot.map_err(|faults| format!("depot: {faults:?}"))?;
    let mut rows = String::new();
    let mut all = Vec::new();
    push_row(&mut rows, "depot", &depot, seconds, &mut all)?;
    for seed in 1..=floors {
        let scene = scenes::floor(seed)?;
        let instance = Instance::new(scene).map_err(|faults| format!("{seed}: {faults:?}"))?;
        let name = format!("floor {seed}");
        push_row(&mut rows, &name, &instance, seconds, &mut all)?;
    }
    let count = all.len();
    let of = |is_so: &dyn Fn(&Asked) -> bool| all.iter().filter(|it| is_so(it)).count();
    let is_known = |it: &Asked| it.answer.verdict != Verdict::Unknown;
    let mut text = format!(
        "{count} questions. In time: here {} (in {HERE} s), near {} (in {NEAR} s), the verdict {} \
         (in {WHOLE} s). A verdict is there within {seconds} s for {}; ",
        of(&|it| it.here <= HERE),
        of(&|it| it.near <= NEAR),
        of(&|it| is_known(it) && it.verdict <= WHOLE),
        of(&is_known),
    );
    let refuted = |it: &Asked| matches!(it.answer.verdict, Verdict::Costly | Verdict::Necessary);
    let _ = write!(
        text,
        "of {} that cost more or cannot be, {} have a reason, {} of them shown minimal. The most \
         groups of one reason are {} of {MOST_GROUPS}.\n\n{HEAD}{rows}",
        of(&refuted),
        of(&|it| refuted(it) && it.answer.core.is_some()),
        of(&|it| it.answer.core.as_ref().is_some_and(|core| core.minimal)),
        all.iter().map(groups).max().unwrap_or(0),
    );
    Ok(text)
}

fn groups(asked: &Asked) -> usize {
    let core = asked.answer.core.as_ref();
    core.map_or(0, |core| core.groups.len())
}

fn push_row(
    rows: &mut String,
    name: &str,
    instance: &Instance,
    limit: f64,
    all: &mut Vec<Asked>,
) -> Result<(), Box<dyn Error>> {
    let begin = now();
    let solved = solved(instance)?;
    let seconds = now() - begin;
    let plan = solved.plan.ok_or_else(|| format!("{name}: no plan"))?;
    let is_best = solved.status == Status::Optimal;
    let proved = is_best.then_some(solved.reach);
    let mut asked = Vec::new();
    let first = std::iter::once(Question::Makespan);
    let drawn = (0..).map_while(|number| {
        (number < 10 * QUESTIONS as u64).then(|| questions::about(instance, &plan, SEED, number))
    });
    for question in first.chain(drawn.flatten()).take(QUESTIONS) {
        let words = to_words(&question);
        let one = ask(instance, &plan, question, (proved, limit))
            .map_err(|error| format!("{name}, {words}: {error}"))?;
        eprintln!(
            "{name}, {words}: {:?}; here {:.2}, near {:.2}, verdict {:.2}",
            one.answer.verdict, one.here, one.near, one.verdict
        );
        asked.push(one);
    }
    let times = |time: fn(&Asked) -> f64| asked.iter().map(time).collect::<Vec<f64>>();
    let is_known = |it: &&Asked| it.answer.verdict != Verdict::Unknown;
    let sizes: Vec<(f64, f64)> = asked.iter().filter_map(|it| it.size(instance)).collect();
    let _ = writeln!(
        rows,
        "| {name} | {} | {seconds:.1}{} | {:.2} | {:.2} | {:.2} | {} | {} | {} | {} | {} % | {} |",
        instance.agents().len(),
        if is_best { "" } else { ", not proved" },
        most(&times(|it| it.here)),
        most(&times(|it| it.near)),
        median(times(|it| it.verdict)),
        asked
            .iter()
            .filter(is_known)
            .filter(|it| it.verdict <= WHOLE)
            .count(),
        asked.iter().filter(is_known).count(),
        sizes.len(),
        median(sizes.iter().map(|size| size.0).collect()),
        median(sizes.iter().map(|size| size.1).collect()).round(),
        asked.iter().map(groups).max().unwrap_or(0),
    );
    all.extend(asked);
    Ok(())
}

const fn limits(seconds: f64) -> Limits {
    Limits {
        seconds: Some(seconds),
        conflicts: None,
        work: None,
        memory_bytes: None,
    }
}

fn solved(instance: &Instance) -> Result<SolveAnswer, Box<dyn Error>> {
    let request = Request::Solve(SolveRequest {
        scene: instance.to_scene(),
        limits: limits(SECONDS),
        ..SolveRequest::default()
    });
    match serve(&request, &Watch::default()) {
        Response::Solved(answer) => Ok(answer),
        _ => Err("not solved".into()),
    }
}

fn ask(
    instance: &Instance,
    plan: &Plan,
    question: Question,
    (proved, limit): (Option<Reach>, f64),
) -> Result<Asked, Box<dyn Error>> {
    let watch = Watch::default();
    watch.begin.set(now());
    let request = Request::Explain(ExplainRequest {
        scene: instance.to_scene(),
        plan: Some(plan.clone()),
        question,
        changes: None,
        at: None,
        objective: None,
        within: None,
        proved,
        layers: vec![Layer::Here, Layer::Near, Layer::Reason],
        limits: limits(limit),
    });
    let Response::Explained(answer) = serve(&request, &watch) else {
        return Err("not answered".into());
    };
    let end = now() - watch.begin.get();
    let parts = watch.parts.into_inner();
    let time = |part| parts.get(&part).copied().unwrap_or(end);
    Ok(Asked {
        here: time(Part::Here),
        near: time(Part::Near) - time(Part::Here),
        verdict: time(Part::Verdict) - time(Part::Near),
        answer: *answer,
    })
}

fn most(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
