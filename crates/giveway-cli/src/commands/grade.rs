//! `giveway grade`: a class's hand-ins, each judged anew.

mod course;

use std::fs;
use std::path::Path;
use std::time::UNIX_EPOCH;

use giveway_course::grade::{Class, Next, Report, csv::csv};
use giveway_course::handin::link;
use giveway_model::{Fault, Objective};
use giveway_solve::serve;

use super::one_standard_input;
use crate::{
    args::{Common, Grade},
    clock::Clock,
    exit::Exit,
    failure::Failure,
    input::{Source, is_standard_input},
    interrupt,
    output::{self, Said, text},
    progress::{CommandHost, StepLine},
};

pub(crate) fn run(args: &Grade, common: &Common, clock: Clock) -> Result<Exit, Failure> {
    one_standard_input(args.files.iter().chain(&args.lessons))?;
    let mut class = Class::new(course::lessons(&args.lessons)?);
    class.allow_work(args.work_limit);
    for file in &args.files {
        add(&mut class, file);
    }
    judge(&mut class, common, clock);
    let order = args.order.into();
    if args.csv {
        output::stream::result(&csv(&class, order))?;
    } else {
        let report = Report::of(&class, order);
        output::answer(common.format, &Said::default(), &report, |columns| {
            text::grade(&class, order, columns)
        })?;
    }
    let is_wrong = class.false_claims() > 0 || class.tables().is_empty();
    Ok(if is_wrong {
        Exit::Wrong
    } else {
        Exit::Answered
    })
}

/// Adds a file, or each link of a list. What cannot be read is told with the rest.
fn add(class: &mut Class, path: &Path) {
    let name = path.to_string_lossy();
    let source = match Source::read(path) {
        Ok(source) => source,
        Err(Failure::Input { faults, .. }) => {
            let none = || Fault::at("", "a file that cannot be read", "a hand-in");
            let fault = faults.into_iter().next().unwrap_or_else(none);
            return class.add_unreadable(&name, fault);
        }
        // Reading a file fails in no other way.
        Err(_) => return,
    };
    let lines = || source.text.lines().map(str::trim);
    let links: Vec<(usize, &str)> = (1..)
        .zip(lines())
        .filter(|(_, it)| !it.is_empty())
        .collect();
    let is_list = !links.is_empty() && links.iter().all(|(_, it)| link::letters(it).is_some());
    if !is_list {
        return class.add(&source.name, date(path), &source.text);
    }
    for (line, link) in links {
        class.add(&format!("{}:{line}", source.name), None, link);
    }
}

/// When a file was changed last, in milliseconds.
fn date(path: &Path) -> Option<u64> {
    if is_standard_input(path) {
        return None;
    }
    let changed = fs::metadata(path).ok()?.modified().ok()?;
    let since = changed.duration_since(UNIX_EPOCH).ok()?;
    u64::try_from(since.as_millis()).ok()
}

/// Asks the solver what the judges ask, until all is judged or Ctrl-C is pressed.
fn judge(class: &mut Class, common: &Common, clock: Clock) {
    let mut line = StepLine::new(clock, common.quiet);
    let host = CommandHost::new(clock, true, Objective::default());
    loop {
        if interrupt::happened() {
            class.cancel();
        }
        let progress = class.progress();
        line.show(|| format!("Judging {} of {} ...", progress.done + 1, progress.all));
        match class.step() {
            Next::Ask { number, request } => {
                let response = serve(&request, &host);
                class.answered(number, response);
            }
            Next::Again => {}
            Next::Done => break,
        }
    }
    line.clear();
    host.finish();
}
