//! A report as one page of HTML that needs nothing else.

use std::fmt::Write as _;

use giveway_solve::audit::AuditStatus;

use super::{Audited, Link, TOLD, svg, words};

/// How the page looks, on a screen, light or dark, and on paper.
const STYLE: &str = "
:root { color-scheme: light dark; --ink: #1b1f24; --paper: #fff; --line: #d0d5dc; --floor: #f3f5f8;
  --wall: #6b7480; --red: #c4281c; --green: #1a7f37; --amber: #8a5a00; --blue: #1f6feb;
  --slow: #d98a80; --yellow: #ffdc5e; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6eaef; --paper: #14171b; --line: #3a424d;
  --floor: #20252c; --wall: #7d8794; --red: #ff7b72; --green: #56d364; --amber: #e3b341; --blue: #79b8ff;
  --slow: #b06a60; --yellow: #e9bd35; } }
@media print { :root { --ink: #000; --paper: #fff; --line: #999; --floor: #fff; --wall: #777; }
  section { break-inside: avoid-page; } }
body { color: var(--ink); background: var(--paper); font: 16px/1.5 system-ui, sans-serif;
  max-width: 46rem; margin: 2rem auto; padding: 0 1rem; overflow-wrap: anywhere; }
h1 { font-size: 1.4rem; } h2 { font-size: 1.1rem; border-bottom: 1px solid var(--line); }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { text-align: right; padding: .2rem .4rem; border-bottom: 1px solid var(--line); }
th:first-child, td:first-child { text-align: left; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .2rem 1rem; }
dd { margin: 0; } dt { font-weight: 600; }
pre { white-space: pre-wrap; border: 1px solid var(--line); padding: .6rem; }
.verdict { font-size: 1.15rem; } .good { color: var(--green); } .bad { color: var(--red); }
.open { color: var(--amber); }
svg { width: 100%; max-height: 40rem; border: 1px solid var(--line); }
.floor { fill: var(--floor); } .wall { fill: var(--wall); } .start { fill: var(--blue); }
.slow { fill: url(#hatch); } .hatch { stroke: var(--slow); stroke-width: .08; } .charger { fill: var(--yellow); } .bolt { fill: #3a2d00; }
.goal { fill: none; stroke: var(--blue); stroke-width: .1; }
.broken { fill: var(--red); fill-opacity: .6; }
";

/// The whole page.
pub(super) fn page(audited: &Audited, command: &str, link: &Link) -> String {
    let answer = &audited.answer;
    let title = escaped(&audited.plan.file);
    let mut html = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}</title>\n\
         <style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
    );
    let colour = match answer.status {
        AuditStatus::Optimal => "good",
        AuditStatus::Illegal => "bad",
        AuditStatus::Feasible | AuditStatus::Unknown => "open",
    };
    let head = words::verdict(audited);
    let mut verdict = format!(
        "<p class=\"verdict\"><strong class=\"{colour}\">{}</strong>{}</p>\n",
        escaped(&head.word),
        escaped(&head.rest)
    );
    for note in &words::more_of(audited) {
        let _ = writeln!(verdict, "<p>{}</p>", escaped(note));
    }
    match link {
        Link::To(address) => {
            let (address, open) = (escaped(address), words::OPEN);
            let _ = writeln!(verdict, "<p><a href=\"{address}\">{open}</a></p>");
        }
        Link::TooLarge => {
            let _ = writeln!(verdict, "<p>{}</p>", words::NO_LINK);
        }
        Link::Nowhere => {}
    }
    section(&mut html, words::VERDICT, &verdict);
    section(&mut html, words::RECOGNISED, &recognised(audited));
    if !answer.violations.is_empty() {
        section(&mut html, words::VIOLATIONS, &violations(audited));
    }
    section(&mut html, words::COSTS, &costs(audited));
    let map = format!("{}\n<p>{}</p>\n", svg::map(audited), words::legend(audited));
    section(&mut html, words::MAP, &map);
    let again = format!("<pre>{}</pre>\n", escaped(command));
    section(&mut html, words::AGAIN, &again);
    html.push_str("</body>\n</html>\n");
    html
}

fn section(html: &mut String, heading: &str, content: &str) {
    let _ = write!(html, "<section>\n<h2>{heading}</h2>\n{content}</section>\n");
}

fn recognised(audited: &Audited) -> String {
    let mut html = "<dl>\n".to_owned();
    for (about, what) in words::recognised(audited) {
        let about = words::heading(&about);
        let _ = writeln!(
            html,
            "<dt>{}</dt><dd>{}</dd>",
            escaped(&about),
            escaped(&what)
        );
    }
    html + "</dl>\n"
}

fn violations(audited: &Audited) -> String {
    let violations = &audited.answer.violations;
    let mut html = "<ol>\n".to_owned();
    for violation in violations.iter().take(TOLD) {
        let _ = writeln!(html, "<li>{}</li>", escaped(&words::violation(violation)));
    }
    html.push_str("</ol>\n");
    if let Some(more) = words::more(violations) {
        let _ = writeln!(html, "<p>{more}</p>");
    }
    html
}

fn costs(audited: &Audited) -> String {
    let headings = words::COST_HEADINGS.map(|heading| format!("<th scope=\"col\">{heading}</th>"));
    let mut html = format!(
        "<table>\n<tr><th scope=\"col\">cost</th>{}</tr>\n",
        headings.concat()
    );
    for row in words::costs(audited) {
        let cell = |n: Option<u64>| n.map_or("-".to_owned(), |n| n.to_string());
        let cells = row.cells.map(|n| format!("<td>{}</td>", cell(n)));
        let _ = writeln!(html, "<tr><td>{}</td>{}</tr>", row.cost, cells.concat());
    }
    html.push_str("</table>\n");
    for claim in words::claims(audited) {
        let _ = writeln!(html, "<p>{}</p>", escaped(&claim));
    }
    html
}

/// A text that HTML shows as it is.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() => out.push(' '),
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
        assert_eq!(escaped("<b>\n\"&"), "&lt;b&gt; &quot;&amp;");
    }
}
