//! What `convert` reads: scenarios with their maps, instances and plans.

use std::path::PathBuf;

use giveway_model::{Fault, Instance, Plan, Scene, format};

use crate::{
    args::{Common, Convert},
    failure::Failure,
    input::{self, Kind, Map, Maps, Scen, Source, foreign},
    output::stream,
};

/// The stem of files that come from standard input.
const UNNAMED: &str = "instance";

/// One thing to write.
pub(super) struct Item {
    /// The file that it came from, in messages.
    pub(super) name: String,
    /// The name of its files, without ending.
    pub(super) stem: String,
    /// What it is.
    pub(super) content: Content,
    /// What its file tells and no format holds, a phrase.
    pub(super) lost: Option<String>,
}

/// An instance or a plan.
pub(super) enum Content {
    Instance(Instance),
    Plan(Plan),
}

/// All that was read.
pub(super) struct Inputs {
    /// In the order of the command line; maps that no scenario takes are last.
    pub(super) items: Vec<Item>,
    /// Every file that was read; none of them is ever overwritten.
    pub(super) paths: Vec<PathBuf>,
}

impl Inputs {
    /// The instance of the plans, where there is only one.
    pub(super) fn instance(&self) -> Option<&Instance> {
        let mut instances = self.items.iter().filter_map(|item| match &item.content {
            Content::Instance(instance) => Some(instance),
            Content::Plan(_) => None,
        });
        instances.next().filter(|_| instances.next().is_none())
    }

    /// Whether there is a plan.
    pub(super) fn have_plan(&self) -> bool {
        let mut items = self.items.iter();
        items.any(|item| matches!(item.content, Content::Plan(_)))
    }
}

/// Reads the files of the command line.
pub(super) fn inputs(args: &Convert, common: &Common) -> Result<Inputs, Failure> {
    let read = args.files.iter().map(|path| Source::read(path));
    let read = read.collect::<Result<Vec<Source>, Failure>>()?;
    if read.iter().any(|source| Kind::of(source) == Kind::Foreign) {
        return combined(args, common, &read);
    }
    let notes = read.iter().filter_map(|source| source.note.as_ref());
    for note in notes.filter(|_| !common.quiet) {
        stream::note(&format!("note: {note}"));
    }
    let mut sources = Vec::new();
    let mut given = Vec::new();
    for source in read {
        match Kind::of(&source) {
            Kind::Map => given.push(Map::read(source)?),
            kind => sources.push((kind, source)),
        }
    }
    let maps = Maps::new(&given, common.map.as_deref())?;
    let first = args.first.agents;
    let mut inputs = Inputs {
        items: Vec::new(),
        paths: Vec::new(),
    };
    let mut taken = Vec::new();
    for (kind, source) in sources {
        inputs.paths.extend(source.path.clone());
        let (name, stem) = (source.name.clone(), stem(&source));
        let content = match kind {
            Kind::Scenario => {
                let scen = Scen::read(source)?;
                if let Some(note) = scen.note().filter(|_| !common.quiet) {
                    stream::note(&format!("note: {note}"));
                }
                let map = maps.of(&scen)?;
                if let Some(note) = map.note(&scen).filter(|_| !common.quiet) {
                    stream::note(&note);
                }
                let instance = scen.instance(&map, first, args.ruling)?;
                taken.extend(map.source.path);
                Content::Instance(instance)
            }
            Kind::Native if input::is_plan(&source) => {
                if first.is_some() {
                    return Err(Failure::Usage(format!(
                        "--agents is for instances, and {name} is a plan"
                    )));
                }
                Content::Plan(input::plan_in(&source, common)?)
            }
            Kind::Foreign | Kind::Native | Kind::Map => {
                Content::Instance(input::native(&source, first, args.ruling)?)
            }
        };
        inputs.items.push(Item {
            name,
            stem,
            content,
            lost: None,
        });
    }
    for map in given {
        let is_taken = map
            .source
            .path
            .as_ref()
            .is_some_and(|path| taken.contains(path));
        inputs.paths.extend(map.source.path.clone());
        if !is_taken {
            inputs.items.push(without_agents(map, first)?);
        }
    }
    inputs.paths.extend(taken);
    inputs.paths.extend(common.map.clone());
    Ok(inputs)
}

/// Files of others, matched to each other and to the maps and scenes beside them.
fn combined(args: &Convert, common: &Common, read: &[Source]) -> Result<Inputs, Failure> {
    let paths = read.iter().filter_map(|source| source.path.clone());
    let paths = paths.chain(common.map.clone()).collect();
    let combined = foreign::combine(
        read,
        foreign::Wanted {
            map: common.map.as_deref(),
            agents: args.first.agents,
            reading: args.reading,
            ruling: args.ruling,
        },
    )?;
    let plans = combined.plans.iter().flat_map(|plan| &plan.notes);
    for note in combined.notes.iter().chain(plans) {
        stream::note(&format!("note: {note}"));
    }
    let name = combined.instance.name();
    let scene = if name.is_empty() { UNNAMED } else { name }.to_owned();
    let mut items = vec![Item {
        name: scene.clone(),
        stem: scene.clone(),
        content: Content::Instance(combined.instance),
        lost: None,
    }];
    for plan in combined.plans {
        let own = format::stem(&plan.file);
        let stem = if own == scene {
            format!("{own}-plan")
        } else {
            own.to_owned()
        };
        items.push(Item {
            lost: plan.lost_headings(),
            name: plan.file,
            stem,
            content: Content::Plan(plan.plan),
        });
    }
    Ok(Inputs { items, paths })
}

/// A map alone: an instance without agents.
fn without_agents(map: Map, first: Option<usize>) -> Result<Item, Failure> {
    if let Some(first) = first.filter(|first| *first > 0) {
        let expected = format!("a scenario for {first} robots, as asked with --agents");
        return Err(map.source.fault(Fault::at("", "a map alone", expected)));
    }
    let stem = stem(&map.source);
    let scene = Scene {
        name: stem.clone(),
        map: map.grid.rows(),
        ..Scene::default()
    };
    let instance = Instance::new(scene).map_err(|faults| map.source.faults(faults))?;
    Ok(Item {
        name: map.source.name,
        stem,
        content: Content::Instance(instance),
        lost: None,
    })
}

fn stem(source: &Source) -> String {
    source.stem().unwrap_or_else(|| UNNAMED.to_owned())
}
