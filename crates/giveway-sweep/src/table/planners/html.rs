//! The report: one page of HTML that needs nothing else, without scripts, black on white.

use std::fmt::Write as _;

use super::line::{Kind, Line};
use super::looks::look_of;
use super::plot::{gaps, solved};
use super::words::{FOOT, claim, runs, scope, shared};
use super::{Comparison, Gap};
use crate::table::html::escaped;

const STYLE: &str = include_str!("planners.css");
const TITLE: &str = "Planners beside the proof";
const BRAND: &str = "<span class=\"brand\"><svg viewBox=\"0 0 24 24\" aria-hidden=\"true\"><path d=\"M3.6 5.2h16.8L12 19.6Z\" fill=\"none\" stroke=\"#111\" stroke-width=\"3.4\" stroke-linejoin=\"round\"/></svg><b>Giveway</b></span>";

/// The page, with a sheet for each objective.
pub(in crate::table) fn page(comparisons: &[Comparison]) -> String {
    let mut html = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{TITLE}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n"
    );
    for comparison in comparisons {
        sheet(&mut html, comparison);
    }
    html + "</body>\n</html>\n"
}

fn sheet(html: &mut String, comparison: &Comparison) {
    let (bold, rest) = claim(comparison);
    let bad = comparison.contradictions.iter();
    let bad: Vec<String> = bad
        .map(|sentence| format!("<p class=\"bad\">{}</p>", escaped(sentence)))
        .collect();
    let bad = bad.concat();
    let _ = writeln!(
        html,
        "<article class=\"sheet\">\n<header><div><h1>{TITLE}</h1><p class=\"sub\">{}</p></div>{BRAND}</header>\n<div class=\"claim\"><p><b>{bold}</b> {rest}</p>{bad}</div>",
        escaped(&scope(comparison))
    );
    table(html, comparison);
    let of = comparison.instances;
    let _ = writeln!(
        html,
        "<p class=\"note\">{}</p>\n<div class=\"plots\">\n<figure><figcaption><b>Solved within a time</b><span>legal plans, of {of}</span></figcaption>\n{}</figure>\n<figure><figcaption><b>Gap to the best</b><span>median of the legal plans</span></figcaption>\n{}</figure>\n</div>",
        shared(comparison),
        solved(comparison),
        gaps(comparison)
    );
    if !comparison.first.is_empty() {
        html.push_str("<section>\n<h2>What went wrong, the first of each kind</h2>\n<dl>\n");
        for first in &comparison.first {
            let mut kind = first.kind.to_owned();
            if let Some(letter) = kind.get_mut(..1) {
                letter.make_ascii_uppercase();
            }
            let _ = writeln!(
                html,
                "<div><dt>{kind}</dt><dd><b>{}</b>, {}: {}</dd></div>",
                escaped(&first.planner),
                escaped(&first.place),
                escaped(&first.how)
            );
        }
        html.push_str("</dl>\n</section>\n");
    }
    let _ = writeln!(
        html,
        "<footer><span>{}</span><span>{FOOT}</span></footer>\n</article>",
        runs(comparison)
    );
}

/// The table: a line for each planner.
fn table(html: &mut String, comparison: &Comparison) {
    let lines: Vec<&Line> = comparison.lines.iter().collect();
    let kinds = Kind::columns_of(&lines);
    let _ = write!(
        html,
        "<div class=\"tw\"><table class=\"ptab\">\n<thead><tr class=\"g1\"><th></th><th colspan=\"3\">Legal plans</th><th colspan=\"3\" class=\"b\">Gap to the best</th><th colspan=\"{}\" class=\"b\">Failed</th></tr>\n<tr><th scope=\"col\">Planner</th><th scope=\"col\" class=\"sv\">of {}</th><th scope=\"col\">half within</th><th scope=\"col\">9 of 10 within</th><th scope=\"col\" class=\"b\">at the best</th><th scope=\"col\">median</th><th scope=\"col\">largest</th>",
        kinds.len(),
        comparison.instances
    );
    for (index, kind) in kinds.iter().enumerate() {
        let class = if index == 0 { " class=\"b\"" } else { "" };
        let _ = write!(html, "<th scope=\"col\"{class}>{}</th>", kind.word());
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for (index, line) in lines.iter().enumerate() {
        row(html, index, line, comparison, &kinds);
    }
    html.push_str("</tbody>\n</table></div>\n");
}

fn row(html: &mut String, index: usize, line: &Line, comparison: &Comparison, kinds: &[Kind]) {
    let own = line
        .is_reference
        .then(|| "proved, not only legal".to_owned());
    let about = line.about.clone().or(own);
    let about = about.map_or_else(String::new, |about| {
        format!("<small>{}</small>", escaped(&about))
    });
    let share = 100.0 * line.solved as f64 / comparison.instances.max(1) as f64;
    let seconds = |seconds: Option<f64>| {
        seconds.map_or_else(|| "–".to_owned(), |seconds| format!("{seconds:.2} s"))
    };
    let gap = |gap: Option<Gap>| gap.map_or_else(|| "–".to_owned(), |gap| format!("{gap} %"));
    let class = if line.is_reference {
        " class=\"ref\""
    } else {
        ""
    };
    let _ = write!(
        html,
        "<tr{class}><th scope=\"row\"><div>{}<span><b>{}</b>{about}</span></div></th><td class=\"sv\"><span class=\"bar\"><i style=\"width: {share:.1}%\"></i></span><b>{}</b></td><td>{}</td><td>{}</td><td class=\"b\">{}</td><td>{}</td><td>{}</td>",
        look_of(index).piece(line.is_reference),
        escaped(&line.name),
        line.solved,
        seconds(line.half),
        seconds(line.nine_of_ten),
        line.at_best,
        gap(line.median),
        gap(line.largest),
    );
    for (index, kind) in kinds.iter().enumerate() {
        let first = if index == 0 { " b" } else { "" };
        let _ = match line.failed.get(kind) {
            None => write!(html, "<td class=\"f z{first}\">–</td>"),
            Some(count) => write!(html, "<td class=\"f{first}\">{count}</td>"),
        };
    }
    html.push_str("</tr>\n");
}
