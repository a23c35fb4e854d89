//! A report of an audit: a page, text, or an object for programs. It is written
//! by the reader, so that the page need not hold the words.

use std::fmt::Write as _;

use giveway_model::tr;
use serde_json::{Map, Value, json};

use super::Told;
use crate::intake::protocol::ReportKind;

/// The name of the file, and its text.
pub(crate) fn write(kind: ReportKind, told: &Told, link: &str) -> (String, String) {
    let stem = giveway_model::format::stem(&told.facts.file);
    match kind {
        ReportKind::Html => (format!("{stem}-report.html"), html(told, link)),
        ReportKind::Markdown => (format!("{stem}-report.md"), markdown(told, link)),
        ReportKind::Json => (format!("{stem}-report.json"), object(told)),
    }
}

fn title(told: &Told) -> String {
    tr!(
        "{file} on {scene}",
        file = told.facts.file,
        scene = told.scene
    )
}

fn verdict(told: &Told) -> String {
    let verdict = &told.facts.verdict;
    match verdict.detail.as_str() {
        "" => format!("{}.", verdict.word),
        detail => format!("{}: {detail}.", verdict.word),
    }
}

/// The rows of both kinds of text: title, what, why.
fn facts(told: &Told) -> Vec<[String; 3]> {
    let facts = &told.facts;
    let mut rows = vec![[tr!("Plan").to_owned(), facts.extent.clone(), String::new()]];
    for fact in &facts.facts {
        rows.push([fact.title.clone(), fact.what.clone(), fact.why.clone()]);
    }
    rows
}

/// Every broken rule, by time.
fn broken(told: &Told) -> impl Iterator<Item = (u32, &str)> {
    let all = told.violations.iter();
    all.map(|violation| (violation.time, violation.message.as_str()))
}

fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;").replace('"', "&quot;")
}

fn html(told: &Told, link: &str) -> String {
    let title = escaped(&title(told));
    let mut text = format!(
        "<!doctype html>\n<html lang=\"{}\">\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n\
         :root {{ color-scheme: light dark }}\n\
         body {{ max-width: 44rem; margin: 2rem auto; padding: 0 1rem; font: 16px/1.5 system-ui, sans-serif }}\n\
         th, td {{ padding: 0.3rem 1rem 0.3rem 0; text-align: left; vertical-align: top }}\n\
         </style>\n<h1>{title}</h1>\n<p><strong>{}</strong> {}</p>\n",
        tr!("the tag of the language" => "en"),
        escaped(&verdict(told)),
        escaped(&told.facts.verdict.sentence),
    );
    // Writing to a string cannot fail.
    let _ = writeln!(
        text,
        "<p><a href=\"{}\">{}</a></p>",
        escaped(link),
        tr!("Open it in Giveway")
    );
    let _ = writeln!(text, "<h2>{}</h2>\n<table>", tr!("How it was read"));
    for [title, what, why] in facts(told) {
        let _ = writeln!(
            text,
            "<tr><th scope=\"row\">{}</th><td>{}<br><small>{}</small></td></tr>",
            escaped(&title),
            escaped(&what),
            escaped(&why)
        );
    }
    text += "</table>\n";
    if !told.facts.costs.is_empty() {
        let _ = writeln!(
            text,
            "<h2>{}</h2>\n<table>\n<tr><td></td><th scope=\"col\">{}</th><th scope=\"col\">{}</th></tr>",
            tr!("Costs"),
            tr!("This plan"),
            tr!("At least")
        );
        for row in &told.facts.costs {
            let least = row
                .least
                .map_or_else(String::new, |least| least.to_string());
            let _ = writeln!(
                text,
                "<tr><th scope=\"row\">{}</th><td>{}</td><td>{least}</td></tr>",
                escaped(&row.title),
                row.this
            );
        }
        text += "</table>\n";
    }
    if !told.violations.is_empty() {
        let _ = writeln!(text, "<h2>{}</h2>\n<ul>", tr!("What goes wrong"));
        for (time, message) in broken(told) {
            let told = tr!("Time {time}: {message}", time, message = escaped(message));
            let _ = writeln!(text, "<li>{told}</li>");
        }
        text += "</ul>\n";
    }
    for note in &told.facts.notes {
        let _ = writeln!(text, "<p>{}</p>", escaped(note));
    }
    text + "</html>\n"
}

/// Text in which Markdown finds nothing of its own.
fn plain(text: &str) -> String {
    let mut plain = String::new();
    for letter in text.chars() {
        if matches!(
            letter,
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '|' | '#' | '&'
        ) {
            plain.push('\\');
        }
        plain.push(if letter == '\n' { ' ' } else { letter });
    }
    plain
}

fn markdown(told: &Told, link: &str) -> String {
    let mut text = format!(
        "# {}\n\n**{}** {}\n\n[{}](<{link}>)\n\n",
        plain(&title(told)),
        plain(&verdict(told)),
        plain(&told.facts.verdict.sentence),
        tr!("Open it in Giveway")
    );
    text += "| | | |\n|---|---|---|\n";
    for row in facts(told) {
        let row = row.map(|cell| plain(&cell));
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| {} |", row.join(" | "));
    }
    if !told.facts.costs.is_empty() {
        let _ = writeln!(
            text,
            "\n| {} | {} | {} |\n|---|---|---|",
            tr!("a column of a report" => "cost"),
            tr!("a column of a report" => "this plan"),
            tr!("a column of a report" => "at least")
        );
        for row in &told.facts.costs {
            let least = row
                .least
                .map_or_else(String::new, |least| least.to_string());
            let _ = writeln!(text, "| {} | {} | {least} |", plain(&row.title), row.this);
        }
    }
    if !told.violations.is_empty() {
        let _ = writeln!(
            text,
            "\n{}:\n",
            tr!("{n} broken rule" | "{n} broken rules" % told.violations.len())
        );
        for (time, message) in broken(told) {
            let told = tr!("Time {time}: {message}", time, message = plain(message));
            let _ = writeln!(text, "- {told}");
        }
    }
    for note in &told.facts.notes {
        let _ = writeln!(text, "\n{}", plain(note));
    }
    text
}

/// What programs want: the same object that `giveway audit` writes.
fn object(told: &Told) -> String {
    let file = &told.file;
    let words = file.words.iter();
    let conventions: Map<String, Value> = words
        .map(|(about, how)| (about.clone(), Value::from(how.as_str())))
        .collect();
    let is_legal = told.violations.is_empty();
    let status = match (is_legal, told.is_best, told.bounds.is_empty()) {
        (false, ..) => "illegal",
        (true, true, _) => "optimal",
        (true, false, _) => "feasible",
    };
    let first = told.facts.costs.first();
    let gap = first.and_then(|row| {
        let (this, least) = (f64::from(row.this), f64::from(row.least?));
        Some((this - least) / least.max(1.0))
    });
    let object = json!({
        "giveway": 1,
        "file": file.file,
        "format": file.format.name(),
        "conventions": conventions,
        "why": file.why,
        "agents": file.plan.paths.len(),
        "legal": is_legal,
        "violations": told.violations,
        "costs": told.costs,
        "claimed": file.claimed,
        "bounds": told.bounds,
        "status": status,
        "gap": gap,
        "better": told.better,
    });
    let text = serde_json::to_string_pretty(&object);
    text.unwrap_or_default() + "\n"
}
