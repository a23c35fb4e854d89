//! Problems of the League of Robot Runners: one file that names the others.
//!
//! ```text
//! { "mapFile": "maps/a.map", "agentFile": "agents/a.agents", "taskFile": "tasks/a.tasks",
//!   "teamSize": 2, ".." }
//!
//! agents: how many, then the cell of each, row * width + column, a line each
//! tasks:  how many, then the cell of each; from 2024 on cells with commas, one for each errand
//! ```
//!
//! Lines that begin with `#` are comments. A problem goes on without end: robots get
//! their next task when one is done. Here each robot has one task. Robots face east at first
//! and turn, a step for a quarter turn.
//!
//! Source: the Start-Kit of the League (`read_int_vec`, `read_tasks`).

use std::collections::BTreeSet;

use serde::Deserialize;

use crate::lines::{Line, lines};
use crate::unknown_keys::UnknownKeys;
use giveway_model::constraint::{ConstraintKind, Heading};
use giveway_model::format::base_name;
use giveway_model::format::json;
use giveway_model::format::locate::Fields;
use giveway_model::{Agent, Assumption, Cell, Constraint, Fault, Grid, LeftOutRule, Scene, tr};

/// The files of a problem, as it names them.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Problem {
    /// The map.
    pub map_file: String,
    /// The starts of the robots.
    pub agent_file: String,
    /// The tasks.
    #[serde(default)]
    pub task_file: Option<String>,
    /// How many robots there are.
    #[serde(default)]
    pub team_size: Option<usize>,
    /// Keys that are not read and may change the problem.
    #[serde(skip)]
    pub unknown_keys: Vec<String>,
}

/// The keys that are read, and those about how tasks come to be known in the course of time.
const KEYS: [&str; 9] = [
    "mapFile",
    "agentFile",
    "taskFile",
    "teamSize",
    "numTasksReveal",
    "revealPeriod",
    "taskAssignmentStrategy",
    "numTasks",
    "version",
];

impl Problem {
    /// Reads a problem; `None` where a text is none.
    pub(super) fn read(text: &str) -> Option<Result<Self, Fault>> {
        let fields: Fields<'_> = serde_json::from_str(text).ok()?;
        let is_problem = fields.has("mapFile") && fields.has("agentFile");
        is_problem.then(|| {
            let unknown = UnknownKeys::in_object(text, |key| KEYS.contains(&key));
            let problem: Self = json::read(text)?;
            Ok(Self {
                unknown_keys: unknown.keys(),
                ..problem
            })
        })
    }

    /// The names of the files that belong to it: map, robots, tasks.
    pub fn files(&self) -> Vec<&str> {
        let all = [
            Some(&self.map_file),
            Some(&self.agent_file),
            self.task_file.as_ref(),
        ];
        all.into_iter().flatten().map(String::as_str).collect()
    }

    /// Whether a file is one of those that it names, by the name without folders.
    pub fn names(&self, file: &str) -> bool {
        let is_it = |own: &&str| base_name(own) == base_name(file);
        self.files().iter().any(is_it)
    }
}

/// The texts of the files of a problem, each with its name.
pub(crate) struct Texts<'a> {
    pub(crate) agents: (&'a str, &'a str),
    pub(crate) tasks: Option<(&'a str, &'a str)>,
}

