//! A problem of the League of Robot Runners with the files that it names.

use super::{Missing, Refused};
use crate::{Format, Held, Source, league, recognise};
use giveway_model::format::base_name;
use giveway_model::{Fault, Scene, tr};

/// A problem, made a scene; and which of the files are a part of it.
pub(super) struct Joined {
    pub(super) file: String,
    /// `None` where a result among the files tells what the robots do: of the problem
    /// only the map is looked at.
    pub(super) scene: Option<(Scene, Vec<String>)>,
    /// Files that are not read by themselves.
    pub(super) taken: Vec<usize>,
}

/// Joins a problem among files with those that it names; `None` where there is no
/// problem.
///
/// # Errors
/// When one of its files is missing or wrong.
pub(super) fn join(sources: &[Source<'_>]) -> Result<Option<Joined>, Refused> {
    let mut all = sources.iter().enumerate();
    let first = all.find_map(|(i, source)| {
        // A look at the text is quicker than reading it.
        let read = source
            .text
            .contains("\"mapFile\"")
            .then(|| recognise::read(source.text))?;
        match read {
            Ok((Format::League, Held::Problem(problem))) => {
                Some((i, base_name(source.name), problem))
            }
            _ => None,
        }
    });
    let Some((own, file, problem)) = first else {
        return Ok(None);
    };
    let find = |name: &str| {
        let mut all = sources.iter().enumerate();
        all.find(|(i, source)| *i != own && base_name(source.name) == base_name(name))
    };
    let files = problem.files();
    let mut taken = vec![own];
    let beside = files.iter().skip(1).filter_map(|name| find(name));
    taken.extend(beside.map(|(i, _)| i));
    let result = sources
        .iter()
        .any(|source| source.text.contains("\"actualPaths\""));
    if result {
        return Ok(Some(Joined {
            file: file.to_owned(),
            scene: None,
            taken,
        }));
    }
    let lacking = files.iter().filter(|name| find(name).is_none());
    let lacking: Vec<String> = lacking.map(|&name| name.to_owned()).collect();
    if !lacking.is_empty() {
        let names: Vec<&str> = lacking.iter().map(|name| base_name(name)).collect();
        let sentence = tr!(
            "{file} is a problem of the League of Robot Runners: open the files that it names together with it: {names}.",
            file,
            names = names.join(", ")
        );
        return Err(Refused::Missing {
            file: file.to_owned(),
            what: Missing::Files(lacking),
            sentence,
        });
    }
    let text = |name: &str| {
        find(name).map_or(("", ""), |(_, source)| {
            (base_name(source.name), source.text)
        })
    };
    let refused = |(file, fault): (String, Box<Fault>)| Refused::File {
        file,
        faults: vec![*fault],
    };
    let (map, map_text) = text(&problem.map_file);
    taken.extend(find(&problem.map_file).map(|(i, _)| i));
    let read = recognise::read(map_text).and_then(|(_, held)| {
        if let Held::Map(grid, _) = held {
            return Ok(grid);
        }
        let expected = tr!("the map of the problem");
        let fault = Fault::at("", tr!("a file without a map"), expected);
        Err(vec![fault.in_text(1, 1)])
    });
    let grid = read.map_err(|faults| Refused::File {
        file: map.to_owned(),
        faults,
    })?;
    let texts = league::Texts {
        agents: text(&problem.agent_file),
        tasks: problem.task_file.as_deref().map(text),
    };
    let scene = league::scene(&problem, &grid, &texts).map_err(refused)?;
    Ok(Some(Joined {
        file: file.to_owned(),
        scene: Some(scene),
        taken,
    }))
}
