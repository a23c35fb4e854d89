//! A report as Markdown.

use std::fmt::Write as _;

use super::{Audited, Link, TOLD, words};

/// The whole report.
pub(super) fn text(audited: &Audited, command: &str, link: &Link) -> String {
    let answer = &audited.answer;
    let mut text = format!("# {}\n\n", escaped(&audited.plan.file));
    let head = words::verdict(audited);
    let _ = writeln!(text, "**{}**{}\n", escaped(&head.word), escaped(&head.rest));
    for note in &words::more_of(audited) {
        let _ = writeln!(text, "{}\n", escaped(note));
    }
    match link {
        Link::To(address) => {
            let _ = writeln!(text, "[{}](<{address}>)\n", words::OPEN);
        }
        Link::TooLarge => {
            let _ = writeln!(text, "{}\n", words::NO_LINK);
        }
        Link::Nowhere => {}
    }
    section(&mut text, words::RECOGNISED);
    for (about, what) in words::recognised(audited) {
        let _ = writeln!(
            text,
            "- {}: {}",
            escaped(&words::heading(&about)),
            escaped(&what)
        );
    }
    if !answer.violations.is_empty() {
        section(&mut text, words::VIOLATIONS);
        for violation in answer.violations.iter().take(TOLD) {
            let _ = writeln!(text, "- {}", escaped(&words::violation(violation)));
        }
        if let Some(more) = words::more(&answer.violations) {
            let _ = writeln!(text, "- {more}");
        }
    }
    section(&mut text, words::COSTS);
    let _ = writeln!(text, "| cost | {} |", words::COST_HEADINGS.join(" | "));
    text.push_str("|---|--:|--:|--:|--:|\n");
    for row in words::costs(audited) {
        let cells = row
            .cells
            .map(|n| n.map_or("-".to_owned(), |n| n.to_string()));
        let _ = writeln!(text, "| {} | {} |", row.cost, cells.join(" | "));
    }
    for claim in words::claims(audited) {
        let _ = writeln!(text, "\n{}", escaped(&claim));
    }
    section(&mut text, words::AGAIN);
    let _ = writeln!(text, "    {}", command.replace(['\n', '\r'], " "));
    text
}

fn section(text: &mut String, heading: &str) {
    let _ = writeln!(text, "\n## {heading}\n");
}

/// A text that Markdown shows as it is, in one line.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            c if c.is_control() => out.push(' '),
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '#' | '|' | '~' => {
                out.push('\\');
                out.push(c);
            }
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files_make_no_markup() {
        assert_eq!(escaped("a_b*\n<i>"), "a\\_b\\* \\<i\\>");
    }
}
