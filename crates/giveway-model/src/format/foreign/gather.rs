//! Files that belong together: a map, tasks and plans made one scene with its plans.

mod origin;
mod scene;

use std::collections::BTreeMap;

use borsh::{BorshDeserialize, BorshSerialize};
use serde::{Deserialize, Serialize};

use super::decide::{self, Decision, Task};
use super::{
    Alternative, Claimed, Conventions, Fit, Format, Heading, Held, Source, WrittenPlan, place,
    recognise,
};
use crate::format::base_name;
use crate::{Fault, Instance, Plan, tr};
use scene::Base;

/// What a person chose.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options {
    /// How plans are to be read, instead of what fits best.
    pub conventions: Option<Conventions>,
    /// Only the first agents of a scenario, where no plan says how many there are.
    pub agents: Option<usize>,
}

/// A plan of elsewhere, read.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, BorshSerialize, BorshDeserialize)]
pub struct ForeignPlan {
    /// The name of its file.
    pub file: String,
    /// Its format.
    pub format: Format,
    /// How it was read, where that is a matter of convention: what it is about
    /// (`cells`, `up`), and how.
    pub words: Vec<(String, String)>,
    /// The same as data.
    pub conventions: Conventions,
    /// Why it was read so, a sentence.
    pub why: String,
    /// The other ways to read it.
    pub alternatives: Vec<Alternative>,
    /// How well it fits the scene.
    pub fit: Fit,
    /// What its file says that it costs.
    pub claimed: Claimed,
    /// What it would cost if every step that its file writes counted, waits at the
    /// goal after the arrival too.
    pub written: Claimed,
    /// Where agents that turn look at each time; empty where none does.
    pub headings: BTreeMap<String, Vec<Heading>>,
    /// What a person should know, each a sentence.
    pub notes: Vec<String>,
    /// The plan; it may break any rule.
    pub plan: Plan,
}

/// A scene and the plans for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Gathered {
    /// The scene.
    pub instance: Instance,
    /// The plans, in the order of the files.
    pub plans: Vec<ForeignPlan>,
    /// What a person should know about the scene, each a sentence.
    pub notes: Vec<String>,
}

/// A file that is not there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Missing {
    /// A map, by its name without folders where it is known.
    Map(Option<String>),
    /// The starts (and goals) of the agents, in a scenario.
    Scenario,
    /// The problem that a solution is for, in its makers' own format: map and agents.
    Problem,
}

/// Why files make no scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refused {
    /// A file is wrong.
    File {
        /// Its name.
        file: String,
        /// What is wrong with it.
        faults: Vec<Fault>,
    },
    /// A file of another kind is needed beside them.
    Missing {
        /// The file that needs it.
        file: String,
        /// What is missing.
        what: Missing,
        /// That in a sentence, with what to do.
        sentence: String,
    },
    /// The files do not belong together; a sentence.
    Apart(String),
}

impl Refused {
    /// The same as faults whose places are files.
    pub fn faults(self) -> Vec<Fault> {
        match self {
            Self::File { file, faults } => {
                let faults = faults.into_iter();
                faults.map(|fault| fault.in_file(&file)).collect()
            }
            Self::Missing { file, what, .. } => {
                let found = match &what {
                    Missing::Map(Some(map)) => tr!("a file for the map {map}", map),
                    Missing::Map(None) => tr!("a file for a map").to_owned(),
                    Missing::Scenario => tr!("a plan without the starts of its robots").to_owned(),
                    Missing::Problem => tr!("a solution without its problem").to_owned(),
                };
                let expected = match what {
                    Missing::Map(_) => tr!("that map among the files"),
                    Missing::Scenario => tr!("its scenario (.scen) among the files"),
                    Missing::Problem => {
                        tr!("the file of its problem, with map and robots, among the files")
                    }
                };
                vec![Fault::at(file, found, expected)]
            }
            Self::Apart(sentence) => {
                let found = sentence.trim_end_matches('.');
                vec![Fault::at("", found, tr!("files that belong together"))]
            }
        }
    }
}

