//! The tracker's solutions in YAML: objects, lists of them, or several documents.

use std::borrow::Cow;
use std::fmt::Write as _;

use super::{Paths, Solution, Spot, plan};
use crate::format::foreign::limits::robots;
use crate::format::foreign::yaml::{Kind, Yaml};
use crate::format::foreign::{Up, WrittenPlan};
use crate::{Fault, tr, tr_later};

/// Where the plan of a solution is, as a fault without words, and where each path
/// of a list begins.
#[derive(Debug)]
struct Place {
    whole: Fault,
    paths: Vec<(usize, usize)>,
}

pub(super) fn read(text: &str) -> Result<WrittenPlan, Fault> {
    let mut yaml = Yaml::new(text);
    let mut solutions = Vec::new();
    let counted = |yaml: &Yaml<'_>, count| {
        super::solutions(count).map_err(|many| yaml.fault(many.found, many.expected))
    };
    while yaml.document()? {
        counted(&yaml, solutions.len() + 1)?;
        match yaml.kind()? {
            Kind::List => yaml.list(tr_later!("a list of solutions"), |yaml, _| {
                counted(yaml, solutions.len() + 1)?;
                solutions.push(solution(yaml)?);
                Ok(())
            })?,
            _ => solutions.push(solution(&mut yaml)?),
        }
    }
    plan(solutions, at)
}

/// Gives a fault the place of the path that it is in.
fn at(place: &Place, spot: Option<Spot>, fault: Fault) -> Fault {
    let mut whole = place.whole.clone();
    let Some(spot) = spot else {
        return Fault {
            found: fault.found,
            expected: fault.expected,
            ..whole
        };
    };
    let index = spot.text.unwrap_or_default();
    if let (Some(_), Some(&(line, column))) = (spot.text, place.paths.get(index)) {
        let _ = write!(whole.place, "[{index}]");
        whole = whole.in_text(line, column);
    }
    let letter = spot.byte + 1;
    let found = match spot.text {
        Some(_) => tr!(
            "{found} at letter {letter} of the path",
            found = fault.found,
            letter
        ),
        None => tr!(
            "{found} at letter {letter} of all paths",
            found = fault.found,
            letter
        ),
    };
    Fault {
        found,
        expected: fault.expected,
        ..whole
    }
}

fn solution<'a>(yaml: &mut Yaml<'a>) -> Result<Solution<'a, Place>, Fault> {
    let mut solution = Solution {
        place: Place {
            whole: yaml.fault("", ""),
            paths: Vec::new(),
        },
        map: None,
        scenario: None,
        agents: None,
        cost: None,
        up: Up::Lowers,
        paths: None,
    };
    let mut kind = None;
    let mut number = None;
    yaml.object(tr_later!("a solution"), |yaml, key| {
        match key {
            "map_name" => solution.map = yaml.optional(tr_later!("a name"))?.map(Cow::into_owned),
            "scen_type" => kind = yaml.optional(tr_later!("a word"))?,
            "type_id" => number = yaml.optional(tr_later!("a number"))?,
            "agents" => {
                solution.agents = Some(yaml.number::<u32>(tr_later!("a number from 0"))? as usize);
            }
            "solution_cost" => solution.cost = optional_number(yaml)?,
            "flip_up_down" => {
                let word = yaml.text(tr_later!("true or false"))?;
                if word.eq_ignore_ascii_case("true") {
                    solution.up = Up::Raises;
                } else if !word.eq_ignore_ascii_case("false") {
                    return Err(yaml.unlike(&word, tr_later!("true or false")));
                }
            }
            "solution_plan" => solution.paths = paths(yaml, &mut solution.place)?,
            _ => yaml.skip()?,
        }
        Ok(())
    })?;
    solution.scenario = kind
        .zip(number)
        .map(|(kind, number)| format!("{kind}-{number}"));
    Ok(solution)
}

fn optional_number(yaml: &mut Yaml<'_>) -> Result<Option<u64>, Fault> {
    let Some(text) = yaml.optional(tr_later!("a number from 0"))? else {
        return Ok(None);
    };
    match text.parse::<u32>() {
        Ok(number) => Ok(Some(u64::from(number))),
        Err(_) => Err(yaml.unlike(&text, tr_later!("a number from 0"))),
    }
}

fn paths<'a>(yaml: &mut Yaml<'a>, place: &mut Place) -> Result<Option<Paths<'a>>, Fault> {
    let expected = tr_later!("a text with a line for each robot, or a list of texts");
    if yaml.kind()? != Kind::List {
        let text = yaml.optional(expected)?;
        place.whole = yaml.fault("", "");
        return Ok(text.map(Paths::Lines));
    }
    place.whole = yaml.fault("", "");
    let mut texts = Vec::new();
    yaml.list(expected, |yaml, index| {
        robots(index + 1).map_err(|many| yaml.fault(many.found, many.expected))?;
        texts.push(yaml.text(tr_later!("the path of a robot"))?);
        place.paths.push(yaml.at());
        Ok(())
    })?;
    Ok(Some(Paths::List(texts)))
}
