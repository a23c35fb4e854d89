//! The tracker's tables: values with commas between them, in quotes where they
//! hold commas or ends of lines (RFC 4180).

use std::borrow::Cow;

use super::{Paths, Solution, plan};
use crate::format::foreign::{Up, WrittenPlan};
use crate::format::text::{position, shorten};
use crate::{Fault, tr};

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
    let line = text.lines().next().unwrap_or("");
    let has = |name: &str| line.split(',').any(|column| bare(column) == name);
    line.len() < 4096 && (has("solution_plan") || has("path") && has("agents"))
}

fn bare(column: &str) -> &str {
    column.trim().trim_matches('"')
}

pub(super) fn read(text: &str) -> Result<WrittenPlan, Fault> {
    let mut at = 0;
    let columns: Vec<String> = record(text, &mut at)?
        .iter()
        .map(|field| field.text.trim().to_owned())
        .collect();
    let mut solutions = Vec::new();
    while at < text.len() {
        let begin = at;
        let fields = record(text, &mut at)?;
        if fields.len() == 1 && fields.iter().all(|field| field.text.trim().is_empty()) {
            continue;
        }
        if fields.len() != columns.len() {
            let found = tr!("{n} value" | "{n} values" % fields.len());
            let expected = tr!("{n}, as the first line has columns", n = columns.len());
            return Err(fault(text, begin, found, expected));
        }
        super::solutions(solutions.len() + 1).map_err(|many| {
            let (line, column) = position(text, begin);
            many.in_text(line, column)
        })?;
        let named = columns.iter().map(String::as_str).zip(fields);
        solutions.push(solution(text, named)?);
    }
    plan(solutions, |place, spot, fault| {
        let at = if place.is_exact {
            place.at + spot.map_or(0, |spot| spot.byte)
        } else {
            place.at
        };
        let (line, column) = position(text, at);
        fault.in_text(line, column)
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
    let mut solution = Solution {
        place: Place::default(),
        map: None,
        scenario: None,
        agents: None,
        cost: None,
        up: Up::Lowers,
        paths: None,
    };
    let mut kind = None;
    let mut number = None;
    let mut is_flipped = false;
    for (name, field) in fields {
        let is_old = name == "path";
        if name != "solution_plan" && !is_old && matches!(field.text.trim(), "" | "null") {
            continue;
        }
        match name {
            "map_name" => solution.map = Some(field.text.into_owned()),
            "scen_type" => kind = Some(field.text.into_owned()),
            "type_id" => number = Some(field.text.into_owned()),
            "agents" => solution.agents = Some(field.number(text)? as usize),
            "solution_cost" => solution.cost = Some(field.number(text)?),
            "flip_up_down" => {
                is_flipped |= field.flag(text)?;
            }
            "solution_plan" | "path" if !is_empty(&field, solution.agents) => {
                is_flipped |= is_old;
                solution.place = Place {
                    at: field.at,
                    is_exact: matches!(field.text, Cow::Borrowed(_)),
                };
                solution.paths = Some(Paths::Lines(field.text));
            }
            _ => {}
        }
    }
    solution.scenario = kind
        .zip(number)
        .map(|(kind, number)| format!("{kind}-{number}"));
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

impl Field<'_> {
    fn number(&self, text: &str) -> Result<u64, Fault> {
        let number = self.text.trim().parse::<u32>();
        number
            .map(u64::from)
            .map_err(|_| self.fault(text, tr!("a number from 0")))
    }

    fn flag(&self, text: &str) -> Result<bool, Fault> {
        let word = self.text.trim();
        if word.eq_ignore_ascii_case("true") {
            Ok(true)
        } else if word.eq_ignore_ascii_case("false") {
            Ok(false)
        } else {
            Err(self.fault(text, tr!("TRUE or FALSE")))
        }
    }

    fn fault(&self, text: &str, expected: &str) -> Fault {
        let found = format!("\"{}\"", shorten(&self.text));
        fault(text, self.at, found, expected)
    }
}

/// Reads the values of a line, whose end it passes over.
fn record<'a>(text: &'a str, at: &mut usize) -> Result<Vec<Field<'a>>, Fault> {
    let mut fields = Vec::new();
    loop {
        let rest = text.get(*at..).unwrap_or("");
        let field = if rest.starts_with('"') {
            quoted(text, at)?
        } else {
            let end = rest.find([',', '\n', '\r']).unwrap_or(rest.len());
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
        if rest.starts_with(',') {
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
    let open = *at;
    let begin = open + 1;
    let mut whole: Option<String> = None;
    let mut from = begin;
    loop {
        let rest = text.get(from..).unwrap_or("");
        let Some(length) = rest.find('"') else {
            let found = tr!("a quote without its end");
            return Err(fault(text, open, found, tr!("another quote")));
        };
        let part = rest.get(..length).unwrap_or("");
        from += length + 1;
        if text.get(from..).unwrap_or("").starts_with('"') {
            let whole = whole.get_or_insert_default();
            whole.push_str(part);
            whole.push('"');
            from += 1;
            continue;
        }
        *at = from;
        let text = match whole {
            None => Cow::Borrowed(part),
            Some(mut whole) => {
                whole.push_str(part);
                Cow::Owned(whole)
            }
        };
        return Ok(Field { text, at: begin });
    }
}

fn fault(text: &str, at: usize, found: impl Into<String>, expected: impl Into<String>) -> Fault {
    let (line, column) = position(text, at);
    Fault::at("", found, expected).in_text(line, column)
}
