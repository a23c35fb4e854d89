//! Questions about the best plans of graded instances: how long it takes to the
//! verdict, and to the whole answer.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;

use cpu_time::ProcessTime;
use giveway_model::{format::native, question::to_words};
use giveway_solve::explain::{ExplainRequest, Part, Verdict};
use giveway_solve::{Host, Progress, Request, Response, SilentHost, SolveRequest, serve};
use giveway_tests::questions;

use crate::rows;

/// The instances whose plans are asked about.
const INSTANCES: [&str; 10] = [
    "A01", "A02", "A03", "A04", "A05", "A06", "A07", "A08", "A09", "A12",
];
/// Questions about each, and the seed that draws them.
const QUESTIONS: u64 = 10;
const SEED: u64 = 4;

/// Where the questions are left, with the seconds that they took, for those who
/// ask them in a browser.
const ASKED: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../target/questions.json");

/// A host that notes when the verdict is there. Its only clock is that of the
/// processor.
struct Watch {
    begin: f64,
    verdict: Cell<Option<f64>>,
}

fn now() -> f64 {
    ProcessTime::try_now().map_or(0.0, |time| time.as_duration().as_secs_f64())
}

impl Host for Watch {
    fn wall_seconds(&self) -> f64 {
        now()
    }

    fn progress(&self, event: &Progress) {
        if let Progress::Explained { answer } = event
            && !answer.pending.contains(&Part::Verdict)
            && self.verdict.get().is_none()
        {
            self.verdict.set(Some(now() - self.begin));
        }
    }
}

/// The table, and what it comes to.
///
/// # Errors
/// Where an instance cannot be read, or a question is not answered.
pub(crate) fn table() -> Result<String, Box<dyn Error>> {
    let mut rows = String::new();
    let mut asked = Vec::new();
    let (mut verdicts, mut wholes) = (Vec::new(), Vec::new());
    for name in INSTANCES {
        let (stem, file) = rows::graded_file(name)?;
        let Ok(instance) = native::read_instance(&fs::read_to_string(file)?) else {
            return Err(format!("{stem} is no instance").into());
        };
        let solve = Request::Solve(SolveRequest {
            scene: instance.to_scene(),
            ..SolveRequest::default()
        });
        let Response::Solved(solved) = serve(&solve, &SilentHost) else {
            return Err(format!("{stem} was not solved").into());
        };
        let plan = solved.plan.ok_or("there is no plan to ask about")?;
        let mut seen: BTreeMap<Verdict, usize> = BTreeMap::new();
        let (mut first, mut whole) = (Vec::new(), Vec::new());
        for number in 0..QUESTIONS {
            let Some(question) = questions::about(&instance, &plan, SEED, number) else {
                continue;
            };
            let words = to_words(&question);
            let watch = Watch {
                begin: now(),
                verdict: Cell::new(None),
            };
            let ask = ExplainRequest {
                scene: instance.to_scene(),
                plan: Some(plan.clone()),
                question,
                changes: None,
                at: None,
                objective: None,
                within: None,
                proved: None,
                known: None,
                layers: Vec::new(),
                limits: giveway_solve::Limits::default(),
            };
            let Response::Explained(answer) = serve(&Request::Explain(ask.clone()), &watch) else {
                return Err(format!("{stem}: {words} was not answered").into());
            };
            let end = now() - watch.begin;
            let verdict = watch.verdict.get().unwrap_or(end);
            eprintln!("{stem} {words}: {:?} {verdict:.3} {end:.3}", answer.verdict);
            asked.push(serde_json::json!({
                "about": format!("{stem}: {words}"),
                "request": ask,
                "verdict": answer.verdict,
                "seconds": [verdict, end],
            }));
            *seen.entry(answer.verdict).or_default() += 1;
            first.push(verdict);
            whole.push(end);
        }
        let verdict = |verdict| seen.get(&verdict).copied().unwrap_or(0);
        let _ = writeln!(
            rows,
            "| {stem} | {} | {} | {} | {} | {:.3} | {:.3} | {:.3} | {:.3} |",
            verdict(Verdict::Needless),
            verdict(Verdict::Costly),
            verdict(Verdict::Necessary),
            verdict(Verdict::Unknown) + verdict(Verdict::Improvable),
            share(&mut first, 50),
            share(&mut first, 100),
            share(&mut whole, 50),
            share(&mut whole, 100),
        );
        verdicts.extend(first);
        wholes.extend(whole);
    }
    fs::write(ASKED, serde_json::to_string(&asked)?)?;
    Ok(format!(
        "{} questions: to the verdict median {:.3} s, 95 % within {:.3} s; to the whole answer \
         median {:.3} s, 95 % within {:.3} s.\n\n\
         | instance | needless | costly | necessary | other | verdict, median s | most | whole, median s | most |\n\
         | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n{rows}",
        verdicts.len(),
        share(&mut verdicts, 50),
        share(&mut verdicts, 95),
        share(&mut wholes, 50),
        share(&mut wholes, 95),
    ))
}

/// The value that so many percent do not exceed.
fn share(values: &mut [f64], percent: usize) -> f64 {
    values.sort_by(f64::total_cmp);
    let index = (values.len() * percent).div_ceil(100).saturating_sub(1);
    values.get(index).copied().unwrap_or(0.0)
}
