//! The judgements of a class as text.

use std::fmt::Write as _;

use anstyle::{AnsiColor, Style};
use giveway_course::grade::{Claim, Class, Given, Graded, Judgement, Order, Row};
use giveway_course::lesson::Step;
use giveway_model::words::count;

use super::{bold, paint};
use crate::output::plain;

/// The most columns of a name.
const NAME: usize = 28;
/// The columns of a task.
const TASK: usize = 8;

/// A table for each lesson, what the class did with each task, and the files that were not
/// judged.
pub(crate) fn grade(class: &Class, order: Order, columns: usize) -> String {
    let mut text = String::new();
    for place in class.tables() {
        let Some(given) = class.lessons().get(place) else {
            continue;
        };
        let rows = class.rows(place, order);
        let handed = count(rows.len(), "hand-in");
        let _ = writeln!(
            text,
            "{}: {handed}\n",
            bold(&plain::text(&given.lesson.title))
        );
        text.push_str(&table(&rows, given));
        text.push('\n');
        text.push_str(&tasks(class, place, given));
        text.push_str(&wrong(class, place, given, columns));
        text.push_str(&reasons(&rows, given));
    }
    let unread = class.files().iter().filter_map(|file| {
        let words = file.unread()?.words();
        Some(format!(
            "  {}: {}\n",
            plain::text(&file.file),
            plain::text(&words)
        ))
    });
    let unread: String = unread.collect();
    if !unread.is_empty() {
        text = text + &bold("Not judged") + "\n" + &unread + "\n";
    }
    if class.is_cancelled() {
        text.push_str("Stopped before all was judged.\n");
    }
    text.push_str(&conclusion(class));
    text
}

fn table(rows: &[Row<'_>], given: &Given) -> String {
    let steps: Vec<usize> = given.tasks().collect();
    let named = |row: &Row<'_>| {
        let name = plain::cut(&plain::text(row.title()), NAME);
        match row.files().len() {
            0 | 1 => name,
            files => format!("{name} ({files} files)"),
        }
    };
    let names: Vec<String> = rows.iter().map(named).collect();
    let width = names.iter().map(|name| plain::width(name)).max();
    let width = width.unwrap_or(0).max("Who".len());
    let mut text = format!("  {}", plain::pad_right("Who", width));
    for number in 1..=steps.len() {
        let head = format!("task {number}");
        let _ = write!(text, "  {}", plain::pad_right(&head, TASK));
    }
    text.push_str("  solved\n");
    for (row, name) in rows.iter().zip(&names) {
        let _ = write!(text, "  {}", plain::pad_right(name, width));
        for step in &steps {
            let task = row.tasks().iter().find(|task| task.step == *step);
            let sign = task.map_or_else(String::new, sign);
            let colour = task.map_or(Style::new(), colour);
            let blanks = " ".repeat(TASK.saturating_sub(plain::width(&sign)));
            let _ = write!(text, "  {}{blanks}", paint(colour, &sign));
        }
        let _ = writeln!(text, "  {} of {}", row.solved(), steps.len());
    }
    text + "  yes solved, no not solved, FALSE says solved and is not, - not tried, ? not decided;\n  \
            the number is how often they tried, as the file says\n"
}

/// A task in a word, and the tries.
fn sign(task: &Graded) -> String {
    let word = match (task.claim(), task.judgement()) {
        (Claim::False, _) => "FALSE",
        (_, Some(Judgement::Solved(_))) => "yes",
        (_, Some(Judgement::NotSolved(_))) => "no",
        (_, Some(Judgement::NotTried)) => return "-".to_owned(),
        (_, Some(Judgement::Undecided(_)) | None) => "?",
    };
    format!("{word} {}", task.tries())
}

fn colour(task: &Graded) -> Style {
    match (task.claim(), task.judgement()) {
        (Claim::False, _) => AnsiColor::Red.on_default().bold(),
        (_, Some(Judgement::Solved(_))) => AnsiColor::Green.on_default(),
        (_, Some(Judgement::Undecided(_)) | None) => AnsiColor::Yellow.on_default(),
        (_, Some(Judgement::NotSolved(_) | Judgement::NotTried)) => Style::new(),
    }
}

/// The share of each task.
fn tasks(class: &Class, place: usize, given: &Given) -> String {
    let mut text = bold("Solved") + "\n";
    for share in class.shares(place) {
        let _ = write!(
            text,
            "  {}: {} of {}",
            task_words(given, share.step),
            share.solved,
            share.all()
        );
        let more = [
            (share.not_tried, "not tried"),
            (share.undecided + share.open, "not decided"),
            (share.false_claims, "said solved and not"),
        ];
        for (n, words) in more {
            if n > 0 {
                let _ = write!(text, ", {n} {words}");
            }
        }
        text.push('\n');
    }
    text + "\n"
}

/// The most common wrong answers, each with its reply.
fn wrong(class: &Class, place: usize, given: &Given, columns: usize) -> String {
    let all = class.wrong(place);
    if all.is_empty() {
        return String::new();
    }
    let mut text = bold("Most common wrong answers, first tries included") + "\n";
    let mut before = None;
    for wrong in &all {
        if before != Some(wrong.step) {
            let _ = writeln!(text, "  {}", task_words(given, wrong.step));
            before = Some(wrong.step);
        }
        let words = plain::text(&wrong.words);
        let line = plain::cut(&words, columns.saturating_sub(12));
        let _ = writeln!(text, "    {:>3}  {line}", wrong.count);
        if let Some(reply) = &wrong.reply {
            let reply = plain::text(&reply.plain());
            let _ = writeln!(
                text,
                "         {}",
                plain::cut(&reply, columns.saturating_sub(9))
            );
        }
    }
    text + "\n"
}

/// Why a claim is false, or what is not decided.
fn reasons(rows: &[Row<'_>], given: &Given) -> String {
    let none = Step::default();
    let mut text = String::new();
    for row in rows {
        for task in row.tasks() {
            let head = match (task.claim(), task.judgement()) {
                (Claim::False, _) => "says solved, is not",
                (_, Some(Judgement::Undecided(_))) => "not decided",
                _ => continue,
            };
            let step = given.lesson.steps.get(task.step).unwrap_or(&none);
            let reason = task.judgement().map(|judgement| judgement.reason(step));
            let reason = match reason.unwrap_or_default() {
                reason if reason.is_empty() => "Nothing was answered.".to_owned(),
                reason => reason,
            };
            let _ = writeln!(
                text,
                "  {}, {}: {head}. {}",
                plain::text(row.title()),
                task_words(given, task.step),
                plain::text(&reason)
            );
        }
    }
    if text.is_empty() {
        return text;
    }
    bold("Look at these") + "\n" + &text + "\n"
}

fn task_words(given: &Given, step: usize) -> String {
    let words = plain::text(&given.task_words(step));
    match given.number(step) {
        Some(_) => format!("task {words}"),
        None => words,
    }
}

fn conclusion(class: &Class) -> String {
    match class.false_claims() {
        _ if class.tables().is_empty() => "No file could be judged.\n".to_owned(),
        0 => "No claim is false.\n".to_owned(),
        1 => "1 claim is false.\n".to_owned(),
        n => format!("{n} claims are false.\n"),
    }
}
