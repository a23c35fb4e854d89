//! Questions on warehouse floors of a real size: when each layer of the answer is there, and how
//! large its reason is.

mod export;
mod scenes;
mod tell;

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use cpu_time::ProcessTime;
use giveway_model::{Instance, Plan, Question, format::native, question::to_words};
use giveway_solve::explain::{ExplainAnswer, ExplainRequest, FactKind, Layer, Part, Verdict};
use giveway_solve::{
    Host, Limits, Progress, ProvedBest, Request, Response, SolveAnswer, SolveRequest, Status, serve,
};
use giveway_tests::questions;

use crate::rows::data;

/// Questions about each plan, the first of them about its makespan, and the seed that draws the
/// others.
const QUESTIONS: usize = 10;
const SEED: u64 = 4;
/// CPU seconds for a plan.
const SECONDS: f64 = 60.0;
/// CPU seconds within which a layer is to be there.
const HERE: f64 = 0.1;
const NEAR: f64 = 1.0;
const WHOLE: f64 = 3.0;
const REASON: f64 = 3.0;

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
        for part in [
            Part::Here,
            Part::Near,
            Part::Verdict,
            Part::Closest,
            Part::Core,
        ] {
            if !answer.pending.contains(&part) {
                parts
                    .entry(part)
                    .or_insert_with(|| now() - self.begin.get());
            }
        }
    }
}

/// What one answer came to: the CPU seconds of each layer by itself, and the answer.
struct Asked {
    question: Question,
    here: f64,
    near: f64,
    verdict: f64,
    closest: f64,
    reason: f64,
    answer: ExplainAnswer,
}

impl Asked {
    fn is_known(&self) -> bool {
        self.answer.verdict != Verdict::Unknown
    }

    /// Whether it has to have a reason.
    fn is_refuted(&self) -> bool {
        matches!(self.answer.verdict, Verdict::Costly | Verdict::Necessary)
    }

    fn groups(&self) -> usize {
        let core = self.answer.core.as_ref();
        core.map_or(0, |core| core.groups.len())
    }

    /// The robots among the facts of the reason, and the percentage of the floor's cells.
    fn size(&self, instance: &Instance) -> Option<(f64, f64)> {
        let core = self.answer.core.as_ref()?;
        let mut robots: Vec<&String> = core.facts.iter().flat_map(|it| &it.agents).collect();
        robots.sort();
        robots.dedup();
        let facts = core.facts.iter();
        let obstacles = facts.filter(|fact| fact.kind == FactKind::Obstacle).count();
        let cells = instance.grid().cells().count();
        Some((
            robots.len() as f64,
            100.0 * obstacles as f64 / cells.max(1) as f64,
        ))
    }
}

/// A floor, its plan, and the answers about it.
struct Floor {
    name: String,
    instance: Instance,
    /// CPU seconds for the plan.
    seconds: f64,
    is_best: bool,
    plan: Plan,
    asked: Vec<Asked>,
}

/// The tables: the depot, and so many random floors by seeds from 1, or the first scenes of a
/// folder, with so many CPU seconds for each answer.
///
/// # Errors
/// Where a scene cannot be read, or a question is not answered.
pub(crate) fn table(
    (floors, folder): (u64, Option<&Path>),
    seconds: f64,
) -> Result<String, Box<dyn Error>> {
    let mut all = vec![asked_about(
        "depot".to_owned(),
        read(&data("depot/depot.json"))?,
        seconds,
    )?];
    if let Some(folder) = folder {
        let entries = fs::read_dir(folder)?.collect::<Result<Vec<_>, _>>()?;
        let mut files: Vec<PathBuf> = entries.iter().map(fs::DirEntry::path).collect();
        files.sort();
        for file in files.iter().take(floors as usize) {
            let name = file.file_stem().unwrap_or_default().to_string_lossy();
            all.push(asked_about(name.into_owned(), read(file)?, seconds)?);
        }
    } else {
        for seed in 1..=floors {
            let scene = scenes::floor(seed)?;
            let instance = Instance::new(scene).map_err(|faults| format!("{seed}: {faults:?}"))?;
            all.push(asked_about(format!("floor {seed}"), instance, seconds)?);
        }
    }
    export::write(&all)?;
    Ok(tell::tables(&all, seconds))
}

fn read(file: &Path) -> Result<Instance, Box<dyn Error>> {
    let instance = native::read_instance(&fs::read_to_string(file)?);
    Ok(instance.map_err(|faults| format!("{}: {faults:?}", file.display()))?)
}

/// A floor with its plan, and the questions about it.
fn asked_about(name: String, instance: Instance, limit: f64) -> Result<Floor, Box<dyn Error>> {
    let begin = now();
    let solved = solved(&instance)?;
    let seconds = now() - begin;
    let plan = solved
        .plan
        .clone()
        .ok_or_else(|| format!("{name}: no plan"))?;
    let is_best = solved.status == Status::Optimal;
    let proved = is_best.then(|| ProvedBest::by_search(&solved));
    eprintln!("{name}: {:?} in {seconds:.1}", solved.status);
    let mut asked = Vec::new();
    let first = std::iter::once(Question::Makespan);
    let drawn = (0..).map_while(|number| {
        (number < 10 * QUESTIONS as u64).then(|| questions::about(&instance, &plan, SEED, number))
    });
    for question in first.chain(drawn.flatten()).take(QUESTIONS) {
        let words = to_words(&question);
        let one = ask(&instance, &plan, question, (proved.clone(), limit))
            .map_err(|error| format!("{name}, {words}: {error}"))?;
        let (answer, size) = (&one.answer, one.size(&instance));
        eprintln!(
            "{name}, {words}: {:?} {:?}; here {:.2}, near {:.2}, verdict {:.2}, closest {:.2}, \
             reason {:.2}: {:?}, {} groups, {} bounds, minimal {:?}",
            answer.verdict,
            answer.deltas.values().collect::<Vec<_>>(),
            one.here,
            one.near,
            one.verdict,
            one.closest,
            one.reason,
            size,
            one.groups(),
            answer.alone.len(),
            answer.core.as_ref().map(|core| core.minimal),
        );
        asked.push(one);
    }
    Ok(Floor {
        name,
        instance,
        seconds,
        is_best,
        plan,
        asked,
    })
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
        trace: true, // as the page asks
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
    (proved, limit): (Option<ProvedBest>, f64),
) -> Result<Asked, Box<dyn Error>> {
    let watch = Watch::default();
    watch.begin.set(now());
    let request = Request::Explain(ExplainRequest {
        scene: instance.to_scene(),
        plan: Some(plan.clone()),
        question: question.clone(),
        changes: None,
        at: None,
        objective: None,
        within: None,
        proved,
        known: None,
        layers: vec![Layer::Here, Layer::Near, Layer::Reason],
        limits: limits(limit),
    });
    let Response::Explained(answer) = serve(&request, &watch) else {
        return Err("not answered".into());
    };
    let end = now() - watch.begin.get();
    let parts = watch.parts.into_inner();
    let time = |part| parts.get(&part).copied().unwrap_or(end);
    let (verdict, closest, core) = (time(Part::Verdict), time(Part::Closest), time(Part::Core));
    // Where the verdict is there before the best other plan is known, the reason comes first.
    let before = |mine: f64, other: f64| if other < mine { other } else { verdict };
    Ok(Asked {
        question,
        here: time(Part::Here),
        near: time(Part::Near) - time(Part::Here),
        verdict: verdict - time(Part::Near),
        closest: closest - before(closest, core),
        reason: core - before(core, closest),
        answer: *answer,
    })
}
