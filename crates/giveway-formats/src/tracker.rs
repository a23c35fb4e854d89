//! Plans of the MAPF tracker: a string of letters for each robot.
//!
//! ```text
//!   path = { [ run length ] letter }      "5r2d3w"; one step has no run length
//!   letter = "u" | "d" | "l" | "r" | "w"
//!   plan = path { end path }, or a list of paths in JSON and YAML
//! ```
//!
//! A solution is an object, or a line of a CSV file, whose columns its first line
//! names: `map_name`, `scen_type`, `type_id`, `agents`, `solution_plan`, and, not
//! always, `lower_cost`, `solution_cost`, `flip_up_down`. A file has one solution or
//! more: lines, a list, documents of YAML. Older files have `path` instead of
//! `solution_plan`, and no name of the map.
//!
//! Sources: `client/src/docs/JSONSchema.mdx` and `format.mdx`,
//! `server/src/validation/submissionRequestValidatorWorker.ts` (what is accepted) and
//! `server/src/controllers/bulk.worker.ts` (what can be downloaded) of
//! ShortestPathLab/mapf-tracker.
//!
//! `u` is `y - 1`, and `y + 1` where `flip_up_down` is true, as in all that is
//! downloaded, and in older files. Robots are in the order of the scenario, which
//! also has their starts. `solution_cost` is the number of all letters.

mod csv;
mod json;
mod moves;
mod write;
mod yaml;

use crate::limits::refuse;
use std::borrow::Cow;

pub(super) use write::write;

use super::limits::{Steps, robots};
use super::unknown_keys::UnknownKeys;
use super::{Conventions, Held, Up, Walk, WrittenAgent, WrittenAt, WrittenPlan};
use giveway_model::compare::{Claimed, ClaimedBounds};
use giveway_model::words::{Later, count};
use giveway_model::{Fault, tr, tr_later};

/// Whether a text is JSON or YAML with a `solution_plan`, or a table with one.
pub(super) fn sniff(text: &str) -> bool {
    if text.trim_start().starts_with(['{', '[']) && text.contains("\"solution_plan\"") {
        !text.contains("\"giveway\"")
    } else {
        csv::sniff(text) || text.contains("solution_plan")
    }
}

/// Reads the largest solution of a file.
pub(super) fn read(text: &str) -> Result<Held, Fault> {
    let plan = if text.trim_start().starts_with(['{', '[']) {
        // A text that is not JSON may be YAML in flow style.
        json::read(text).or_else(|fault| yaml::read(text).map_err(|_| fault))
    } else if csv::sniff(text) {
        csv::read(text)
    } else {
        yaml::read(text)
    };
    plan.map(Held::Plan)
}

/// The paths of a solution, as they are written.
#[derive(Debug)]
enum Paths<'a> {
    /// One text with a line for each.
    Lines(Cow<'a, str>),
    /// A text for each.
    List(Vec<Cow<'a, str>>),
}

/// The most solutions of a file; a scenario has one for each number of robots.
const MAX_SOLUTIONS: usize = 4096;

/// Whether there is room for so many solutions.
fn solutions(count: usize) -> Result<(), Fault> {
    if count > MAX_SOLUTIONS {
        let found = tr!("over {most} solutions", most = MAX_SOLUTIONS);
        return refuse(found, tr!("at most {most}", most = MAX_SOLUTIONS));
    }
    Ok(())
}

/// A solution of a file; `P` is what its reader knows of its place.
#[derive(Debug)]
struct Solution<'a, P> {
    place: P,
    map: Option<String>,
    /// The kind of the scenario, and its number.
    scenario: (Option<String>, Option<String>),
    agents: Option<usize>,
    cost: Option<u64>,
    bounds: ClaimedBounds,
    unknown: UnknownKeys,
    up: Up,
    paths: Option<Paths<'a>>,
}

/// The expected content of a key other than the plan; `None` for keys that are not read.
fn expected(key: &str) -> Option<Later> {
    match key {
        "map_name" => Some(tr_later!("a name")),
        "scen_type" => Some(tr_later!("a word")),
        "type_id" => Some(tr_later!("a number")),
        "agents" | "lower_cost" | "solution_cost" => Some(tr_later!("a number from 0")),
        "flip_up_down" => Some(tr_later!("true or false")),
        _ => None,
    }
}

impl<P> Solution<'_, P> {
    /// A solution of which nothing is known.
    fn new(place: P) -> Self {
        Self {
            place,
            map: None,
            scenario: (None, None),
            agents: None,
            cost: None,
            bounds: ClaimedBounds::default(),
            unknown: UnknownKeys::default(),
            up: Up::Lowers,
            paths: None,
        }
    }

    /// Takes the text of a key that is read; `None` where it is not as expected.
    fn take(&mut self, key: &str, text: &str) -> Option<()> {
        let word = text.trim();
        let number = || word.parse::<u32>().ok();
        match key {
            "map_name" => self.map = Some(text.to_owned()),
            "scen_type" => self.scenario.0 = Some(text.to_owned()),
            "type_id" => self.scenario.1 = Some(text.to_owned()),
            "agents" => self.agents = Some(number()? as usize),
            "lower_cost" => self.bounds.sum_of_costs = Some(number()?.into()),
            "solution_cost" => self.cost = Some(number()?.into()),
            _ if word.eq_ignore_ascii_case("true") => self.up = Up::Raises,
            _ if word.eq_ignore_ascii_case("false") => {}
            _ => return None,
        }
        Some(())
    }
}