/// The scene of a problem, and what a person should know of it; each robot has one task.
///
/// # Errors
/// The name of the file that is wrong, and its fault.
pub(crate) fn scene(
    problem: &Problem,
    grid: &Grid,
    texts: &Texts<'_>,
) -> Result<(Scene, Vec<String>), (String, Box<Fault>)> {
    let of = |name: &str| {
        let name = name.to_owned();
        move |fault: Fault| (name, Box::new(fault))
    };
    let mut starts = cells(texts.agents.1, grid).map_err(of(texts.agents.0))?;
    let team = problem.team_size.unwrap_or(starts.len());
    let mut notes = Vec::new();
    if starts.len() < team {
        let found = tr!("{n} robot" | "{n} robots" % starts.len());
        let fault = Fault::at("", found, tr!("{team}, the teamSize of the problem", team));
        return Err(of(texts.agents.0)(fault.in_text(1, 1)));
    }
    if let more @ 1.. = starts.len() - team {
        notes.push(tr!(
            "teamSize is {team}: further robots of the file ({more}) are left out.",
            team,
            more
        ));
    }
    starts.truncate(team);
    let mut tasks = match texts.tasks {
        Some((name, text)) => cells(text, grid).map_err(of(name))?.into_iter(),
        None => Vec::new().into_iter(),
    };
    let mut goals = BTreeSet::new();
    let (mut idle, mut has_order) = (0, false);
    let agents = starts.iter().enumerate().map(|(i, errands)| {
        let start = errands.first().copied().unwrap_or(Cell::new(0, 0));
        let task = tasks.find(|task| task.last().is_some_and(|goal| goals.insert(*goal)));
        idle += usize::from(task.is_none());
        let mut waypoints = task.unwrap_or_default();
        // The goal is the last errand anyway.
        has_order |= waypoints.len() > 2;
        let goal = waypoints.pop();
        let mut seen: BTreeSet<Cell> = goal.into_iter().collect();
        waypoints.retain(|cell| seen.insert(*cell));
        Agent {
            waypoints,
            // As the Start-Kit lets them begin.
            heading: Some(Heading::East),
            ..Agent::new(format!("A{}", i + 1), start, goal)
        }
    });
    let agents: Vec<Agent> = agents.collect();
    let mut assumptions = assumptions(&agents, has_order);
    let keys = problem.unknown_keys.iter().cloned();
    assumptions.extend(keys.map(|key| Assumption::UnknownKey { key }));
    let scene = Scene {
        map: grid.rows(),
        agents,
        assumptions,
        constraints: vec![turns()],
        ..Scene::default()
    };
    notes.push(tr!("It is a problem of the League of Robot Runners, which goes on without end: here each robot has one task, in the order of the file; further tasks, and tasks that end where another one does, are left out.").to_owned());
    notes.push(tr!("Robots turn, a step for a quarter turn. The files do not say where they face at first: it is east, as in the program of the League.").to_owned());
    if idle > 0 {
        notes.push(tr!(
            "{n} robot has no task: it has no goal, and may rest anywhere."
                | "{n} robots have no task: they have no goal, and may rest anywhere." % idle
        ));
    }
    Ok((scene, notes))
}

/// Robots of the League turn, and a quarter turn takes a step.
fn turns() -> Constraint {
    Constraint {
        kind: ConstraintKind::Turns { quarter: 1 },
        agents: None,
        name: None,
        off: false,
    }
}

/// The assumptions of a problem's scene: tasks were given to the robots, whose program chooses them there;
/// errands are done in their order.
fn assumptions(agents: &[Agent], has_order: bool) -> Vec<Assumption> {
    let has_tasks = agents.iter().any(|agent| agent.goal.is_some());
    let left_out = |rule| Assumption::RuleLeftOut { rule };
    let all = [
        (has_tasks, Assumption::GoalsChosen),
        (has_order, left_out(LeftOutRule::ErrandOrder)),
    ];
    let all = all.into_iter();
    all.filter_map(|(is_there, one)| is_there.then_some(one))
        .collect()
}

/// The cells of each line after the one with their number.
fn cells(text: &str, grid: &Grid) -> Result<Vec<Vec<Cell>>, Fault> {
    let is_told = |line: &Line<'_>| !(line.text.is_empty() || line.text.starts_with('#'));
    let mut all = lines(text).filter(is_told);
    let first = all.next().ok_or_else(|| {
        Fault::at("", tr!("an empty file"), tr!("how many lines follow")).in_text(1, 1)
    })?;
    let wanted: usize = first.number(first.text.trim(), || {
        tr!("how many lines follow").to_owned()
    })?;
    let (width, height) = (grid.width(), grid.height());
    let mut cells = Vec::new();
    for line in all {
        if cells.len() == wanted {
            let expected = tr!(
                "the end of the file after {wanted} lines, as its first line says",
                wanted
            );
            return Err(line.fault(line.text, expected));
        }
        let words = line
            .text
            .split([',', ' ', '\t'])
            .filter(|word| !word.is_empty());
        let cell = |word| {
            let expected = || {
                tr!(
                    "a cell, row * {width} + column, less than {most}",
                    width,
                    most = width * height
                )
            };
            let number: u32 = line.number(word, expected)?;
            let cell = Cell::new(number % width, number / width);
            (cell.y < height)
                .then_some(cell)
                .ok_or_else(|| line.fault(word, expected()))
        };
        cells.push(words.map(cell).collect::<Result<Vec<Cell>, Fault>>()?);
    }
    if cells.len() < wanted {
        let found = tr!("{n} lines", n = cells.len());
        let expected = tr!("{wanted}, as the first line says", wanted);
        return Err(Fault::at("", found, expected).in_text(first.number, 1));
    }
    Ok(cells)
}
