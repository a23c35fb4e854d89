//! The verdict on a run: solved with a legal plan of the cost that it says, or failed.

use std::ffi::{OsStr, OsString};
use std::os::unix::process::ExitStatusExt;
use std::process::ExitStatus;

use giveway_formats::{Combined, ForeignPlan, Held, Options, Source, combine, read};
use giveway_model::check::{Violation, check};
use giveway_model::compare::{ClaimedCost, claims};
use giveway_model::format::native;
use giveway_model::words::name;
use giveway_model::{Costs, Instance};
use giveway_solve::Host;

use super::PlannerSpec;
use super::command::{Command, Placeholder};
use super::given::{Given, unknown};
use super::output::{self, NoText};
use super::run::{Ended, Job, Ran, Stop};
use crate::row::Took;
use crate::{Clock, Failure, Loaded, Row, RowStatus, Task};

/// Why a task is not solved: the kind, and a phrase that tells how.
type Failed = (Failure, String);

/// Runs the command of a task, and judges what it writes.
pub(super) fn row(task: &Task, spec: &PlannerSpec, loaded: &Loaded, host: &dyn Host) -> Row {
    let instance = &loaded.instance;
    let objective = task.objective.clone();
    let facts = |row: Row| Row {
        map: loaded.map.clone(),
        agents: Some(instance.agents().len()),
        objective: Some(objective.unwrap_or_else(|| instance.objective().clone())),
        ..row
    };
    if let Some(reason) = unknown(instance) {
        return facts(Row::bare(task, RowStatus::Refused, Some(reason)));
    }
    let ran = run(task, spec, loaded, host);
    let (ran, outcome) = match ran {
        Ok(ran) => ran,
        Err(reason) => return Row::error(task, reason),
    };
    let (status, costs, failure, reason) = match outcome {
        Ok(costs) => (RowStatus::Feasible, Some(costs), None, None),
        Err((failure, reason)) => (RowStatus::Failed, None, Some(failure), Some(reason)),
    };
    facts(Row {
        costs,
        failure,
        took: Took {
            cpu_seconds: ran.cpu_seconds,
            wall_seconds: ran.wall_seconds,
            peak_bytes: ran.peak_bytes,
            ..Took::default()
        },
        ..Row::bare(task, status, reason)
    })
}

/// Runs the command, and judges what it wrote.
fn run(
    task: &Task,
    spec: &PlannerSpec,
    loaded: &Loaded,
    host: &dyn Host,
) -> Result<(Ran, Result<Costs, Failed>), String> {
    let command = Command::read(&spec.command);
    let command = command.map_err(|(found, expected)| {
        format!("{}: found {found}, expected {expected}.", spec.name)
    })?;
    let given = Given::write(&loaded.instance)?;
    let (map, scen, out) = (given.map(), given.scen(), given.out());
    let agents = loaded.instance.agents().len().to_string();
    let seconds = task
        .limits
        .seconds
        .map_or_else(String::new, |limit| limit.to_string());
    let words: Vec<OsString> = command.words(&|placeholder| match placeholder {
        Placeholder::Map => map.as_os_str(),
        Placeholder::Scen => scen.as_os_str(),
        Placeholder::Agents => OsStr::new(&agents),
        Placeholder::Seconds => OsStr::new(&seconds),
        Placeholder::Out => out.as_os_str(),
    });
    let ran = Job::new(task, &words, &loaded.folder, &out).run(host)?;
    let outcome = match ended_badly(task, &ran) {
        Some(failed) => Err(failed),
        None => match output::read(&out) {
            Ok(text) => judged(&loaded.instance, &text),
            Err(NoText::Nothing) => Err((Failure::Nothing, "wrote no plan".to_owned())),
            Err(NoText::Unreadable(what)) => Err((Failure::Unreadable, format!("wrote {what}"))),
        },
    };
    Ok((ran, outcome))
}

