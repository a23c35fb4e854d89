//! Files in another format, from texts to texts: as `giveway convert` writes them.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::foreign::{self, Format, Options, Source};
use super::{movingai, native, stem};
use crate::{Fault, Grid, Instance, Plan, Scene, tr};

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
    /// What the other format cannot say.
    pub notes: Vec<String>,
}

/// What a file holds.
enum Content {
    Instance(Instance),
    Plan(Plan),
}

/// Writes instances and plans in another format.
///
/// # Errors
/// Every fault of a file, with the file's name and its line before its place.
///
/// ```
/// use giveway_model::format::convert::{ConvertRequest, convert};
/// use giveway_model::format::foreign::Format;
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
        gathered(request)?
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
        let written = foreign::write(request.to, stem, instance, plan)
            .map_err(|fault| vec![fault.in_file(name)])?;
        answer.files.extend(written.files);
        answer.notes.extend(written.losses);
    }
    Ok(answer)
}

/// Whether a text is of this project or of the standard benchmark, or of nobody.
fn is_own(text: &str) -> bool {
    let format = foreign::recognise(text);
    matches!(format, Ok(Format::Giveway | Format::MovingAi) | Err(_))
}

/// A scene and the plans for it, out of files that belong together.
fn gathered(request: &ConvertRequest) -> Result<Vec<(String, String, Content)>, Vec<Fault>> {
    let options = Options {
        agents: request.agents,
        conventions: None,
    };
    let sources: Vec<Source<'_>> = request
        .files
        .iter()
        .map(|(name, text)| Source { name, text })
        .collect();
    let gathered = foreign::gather(&sources, &options).map_err(foreign::Refused::faults)?;
    let name = match gathered.instance.name() {
        "" => "instance".to_owned(),
        name => name.to_owned(),
    };
    let scene = Content::Instance(gathered.instance);
    let mut contents = vec![(name.clone(), name.clone(), scene)];
    for plan in gathered.plans {
        let own = stem(&plan.file);
        let stem = if own == name {
            format!("{own}-plan")
        } else {
            own.to_owned()
        };
        contents.push((stem, plan.file, Content::Plan(plan.plan)));
    }
    Ok(contents)
}

/// What the files hold, each with the name of what is written and of its file.
fn contents(request: &ConvertRequest) -> Result<Vec<(String, String, Content)>, Vec<Fault>> {
    let mut maps: BTreeMap<&str, Grid> = BTreeMap::new();
    for (name, text) in &request.files {
        if let Some(stem) = name.strip_suffix(".map") {
            let grid = movingai::read_map(text).map_err(|fault| vec![fault.in_file(name)])?;
            maps.insert(stem, grid);
        }
    }
    let mut contents = Vec::new();
    let mut is_taken = false;
    for (name, text) in &request.files {
        let faults = |faults: Vec<Fault>| -> Vec<Fault> {
            faults
                .into_iter()
                .map(|fault| fault.in_file(name))
                .collect()
        };
        if let Some(stem) = name.strip_suffix(".scen") {
            let fault = |fault: Fault| vec![fault.in_file(name)];
            let scenario = movingai::read_scenario(text).map_err(fault)?;
            let named = scenario.map_name().and_then(|map| map.strip_suffix(".map"));
            let grid = named
                .and_then(|named| maps.get(named))
                .or_else(|| maps.get(stem))
                .or_else(|| (maps.len() == 1).then(|| maps.values().next()).flatten())
                .ok_or_else(|| {
                    fault(Fault::at(
                        "",
                        tr!("no map of it"),
                        tr!("its .map among the files"),
                    ))
                })?;
            let scene = movingai::to_scene(stem, grid, &scenario, request.agents).map_err(fault)?;
            let instance = Instance::new(scene).map_err(faults)?;
            is_taken = true;
            contents.push((stem.to_owned(), name.clone(), Content::Instance(instance)));
        } else if name.strip_suffix(".map").is_none() {
            let stem = name.strip_suffix(".json").unwrap_or(name);
            let content = native_content(text, request.agents).map_err(faults)?;
            contents.push((stem.to_owned(), name.clone(), content));
        }
    }
    if !is_taken {
        for (stem, grid) in maps {
            let scene = Scene {
                name: stem.to_owned(),
                map: grid.rows(),
                ..Scene::default()
            };
            let name = format!("{stem}.map");
            let instance = Instance::new(scene).map_err(|all| {
                all.into_iter()
                    .map(|fault| fault.in_file(&name))
                    .collect::<Vec<_>>()
            })?;
            contents.push((stem.to_owned(), name, Content::Instance(instance)));
        }
    }
    Ok(contents)
}

/// A plan or an instance; where it is neither, the faults of what it looks like.
fn native_content(text: &str, agents: Option<usize>) -> Result<Content, Vec<Fault>> {
    let faults = match native::read_instance(text) {
        Ok(instance) => {
            let mut scene = instance.to_scene();
            scene.agents.truncate(agents.unwrap_or(usize::MAX));
            return Instance::new(scene).map(Content::Instance);
        }
        Err(faults) => faults,
    };
    match native::read_plan(text) {
        Ok(plan) => Ok(Content::Plan(plan)),
        Err(fault) if text.contains("\"paths\"") => Err(vec![fault]),
        Err(_) => Err(faults),
    }
}