/// Keys that say what a solution is about and change nothing, also those that people add.
const ABOUT: [&str; 12] = [
    "algo_name",
    "best_known",
    "github",
    "google_scholar",
    "lower_algos",
    "lower_date",
    "paper_reference",
    "solution_algos",
    "solution_date",
    "solved",
    "submission_date",
    "comments",
];

/// Notes a key of a solution that is not read.
fn note_unknown(unknown: &mut UnknownKeys, key: &str) {
    if !ABOUT.contains(&key) {
        unknown.note("", key);
    }
}

/// Where something is wrong in the paths of a solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Spot {
    /// The number of the text in a list of them, from 0.
    text: Option<usize>,
    /// The byte of that text.
    byte: usize,
}

/// The plan of the solution with the most robots among those with a path; `at`
/// gives a fault its place, which is the whole plan where it has no spot.
fn plan<P>(
    solutions: Vec<Solution<'_, P>>,
    at: impl Fn(&P, Option<Spot>, Fault) -> Fault,
) -> Result<WrittenPlan, Fault> {
    let all = solutions.len();
    let mut unknown = UnknownKeys::default();
    for solution in &solutions {
        unknown.merge(&solution.unknown);
    }
    let with_paths = solutions.into_iter().filter_map(|mut solution| {
        let paths = solution.paths.take()?;
        let robots = paths.robots(solution.agents);
        (robots > 0).then_some((robots, solution, paths))
    });
    // Of equals the first.
    let largest = with_paths.reduce(|best, next| if next.0 > best.0 { next } else { best });
    let Some((count_of_paths, solution, paths)) = largest else {
        let fault = Fault::at(
            "",
            tr!("no solution with a plan"),
            tr!("a \"solution_plan\""),
        );
        return Err(fault.in_text(1, 1));
    };
    let fault = |spot, fault| at(&solution.place, spot, fault);
    robots(count_of_paths).map_err(|many| fault(None, many))?;
    let paths = paths.split(count_of_paths);
    if let Some(agents) = solution.agents
        && agents != paths.len()
    {
        let found = tr!("{n} path" | "{n} paths" % paths.len());
        let expected = tr!("{agents}, as \"agents\" says", agents);
        return Err(fault(None, Fault::at("", found, expected)));
    }
    let mut notes = Vec::new();
    if all > 1 {
        let of = match (&solution.map, &solution.scenario) {
            (Some(map), (Some(kind), Some(number))) => format!(" of {map}-{kind}-{number}"),
            (Some(map), _) => format!(" of {map}"),
            _ => String::new(),
        };
        notes.push(format!(
            "The file has {all} solutions; this is the one with a plan for {}{of}.",
            count(paths.len(), "robot")
        ));
    }
    notes.extend(unknown.sentence());
    let mut steps = Steps::default();
    let mut agents = Vec::with_capacity(paths.len());
    for (spot, path) in &paths {
        let walked = moves::read(path, &mut steps).map_err(|(byte, wrong)| {
            let byte = spot.byte + byte;
            fault(Some(Spot { byte, ..*spot }), wrong)
        })?;
        agents.push(WrittenAgent::walking(Walk::Moves(walked), WrittenAt::Whole));
    }
    let documented = Conventions {
        up: solution.up,
        ..Conventions::OWN
    };
    Ok(WrittenPlan {
        map: solution.map,
        claimed: Claimed {
            makespan: None,
            sum_of_costs: solution.cost,
        },
        bounds: solution.bounds,
        notes,
        ..WrittenPlan::new(agents, documented)
    })
}

impl<'a> Paths<'a> {
    /// How many robots have a path. A last line that is empty is a robot that does
    /// not move, if there is to be one more.
    fn robots(&self, agents: Option<usize>) -> usize {
        let text = match self {
            Self::List(texts) => return texts.len(),
            Self::Lines(text) => text,
        };
        let ends = text.bytes().filter(|&byte| byte == b'\n').count();
        let has_last = if text.is_empty() {
            agents == Some(1)
        } else {
            !text.ends_with('\n') || agents.is_some_and(|agents| agents > ends)
        };
        ends + usize::from(has_last)
    }

    /// The path of each robot with its place.
    fn split(self, robots: usize) -> Vec<(Spot, Cow<'a, str>)> {
        match self {
            Self::List(texts) => {
                let texts = texts.into_iter().enumerate();
                let spot = |i| Spot {
                    text: Some(i),
                    byte: 0,
                };
                texts.map(|(i, text)| (spot(i), text)).collect()
            }
            Self::Lines(Cow::Borrowed(text)) => lines(text, robots)
                .map(|(spot, path)| (spot, Cow::Borrowed(path)))
                .collect(),
            Self::Lines(Cow::Owned(text)) => lines(&text, robots)
                .map(|(spot, path)| (spot, Cow::Owned(path.to_owned())))
                .collect(),
        }
    }
}

/// So many lines of a text, empty ones where it ends before, each with its place.
fn lines(text: &str, count: usize) -> impl Iterator<Item = (Spot, &str)> {
    let lines = text.split('\n').chain(std::iter::repeat(""));
    let mut byte = 0;
    lines.take(count).map(move |line| {
        let spot = Spot { text: None, byte };
        byte += line.len() + 1;
        (spot, line.trim_end_matches('\r'))
    })
}
