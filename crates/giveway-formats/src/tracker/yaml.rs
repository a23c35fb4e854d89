//! The tracker's solutions in YAML: objects, lists of them, or several documents.

use std::fmt::Write as _;

use super::{Paths, Solution, Spot, expected, note_unknown, plan};
use crate::WrittenPlan;
use crate::limits::robots;
use crate::yaml::{Kind, Yaml};
use giveway_model::{Fault, tr, tr_later};

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
    let (letter, found) = (spot.byte + 1, fault.found);
    let found = match spot.text {
        Some(_) => tr!("{found} at letter {letter} of the path", found, letter),
        None => tr!("{found} at letter {letter} of all paths", found, letter),
    };
    Fault {
        found,
        expected: fault.expected,
        ..whole
    }
}

fn solution<'a>(yaml: &mut Yaml<'a>) -> Result<Solution<'a, Place>, Fault> {
    let mut solution = Solution::new(Place {
        whole: yaml.fault("", ""),
        paths: Vec::new(),
    });
    yaml.object(tr_later!("a solution"), |yaml, key| {
        if key == "solution_plan" {
            solution.paths = paths(yaml, &mut solution.place)?;
        } else if let Some(expected) = expected(key) {
            let text = match key {
                "agents" | "flip_up_down" => Some(yaml.text(expected)?),
                _ => yaml.optional(expected)?,
            };
            if let Some(text) = text {
                let is_taken = solution.take(key, &text);
                is_taken.ok_or_else(|| yaml.unlike(&text, expected))?;
            }
        } else {
            note_unknown(&mut solution.unknown, key);
            yaml.skip()?;
        }
        Ok(())
    })?;
    Ok(solution)
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