/// Matches files to each other.
///
/// # Errors
/// When one of them is wrong, when another is missing, or when they hold more
/// than one scene.
pub fn gather(sources: &[Source<'_>], options: &Options) -> Result<Gathered, Refused> {
    let mut base = Base::default();
    let mut plans = Vec::new();
    for source in sources {
        let file = base_name(source.name).to_owned();
        let (format, held) = recognise::read(source.text).map_err(|faults| Refused::File {
            file: file.clone(),
            faults,
        })?;
        match held {
            Held::Map(grid) => base.take_map(file, grid)?,
            Held::Scenario(scenario) => base.take_scenario(file, scenario)?,
            Held::Scene(scene, notes) => base.take_scene((file, format), scene, notes)?,
            Held::OwnPlan(plan) => plans.push((file, format, Body::Own(plan))),
            Held::Plan(plan) => plans.push((file, format, Body::Written(plan, source.text))),
            Held::Both(scene, plan) => {
                base.take_scene((file.clone(), format), scene, Vec::new())?;
                plans.push((file, format, Body::Written(plan, source.text)));
            }
        }
    }
    let first = plans.iter().find_map(|(file, format, body)| match body {
        Body::Own(_) => None,
        Body::Written(plan, text) => Some(scene::First {
            file,
            format: *format,
            text,
            plan,
        }),
    });
    let settled = base.settle(first, options)?;
    let plans = plans
        .into_iter()
        .map(|(file, format, body)| match body {
            Body::Own(plan) => Ok(own(file, format, plan)),
            Body::Written(plan, _) => written(file, format, &plan, &settled, options.conventions),
        })
        .collect::<Result<_, Refused>>()?;
    Ok(Gathered {
        instance: settled.instance,
        plans,
        notes: settled.notes,
    })
}

/// A plan by names, or one by the order of its agents with the text of its file.
enum Body<'a> {
    Own(Plan),
    Written(WrittenPlan, &'a str),
}

fn own(file: String, format: Format, plan: Plan) -> ForeignPlan {
    ForeignPlan {
        file,
        format,
        words: Vec::new(),
        conventions: Conventions::OWN,
        why: "There is only one way to read it.".to_owned(),
        alternatives: Vec::new(),
        fit: Fit::default(),
        claimed: Claimed::default(),
        written: every_step(&plan),
        headings: BTreeMap::new(),
        notes: Vec::new(),
        plan,
    }
}

/// The costs of a plan whose agents never arrive before the end of their path.
fn every_step(plan: &Plan) -> Claimed {
    let steps = || {
        let paths = plan.paths.values();
        paths.map(|path| path.len().saturating_sub(1) as u64)
    };
    Claimed {
        makespan: steps().max(),
        sum_of_costs: Some(steps().sum()),
    }
}

fn written(
    file: String,
    format: Format,
    plan: &WrittenPlan,
    settled: &scene::Settled,
    chosen: Option<Conventions>,
) -> Result<ForeignPlan, Refused> {
    let agents = settled.instance.agents();
    if plan.agents.len() > agents.len() {
        let planned = tr!("{n} robot" | "{n} robots" % plan.agents.len());
        let there = tr!("{n} robot" | "{n} robots" % agents.len());
        return Err(Refused::Apart(tr!(
            "{file} has a plan for {planned}, and the scene has {there}.",
            file,
            planned,
            there
        )));
    }
    let tasks: Vec<Task> = agents
        .iter()
        .map(|agent| (agent.start, agent.goal))
        .collect();
    let known = (settled.tasks_of.as_ref() != Some(&file)).then_some(&*tasks);
    let Decision {
        conventions,
        fit,
        why,
        alternatives,
    } = decide::decide(plan, settled.instance.grid(), known, chosen);
    let mut made = Plan::default();
    let mut headings = BTreeMap::new();
    for (walking, agent) in plan.agents.iter().zip(agents) {
        let (path, looks) = place::path(walking, Some(agent.start), conventions);
        made.paths.insert(agent.name.clone(), path);
        headings.extend(looks.map(|looks| (agent.name.clone(), looks)));
    }
    let every_step = every_step(&made);
    made.cut_trailing_goals(&settled.instance);
    let words = conventions.words(plan).into_iter();
    Ok(ForeignPlan {
        file,
        format,
        words: words.map(|(about, how)| (about.to_owned(), how)).collect(),
        conventions,
        why,
        alternatives,
        fit,
        claimed: plan.claimed,
        written: every_step,
        headings,
        notes: plan.notes.clone(),
        plan: made,
    })
}
