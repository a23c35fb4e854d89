//! The tracker's tables: values with commas between them, in quotes where they
//! hold commas or ends of lines (RFC 4180).

use std::borrow::Cow;

use super::{Paths, Solution, expected, note_unknown, plan};
use crate::{Up, WrittenPlan};
use giveway_model::format::text::{at_byte, shorten};
use giveway_model::{Fault, tr, tr_later};

/// The most columns of a table.
const MAX_COLUMNS: usize = 64;

/// A value, and the byte at which it begins, after its quote.
#[derive(Clone, Debug)]
struct Field<'a> {
    text: Cow<'a, str>,
    at: usize,
}

/// Whether the first line names a column of plans.
pub(super) fn sniff(text: &str) -> bool {
    separator(text).is_some()
}

/// The separator of the columns, if the first line names a column of plans: a comma, or the mark that a
/// spreadsheet writes instead.
fn separator(text: &str) -> Option<char> {
    let line = table(text).lines().next().unwrap_or("");
    [',', ';', '\t'].into_iter().find(|&separator| {
        let has = |name: &str| line.split(separator).any(|column| bare(column) == name);
        line.len() < 4096 && (has("solution_plan") || has("path") && has("agents"))
    })
}

/// The text without a first line `sep=;`, which tells a spreadsheet what stands between columns.
fn table(text: &str) -> &str {
    let Some(rest) = text.strip_prefix("sep=") else {
        return text;
    };
    rest.split_once('\n').map_or(text, |(_, table)| table)
}

fn bare(column: &str) -> &str {
    column.trim().trim_matches('"')
}

pub(super) fn read(text: &str) -> Result<WrittenPlan, Fault> {
    let separator = separator(text).unwrap_or(',');
    match unwrapped(text, separator)? {
        Some(lines) => read_table(&lines, 0, separator),
        None => read_table(text, text.len() - table(text).len(), separator),
    }
}

/// The lines of a table in which each whole line is one value in quotes, as a spreadsheet
/// writes it that took the lines for a single column; `None` where that is not so.
fn unwrapped(text: &str, separator: char) -> Result<Option<String>, Fault> {
    let mut at = text.len() - table(text).len();
    let mut lines = String::new();
    while at < text.len() {
        let fields = record(text, &mut at, separator)?;
        let [line] = fields.as_slice() else {
            return Ok(None);
        };
        lines.push_str(&line.text);
        lines.push('\n');
    }
    Ok(Some(lines).filter(|lines| lines.contains(separator)))
}

/// Reads a table from a byte on.
fn read_table(text: &str, begin: usize, separator: char) -> Result<WrittenPlan, Fault> {
    let mut at = begin;
    let columns: Vec<String> = record(text, &mut at, separator)?
        .iter()
        .map(|field| field.text.trim().to_owned())
        .collect();
    let mut solutions = Vec::new();
    while at < text.len() {
        let begin = at;
        let fields = record(text, &mut at, separator)?;
        if fields.len() == 1 && fields.iter().all(|field| field.text.trim().is_empty()) {
            continue;
        }
        if fields.len() != columns.len() {
            let found = tr!("{n} value" | "{n} values" % fields.len());
            let expected = tr!("{n}, as the first line has columns", n = columns.len());
            return Err(fault(text, begin, found, expected));
        }
        super::solutions(solutions.len() + 1).map_err(|many| at_byte(text, begin, many))?;
        let named = columns.iter().map(String::as_str).zip(fields);
        solutions.push(solution(text, named)?);
    }
    plan(solutions, |place, spot, fault| {
        let byte = spot.filter(|_| place.is_exact).map_or(0, |spot| spot.byte);
        at_byte(text, place.at + byte, fault)
    })
}

/// Where the plan of a solution begins.
#[derive(Debug, Default)]
struct Place {
    at: usize,
    /// Whether it stands there byte by byte.
    is_exact: bool,
}

