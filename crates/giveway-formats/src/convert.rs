//! Files in another format, from texts to texts: as `giveway convert` writes them.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::{Format, Held, Options, Source, movingai};
use giveway_model::format::{native, stem};
use giveway_model::{Fault, Grid, Instance, Plan, Scene, tr};

/// Texts by file names, and what they should become.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ConvertRequest {
    /// The texts, of any format that is known.
    pub files: BTreeMap<String, String>,
    /// The format to write.
    pub to: Format,
    /// Only the first so many agents.
    #[serde(default)]
    pub agents: Option<usize>,
}

/// Texts by file names, and what was lost.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct ConvertAnswer {
    /// The texts.
    pub files: BTreeMap<String, String>,
    /// The parts that the other format cannot hold.
    pub notes: Vec<String>,
}

/// The content of a file.
enum Content {
    Instance(Instance),
    Plan(Plan),
}

/// A content with the name of what is written and of its file.
type Named = (String, String, Content);

/// Writes instances and plans in another format.
///
/// # Errors
/// Every fault of a file, with the file's name and its line before its place.
///
/// ```
/// use giveway_formats::convert::{ConvertRequest, convert};
/// use giveway_formats::Format;
/// let map = "type octile\nheight 1\nwidth 2\nmap\n..\n";
/// let files = [("a.map".to_owned(), map.to_owned())].into();
/// let answer = convert(&ConvertRequest { files, to: Format::Giveway, agents: None }).unwrap();
/// assert!(answer.files["a.json"].contains("\"map\""));
/// ```
pub fn convert(request: &ConvertRequest) -> Result<ConvertAnswer, Vec<Fault>> {
    let mut answer = ConvertAnswer::default();
    let by_itself = matches!(request.to, Format::Giveway | Format::MovingAi);
    let contents = if by_itself && request.files.values().all(|text| is_own(text)) {
        contents(request)?
    } else {
        let (contents, notes) = combined(request)?;
        answer.notes = notes;
        contents
    };
    let have_plan = contents
        .iter()
        .any(|(.., content)| matches!(content, Content::Plan(_)));
    let instance = contents.iter().find_map(|(.., content)| match content {
        Content::Instance(instance) => Some(instance),
        Content::Plan(_) => None,
    });
    for (stem, name, content) in &contents {
        let (instance, plan) = match content {
            Content::Instance(instance) if by_itself || !have_plan => (Some(instance), None),
            Content::Instance(_) => continue,
            Content::Plan(plan) if by_itself => (None, Some(plan)),
            Content::Plan(plan) => (instance, Some(plan)),
        };
        let written = crate::write(request.to, stem, instance, plan)
            .map_err(|fault| vec![fault.in_file(name)])?;
        answer.files.extend(written.files);
        answer.notes.extend(written.losses);
    }
    Ok(answer)
}

/// Whether a text is of this project or of the standard benchmark.
fn is_own(text: &str) -> bool {
    let format = crate::recognise(text);
    matches!(format, Ok(Format::Giveway | Format::MovingAi))
}

/// A scene and the plans for it, out of files that belong together, and what plans lose in any
/// format.
fn combined(request: &ConvertRequest) -> Result<(Vec<Named>, Vec<String>), Vec<Fault>> {
    let options = Options {
        agents: request.agents,
        conventions: None,
        ..Options::default()
    };
    let sources: Vec<Source<'_>> = request
        .files
        .iter()
        .map(|(name, text)| Source { name, text })
        .collect();
    let combined = crate::combine(&sources, &options).map_err(crate::Refused::faults)?;
    let name = match combined.instance.name() {
        "" => "instance".to_owned(),
        name => name.to_owned(),
    };
    let scene = Content::Instance(combined.instance);
    let mut contents = vec![(name.clone(), name.clone(), scene)];
    let mut notes = Vec::new();
    for plan in combined.plans {
        let own = stem(&plan.file);
        let stem = if own == name {
            format!("{own}-plan")
        } else {
            own.to_owned()
        };
        notes.extend(plan.lost_headings());
        contents.push((stem, plan.file, Content::Plan(plan.plan)));
    }
    Ok((contents, notes))
}

/// The contents of the files, each with the name of the file that is written and of its own.
fn contents(request: &ConvertRequest) -> Result<Vec<Named>, Vec<Fault>> {
    let mut maps: BTreeMap<&str, Grid> = BTreeMap::new();
    let mut others = Vec::new();
    for (name, text) in &request.files {
        if movingai::is_map(text) {
            let stem = name.strip_suffix(".map").unwrap_or(name);
            let grid = movingai::read_map(text).map_err(|fault| vec![fault.in_file(name)])?;
            maps.insert(stem, grid);
        } else {
            others.push((name, text));
        }
    }
    let mut contents = Vec::new();
    let is_alone = !others.iter().any(|(_, text)| movingai::is_scenario(text));
    for (name, text) in others {
        let is_scenario = movingai::is_scenario(text);
        let ending = if is_scenario { ".scen" } else { ".json" };
        let stem = name.strip_suffix(ending).unwrap_or(name);
        let content = if is_scenario {
            scenario_content(stem, text, &maps, request.agents)
        } else {
            native_content(text, request.agents)
        };
        let content = content.map_err(|faults| in_file(faults, name))?;
        contents.push((stem.to_owned(), name.clone(), content));
    }
    for (stem, grid) in maps.into_iter().filter(|_| is_alone) {
        let scene = Scene {
            name: stem.to_owned(),
            map: grid.rows(),
            ..Scene::default()
        };
        let name = format!("{stem}.map");
        let instance = Instance::new(scene).map_err(|faults| in_file(faults, &name))?;
        contents.push((stem.to_owned(), name, Content::Instance(instance)));
    }
    Ok(contents)
}

fn in_file(faults: Vec<Fault>, name: &str) -> Vec<Fault> {
    faults.into_iter().map(|it| it.in_file(name)).collect()
}

/// The instance of a scenario, with the map that it names, the one of its own name, or the only
/// one.
fn scenario_content(
    stem: &str,
    text: &str,
    maps: &BTreeMap<&str, Grid>,
    agents: Option<usize>,
) -> Result<Content, Vec<Fault>> {
    let scenario = movingai::read_scenario(text).map_err(|fault| vec![fault])?;
    let named = scenario.map_name().and_then(|map| map.strip_suffix(".map"));
    let only = maps.values().next().filter(|_| maps.len() == 1);
    let grid = named.and_then(|named| maps.get(named));
    let grid = grid.or_else(|| maps.get(stem)).or(only).ok_or_else(|| {
        vec![Fault::at(
            "",
            tr!("no map of it"),
            tr!("its .map among the files"),
        )]
    })?;
    let scene = movingai::to_scene(stem, grid, &scenario, agents).map_err(|fault| vec![fault])?;
    Instance::new(scene).map(Content::Instance)
}

/// A plan or an instance; where it is neither, what it is.
fn native_content(text: &str, agents: Option<usize>) -> Result<Content, Vec<Fault>> {
    match crate::read(text)?.1 {
        Held::Scene(mut scene, _) => {
            scene.agents.truncate(agents.unwrap_or(usize::MAX));
            Instance::new(scene).map(Content::Instance)
        }
        Held::OwnPlan(plan, _) => Ok(Content::Plan(plan)),
        // A file that holds no instance is reported by the reader of instances.
        _ => native::read_instance(text).map(Content::Instance),
    }
}
