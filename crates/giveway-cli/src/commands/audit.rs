//! `giveway audit`: whether a plan is legal, and how good it is.

mod batch;
mod plan;

use std::path::Path;

use giveway_formats::Combined;
use giveway_solve::audit::AuditStatus;

use super::one_standard_input;
use crate::{
    args::{Audit, Common, Ruling},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input::{Source, foreign},
    output::{self, Said, files, report, text},
};
use plan::audited;

pub(crate) fn run(args: &Audit, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    one_standard_input(&args.files)?;
    if args.jsonl {
        return batch::run(args, common, clock);
    }
    let kind = args.report.as_deref().map(report_kind).transpose()?;
    let sources = args.files.iter().map(|path| Source::read(path));
    let sources = sources.collect::<Result<Vec<Source>, Failure>>()?;
    let combined = foreign::combine(&sources, wanted(args, common))?;
    let subject = only_plan(combined, args.ruling)?;
    let audited = audited(subject, args, common, clock)?;
    output::answer(common.format, &Said::default(), &audited.object(), |_| {
        text::audit(&audited)
    })?;
    if let (Some(path), Some(kind)) = (&args.report, kind) {
        let link = link(args, &audited);
        let text = report::write(kind, &audited, &command_line(args, common), &link)?;
        files::write_all(&[files::NewFile {
            path: path.clone(),
            text,
        }])?;
    }
    Ok(exit(audited.answer.status))
}

/// Where the report says that the plan can be opened: judged by the same costs there.
fn link(args: &Audit, audited: &report::Audited) -> report::Link {
    let mut scene = audited.instance.to_scene();
    if let Some(objective) = &args.objective {
        scene.objective = objective.clone();
    }
    report::Link::new(args.address.as_ref(), &scene, &audited.plan, &audited.notes)
}

/// How the files of a command line are combined.
fn wanted<'a>(args: &Audit, common: &'a Common) -> foreign::Wanted<'a> {
    foreign::Wanted {
        map: common.map.as_deref(),
        agents: args.first.agents,
        reading: args.reading,
        ruling: args.ruling,
    }
}

/// The one plan among the files, with its instance.
fn only_plan(mut combined: Combined, ruling: Ruling) -> Result<plan::Subject, Failure> {
    let plans = combined.plans.len();
    match combined.plans.pop() {
        Some(plan) if plans == 1 => {
            let mut notes = ruling.notes();
            notes.extend(combined.notes);
            Ok(plan::Subject {
                instance: combined.instance,
                notes,
                plan,
            })
        }
        None => Err(Failure::Refused(vec![
            "There is no plan in these files.".to_owned(),
        ])),
        Some(_) => Err(Failure::Usage(format!(
            "found {plans} plans, expected one; --jsonl audits each of them, and giveway compare \
             compares two"
        ))),
    }
}

/// The kind of a report by the ending of its file.
fn report_kind(path: &Path) -> Result<report::Kind, Failure> {
    report::Kind::of(path).ok_or_else(|| {
        Failure::Usage(format!(
            "found the report {}, expected a name that ends in .html, .md or .json",
            path.display()
        ))
    })
}

/// The command that makes the same audit again.
fn command_line(args: &Audit, common: &Common) -> String {
    let mut words = vec!["giveway".to_owned(), "audit".to_owned()];
    words.extend(args.files.iter().map(|path| quoted(path)));
    let mut option = |name: &str, value: Option<String>| {
        words.extend(value.map(|value| format!("--{name} {value}")));
    };
    option("map", common.map.as_deref().map(quoted));
    option(
        "objective",
        args.objective.as_ref().map(ToString::to_string),
    );
    option("agents", args.first.agents.map(|n| n.to_string()));
    option("within", args.within.map(|n| n.to_string()));
    for (name, value) in args
        .reading
        .chosen()
        .into_iter()
        .chain(args.ruling.chosen())
    {
        option(name, Some(value));
    }
    option("time-limit", Some(args.time_limit.to_string()));
    words.join(" ")
}

/// A path as a shell takes it.
fn quoted(path: &Path) -> String {
    let name = path.to_string_lossy();
    let plain = |c: char| c.is_alphanumeric() || "-_./+,=@".contains(c);
    if name.chars().all(plain) {
        name.into_owned()
    } else {
        format!("'{}'", name.replace('\'', "'\\''"))
    }
}

const fn exit(status: AuditStatus) -> Exit {
    match status {
        AuditStatus::Optimal | AuditStatus::Feasible => Exit::Answered,
        AuditStatus::Illegal => Exit::Wrong,
        AuditStatus::Unknown => Exit::Unknown,
    }
}