fn solution<'a, 'b>(
    text: &'a str,
    fields: impl Iterator<Item = (&'b str, Field<'a>)>,
) -> Result<Solution<'a, Place>, Fault> {
    let mut solution = Solution::new(Place::default());
    let mut is_flipped = false;
    for (name, field) in fields {
        match name {
            "solution_plan" | "path" if is_empty(&field, solution.agents) => {}
            "solution_plan" | "path" => {
                is_flipped |= name == "path";
                solution.place = Place {
                    at: field.at,
                    is_exact: matches!(field.text, Cow::Borrowed(_)),
                };
                solution.paths = Some(Paths::Lines(field.text));
            }
            _ if matches!(field.text.trim(), "" | "null") => {}
            _ => {
                let is_flag = name == "flip_up_down";
                let written = is_flag.then_some(tr_later!("TRUE or FALSE"));
                let Some(expected) = written.or(expected(name)) else {
                    note_unknown(&mut solution.unknown, name);
                    continue;
                };
                let found = || format!("\"{}\"", shorten(&field.text));
                let is_taken = solution.take(name, &field.text);
                is_taken.ok_or_else(|| fault(text, field.at, found(), expected))?;
            }
        }
    }
    if is_flipped {
        solution.up = Up::Raises;
    }
    Ok(solution)
}

/// Whether there is no plan: what one robot that does not move looks like, too, if
/// the file says that there is one.
fn is_empty(field: &Field<'_>, agents: Option<usize>) -> bool {
    matches!(&*field.text, "" | "null") && agents != Some(1)
}

/// Reads the values of a line, whose end it passes over.
fn record<'a>(text: &'a str, at: &mut usize, separator: char) -> Result<Vec<Field<'a>>, Fault> {
    let mut fields = Vec::new();
    loop {
        let rest = text.get(*at..).unwrap_or("");
        let field = if rest.starts_with('"') {
            quoted(text, at)?
        } else {
            let end = rest.find([separator, '\n', '\r']).unwrap_or(rest.len());
            let field = Field {
                text: Cow::Borrowed(rest.get(..end).unwrap_or("")),
                at: *at,
            };
            *at += end;
            field
        };
        if fields.len() == MAX_COLUMNS {
            let found = tr!("over {most} values", most = MAX_COLUMNS);
            let expected = tr!("at most {most}", most = MAX_COLUMNS);
            return Err(fault(text, field.at, found, expected));
        }
        fields.push(field);
        let rest = text.get(*at..).unwrap_or("");
        if rest.starts_with(separator) {
            *at += 1;
            continue;
        }
        let ends = ["\r\n", "\n", "\r"];
        let end = ends.into_iter().find(|end| rest.starts_with(end));
        match end {
            Some(end) => *at += end.len(),
            None if rest.is_empty() => {}
            None => {
                let found: String = rest.chars().take(9).collect();
                let found = tr!("\"{found}\" after a quote", found = shorten(&found));
                return Err(fault(
                    text,
                    *at,
                    found,
                    tr!("a comma or the end of the line"),
                ));
            }
        }
        return Ok(fields);
    }
}

/// Reads a value in quotes, in which two quotes are one.
fn quoted<'a>(text: &'a str, at: &mut usize) -> Result<Field<'a>, Fault> {
    let begin = *at + 1;
    let mut end = begin;
    loop {
        let rest = text.get(end..).unwrap_or("");
        let Some(length) = rest.find('"') else {
            let found = tr!("a quote without its end");
            return Err(fault(text, *at, found, tr!("another quote")));
        };
        end += length;
        if !text.get(end..).unwrap_or("").starts_with("\"\"") {
            break;
        }
        end += 2;
    }
    *at = end + 1;
    let part = text.get(begin..end).unwrap_or("");
    let text = if part.contains('"') {
        Cow::Owned(part.replace("\"\"", "\""))
    } else {
        Cow::Borrowed(part)
    };
    Ok(Field { text, at: begin })
}

fn fault(text: &str, at: usize, found: impl Into<String>, expected: impl Into<String>) -> Fault {
    at_byte(text, at, Fault::at("", found, expected))
}