/// Why nothing that it wrote counts: it was ended, it crashed, or it took more than it may
/// before anybody looked.
fn ended_badly(task: &Task, ran: &Ran) -> Option<Failed> {
    let limits = task.limits;
    let over = ran.peak_bytes.zip(limits.memory_bytes);
    let is_over = over.is_some_and(|(peak, limit)| peak > limit);
    let limit = limits.seconds.unwrap_or_default();
    let is_late = match task.clock {
        Clock::Cpu => limits.seconds.is_some_and(|limit| ran.cpu_seconds > limit),
        Clock::Wall => false,
    };
    let after = seconds(ran.wall_seconds);
    let memory = || {
        let limit = bytes(limits.memory_bytes.unwrap_or_default());
        (
            Failure::Memory,
            format!("held more than {limit}, ended after {after}"),
        )
    };
    let time = || (Failure::Time, format!("no plan within {}", seconds(limit)));
    match ran.ended {
        Ended::Stopped(Stop::Memory) => Some(memory()),
        Ended::Stopped(Stop::Time) => Some(time()),
        Ended::Stopped(Stop::Output) => {
            let what = output::too_long();
            Some((
                Failure::Unreadable,
                format!("wrote {what}, ended after {after}"),
            ))
        }
        Ended::Stopped(Stop::Cancelled) => Some((Failure::Time, "was interrupted".to_owned())),
        Ended::Exit(_) if is_over => Some(memory()),
        Ended::Exit(_) if is_late => Some(time()),
        Ended::Exit(status) if !status.success() => {
            let line = ran.last_line.as_ref();
            let said = line.map_or_else(String::new, |line| format!(": {line}"));
            Some((
                Failure::Crashed,
                format!("{} after {after}{said}", exit(status)),
            ))
        }
        Ended::Exit(_) => None,
    }
}

/// Judges a text: the costs of its plan, where that is legal and what the text says of its
/// costs is so.
fn judged(instance: &Instance, text: &str) -> Result<Costs, Failed> {
    if says_none(text) {
        return Err((
            Failure::Nothing,
            "says itself that it found no plan".to_owned(),
        ));
    }
    let plan = plan_of(instance, text).map_err(|why| (Failure::Unreadable, why))?;
    let report = check(instance, &plan.plan);
    if let Some(first) = report.violations.first() {
        return Err((Failure::Illegal, broken(first, report.violations.len())));
    }
    let claims = claims(instance, &plan.plan, plan.claimed, plan.written);
    if let Some(wrong) = claims.iter().find(|claim| !claim.agrees()) {
        return Err((Failure::WrongCost, said(wrong)));
    }
    let costs = report
        .costs
        .ok_or_else(|| "a plan without costs".to_owned());
    costs.map_err(|why| (Failure::Unreadable, why))
}

/// Whether a planner says in its file that it found nothing.
fn says_none(text: &str) -> bool {
    match read(text) {
        Ok((_, Held::NoPlan(_))) => true,
        Ok(_) => false,
        Err(_) => text.lines().any(|line| line.trim() == "solved=0"),
    }
}

/// The plan in a text, for an instance; its cells are read by the convention that fits.
fn plan_of(instance: &Instance, text: &str) -> Result<ForeignPlan, String> {
    let scene = native::write_scene(&instance.to_scene());
    let scene = Source {
        name: "instance.json",
        text: &scene,
    };
    let plan = Source {
        name: "plan.txt",
        text,
    };
    let options = Options::default();
    // A file with an instance of its own is judged by the instance that was given, too.
    let combined = combine(&[scene, plan], &options);
    let combined = combined.or_else(|refused| combine(&[plan], &options).map_err(|_| refused));
    match combined {
        Ok(Combined { plans, .. }) => {
            let plan = plans.into_iter().next();
            plan.ok_or_else(|| "wrote a file without a plan".to_owned())
        }
        Err(refused) => {
            let fault = refused.faults().into_iter().next();
            Err(fault.map_or_else(String::new, |fault| fault.to_string()))
        }
    }
}

/// The first rule that a plan breaks, and how many more.
fn broken(first: &Violation, count: usize) -> String {
    let first = first.message.trim_end_matches('.');
    match count {
        0 | 1 => first.to_owned(),
        count => format!("{first}, and {} more", count - 1),
    }
}

/// What a file says of a cost, and what that is.
fn said(wrong: &ClaimedCost) -> String {
    let cost = name(wrong.cost);
    let counted = wrong
        .counted
        .map_or_else(|| "unknown".to_owned(), |cost| cost.to_string());
    let how = wrong.definition.map_or_else(String::new, |definition| {
        format!(". {}", definition.sentence().trim_end_matches('.'))
    });
    format!("says {cost} {}, the plan has {counted}{how}", wrong.claimed)
}

/// How a process ended.
fn exit(status: ExitStatus) -> String {
    match (status.code(), status.signal()) {
        (Some(code), _) => format!("exit {code}"),
        (None, Some(signal)) => format!("killed by signal {signal}"),
        (None, None) => "ended".to_owned(),
    }
}

fn seconds(seconds: f64) -> String {
    match seconds {
        few if few < 10.0 => format!("{} s", (100.0 * few).round() / 100.0),
        many => format!("{} s", (10.0 * many).round() / 10.0),
    }
}

fn bytes(bytes: u64) -> String {
    match bytes {
        many if many >= 1_000_000_000 => format!("{} GB", (many as f64 / 1e8).round() / 10.0),
        few => format!("{} MB", (few as f64 / 1e5).round() / 10.0),
    }
}
